#ifndef ConventionalHeat_h
#define ConventionalHeat_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <vector>

/** Heat diffusion from one voxel at a time (dissertation 2.2.1), which cumulative heat diffusion replaces: each voxel
 * in turn is the only one with heat, 1, and what is left on it after so many steps of length 1/12 is its value: the
 * diagonal of (1 - dt L)^timeSteps. The cost grows with the square of the number of voxels: for small volumes. As many
 * values as the volume has voxels, x fastest. */
std::vector<float>
ConventionalHeat(const shapeton::VolumeGradientOperator & volumeGradient, std::uint64_t timeSteps);

#endif
