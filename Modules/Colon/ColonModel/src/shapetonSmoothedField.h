#ifndef shapetonSmoothedField_h
#define shapetonSmoothedField_h

#include "shapetonVoxelGrid.h"

#include <vector>

namespace shapeton
{
/** Gaussian smoothing with `sigma` in voxels; border values are repeated. */
std::vector<float>
SmoothedField(const VoxelGrid & grid, const std::vector<unsigned char> & values, double sigma);
} // namespace shapeton

#endif
