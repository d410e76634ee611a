#ifndef shapetonTaggedPools_h
#define shapetonTaggedPools_h

#include "shapetonColonEvidence.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenVoxels.h"

namespace shapeton
{
/** Decides what is Undecided: of the bright matter joined to the colon's levels and seeds only what a wide passage
 * reaches is colon; the rest competes for what lies between. Thin matter is colon no farther than 12 mm from wide fluid
 * or a level: beyond, it is bone or another bowel. */
void
SplitAtNecks(LumenField & field);

/** Adds to the colon's fluid what is fainter but joined to it: layers of badly mixed contrast agent.
 *
 * From the fluid, paths run through matter brighter than tissue, by shares of 3 by 3 by 3 voxels. A path may go down to
 * fainter matter but not up again: between the colon and another bowel the wall is a dip. What is too far from the
 * fluid to be its blurred edge is a core; each core is grown back to the half-height between tissue and itself.
 * Dips are looked for in `sharp`, the values without the prefilter of sigma `smoothing` (mm). `seeds`: voxels that are
 * cores at once. */
void
AddUnmixedFluid(const ColonGrid &                grid,
                const VoxelValues &              hu,
                const VoxelValues &              sharp,
                const ColonThresholds &          thresholds,
                double                           noise,
                double                           smoothing,
                const std::vector<std::size_t> & seeds,
                ClassVolume &                    classes);

/** A stretch of the colon filled with fluid alone. */
struct FluidWithoutGas
{
  double          ml{ 0.0 };
  bool            isRectum{ false };       ///< taken as nothing else is near the anus
  Eigen::Vector3d centre{ 0.0, 0.0, 0.0 }; ///< of the largest ball in it, LPS, mm
};

/** Takes bright matter without a level for colon, where its calibre is that of no small bowel: at least 50 ml, an
 * inscribed radius of 14 mm or more, longer than wide, which a bladder is not, and as bright as the colon's fluid.
 * Only where fluid is tagged so well (300 HU above tissue) that no bone of that width is as bright. Each becomes a seed
 * point of `evidence`. Nearer to the anus than the colon (see PiecesNearerToAnus()) 20 ml and 10 mm are
 * enough. */
std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence);
} // namespace shapeton

#endif
