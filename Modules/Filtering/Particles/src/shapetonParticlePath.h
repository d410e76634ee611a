#ifndef shapetonParticlePath_h
#define shapetonParticlePath_h

#include "shapetonPhilox.h"
#include "shapetonParticleKernels.h"

namespace shapeton
{
/** A step by PathRule::Traversal, for the CPU and for the kernels of a GPU: see TraverseVoxels(). */
namespace ParticleKernels
{
/** The random numbers of a shapeton in a step, except for its direction; drawn on demand. */
class Numbers
{
public:
  SHAPETON_HOST_DEVICE
  Numbers(const Random & random, std::uint32_t shapeton)
    : m_Seed(random.seed)
    , m_Counter{ shapeton, static_cast<std::uint32_t>(random.step), static_cast<std::uint32_t>(random.step >> 32), 0 }
  {}

  /** Uniform in [0, 1). */
  SHAPETON_HOST_DEVICE float
  Next()
  {
    if (m_Used == 4)
    {
      ++m_Counter.d;
      const auto words = Philox4x32(m_Seed, m_Counter);
      m_Numbers[0] = UnitFloat(words.a);
      m_Numbers[1] = UnitFloat(words.b);
      m_Numbers[2] = UnitFloat(words.c);
      m_Numbers[3] = UnitFloat(words.d);
      m_Used = 0;
    }
    return m_Numbers[m_Used++];
  }

private:
  std::uint64_t              m_Seed;
  PhiloxWords<std::uint32_t> m_Counter;
  float                      m_Numbers[4]{};
  unsigned int               m_Used{ 4 };
};

/** A shapeton during one step. */
struct Path
{
  Numbers       numbers;
  std::uint32_t voxel;
  float         rest; ///< remaining share of the step
  std::int32_t  index[3];
  float         place[3]; ///< position in the voxel, in [0, 1]
  float         way[3];   ///< displacement of the whole step, in voxels
};

/** The axis of the next face, and the fraction of the step needed to reach it; 3 if none is reached within the
 * remaining step. */
SHAPETON_HOST_DEVICE unsigned int
NextFace(const Path & path, float & share)
{
  unsigned int face = 3;
  share = path.rest;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const float     way = path.way[axis];
    const float     distance = way > 0.0F ? 1.0F - path.place[axis] : path.place[axis];
    constexpr float never = 3.402823466e38F; // largest float
    const float     need = way == 0.0F ? never : distance / (way < 0.0F ? -way : way);
    face = need < share ? axis : face;
    share = need < share ? need : share;
  }
  return face;
}

SHAPETON_HOST_DEVICE const std::uint16_t *
                           RecordOf(const Surroundings & surroundings, const Path & path)
{
  return surroundings.records + static_cast<std::size_t>(path.voxel) * RecordLength;
}

/** Advances to the next face, then passes through it or turns back; false if the step ends before the face. */
SHAPETON_HOST_DEVICE bool
GoOn(const Surroundings & surroundings, Path & path)
{
  float              share = 0.0F;
  const unsigned int face = NextFace(path, share);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const float place = path.place[axis] + share * path.way[axis];
    path.place[axis] = place < 0.0F ? 0.0F : place > 1.0F ? 1.0F : place;
  }
  if (face == 3)
  {
    return false;
  }
  path.rest -= share;
  const bool          forwards = path.way[face] > 0.0F;
  const std::uint16_t weight = RecordOf(surroundings, path)[2 * face + (forwards ? 1 : 0)];
  const std::int32_t  next = path.index[face] + (forwards ? 1 : -1);
  const bool          inside = next >= 0 && next < surroundings.size[face];
  constexpr float     greatestWeight = 65535.0F;
  if (inside && path.numbers.Next() * greatestWeight < static_cast<float>(weight))
  {
    const std::int32_t strides[3] = { 1, surroundings.size[0], surroundings.size[0] * surroundings.size[1] };
    path.index[face] = next;
    path.place[face] = forwards ? 0.0F : 1.0F;
    path.voxel += static_cast<std::uint32_t>(forwards ? strides[face] : -strides[face]);
    SHAPETON_PREFETCH(RecordOf(surroundings, path));
  }
  else
  {
    path.place[face] = forwards ? 1.0F : 0.0F;
    path.way[face] = -path.way[face];
  }
  return true;
}

/** `direction`: a unit vector. */
SHAPETON_HOST_DEVICE Path
Begin(const Surroundings & surroundings,
      std::uint32_t        shapeton,
      std::uint32_t        voxel,
      const Random &       random,
      const float          direction[3])
{
  const auto * const size = surroundings.size;
  Path               path = {
                  Numbers(random, shapeton),
                  voxel,
                  1.0F,
                  { static_cast<std::int32_t>(voxel % size[0]),
                    static_cast<std::int32_t>(voxel / size[0] % size[1]),
                    static_cast<std::int32_t>(voxel / size[0] / size[1]) },
                  {},
                  { surroundings.step[0] * direction[0], surroundings.step[1] * direction[1], surroundings.step[2] * direction[2] }
  };
  SHAPETON_PREFETCH(RecordOf(surroundings, path));
  for (float & place : path.place)
  {
    place = path.numbers.Next();
  }
  return path;
}
} // namespace ParticleKernels
} // namespace shapeton

#endif
