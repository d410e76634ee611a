#ifndef shapetonTubeEnds_h
#define shapetonTubeEnds_h

#include "ConformalFlatteningExport.h"

#include "shapetonRemarks.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** The boundary loops of a tube: u is 0 on the first and greatest on the second. \ingroup ConformalFlattening */
struct TubeEnds
{
  std::vector<int> first;
  std::vector<int> second;
  /** The first one is the loop that the field array `rectumLoop` names; else the one with the least vertex. */
  bool isRectumKnown{ false };

  /** All vertices of the first loop and then of the second. */
  ConformalFlattening_EXPORT std::vector<int>
                             Vertices() const;
};

/** Throws InputError, which begins with `what` and says what the surface has and which tool serves it, unless the
 * surface is one manifold, oriented component with exactly two boundary loops. Handles are allowed.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT TubeEnds
FindTubeEnds(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::string & what);

/** A tube as FindTubeEnds() needs it, whose faces look outwards, with what was changed for that in words (which name no
 * file). */
struct PreparedTube
{
  SurfaceMesh mesh;
  Remarks     warnings;
};

/** Repairs what can be repaired: coincident vertices, degenerate and duplicate faces, unreferenced vertices, faces that
 * are turned over, edges and vertices that are not manifold; turns the surface when its faces look inwards (by the
 * volume that the surface encloses with its ends closed). A sound surface is returned as it is. Vertices that
 * `rectumLoop` and `caecumLoop` name are renumbered. Throws InputError as FindTubeEnds() does.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT PreparedTube
PrepareTube(SurfaceMesh mesh, const std::string & what);

/** Gives the field arrays `rectumLoop` and `caecumLoop` of `after` the vertices that lie where those of `before` lay;
 * arrays of which a vertex is gone are removed. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT void
RenumberLoopArrays(const SurfaceMesh & before, SurfaceMesh & after);
} // namespace shapeton

#endif
