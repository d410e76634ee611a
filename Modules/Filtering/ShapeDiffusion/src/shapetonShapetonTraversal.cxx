#include "shapetonShapetonTraversal.h"

#include "shapetonPhilox.h"
#include "shapetonPlaceInVoxel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace shapeton
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

/** A shapeton on its way through one step. */
struct Path
{
  Numbers       numbers;
  std::uint32_t shapeton;
  std::uint32_t voxel;
  float         rest; ///< share of the step that is left
  std::int32_t  index[3];
  float         place[3]; ///< in the voxel, in [0, 1]
  float         way[3];   ///< of the whole step, in voxels
};

/** The axis of the face that is reached next, and the share of the step that it takes; 3 when none is reached within
 * the rest. */
unsigned int
NextFace(const Path & path, float & share)
{
  unsigned int face = 3;
  share = path.rest;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const float way = path.way[axis];
    const float distance = way > 0.0F ? 1.0F - path.place[axis] : path.place[axis];
    const float need = way == 0.0F ? std::numeric_limits<float>::max() : distance / std::abs(way);
    face = need < share ? axis : face;
    share = need < share ? need : share;
  }
  return face;
}

const std::uint16_t *
RecordOf(const ShapetonKernels::Surroundings & surroundings, const Path & path)
{
  return surroundings.records + static_cast<std::size_t>(path.voxel) * ShapetonKernels::RecordLength;
}

/** Goes on to the next face and through it or back; false where the step ends before. */
bool
GoOn(const ShapetonKernels::Surroundings & surroundings, Path & path)
{
  float              share = 0.0F;
  const unsigned int face = NextFace(path, share);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    path.place[axis] = std::clamp(path.place[axis] + share * path.way[axis], 0.0F, 1.0F);
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
  if (inside && path.numbers.Next() * 65535.0F < static_cast<float>(weight))
  {
    const std::int32_t strides[3] = { 1, surroundings.size[0], surroundings.size[0] * surroundings.size[1] };
    path.index[face] = next;
    path.place[face] = forwards ? 0.0F : 1.0F;
    path.voxel += static_cast<std::uint32_t>(forwards ? strides[face] : -strides[face]);
    __builtin_prefetch(RecordOf(surroundings, path));
  }
  else
  {
    path.place[face] = forwards ? 1.0F : 0.0F;
    path.way[face] = -path.way[face];
  }
  return true;
}

Path
Begin(const ShapetonKernels::Surroundings & surroundings,
      const ShapetonKernels::Shapetons &    shapetons,
      std::size_t                           i,
      const ShapetonKernels::Random &       random,
      const ShapetonKernels::Directions &   directions)
{
  const auto * const  size = surroundings.size;
  const std::uint32_t voxel = shapetons.voxel[i];
  Path                path = { Numbers(random, shapetons.first + static_cast<std::uint32_t>(i)),
                               static_cast<std::uint32_t>(i),
                               voxel,
                               1.0F,
                               { static_cast<std::int32_t>(voxel % size[0]),
                                 static_cast<std::int32_t>(voxel / size[0] % size[1]),
                                 static_cast<std::int32_t>(voxel / size[0] / size[1]) },
                               {},
                               { surroundings.step[0] * directions.x[i],
                                 surroundings.step[1] * directions.y[i],
                                 surroundings.step[2] * directions.z[i] } };
  __builtin_prefetch(RecordOf(surroundings, path));
  for (float & place : path.place)
  {
    place = path.numbers.Next();
  }
  return path;
}

void
End(const ShapetonKernels::Surroundings & surroundings, const ShapetonKernels::Shapetons & shapetons, const Path & path)
{
  float * const places[3] = { shapetons.x, shapetons.y, shapetons.z };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    places[axis][path.shapeton] = PlaceInVoxel(static_cast<std::uint32_t>(path.index[axis]), path.place[axis]);
  }
  shapetons.voxel[path.shapeton] = path.voxel;
  __builtin_prefetch(surroundings.visits + path.voxel, 1);
}
} // namespace

void
TraverseVoxels(const ShapetonKernels::Surroundings & surroundings,
               const ShapetonKernels::Shapetons &    shapetons,
               const ShapetonKernels::Random &       random,
               const ShapetonKernels::Directions &   directions)
{
  // Many shapetons pass one face each in turn: the record that one needs next is fetched while the others move.
  constexpr std::size_t together = 64;
  std::vector<Path>     paths;
  paths.reserve(together);
  for (std::size_t first = 0; first < shapetons.number; first += together)
  {
    const std::size_t number = std::min(together, shapetons.number - first);
    for (std::size_t i = first; i < first + number; ++i)
    {
      paths.push_back(Begin(surroundings, shapetons, i, random, directions));
    }
    while (!paths.empty())
    {
      for (std::size_t k = 0; k < paths.size();)
      {
        if (GoOn(surroundings, paths[k]))
        {
          ++k;
          continue;
        }
        End(surroundings, shapetons, paths[k]);
        paths[k] = paths.back();
        paths.pop_back();
      }
    }
  }
}
} // namespace shapeton
