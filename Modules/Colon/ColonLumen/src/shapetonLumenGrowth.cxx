#include "shapetonLumenGrowth.h"

#include "shapetonParallelFor.h"

namespace shapeton
{
namespace
{
bool
IsGrowing(unsigned char c)
{
  return c >= ColonGas && c <= OtherBright;
}

bool
IsColon(unsigned char c)
{
  return c == ColonGas || c == ColonFluid;
}

/** The voxels of growing classes that touch one of another class. */
std::vector<std::size_t>
Front(const ColonGrid & grid, const ClassVolume & classes)
{
  std::vector<std::vector<std::size_t>> ofSlice(grid.size[2]);
  ParallelFor(grid.size[2], [&](std::size_t k) {
    for (std::size_t p = k * grid.stride[2]; p < (k + 1) * grid.stride[2]; ++p)
    {
      bool isFront = false;
      if (IsGrowing(classes[p]))
      {
        ForEachNeighbour(grid, p, [&](std::size_t q) { isFront = isFront || !IsGrowing(classes[q]); });
      }
      if (isFront)
      {
        ofSlice[k].push_back(p);
      }
    }
  });
  std::vector<std::size_t> front;
  for (const auto & slice : ofSlice)
  {
    front.insert(front.end(), slice.begin(), slice.end());
  }
  return front;
}
} // namespace

void
GrowClasses(const ColonGrid &                                               grid,
            ClassVolume &                                                   classes,
            int                                                             layers,
            const std::function<bool(std::size_t voxel, unsigned char c)> & mayEnter)
{
  auto front = Front(grid, classes);
  for (int layer = 0; layer < layers && !front.empty(); ++layer)
  {
    std::vector<std::size_t> next;
    for (const bool colon : { true, false })
    {
      for (const auto p : front)
      {
        if (IsColon(classes[p]) != colon)
        {
          continue;
        }
        ForEachNeighbour(grid, p, [&](std::size_t q) {
          if (!IsGrowing(classes[q]) && mayEnter(q, classes[p]))
          {
            classes[q] = classes[p];
            next.push_back(q);
          }
        });
      }
    }
    front.swap(next);
  }
}
} // namespace shapeton
