#include "itkUnmixedFluid.h"

#include "itkColonStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>

namespace itk
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
  Add(const std::vector<std::size_t> & seeds)
  {
    m_Seeds = seeds;
    std::sort(m_Seeds.begin(), m_Seeds.end());
    this->Flood(seeds);
    this->GrowBack(this->Cores(seeds));
  }

private:
  template <typename TBody>
  void
  ForEachNeighbour(std::size_t voxel, const TBody & body) const
  {
    const auto v = m_Grid.Voxel(voxel);
    for (int a = 0; a < 3; ++a)
    {
      if (v[a] > 0)
      {
        body(voxel - m_Grid.stride[a]);
      }
      if (v[a] + 1 < m_Grid.size[a])
      {
        body(voxel + m_Grid.stride[a]);
      }
    }
  }

  /** The mean of a voxel and those that share a face: less noise, and a wall of two voxels still shows. */
  float
  Mean(std::size_t voxel) const
  {
    float sum = m_Hu[voxel];
    int   count = 1;
    this->ForEachNeighbour(voxel, [&](std::size_t q) {
      sum += m_Hu[q];
      ++count;
    });
    return sum / static_cast<float>(count);
  }

  /** Visits what the paths reach, the brightest ways first, so that each voxel gets the best of its ways. */
  void
  Flood(const std::vector<std::size_t> & seeds)
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
        this->ForEachNeighbour(p, [&](std::size_t q) {
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
      this->ForEachNeighbour(next.voxel, [&](std::size_t q) { visit(q, next.faintest); });
    }
  }

  /** Whether fluid lies within two voxels, or 2 mm: what is reached there may be its blurred edge. */
  bool
  IsNearFluid(std::size_t p) const
  {
    const auto   v = m_Grid.Voxel(p);
    const double reach = std::max(2.0, 1.99 * m_Voxel);
    const auto   box = m_Grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, reach);
    for (int k = box.low[2]; k < box.high[2]; ++k)
    {
      for (int j = box.low[1]; j < box.high[1]; ++j)
      {
        for (int i = box.low[0]; i < box.high[0]; ++i)
        {
          const Eigen::Vector3d d = Eigen::Vector3d(i - v[0], j - v[1], k - v[2]).cwiseProduct(m_Grid.spacing);
          if (m_Classes[m_Grid.Index(i, j, k)] == ColonFluid && d.squaredNorm() < reach * reach)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Reached voxels beyond the blurred edge, in pieces of LeastCoreMl at least that are open to
   * the fluid; in the order of their index. */
  std::vector<std::size_t>
  Cores(const std::vector<std::size_t> & seeds) const
  {
    std::vector<std::size_t> cores;
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
    const auto         v = m_Grid.Voxel(p);
    const auto         box = m_Grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, 3.0 * m_Voxel);
    double             nearest = 9.0 * m_Voxel * m_Voxel;
    std::array<int, 3> towards{ { 0, 0, 0 } };
    for (int k = box.low[2]; k < box.high[2]; ++k)
    {
      for (int j = box.low[1]; j < box.high[1]; ++j)
      {
        for (int i = box.low[0]; i < box.high[0]; ++i)
        {
          const Eigen::Vector3d d = Eigen::Vector3d(i - v[0], j - v[1], k - v[2]).cwiseProduct(m_Grid.spacing);
          if (m_Classes[m_Grid.Index(i, j, k)] == ColonFluid && d.squaredNorm() < nearest)
          {
            nearest = d.squaredNorm();
            towards = { { i - v[0], j - v[1], k - v[2] } };
          }
        }
      }
    }
    const int steps = std::max({ std::abs(towards[0]), std::abs(towards[1]), std::abs(towards[2]) });
    if (steps == 0)
    {
      return std::nullopt;
    }
    double dip = m_Sharp[p];
    for (int n = 1; n < steps; ++n)
    {
      const auto at = [&](int a) {
        return v[a] + static_cast<int>(std::lround(n * static_cast<double>(towards[a]) / steps));
      };
      dip = std::min<double>(dip, m_Sharp[m_Grid.Index(at(0), at(1), at(2))]);
    }
    return dip;
  }

  /** Whether a core meets the fluid broadly and mostly without a dip of the values in between, or holds a seed. */
  bool
  IsOpenToFluid(const std::vector<std::size_t> & piece) const
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

  /** The connected pieces of a sorted set of voxels; with `parts`, voxels join only those of their own part. */
  std::vector<std::vector<std::size_t>>
  Pieces(const std::vector<std::size_t> & voxels, const std::unordered_map<std::size_t, int> & parts = {}) const
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
        this->ForEachNeighbour(piece[n], [&](std::size_t q) {
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

  /** Voxels around which a ball of NeckRadius holds nothing but the set and the colon. */
  std::vector<std::size_t>
  WideVoxels(const std::vector<std::size_t> & voxels) const
  {
    const auto isIn = [&](std::size_t p) {
      return m_Classes[p] == ColonFluid || m_Classes[p] == ColonGas ||
             std::binary_search(voxels.begin(), voxels.end(), p);
    };
    std::vector<std::size_t> wide;
    for (const auto p : voxels)
    {
      const auto v = m_Grid.Voxel(p);
      const auto box = m_Grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, NeckRadius);
      bool       isWide = true;
      for (int k = box.low[2]; isWide && k < box.high[2]; ++k)
      {
        for (int j = box.low[1]; isWide && j < box.high[1]; ++j)
        {
          for (int i = box.low[0]; isWide && i < box.high[0]; ++i)
          {
            const Eigen::Vector3d d = Eigen::Vector3d(i - v[0], j - v[1], k - v[2]).cwiseProduct(m_Grid.spacing);
            isWide = d.squaredNorm() > NeckRadius * NeckRadius || isIn(m_Grid.Index(i, j, k));
          }
        }
      }
      if (isWide)
      {
        wide.push_back(p);
      }
    }
    return wide;
  }

  /** Cuts a set at its necks: for each voxel the number of the wide part that is the next within the set, where any
   * is. */
  std::unordered_map<std::size_t, int>
  PartsAtNecks(const std::vector<std::size_t> & voxels) const
  {
    std::unordered_map<std::size_t, int> parts;
    std::vector<std::size_t>             queue;
    int                                  number = 0;
    for (const auto & piece : this->Pieces(this->WideVoxels(voxels)))
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
      this->ForEachNeighbour(queue[n], [&](std::size_t q) {
        if (std::binary_search(voxels.begin(), voxels.end(), q) && parts.emplace(q, own).second)
        {
          queue.push_back(q);
        }
      });
    }
    return parts;
  }

  std::vector<std::size_t>
  OpenPieces(const std::vector<std::size_t> & cores) const
  {
    std::vector<std::size_t> kept;
    for (const auto & piece : this->Pieces(cores, this->PartsAtNecks(cores)))
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
  GrowBack(const std::vector<std::size_t> & cores)
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
        this->ForEachNeighbour(from.first, [&](std::size_t q) {
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
  std::vector<std::size_t>               m_Seeds;
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
} // namespace itk
