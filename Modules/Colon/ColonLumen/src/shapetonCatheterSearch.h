#ifndef shapetonCatheterSearch_h
#define shapetonCatheterSearch_h

#include "shapetonRectalCatheter.h"
#include "shapetonTubeSections.h"

#include <optional>

namespace shapeton
{
/** Minimum confidence (0 to 1) of a bore that is added to the lumen. Chosen: it is then more likely a catheter than
 * bowel. */
constexpr double LeastCatheterConfidence = 0.5;

/** A bore in the rectum that may be a catheter. */
struct CatheterTube
{
  std::vector<TubeSection> sections; ///< inside the body, 1 mm apart, anal side first
  double                   boreRadius{ 0.0 };
  double                   outerRadius{ 0.0 };
  double                   wallHU{ 0.0 };
  CatheterEvidence         evidence;
};

/** The part of the volume within 150 mm of the caudal end of the lumen. */
VoxelBox
BoxOfCatheter(const ColonGrid & grid, const ClassVolume & classes);

/** Finds the bore with the highest confidence; empty if no long bore is close to the limits.
 *
 * The bore of a catheter is round (ovality below .1) and uniform (radii within .5 mm) for at least 30 mm, with a radius
 * of 1 to 4.5 mm. Along 6 mm of the bore, 90 % of the rays cross a wall (1 to 4.5 mm thick, at least 1.6 mm next to
 * fluid) into the lumen; elsewhere a tube may touch the wall of the rectum or be partly in fluid. In contrast, a crease
 * between folds is open on one side, and a collapsed bowel is surrounded by tissue. See CatheterEvidence for
 * margins. */
std::optional<CatheterTube>
FindCatheterTube(const CatheterRegion & region);
} // namespace shapeton

#endif
