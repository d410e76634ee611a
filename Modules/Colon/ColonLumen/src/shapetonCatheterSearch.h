#ifndef shapetonCatheterSearch_h
#define shapetonCatheterSearch_h

#include "shapetonRectalCatheter.h"
#include "shapetonTubeSections.h"

#include <optional>

namespace shapeton
{
constexpr double LeastCatheterConfidence = 0.5;

/** A bore in the rectum that is or resembles a catheter. */
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

/** Finds the bore with the highest confidence; none if no long bore comes close to the limits.
 *
 * A catheter has a bore that is round (ovality below .1) and even (radii within .5 mm) for at least 30 mm, with a
 * radius of 1 to 4.5 mm. Along 6 mm of it 90 % of the rays cross a wall (1 to 4.5 mm, before fluid from 1.6 mm) and
 * then enter the lumen; elsewhere a tube may touch the wall of the rectum or be partly in fluid. A crease between folds
 * is open along its side; a collapsed bowel is surrounded by tissue. See CatheterEvidence for the margins of these
 * limits. */
std::optional<CatheterTube>
FindCatheterTube(const CatheterRegion & region);
} // namespace shapeton

#endif
