#ifndef shapetonUnmixedFluid_h
#define shapetonUnmixedFluid_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenGrowth.h"

namespace shapeton
{
/** Adds to the colon's fluid what is fainter but joined to it: layers of badly mixed contrast agent.
 *
 * From the fluid, paths run through matter brighter than tissue, by shares of 3 by 3 by 3 voxels. A path may go down to
 * fainter matter but not up again: between the colon and another bowel the wall is a dip. What is too far from the
 * fluid to be its blurred edge is a core; each core is grown back to the half-height between tissue and itself.
 * Dips are looked for in `sharp`, the values without the prefilter of sigma `smoothing` (mm). `seeds`: voxels that are
 * cores at once. */
void
AddUnmixedFluid(const ColonGrid &                grid,
                const std::vector<float> &       hu,
                const std::vector<float> &       sharp,
                const ColonThresholds &          thresholds,
                double                           noise,
                double                           smoothing,
                const std::vector<std::size_t> & seeds,
                ClassVolume &                    classes);
} // namespace shapeton

#endif
