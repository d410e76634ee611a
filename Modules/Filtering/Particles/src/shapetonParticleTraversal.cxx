#include "shapetonParticleTraversal.h"

#include "shapetonPlaceInVoxel.h"
#include "shapetonParticlePath.h"

#include <algorithm>
#include <vector>

namespace shapeton
{
using namespace ParticleKernels;

namespace
{
struct PathOfOne
{
  Path        path;
  std::size_t shapeton;
};

void
End(const Surroundings & surroundings, const Shapetons & shapetons, const PathOfOne & one)
{
  float * const places[3] = { shapetons.x, shapetons.y, shapetons.z };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    places[axis][one.shapeton] = PlaceInVoxel(static_cast<std::uint32_t>(one.path.index[axis]), one.path.place[axis]);
  }
  shapetons.voxel[one.shapeton] = one.path.voxel;
  __builtin_prefetch(surroundings.visits + one.path.voxel, 1);
}
} // namespace

void
TraverseVoxels(const Surroundings & surroundings,
               const Shapetons &    shapetons,
               const Random &       random,
               const Directions &   directions)
{
  // Shapetons pass one face each in turn; the next record of each is prefetched while the others move.
  constexpr std::size_t  together = 64;
  std::vector<PathOfOne> paths;
  paths.reserve(together);
  for (std::size_t first = 0; first < shapetons.number; first += together)
  {
    const std::size_t number = std::min(together, shapetons.number - first);
    for (std::size_t i = first; i < first + number; ++i)
    {
      const float direction[3] = { directions.x[i], directions.y[i], directions.z[i] };
      const auto  shapeton = shapetons.first + static_cast<std::uint32_t>(i);
      paths.push_back({ Begin(surroundings, shapeton, shapetons.voxel[i], random, direction), i });
    }
    while (!paths.empty())
    {
      for (std::size_t k = 0; k < paths.size();)
      {
        if (GoOn(surroundings, paths[k].path))
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
