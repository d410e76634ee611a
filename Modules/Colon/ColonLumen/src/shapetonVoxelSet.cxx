#include "shapetonVoxelSet.h"

#include <algorithm>

namespace shapeton
{
namespace
{
bool
Contains(const VoxelSet & voxels, std::size_t voxel)
{
  return std::binary_search(voxels.begin(), voxels.end(), voxel);
}

/** Voxels around which the ball fits. */
VoxelSet
WideVoxels(const ColonGrid &                        grid,
           const VoxelSet &                         voxels,
           double                                   radius,
           const std::function<bool(std::size_t)> & isOpen)
{
  VoxelSet wide;
  for (const auto p : voxels)
  {
    if (ForAllWithin(grid, p, radius, [&](std::size_t q, double squaredDistance) {
          return squaredDistance > radius * radius || isOpen(q) || Contains(voxels, q);
        }))
    {
      wide.push_back(p);
    }
  }
  return wide;
}
} // namespace

std::vector<std::vector<std::size_t>>
ConnectedPieces(const ColonGrid & grid, const VoxelSet & voxels, const VoxelParts & parts)
{
  const auto part = [&](std::size_t p) {
    const auto found = parts.find(p);
    return found == parts.end() ? 0 : found->second;
  };
  std::unordered_map<std::size_t, char> isLeft;
  for (const auto p : voxels)
  {
    isLeft[p] = 1;
  }
  std::vector<std::vector<std::size_t>> pieces;
  for (const auto first : voxels)
  {
    if (!isLeft[first])
    {
      continue;
    }
    pieces.push_back({ first });
    auto & piece = pieces.back();
    isLeft[first] = 0;
    for (std::size_t n = 0; n < piece.size(); ++n)
    {
      ForEachNeighbour(grid, piece[n], [&](std::size_t q) {
        const auto found = isLeft.find(q);
        if (found != isLeft.end() && found->second && part(q) == part(first))
        {
          found->second = 0;
          piece.push_back(q);
        }
      });
    }
  }
  return pieces;
}

VoxelParts
PartsAtNecks(const ColonGrid &                        grid,
             const VoxelSet &                         voxels,
             double                                   radius,
             const std::function<bool(std::size_t)> & isOpen)
{
  VoxelParts               parts;
  std::vector<std::size_t> queue;
  int                      number = 0;
  for (const auto & piece : ConnectedPieces(grid, WideVoxels(grid, voxels, radius, isOpen)))
  {
    ++number;
    for (const auto p : piece)
    {
      parts[p] = number;
      queue.push_back(p);
    }
  }
  for (std::size_t n = 0; n < queue.size(); ++n)
  {
    const int own = parts[queue[n]];
    ForEachNeighbour(grid, queue[n], [&](std::size_t q) {
      if (Contains(voxels, q) && parts.emplace(q, own).second)
      {
        queue.push_back(q);
      }
    });
  }
  return parts;
}
} // namespace shapeton
