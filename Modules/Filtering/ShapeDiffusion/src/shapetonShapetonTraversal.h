#ifndef shapetonShapetonTraversal_h
#define shapetonShapetonTraversal_h

#include "shapetonShapetonKernels.h"

namespace shapeton
{
/** Moves shapetons by PathRule::Traversal: from a place drawn anew in their voxels along their directions, voxel by
 * voxel; each face lets them pass with the probability of its weight and reflects them otherwise, as the border of the
 * volume does. Shapetons without direction stay in their voxels. */
void
TraverseVoxels(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               const ShapetonKernels::Random &       random,
               const ShapetonKernels::Directions &   directions);
} // namespace shapeton

#endif
