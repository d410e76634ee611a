#ifndef shapetonLumenVoxels_h
#define shapetonLumenVoxels_h

#include "shapetonColonSearch.h"

namespace shapeton
{
/** The voxels of the lumen in the part of the volume around it. */
struct LumenVoxels
{
  ColonGrid          grid;
  std::vector<float> hu;
  ClassVolume        classes;
  std::vector<Level> levels; ///< of the colon; floors are voxels of `grid`
};

/** Decides voxel by voxel. Takes the intensities out of `evidence` to save memory, and marks there the pieces of gas
 * that turn out to be colon because they lie over its fluid. */
LumenVoxels
DecideVoxels(const ColonImage * image, ColonEvidence & evidence);
} // namespace shapeton

#endif
