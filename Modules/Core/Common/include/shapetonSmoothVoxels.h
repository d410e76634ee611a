#ifndef shapetonSmoothVoxels_h
#define shapetonSmoothVoxels_h

#include "shapetonVoxelGrid.h"
#include "ShapetonCommonExport.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shapeton
{
/** Gaussian smoothing in place, separable, cut off at three standard deviations; border values are repeated.
 * \param sigmas standard deviations along the axes, in voxels; 0 for none
 * \param values one per voxel of the grid
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
SmoothVoxels(const VoxelGrid & grid, const std::array<double, 3> & sigmas, float * values);

/** A copy of a volume, smoothed by a Gaussian before edges are found (Catte et al. 1992); empty without smoothing.
 * \param values x fastest
 * \param spacing mm
 * \param smoothing standard deviation in mm
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::vector<float>
                      SmoothedVolume(const float *                      values,
                                     const std::array<std::size_t, 3> & size,
                                     const std::array<double, 3> &      spacing,
                                     double                             smoothing);
} // namespace shapeton

#endif
