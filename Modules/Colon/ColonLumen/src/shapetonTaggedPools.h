#ifndef shapetonTaggedPools_h
#define shapetonTaggedPools_h

#include "shapetonColonEvidence.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenVoxels.h"

namespace shapeton
{
/** Decides Undecided voxels. Bright matter connected to the levels and seeds of the colon by a wide passage is colon;
 * the rest competes for the space between. Thin matter is colon only within 12 mm of wide fluid or a level; beyond it
 * is bone or another bowel. */
void
SplitAtNecks(LumenField & field);

/** Adds fainter fluid connected to the fluid of the colon: layers of poorly mixed contrast agent.
 *
 * From the fluid, paths run through matter brighter than tissue, on means of 3 by 3 by 3 voxels. A path may continue to
 * fainter matter but not to brighter matter again, since the wall between the colon and another bowel is a dip. Matter
 * too far from the fluid to be its blurred edge is a core; each core is grown back to the half height between tissue
 * and itself. Dips are detected in `sharp`, the values without the prefilter of sigma `smoothing` (mm). `seeds`: voxels
 * that are cores from the start. */
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
  bool            isRectum{ false };       ///< identified because nothing else is near the anus
  Eigen::Vector3d center{ 0.0, 0.0, 0.0 }; ///< of the largest ball inside, LPS, mm
};

/** Adds bright matter without a level if its caliber exceeds that of small bowel: at least 50 ml, an inscribed radius
 * of at least 14 mm, longer than wide, unlike a bladder, and as bright as the fluid of the colon. Applies only if fluid
 * is tagged so well (300 HU above tissue) that no bone of that width is as bright. Each becomes a seed point of
 * `evidence`. Nearer to the anus than the colon (see PiecesNearerToAnus()) 20 ml and 10 mm are enough. */
std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence);
} // namespace shapeton

#endif
