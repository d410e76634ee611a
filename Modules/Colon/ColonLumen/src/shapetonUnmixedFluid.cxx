#include "shapetonUnmixedFluid.h"

#include "shapetonColonStatistics.h"
#include "shapetonVoxelSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
constexpr double LeastContrast = 100.0; // HU above tissue
constexpr double Plateau = 0.75;        // of a core's contrast: a wall in between goes below it
constexpr double GreatestDepth = 15.0;  // mm, a core's volume by its open contact with the fluid
constexpr double LeastCoreMl = 0.05;
constexpr double NeckRadius = 2.5; // mm; what hangs on more narrowly is judged alone

struct Arrival
{
  float       faintest; ///< mean value on the way
  std::size_t voxel;

  bool
  operator<(const Arrival & other) const
  {
    return faintest != other.faintest ? faintest < other.faintest : voxel > other.voxel;
  }
};

class UnmixedFluid
{
public:
  UnmixedFluid(const ColonGrid &          grid,
               const std::vector<float> & hu,
               const std::vector<float> & sharp,
               const ColonThresholds &    thresholds,
               double                     noise,
               double                     smoothing,
               ClassVolume &              classes)
    : m_Grid(grid)
    , m_Hu(hu)
    , m_Sharp(sharp)
    , m_Least(thresholds.tissue +
              std::max(LeastContrast, ShareInWall(grid, smoothing) * (thresholds.fluid - thresholds.tissue)))
    , m_Tissue(thresholds.tissue)
    , m_Tolerance(10.0 + 0.5 * noise)
    , m_Voxel(std::max(1.0, std::cbrt(grid.VoxelVolume())))
    , m_Classes(classes)
  {}

  void
  Add(const VoxelSet & seeds)
  {
    m_Seeds = seeds;
    std::sort(m_Seeds.begin(), m_Seeds.end());
    this->Flood(seeds);
    this->GrowBack(this->Cores(seeds));
  }

private:
  /** The mean of a voxel and those that share a face: less noise, and a wall of two voxels still shows. */
  float
  Mean(std::size_t voxel) const
  {
    float sum = m_Hu[voxel];
    int   count = 1;
    ForEachNeighbour(m_Grid, voxel, [&](std::size_t q) {
      sum += m_Hu[q];
      ++count;
    });
    return sum / static_cast<float>(count);
  }

  /** Visits what the paths reach, the brightest ways first, so that each voxel gets the best of its ways. */
  void
  Flood(const VoxelSet & seeds)
  {
    std::priority_queue<Arrival> queue;
    const auto                   visit = [&](std::size_t q, float faintest) {
      if (m_Classes[q] == Nothing && m_Reached.count(q) == 0)
      {
        const float mean = this->Mean(q);
        if (mean >= m_Least && mean <= faintest + m_Tolerance)
        {
          m_Reached[q] = mean;
          queue.push({ std::min(faintest, mean), q });
        }
      }
    };
    for (std::size_t p = 0; p < m_Classes.size(); ++p)
    {
      if (m_Classes[p] == ColonFluid)
      {
        ForEachNeighbour(m_Grid, p, [&](std::size_t q) {
          if (m_Classes[q] == Nothing)
          {
            queue.push({ std::numeric_limits<float>::max(), p });
          }
        });
      }
    }
    for (const auto p : seeds)
    {
      m_Reached[p] = this->Mean(p);
      queue.push({ m_Reached[p], p });
    }
    while (!queue.empty())
    {
      const Arrival next = queue.top();
      queue.pop();
      ForEachNeighbour(m_Grid, next.voxel, [&](std::size_t q) { visit(q, next.faintest); });
    }
  }

  /** Whether fluid lies within two voxels, or 2 mm: what is reached there may be its blurred edge. */
  bool
  IsNearFluid(std::size_t p) const
  {
    const double reach = std::max(2.0, 1.99 * m_Voxel);
    return !ForAllWithin(m_Grid, p, reach, [&](std::size_t q, double squaredDistance) {
      return m_Classes[q] != ColonFluid || squaredDistance >= reach * reach;
    });
  }

  /** Reached voxels beyond the blurred edge, in pieces of LeastCoreMl at least that are open to
   * the fluid; in the order of their index. */
  VoxelSet
  Cores(const VoxelSet & seeds) const
  {
    VoxelSet cores;
    for (const auto & reached : m_Reached)
    {
      if (m_Hu[reached.first] > m_Least && !this->IsNearFluid(reached.first))
      {
        cores.push_back(reached.first);
      }
    }
    cores.insert(cores.end(), seeds.begin(), seeds.end());
    std::sort(cores.begin(), cores.end());
    cores.erase(std::unique(cores.begin(), cores.end()), cores.end());
    return this->OpenPieces(cores);
  }

  /** The lowest value on the straight way to the nearest fluid voxel within three voxels; nothing where there is none.
   */
  std::optional<double>
  DipTowardsFluid(std::size_t p) const
  {
    double      nearest = 9.0 * m_Voxel * m_Voxel;
    std::size_t fluid = p;
    ForAllWithin(m_Grid, p, 3.0 * m_Voxel, [&](std::size_t q, double squaredDistance) {
      if (m_Classes[q] == ColonFluid && squaredDistance < nearest)
      {
        nearest = squaredDistance;
        fluid = q;
      }
      return true;
    });
    if (fluid == p)
    {
      return std::nullopt;
    }
    const auto from = m_Grid.Voxel(p);
    const auto to = m_Grid.Voxel(fluid);
    const int  steps = std::max({ std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2]) });
    double     dip = m_Sharp[p];
    for (int n = 1; n < steps; ++n)
    {
      const auto at = [&](int a) {
        return from[a] + static_cast<int>(std::lround(n * static_cast<double>(to[a] - from[a]) / steps));
      };
      dip = std::min<double>(dip, m_Sharp[m_Grid.Index(at(0), at(1), at(2))]);
    }
    return dip;
  }

  /** Whether a core meets the fluid broadly and mostly without a dip of the values in between, or holds a seed. */
  bool
  IsOpenToFluid(const VoxelSet & piece) const
  {
    double              sum = 0.0;
    std::vector<double> dips;
    for (const auto p : piece)
    {
      if (std::binary_search(m_Seeds.begin(), m_Seeds.end(), p))
      {
        return true;
      }
      sum += m_Reached.at(p);
      if (const auto dip = this->DipTowardsFluid(p))
      {
        dips.push_back(*dip);
      }
    }
    const double mean = sum / static_cast<double>(piece.size());
    const auto   open = static_cast<std::size_t>(std::count_if(
      dips.begin(), dips.end(), [&](double dip) { return dip - m_Tissue > Plateau * (mean - m_Tissue); }));
    return 3 * open > 2 * dips.size() &&
           open * m_Voxel * m_Voxel * GreatestDepth >= piece.size() * m_Grid.VoxelVolume();
  }

  VoxelSet
  OpenPieces(const VoxelSet & cores) const
  {
    VoxelSet   kept;
    const auto isLumen = [this](std::size_t p) { return m_Classes[p] == ColonFluid || m_Classes[p] == ColonGas; };
    for (const auto & piece : ConnectedPieces(m_Grid, cores, PartsAtNecks(m_Grid, cores, NeckRadius, isLumen)))
    {
      if (piece.size() * m_Grid.VoxelVolume() * 1e-3 >= LeastCoreMl && this->IsOpenToFluid(piece))
      {
        kept.insert(kept.end(), piece.begin(), piece.end());
      }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  /** The cores and what is next to them above their half-height. */
  void
  GrowBack(const VoxelSet & cores)
  {
    std::vector<std::pair<std::size_t, float>> front;
    for (const auto p : cores)
    {
      m_Classes[p] = ColonFluid;
      front.push_back({ p, m_Reached[p] });
    }
    for (int layer = 0; layer < 4; ++layer)
    {
      std::vector<std::pair<std::size_t, float>> next;
      for (const auto & from : front)
      {
        ForEachNeighbour(m_Grid, from.first, [&](std::size_t q) {
          if (m_Classes[q] == Nothing && m_Hu[q] > 0.5 * (m_Tissue + from.second))
          {
            m_Classes[q] = ColonFluid;
            next.push_back({ q, from.second });
          }
        });
      }
      front.swap(next);
    }
  }

  const ColonGrid &                      m_Grid;
  const std::vector<float> &             m_Hu;
  const std::vector<float> &             m_Sharp;
  double                                 m_Least;
  double                                 m_Tissue;
  double                                 m_Tolerance;
  double                                 m_Voxel; ///< mm, 1 at least
  ClassVolume &                          m_Classes;
  VoxelSet                               m_Seeds;
  std::unordered_map<std::size_t, float> m_Reached;
};
} // namespace

void
AddUnmixedFluid(const ColonGrid &                grid,
                const std::vector<float> &       hu,
                const std::vector<float> &       sharp,
                const ColonThresholds &          thresholds,
                double                           noise,
                double                           smoothing,
                const std::vector<std::size_t> & seeds,
                ClassVolume &                    classes)
{
  if (thresholds.fluid > 0.0)
  {
    UnmixedFluid(grid, hu, sharp, thresholds, noise, smoothing, classes).Add(seeds);
  }
}
} // namespace shapeton
