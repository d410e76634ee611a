#ifndef shapetonSmoothedField_h
#define shapetonSmoothedField_h

#include "shapetonVoxelGrid.h"

#include <vector>

namespace shapeton
{
/** Gaussian smoothing of cubic voxels with `sigma` voxels; border values are repeated. */
std::vector<float>
SmoothedField(const VoxelGrid & grid, const std::vector<unsigned char> & values, double sigma);
} // namespace shapeton

#endif
