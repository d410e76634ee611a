#ifndef shapetonParticleTraversal_h
#define shapetonParticleTraversal_h

#include "shapetonParticleKernels.h"

namespace shapeton
{
/** Moves shapetons by PathRule::Traversal: from a random position in their voxels along their directions, voxel by
 * voxel. Each face transmits them with the probability of its weight and reflects them otherwise, as does the
 * border of the volume. Shapetons without direction stay in their voxels. */
void
TraverseVoxels(const ParticleKernels::Surroundings & surroundings,
               const ParticleKernels::Shapetons &    shapetons,
               const ParticleKernels::Random &       random,
               const ParticleKernels::Directions &   directions);
} // namespace shapeton

#endif
