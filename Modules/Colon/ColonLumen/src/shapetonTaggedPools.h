#ifndef shapetonTaggedPools_h
#define shapetonTaggedPools_h

#include "shapetonColonEvidence.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenField.h"

namespace shapeton
{
/** Classifies Undecided voxels. Bright matter connected to the levels and seeds of the colon by a wide passage is
 * colon; the other parts compete for the voxels in between. Thin matter is colon only within 12 mm of wide fluid or a
 * level; farther away, it is bone or another bowel. */
void
SplitAtNecks(LumenField & field);

/** Adds fainter fluid connected to the fluid of the colon, such as layers of poorly mixed contrast agent.
 *
 * Paths from the fluid through matter brighter than tissue are searched on the means of voxels and their face
 * neighbors. Values may only decrease along a path, since a wall to another bowel appears as a dip. Matter too far from
 * the fluid to be its blurred edge is a core; each core is grown to its half height above tissue. Dips are detected in
 * `sharp`, the values before the prefilter with a sigma of `smoothing` (mm). `seeds` are initial cores. */
void
AddUnmixedFluid(const ColonGrid &                grid,
                const VoxelValues &              hu,
                const VoxelValues &              sharp,
                const ColonThresholds &          thresholds,
                double                           noise,
                double                           smoothing,
                const std::vector<std::size_t> & seeds,
                ClassVolume &                    classes);

/** A stretch of the colon filled only with fluid. */
struct FluidWithoutGas
{
  double          ml{ 0.0 };
  bool            isRectum{ false };       ///< whether identified because no other colon is near the anus
  Eigen::Vector3d center{ 0.0, 0.0, 0.0 }; ///< of the largest inscribed ball, LPS, mm
};

/** Adds bright matter that has no level but is wider than small bowel: it must have a volume of at least 50 ml and an
 * inscribed radius of at least 14 mm, be elongated (unlike a bladder), and be as bright as the fluid of the colon.
 * Requires well-tagged fluid (300 HU above tissue), which is brighter than bone of that width. Each piece becomes a
 * seed point of `evidence`. If the piece is nearer to the anus than the known colon (see PiecesNearerToAnus()), 20 ml
 * and 10 mm suffice. */
std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence);
} // namespace shapeton

#endif
