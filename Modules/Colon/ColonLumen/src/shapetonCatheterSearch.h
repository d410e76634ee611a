#ifndef shapetonCatheterSearch_h
#define shapetonCatheterSearch_h

#include "shapetonRectalCatheter.h"
#include "shapetonTubeSections.h"

#include <optional>

namespace shapeton
{
constexpr double LeastCatheterConfidence = 0.5;

/** A bore in the rectum that is a catheter, or looks like one. */
struct CatheterTube
{
  std::vector<TubeSection> sections; ///< inside the body, 1 mm apart, the anal side first
  double                   boreRadius{ 0.0 };
  double                   outerRadius{ 0.0 };
  double                   wallHU{ 0.0 };
  CatheterEvidence         evidence;
};

/** The part of the volume within 150 mm of the caudal end of the lumen. */
VoxelBox
BoxOfCatheter(const ColonGrid & grid, const ClassVolume & classes);

/** The bore that is most surely that of a catheter; none where no long bore comes near to one.
 *
 * A catheter has a bore that is round (ovality below .1) and even (radii within .5 mm) for at least 30 mm, with a
 * radius of 1 to 4.5 mm, and along 6 mm of it 90 % of the rays cross a wall (1 to 4.5 mm, before fluid from 1.6 mm) and
 * then enter the lumen: so a tube may lie on the wall of the rectum, or partly in fluid, for the rest of its way. A
 * crease between folds is open along its side, a collapsed bowel has tissue around it. See CatheterEvidence for how
 * near to these limits a bore is. */
std::optional<CatheterTube>
FindCatheterTube(const CatheterRegion & region);
} // namespace shapeton

#endif
