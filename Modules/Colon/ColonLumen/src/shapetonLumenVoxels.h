#ifndef shapetonLumenVoxels_h
#define shapetonLumenVoxels_h

#include "shapetonLumenField.h"

#include <optional>

namespace shapeton
{
/** The voxels of the lumen in the part of the volume around it. */
struct LumenVoxels
{
  ColonGrid          grid;
  VoxelValues        hu;
  ClassVolume        classes;
  std::vector<Level> levels; ///< levels of the colon; floors are voxels of `grid`

  std::optional<RectalCatheter> catheter;
};

/** Classifies voxels. Moves the intensities from `evidence` to save memory, and marks in it additional pieces of gas
 * above the fluid of the colon. */
LumenVoxels
DecideVoxels(const ColonImage * image, ColonEvidence & evidence);
} // namespace shapeton

#endif
