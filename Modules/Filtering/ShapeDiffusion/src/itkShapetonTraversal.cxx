#include "itkShapetonTraversal.h"

#include "itkPhilox.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
/** The random numbers of one shapeton in one step beyond those of its direction, as many as are asked for. */
class Numbers
{
public:
  Numbers(const ShapetonKernels::Random & random, std::uint32_t shapeton)
    : m_Seed(random.seed)
    , m_Counter{ shapeton, static_cast<std::uint32_t>(random.step), static_cast<std::uint32_t>(random.step >> 32), 0 }
  {}

  /** In [0, 1). */
  float
  Next()
  {
    if (m_Used == 4)
    {
      ++m_Counter.d;
      m_Words = Philox4x32(m_Seed, m_Counter);
      m_Used = 0;
    }
    const std::uint32_t words[4] = { m_Words.a, m_Words.b, m_Words.c, m_Words.d };
    return UnitFloat(words[m_Used++]);
  }

private:
  std::uint64_t              m_Seed;
  PhiloxWords<std::uint32_t> m_Counter;
  PhiloxWords<std::uint32_t> m_Words{};
  unsigned int               m_Used{ 4 };
};

/** A shapeton on its way through one step. */
struct Path
{
  std::int32_t index[3];
  float        place[3]; ///< in the voxel, in [0, 1]
  float        way[3];   ///< of the whole step, in voxels
};

/** The axis of the face that is reached next, and the share of the step that it takes; 3 when none is reached within
 * `rest`. */
unsigned int
NextFace(const Path & path, float rest, float & share)
{
  unsigned int face = 3;
  share = rest;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const float way = path.way[axis];
    const float distance = way > 0.0F ? 1.0F - path.place[axis] : path.place[axis];
    const float need = way == 0.0F ? std::numeric_limits<float>::max() : distance / std::abs(way);
    if (need < share)
    {
      share = need;
      face = axis;
    }
  }
  return face;
}

void
Traverse(const ShapetonKernels::Surroundings & surroundings, Numbers & numbers, Path & path)
{
  std::size_t voxel =
    (static_cast<std::size_t>(path.index[2]) * surroundings.size[1] + path.index[1]) * surroundings.size[0] +
    path.index[0];
  const std::size_t strides[3] = { 1,
                                   static_cast<std::size_t>(surroundings.size[0]),
                                   static_cast<std::size_t>(surroundings.size[0]) * surroundings.size[1] };
  float             rest = 1.0F;
  for (;;)
  {
    float              share = 0.0F;
    const unsigned int face = NextFace(path, rest, share);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      path.place[axis] = std::clamp(path.place[axis] + share * path.way[axis], 0.0F, 1.0F);
    }
    if (face == 3)
    {
      return;
    }
    rest -= share;
    const bool          forwards = path.way[face] > 0.0F;
    const std::uint16_t weight =
      surroundings.records[voxel * ShapetonKernels::RecordLength + 2 * face + (forwards ? 1 : 0)];
    const std::int32_t next = path.index[face] + (forwards ? 1 : -1);
    const bool         inside = next >= 0 && next < surroundings.size[face];
    if (inside && numbers.Next() * 65535.0F < static_cast<float>(weight))
    {
      path.index[face] = next;
      path.place[face] = forwards ? 0.0F : 1.0F;
      voxel = forwards ? voxel + strides[face] : voxel - strides[face];
    }
    else
    {
      path.place[face] = forwards ? 1.0F : 0.0F;
      path.way[face] = -path.way[face];
    }
  }
}
} // namespace

void
TraverseVoxels(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               const ShapetonKernels::Random &       random,
               const ShapetonKernels::Directions &   directions)
{
  const auto * const size = surroundings.size;
  for (std::size_t i = 0; i < shapetons.number; ++i)
  {
    Numbers             numbers(random, shapetons.first + static_cast<std::uint32_t>(i));
    const std::uint32_t voxel = shapetons.voxel[i];
    Path                path = { { static_cast<std::int32_t>(voxel % size[0]),
                                   static_cast<std::int32_t>(voxel / size[0] % size[1]),
                                   static_cast<std::int32_t>(voxel / size[0] / size[1]) },
                                 {},
                                 { surroundings.step[0] * directions.x[i],
                                   surroundings.step[1] * directions.y[i],
                                   surroundings.step[2] * directions.z[i] } };
    for (float & place : path.place)
    {
      place = numbers.Next();
    }
    Traverse(surroundings, numbers, path);
    float * const places[3] = { shapetons.x + i, shapetons.y + i, shapetons.z + i };
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      // A place on the upper face of the voxel still belongs to it.
      *places[axis] = static_cast<float>(path.index[axis]) + std::min(path.place[axis], 0.999F);
    }
    shapetons.voxel[i] =
      (static_cast<std::uint32_t>(path.index[2]) * size[1] + path.index[1]) * size[0] + path.index[0];
  }
}
} // namespace itk
