#include "shapetonHollowIslands.h"

#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double LargestIsland = 250.0; // mm^2; chosen: a section of 18 mm
constexpr double TipLength = 4.0;       // mm; chosen
constexpr double LargestBore = 80.0;    // mm^2; chosen: a bore of 10 mm
constexpr double WallThickness = 1.0;   // mm; chosen
constexpr double CanalReach = 60.0;     // mm below the gas of the rectum; chosen longer than the anal canal (40 mm)
constexpr double RingWidth = 4.0;       // mm around the catheter; chosen
constexpr double LeastBody = 0.75;      // minimum fraction of the ring in tissue or lumen

/** Connected parts of the slices outside the lumen. */
struct Islands
{
  VoxelRuns         set;
  RunLabels         labels;
  std::vector<char> isSmall; ///< small and enclosed by lumen in the slice
  std::vector<char> hasGas;
};

Islands
FindIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, const ClassVolume & classes)
{
  Islands islands;
  islands.set = CollectRuns(grid, [&](std::size_t p) { return !IsColonLumen(classes[p]); });
  islands.labels = LabelRuns(islands.set, VoxelContact::FaceInSlice);
  islands.isSmall.assign(islands.labels.number + 1, 1);
  islands.hasGas.assign(islands.labels.number + 1, 0);
  std::vector<double> area(islands.labels.number + 1, 0.0);
  ForEachRun(islands.set, [&](std::size_t r, int j, int k) {
    const int      island = islands.labels.ofRun[r];
    const VoxelRun run = islands.set.runs[r];
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

/** Adds small islands above or below accepted ones, slice by slice, up to the tip. */
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

/** Follows the gas of the catheter slice by slice from the rectum down the anal canal until it leaves the body. */
class CanalWalk
{
public:
  CanalWalk(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes)
    : m_Grid(grid), m_Hu(hu), m_GasBoundary(gasBoundary), m_Classes(classes), m_State(grid.stride[2], Unseen)
  {}

  /** \param bore gas of the catheter in a slice where it is enclosed by lumen. */
  void
  Walk(std::vector<std::size_t> bore)
  {
    const int caudal = m_Grid.axes(2, 2) > 0.0 ? -1 : 1;
    const int steps = static_cast<int>(CanalReach / m_Grid.spacing[2]);
    int       slice = bore.empty() ? -1 : m_Grid.Voxel(bore.front())[2];
    for (int step = 0; step < steps; ++step)
    {
      slice += caudal;
      if (slice < 0 || slice >= m_Grid.size[2])
      {
        return;
      }
      bore = this->NextBore(bore, slice);
      if (bore.empty() || !this->LiesInBody(bore))
      {
        return;
      }
      this->Fill(bore);
    }
  }

private:
  enum State : char
  {
    Unseen,
    Seen
  };

  /** Gas outside the lumen: gas in the catheter or outside air. */
  bool
  IsOtherGas(std::size_t p) const
  {
    return m_Hu[p] < m_GasBoundary && !IsColonLumen(m_Classes[p]);
  }

  /** Dilation of voxels within their slice. */
  std::vector<std::size_t>
  Around(const std::vector<std::size_t> & voxels, double distance)
  {
    std::vector<std::size_t> found;
    const int                ri = static_cast<int>(distance / m_Grid.spacing[0]);
    const int                rj = static_cast<int>(distance / m_Grid.spacing[1]);
    for (const auto p : voxels)
    {
      const auto v = m_Grid.Voxel(p);
      for (int j = std::max(0, v[1] - rj); j <= std::min(m_Grid.size[1] - 1, v[1] + rj); ++j)
      {
        for (int i = std::max(0, v[0] - ri); i <= std::min(m_Grid.size[0] - 1, v[0] + ri); ++i)
        {
          const auto q = m_Grid.Index(i, j, v[2]);
          const bool isNear = std::hypot((i - v[0]) * m_Grid.spacing[0], (j - v[1]) * m_Grid.spacing[1]) <= distance;
          if (isNear && m_State[q % m_Grid.stride[2]] == Unseen)
          {
            m_State[q % m_Grid.stride[2]] = Seen;
            found.push_back(q);
          }
        }
      }
    }
    this->Forget(found);
    return found;
  }

  void
  Forget(const std::vector<std::size_t> & voxels)
  {
    for (const auto p : voxels)
    {
      m_State[p % m_Grid.stride[2]] = Unseen;
    }
  }

  /** Gas in this slice adjacent to the bore in the previous slice; empty if it is too large for a bore. */
  std::vector<std::size_t>
  NextBore(const std::vector<std::size_t> & bore, int slice)
  {
    const auto               most = static_cast<std::size_t>(LargestBore / (m_Grid.spacing[0] * m_Grid.spacing[1]));
    std::vector<std::size_t> next;
    const auto               take = [&](std::size_t q) {
      if (this->IsOtherGas(q) && m_State[q % m_Grid.stride[2]] == Unseen)
      {
        m_State[q % m_Grid.stride[2]] = Seen;
        next.push_back(q);
      }
    };
    for (const auto p : bore)
    {
      take(p % m_Grid.stride[2] + slice * m_Grid.stride[2]);
    }
    for (std::size_t n = 0; n < next.size() && next.size() <= most; ++n)
    {
      const auto v = m_Grid.Voxel(next[n]);
      for (const auto & d : { std::array<int, 2>{ -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } })
      {
        if (m_Grid.Holds(v[0] + d[0], v[1] + d[1], v[2]))
        {
          take(m_Grid.Index(v[0] + d[0], v[1] + d[1], v[2]));
        }
      }
    }
    this->Forget(next);
    return next.size() <= most ? next : std::vector<std::size_t>{};
  }

  bool
  LiesInBody(const std::vector<std::size_t> & bore)
  {
    const auto   around = this->Around(bore, WallThickness + RingWidth);
    const auto   gas = std::count_if(around.begin(), around.end(), [&](auto p) { return this->IsOtherGas(p); });
    const double ring = static_cast<double>(around.size() - bore.size());
    return static_cast<double>(around.size() - gas) >= LeastBody * ring;
  }

  void
  Fill(const std::vector<std::size_t> & bore)
  {
    for (const auto p : this->Around(bore, WallThickness + 0.5 * std::min(m_Grid.spacing[0], m_Grid.spacing[1])))
    {
      m_Classes[p] = IsColonLumen(m_Classes[p]) ? m_Classes[p] : static_cast<unsigned char>(ColonGas);
    }
  }

  const ColonGrid &   m_Grid;
  const VoxelValues & m_Hu;
  double              m_GasBoundary;
  ClassVolume &       m_Classes;
  std::vector<char>   m_State; ///< of the voxels of one slice
};
} // namespace

void
FillHollowIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes)
{
  const Islands     islands = FindIslands(grid, hu, gasBoundary, classes);
  std::vector<char> taken(islands.isSmall.size(), 0);
  for (std::size_t i = 1; i < taken.size(); ++i)
  {
    taken[i] = islands.isSmall[i] && islands.hasGas[i];
  }
  TakeTips(grid, islands, taken);
  // Gas of the catheter in each slice where it is enclosed by lumen.
  std::vector<std::vector<std::size_t>> bores(taken.size());
  ForEachRun(islands.set, [&](std::size_t r, int j, int k) {
    const int island = islands.labels.ofRun[r];
    for (int i = islands.set.runs[r].begin; i < islands.set.runs[r].end && taken[island]; ++i)
    {
      const auto p = grid.Index(i, j, k);
      classes[p] = ColonGas;
      if (hu[p] < gasBoundary)
      {
        bores[island].push_back(p);
      }
    }
  });
  CanalWalk walk(grid, hu, gasBoundary, classes);
  for (auto & bore : bores)
  {
    walk.Walk(std::move(bore));
  }
}
} // namespace shapeton
