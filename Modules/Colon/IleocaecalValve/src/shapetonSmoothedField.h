#ifndef shapetonSmoothedField_h
#define shapetonSmoothedField_h

#include "shapetonVoxelGrid.h"

#include <vector>

namespace shapeton
{
/** The values of cubic voxels smoothed by a Gaussian of `sigma` voxels; the border value goes on beyond the border. */
std::vector<float>
SmoothedField(const VoxelGrid & grid, const std::vector<unsigned char> & values, double sigma);
} // namespace shapeton

#endif
