#ifndef shapetonParticleTally_h
#define shapetonParticleTally_h

#include "shapetonHostDevice.h"

#include <cstdint>

namespace shapeton
{
/** Sums updated with each visit. `old` is the count before a visit; the sums do not depend on the order of visits. */
struct ParticleTally
{
  std::uint64_t sumOfOld{ 0 };
  std::uint32_t maximum{ 0 };
  std::uint64_t reached{ 0 };
  std::uint64_t objectsReached{ 0 };

  SHAPETON_HOST_DEVICE void
  Add(const ParticleTally & other)
  {
    sumOfOld += other.sumOfOld;
    maximum = other.maximum > maximum ? other.maximum : maximum;
    reached += other.reached;
    objectsReached += other.objectsReached;
  }

  /** Adds a visit; `isObject`: whether the voxel counts toward the coverage. */
  SHAPETON_HOST_DEVICE void
  Count(std::uint32_t old, bool isObject)
  {
    sumOfOld += old;
    maximum = old + 1 > maximum ? old + 1 : maximum;
    reached += old == 0 ? 1 : 0;
    objectsReached += old == 0 && isObject ? 1 : 0;
  }
};

/** The visits of the current voxels, summed over the shapetons, and the number of trapped shapetons. */
struct ParticleSum
{
  std::uint64_t visits{ 0 };
  std::uint32_t trapped{ 0 };

  SHAPETON_HOST_DEVICE void
  Add(const ParticleSum & other)
  {
    visits += other.visits;
    trapped += other.trapped;
  }
};
} // namespace shapeton

#endif
