#ifndef VoxelMorphology_h
#define VoxelMorphology_h

#include "shapetonVoxelGrid.h"

#include <vector>

/** One value per voxel of a grid: 1 inside, 0 outside. */
using VoxelMask = std::vector<unsigned char>;

/** The voxels that are in the mask and whose face neighbors are; `times` times. The border of the volume does not
 * erode. */
VoxelMask
Eroded(VoxelMask mask, const shapeton::VoxelGrid & grid, int times = 1);

/** The mask and its face neighbors. */
VoxelMask
Dilated(const VoxelMask & mask, const shapeton::VoxelGrid & grid);

#endif
