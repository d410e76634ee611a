#ifndef shapetonSmoothVoxels_h
#define shapetonSmoothVoxels_h

#include "shapetonVoxelGrid.h"
#include "ShapetonCommonExport.h"

#include <array>

namespace shapeton
{
/** Gaussian smoothing in place, separable, cut off at three standard deviations; border values are repeated.
 * \param sigmas standard deviations along the axes, in voxels; 0 for none
 * \param values one per voxel of the grid
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
SmoothVoxels(const VoxelGrid & grid, const std::array<double, 3> & sigmas, float * values);
} // namespace shapeton

#endif
