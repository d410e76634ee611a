#ifndef shapetonTaeniaNames_h
#define shapetonTaeniaNames_h

#include "shapetonColonSegments.h"
#include "shapetonColonTaeniae.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** Anatomical name of a taenia. \ingroup ShapetonColonLandmarks */
enum class TaeniaName
{
  Unknown,
  /** Free: in front of ascending and descending colon, below the transverse colon. */
  Libera,
  /** At the mesocolon: behind and medial; above and behind the transverse colon. */
  Mesocolica,
  /** At the greater omentum: behind and lateral; above and in front of the transverse colon. */
  Omentalis
};

/** "", "libera", "mesocolica", "omentalis". \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::string
                              NameOf(TaeniaName name);

/** How well the taeniae of a segment are where anatomy has them. \ingroup ShapetonColonLandmarks */
struct TaeniaNameEvidence
{
  /** 3 descending, 4 transverse, 5 ascending. */
  int segment{ 0 };
  /** If taenia 1, 2 or 3 is the libera: mean cosine between the directions of all taeniae from the centerline and the
   * expected ones, -1 to 1. */
  std::array<double, 3> agreement{};
};

/** Names of the taeniae, or the reason why they are unknown. See NameTaeniae(). \ingroup ShapetonColonLandmarks */
struct TaeniaNames
{
  std::array<TaeniaName, 3>       names{};
  std::string                     reason;
  std::vector<TaeniaNameEvidence> evidence;

  bool
  AreKnown() const
  {
    return names[0] != TaeniaName::Unknown;
  }
};

/** Names the taeniae by their directions in descending, transverse and ascending colon (Gray's Anatomy, 41st ed.): the
 * libera is expected in front, or below and 30 degrees backward; mesocolica and omentalis follow by a third of a turn
 * each, in the row order of the flat map, as ColonTaeniae has them.
 *
 * Names are given only if at least two of these segments show the same taenia as the libera, none shows another one,
 * and in each the agreement exceeds that of the second best by 0.4: the colon is turned by less than about 45 degrees.
 * A track that continues on another taenia makes segments contradict each other. The patient must be in LPS; positions
 * do not matter, because the mesentery holds the colon. In three real colons of unlike sources, each segment on its own
 * names the same taenia (agreement 0.53 to 0.97, second best at most 0.24). \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT TaeniaNames
NameTaeniae(const ColonTaeniae & taeniae, const CurveSet & centerline, const ColonSegments & segments);
} // namespace shapeton

#endif
