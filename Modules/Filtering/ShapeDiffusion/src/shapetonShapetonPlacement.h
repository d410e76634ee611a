#ifndef shapetonShapetonPlacement_h
#define shapetonShapetonPlacement_h

#include "shapetonShapetonKernels.h"
#include "shapetonShapetonRecords.h"

#include <cstdint>

namespace shapeton
{
/** Places shapetons uniformly in the volume. */
void
PlaceUniformly(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               std::uint64_t                         seed);

/** Places shapetons in voxels uniformly, or in proportion to their initial heat, where `mask` (may be null) is not
 * 0. Throws std::domain_error if there is no such voxel. */
void
PlaceByDensity(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               std::uint64_t                         seed,
               const ShapetonRecords &               records,
               bool                                  byInitialHeat,
               const unsigned char *                 mask);
} // namespace shapeton

#endif
