#include "shapetonLumenField.h"

#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
bool
IsGrowing(unsigned char c)
{
  return c >= ColonGas && c <= OtherBright;
}

/** The voxels of growing classes that are next to a voxel of another class. */
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
        ForEachNeighbor(grid, p, [&](std::size_t q) { isFront = isFront || !IsGrowing(classes[q]); });
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
      Interruption::Check();
      for (const auto p : front)
      {
        if (IsColonLumen(classes[p]) != colon)
        {
          continue;
        }
        ForEachNeighbor(grid, p, [&](std::size_t q) {
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

LumenField::LumenField(ColonEvidence & colonEvidence)
  : evidence(colonEvidence)
  , box(BoxOfColon(colonEvidence))
  , grid(colonEvidence.grid.Part(box))
  , hu(CropVoxels(colonEvidence.hu, colonEvidence.grid, box))
  , classes(grid.NumberOfVoxels(), Nothing)
  , fall(grid, colonEvidence.gravity)
{
  VoxelValues().swap(colonEvidence.hu);
}

void
LumenField::Fill(const VoxelRun & run, int j, int k, unsigned char voxelClass)
{
  const int begin = std::max(run.begin, box.low[0]);
  const int end = std::min(run.end, box.high[0]);
  if (begin < end && j >= box.low[1] && j < box.high[1] && k >= box.low[2] && k < box.high[2])
  {
    const auto first = classes.begin() + grid.Index(begin - box.low[0], j - box.low[1], k - box.low[2]);
    std::fill(first, first + (end - begin), voxelClass);
  }
}

bool
LumenField::Local(std::size_t whole, std::array<int, 3> & v) const
{
  v = evidence.grid.Voxel(whole);
  for (int a = 0; a < 3; ++a)
  {
    v[a] -= box.low[a];
  }
  return grid.Holds(v[0], v[1], v[2]);
}

std::ptrdiff_t
LumenField::Below(const std::array<int, 3> & v, int t) const
{
  const auto o = fall.Offset(t);
  return grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2])
           ? static_cast<std::ptrdiff_t>(grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
           : -1;
}

double
LumenField::FluidReach() const
{
  constexpr double least = 5.0; // mm; chosen
  return std::max(least, StepsToFluid * fall.step);
}

double
LumenField::Blur() const
{
  return std::sqrt(UsualBlur * UsualBlur + evidence.smoothing * evidence.smoothing + UniformVariance(fall.step));
}

bool
LumenField::LiesOnColonFluid(const Level & level) const
{
  std::size_t hits = 0;
  for (const auto floor : level.voxels)
  {
    std::array<int, 3> v;
    bool               isOnFluid = false;
    for (int t = 1; this->Local(floor, v) && t * fall.step <= this->FluidReach() && !isOnFluid; ++t)
    {
      const auto q = this->Below(v, t);
      isOnFluid = q >= 0 && classes[q] == ColonFluid;
    }
    hits += isOnFluid;
  }
  return 2 * hits > level.voxels.size();
}

std::vector<Level>
LumenField::ColonLevels() const
{
  std::vector<Level> levels;
  for (const auto & level : evidence.levels)
  {
    if (evidence.isColon[level.gas] && this->LiesOnColonFluid(level))
    {
      levels.push_back(level);
    }
  }
  return levels;
}
} // namespace shapeton
