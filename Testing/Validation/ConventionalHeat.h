#ifndef ConventionalHeat_h
#define ConventionalHeat_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <vector>

/** Heat diffusion from one voxel at a time (dissertation 2.2.1), the predecessor of cumulative heat diffusion. Each
 * voxel in turn starts with all heat, 1; its value is the remaining heat after `timeSteps` steps of length 1/12, a
 * diagonal element of (1 - dt L)^timeSteps. The cost is quadratic in the number of voxels, so use it for small volumes
 * only. Returns one value per voxel, x fastest. */
std::vector<float>
ConventionalHeat(const shapeton::VolumeGradientOperator & volumeGradient, std::uint64_t timeSteps);

#endif
