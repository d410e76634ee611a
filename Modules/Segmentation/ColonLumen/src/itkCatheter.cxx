#include "itkCatheter.h"

#include "itkRuns.h"

namespace itk
{
namespace
{
constexpr double LargestIsland = 250.0; // mm^2
constexpr double TipLength = 4.0;       // mm

bool
IsLumen(unsigned char c)
{
  return c == ColonGas || c == ColonFluid;
}

/** Parts of slices outside the lumen. */
struct Islands
{
  RunSet            set;
  RunLabels         labels;
  std::vector<char> isSmall; ///< enclosed by lumen in its slice
  std::vector<char> hasGas;
};

Islands
FindIslands(const ColonGrid & grid, const std::vector<float> & hu, double gasBoundary, const ClassVolume & classes)
{
  Islands islands;
  islands.set = CollectRuns(grid, [&](std::size_t p) { return !IsLumen(classes[p]); });
  islands.labels = LabelRuns(islands.set, false);
  islands.isSmall.assign(islands.labels.number + 1, 1);
  islands.hasGas.assign(islands.labels.number + 1, 0);
  std::vector<double> area(islands.labels.number + 1, 0.0);
  ForEachRun(islands.set, [&](std::size_t r, int j, int k) {
    const int island = islands.labels.ofRun[r];
    const Run run = islands.set.runs[r];
    area[island] += (run.end - run.begin) * grid.spacing[0] * grid.spacing[1];
    if (run.begin == 0 || run.end == grid.size[0] || j == 0 || j + 1 == grid.size[1] || area[island] > LargestIsland)
    {
      islands.isSmall[island] = 0;
    }
    for (int i = run.begin; i < run.end && islands.isSmall[island]; ++i)
    {
      islands.hasGas[island] = islands.hasGas[island] || hu[grid.Index(i, j, k)] < gasBoundary;
    }
  });
  return islands;
}

/** Small islands over or under one that is taken are taken, too, slice by slice up to the tip. */
void
TakeTips(const ColonGrid & grid, const Islands & islands, std::vector<char> & taken)
{
  for (int step = 0; step * grid.spacing[2] < TipLength; ++step)
  {
    const auto before = taken;
    for (int k = 1; k < grid.size[2]; ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        const auto take = [&](std::size_t r, std::size_t s, int) {
          const int a = islands.labels.ofRun[r];
          const int b = islands.labels.ofRun[s];
          taken[a] = taken[a] || (before[b] && islands.isSmall[a]);
          taken[b] = taken[b] || (before[a] && islands.isSmall[b]);
        };
        ForEachOverlap(islands.set, islands.set.Row(j, k - 1), islands.set.Row(j, k), take);
      }
    }
  }
}
} // namespace

void
FillCatheter(const ColonGrid & grid, const std::vector<float> & hu, double gasBoundary, ClassVolume & classes)
{
  const Islands     islands = FindIslands(grid, hu, gasBoundary, classes);
  std::vector<char> taken(islands.isSmall.size(), 0);
  for (std::size_t i = 1; i < taken.size(); ++i)
  {
    taken[i] = islands.isSmall[i] && islands.hasGas[i];
  }
  TakeTips(grid, islands, taken);
  ForEachRun(islands.set, [&](std::size_t r, int j, int k) {
    if (taken[islands.labels.ofRun[r]])
    {
      const auto first = grid.Index(0, j, k);
      std::fill(classes.begin() + first + islands.set.runs[r].begin,
                classes.begin() + first + islands.set.runs[r].end,
                ColonGas);
    }
  });
}
} // namespace itk
