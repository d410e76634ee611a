#ifndef shapetonTimeTiles_h
#define shapetonTimeTiles_h

#include "shapetonFlushToZero.h"
#include "shapetonPaddedGrid.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace shapeton
{
/** Rows along y and slices along z per tile of the sweep, and steps per visit. */
struct TimeTileShape
{
  std::ptrdiff_t y;
  std::ptrdiff_t z;
  unsigned int   steps;
};

/** Calls `operation(step, row)` for steps 1 .. `steps` and all rows of the grid, in an order that respects the stencil:
 * step s of a row follows step s-1 of the row and its four neighbors, and precedes their step s+1.
 *
 * Tiles of rows perform all steps while they are in the cache; each step shifts a tile by one row and one slice toward
 * the origin (time skewing), which limits dependencies to the tile and earlier tiles. Two alternating buffers are
 * sufficient. The result does not depend on the number of threads. */
template <typename TOperation>
void
RunTimeTiles(const PaddedGrid & grid, unsigned int steps, const TimeTileShape & shape, const TOperation & operation)
{
  const auto           ny = static_cast<std::ptrdiff_t>(grid.GetSize()[1]);
  const auto           nz = static_cast<std::ptrdiff_t>(grid.GetSize()[2]);
  const std::ptrdiff_t tilesY = (ny + steps + shape.y - 1) / shape.y;
  const std::ptrdiff_t tilesZ = (nz + steps + shape.z - 1) / shape.z;

  struct Tile
  {
    std::ptrdiff_t y;
    std::ptrdiff_t z;
  };
  std::vector<Tile> order; // by diagonals: the dependencies of a tile precede it
  for (std::ptrdiff_t diagonal = 0; diagonal < tilesY + tilesZ - 1; ++diagonal)
  {
    for (std::ptrdiff_t z = std::max<std::ptrdiff_t>(0, diagonal - tilesY + 1); z <= std::min(diagonal, tilesZ - 1);
         ++z)
    {
      order.push_back({ diagonal - z, z });
    }
  }
  std::vector<std::atomic<bool>> done(order.size());
  std::atomic<std::size_t>       next{ 0 };
  const auto                     waitFor = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
    while (y >= 0 && z >= 0 && !done[static_cast<std::size_t>(z * tilesY + y)].load(std::memory_order_acquire))
    {
      std::this_thread::yield();
    }
  };
  const auto runTile = [&](const Tile & tile) {
    for (unsigned int step = 1; step <= steps; ++step)
    {
      const std::ptrdiff_t firstZ = std::max<std::ptrdiff_t>(0, tile.z * shape.z - step);
      const std::ptrdiff_t endZ = std::min(nz, (tile.z + 1) * shape.z - step);
      const std::ptrdiff_t firstY = std::max<std::ptrdiff_t>(0, tile.y * shape.y - step);
      const std::ptrdiff_t endY = std::min(ny, (tile.y + 1) * shape.y - step);
      for (std::ptrdiff_t z = firstZ; z < endZ; ++z)
      {
        for (std::ptrdiff_t y = firstY; y < endY; ++y)
        {
          operation(step, grid.GetRow(y, z));
        }
      }
    }
  };
  // Tiles start in order, so the dependencies of a tile are complete or running. This avoids deadlocks even if the
  // threader starts fewer workers.
  const auto workers = std::min<std::size_t>(NumberOfThreads(), std::min(tilesY, tilesZ));
  ParallelWorkers(static_cast<unsigned int>(workers), [&](unsigned int) {
    const FlushToZero flushToZero;
    for (std::size_t i = next++; i < order.size(); i = next++)
    {
      const Tile & tile = order[i];
      waitFor(tile.y - 1, tile.z);
      waitFor(tile.y, tile.z - 1);
      runTile(tile);
      done[static_cast<std::size_t>(tile.z * tilesY + tile.y)].store(true, std::memory_order_release);
    }
  });
}
} // namespace shapeton

#endif
