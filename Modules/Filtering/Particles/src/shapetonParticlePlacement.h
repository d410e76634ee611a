#ifndef shapetonParticlePlacement_h
#define shapetonParticlePlacement_h

#include "shapetonParticleKernels.h"
#include "shapetonParticleRecords.h"

#include <cstdint>

namespace shapeton
{
/** Places shapetons uniformly in the volume. */
void
PlaceUniformly(const ParticleKernels::Surroundings & surroundings,
               const ParticleKernels::Shapetons &    shapetons,
               std::uint64_t                         seed);

/** Places shapetons in voxels uniformly, or in proportion to their initial heat, where `mask` (may be null) is not 0.
 * Throws InputError if no voxel is found. */
void
PlaceByDensity(const ParticleKernels::Surroundings & surroundings,
               const ParticleKernels::Shapetons &    shapetons,
               std::uint64_t                         seed,
               const ParticleRecords &               records,
               bool                                  byInitialHeat,
               const unsigned char *                 mask);
} // namespace shapeton

#endif
