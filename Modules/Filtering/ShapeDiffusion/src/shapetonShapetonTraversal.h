#ifndef shapetonShapetonTraversal_h
#define shapetonShapetonTraversal_h

#include "shapetonShapetonKernels.h"

namespace shapeton
{
/** Moves shapetons by PathRule::Traversal: from a random position in their voxels along their directions, voxel by
 * voxel. Each face transmits them with the probability of its weight and reflects them otherwise, as does the
 * border of the volume. Shapetons without direction stay in their voxels. */
void
TraverseVoxels(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               const ShapetonKernels::Random &       random,
               const ShapetonKernels::Directions &   directions);
} // namespace shapeton

#endif
