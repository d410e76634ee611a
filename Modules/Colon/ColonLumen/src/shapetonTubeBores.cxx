#include "shapetonTubeBores.h"

#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>
#include <unordered_set>

namespace shapeton
{
namespace
{
constexpr double AxisStep = 1.0;     // mm
constexpr double AxisSmooth = 3.0;   // mm, standard deviation; chosen: removes voxel steps, keeps bends
constexpr double StepInVoxels = 1.5; // least step; chosen above 1, so that few bins are skipped

/** Residue of the morphological opening of a mask by a ball. */
std::vector<unsigned char>
WithoutBalls(const ColonGrid &                  grid,
             const std::vector<unsigned char> & mask,
             const VoxelValues &                squaredDepth,
             double                             radius)
{
  const auto                 square = static_cast<float>(radius * radius);
  std::vector<unsigned char> rest(mask.size());
  std::transform(squaredDepth.begin(), squaredDepth.end(), rest.begin(), [=](float d) { return d <= square; });
  const auto toMiddle = SquaredDistanceToBackground(grid, rest, radius);
  std::transform(mask.begin(), mask.end(), toMiddle.begin(), rest.begin(), [=](unsigned char isIn, float d) {
    return isIn && d > square;
  });
  return rest;
}

/** Voxel indices of each piece. */
std::vector<VoxelSet>
PiecesOf(const ColonGrid & grid, const std::vector<unsigned char> & mask)
{
  const VoxelRuns       set = CollectRuns(grid, [&](std::size_t p) { return mask[p] != 0; });
  const RunLabels       labels = LabelRuns(set, VoxelContact::FaceOrEdge);
  std::vector<VoxelSet> pieces(labels.number);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
    {
      pieces[labels.ofRun[r] - 1].push_back(grid.Index(i, j, k));
    }
  });
  return pieces;
}

/** Shortest paths within a set from one voxel to all others, indexed by position in the set. */
struct Ways
{
  std::vector<double>      length; ///< mm
  std::vector<std::size_t> before; ///< previous voxel on the path

  std::size_t
  Farthest() const
  {
    return std::max_element(length.begin(), length.end()) - length.begin();
  }
};

/** Finds paths in a 26-connected set of voxels. */
class WaysWithin
{
public:
  WaysWithin(const ColonGrid & grid, const VoxelSet & voxels) : m_Grid(grid), m_Voxels(voxels) {}

  Ways
  From(std::size_t start) const
  {
    using Entry = std::pair<double, std::size_t>;
    Ways ways{ std::vector<double>(m_Voxels.size(), Far), std::vector<std::size_t>(m_Voxels.size(), start) };
    std::vector<double> &                                               way = ways.length;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.emplace(way[start] = 0.0, start);
    RareInterruption interruption;
    while (!queue.empty())
    {
      interruption.Check();
      const double      length = queue.top().first;
      const std::size_t n = queue.top().second;
      queue.pop();
      if (length > way[n])
      {
        continue;
      }
      this->ForEachNeighborOf(n, [&](std::size_t m, double step) {
        if (length + step < way[m])
        {
          ways.before[m] = n;
          queue.emplace(way[m] = length + step, m);
        }
      });
    }
    return ways;
  }

  template <typename TBody>
  void
  ForEachNeighborOf(std::size_t n, const TBody & body) const
  {
    const auto v = m_Grid.Voxel(m_Voxels[n]);
    for (int s = 0; s < 27; ++s)
    {
      const std::array<int, 3> d{ { s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1 } };
      if (s == 13 || !m_Grid.Holds(v[0] + d[0], v[1] + d[1], v[2] + d[2]))
      {
        continue;
      }
      const auto q = m_Grid.Index(v[0] + d[0], v[1] + d[1], v[2] + d[2]);
      const auto at = std::lower_bound(m_Voxels.begin(), m_Voxels.end(), q);
      if (at != m_Voxels.end() && *at == q)
      {
        body(at - m_Voxels.begin(), Eigen::Vector3d(d[0], d[1], d[2]).cwiseProduct(m_Grid.spacing).norm());
      }
    }
  }

private:
  static constexpr double Far = std::numeric_limits<double>::max(); ///< length (mm) of voxels not yet reached

  const ColonGrid & m_Grid;
  const VoxelSet &  m_Voxels; ///< ascending
};

/** Resamples a line to equal steps of at most `step`. */
BoreAxis
Resampled(const BoreAxis & line, double step)
{
  std::vector<double> at{ 0.0 };
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    at.push_back(at.back() + (line[n] - line[n - 1]).norm());
  }
  const auto  steps = static_cast<std::size_t>(std::ceil(at.back() / step));
  BoreAxis    axis{ line.front() };
  std::size_t n = 1;
  for (std::size_t s = 1; s <= steps; ++s)
  {
    const double place = at.back() * static_cast<double>(s) / static_cast<double>(steps);
    while (at[n] < place && n + 1 < line.size())
    {
      ++n;
    }
    axis.push_back(line[n - 1] + (place - at[n - 1]) / (at[n] - at[n - 1]) * (line[n] - line[n - 1]));
  }
  return axis;
}

/** Extends a line on both sides. */
BoreAxis
Lengthened(const BoreAxis & line, double by)
{
  if (line.size() < 2)
  {
    return line;
  }
  const auto beyond = [by](const Eigen::Vector3d & end, const Eigen::Vector3d & before) -> Eigen::Vector3d {
    return end + by * (end - before).normalized();
  };
  BoreAxis longer{ beyond(line[0], line[1]) };
  longer.insert(longer.end(), line.begin(), line.end());
  longer.push_back(beyond(line.back(), line[line.size() - 2]));
  return longer;
}

/** Gaussian smoothing of a line with equal steps, reflected at its ends to avoid shrinking. */
BoreAxis
Smoothed(const BoreAxis & line, double step)
{
  const int  last = static_cast<int>(line.size()) - 1;
  const int  reach = std::min(static_cast<int>(std::ceil(3.0 * AxisSmooth / step)), last);
  const auto at = [&](int n) {
    const int end = std::clamp(n, 0, last);
    return n == end ? line[n] : Eigen::Vector3d(2.0 * line[end] - line[2 * end - n]);
  };
  BoreAxis smooth;
  for (int n = 0; n <= last; ++n)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double          weight = 0.0;
    for (int t = -reach; t <= reach; ++t)
    {
      const double x = t * step / AxisSmooth;
      const double w = std::exp(-0.5 * x * x);
      sum += w * at(n + t);
      weight += w;
    }
    smooth.push_back(sum / weight);
  }
  return smooth;
}

/** The longest path through a piece, and its cross-sections. */
class Trunk
{
public:
  Trunk(const ColonGrid & grid, const VoxelSet & voxels)
    : m_Grid(grid)
    , m_Voxels(voxels)
    , m_Search(grid, voxels)
    , m_Step(std::max(AxisStep, StepInVoxels * grid.spacing.maxCoeff()))
    , m_IsTaken(voxels.size(), 0)
  {
    const Ways        ways = m_Search.From(m_Search.From(0).Farthest());
    const std::size_t end = ways.Farthest();
    m_Length = ways.length[end];
    this->Place(ways, m_Search.From(end));
    std::size_t n = end;
    for (std::size_t bin = m_Bins[end] + 1; bin-- > 0;)
    {
      while (m_Bins[n] > bin)
      {
        n = ways.before[n];
      }
      if (m_Bins[n] == bin) // a diagonal step may skip a bin
      {
        m_Middle.push_back(this->TakeAcross(n));
      }
    }
  }

  double
  Length() const
  {
    return m_Length;
  }

  /** Mean cross-sectional area, mm^2. */
  double
  Section() const
  {
    const auto taken = std::count(m_IsTaken.begin(), m_IsTaken.end(), 1);
    return static_cast<double>(taken) * m_Grid.VoxelVolume() / m_Length;
  }

  BoreAxis
  Axis() const
  {
    // The first and last mean are half a step from the ends.
    return Resampled(Lengthened(Smoothed(m_Middle, m_Step), 0.5 * m_Step), AxisStep);
  }

  /** The pieces that remain after the path and its cross-sections are removed. */
  std::vector<VoxelSet>
  Branches() const
  {
    std::vector<VoxelSet> branches;
    std::vector<char>     isSeen = m_IsTaken;
    for (std::size_t n = 0; n < m_Voxels.size(); ++n)
    {
      if (isSeen[n])
      {
        continue;
      }
      branches.emplace_back();
      for (const std::size_t m : this->Connected(n, [&](std::size_t k) { return !isSeen[k]; }))
      {
        isSeen[m] = 1;
        branches.back().push_back(m_Voxels[m]);
      }
      std::sort(branches.back().begin(), branches.back().end());
    }
    return branches;
  }

private:
  /** Assigns each voxel a position on the path, measured from the farther end: voxels at an equal distance from a far
   * end form a flat cross-section; measured from a near end, they would form shells around its corner. */
  void
  Place(const Ways & fromStart, const Ways & fromEnd)
  {
    m_Bins.resize(m_Voxels.size());
    for (std::size_t n = 0; n < m_Bins.size(); ++n)
    {
      const double before = fromStart.length[n];
      const double after = fromEnd.length[n];
      m_Bins[n] = static_cast<std::size_t>(std::max(0.0, before > after ? before : m_Length - after) / m_Step);
    }
  }

  /** The voxels for which `isPart` is true that are connected to a given one. */
  template <typename TIsPart>
  std::vector<std::size_t>
  Connected(std::size_t start, const TIsPart & isPart) const
  {
    std::vector<std::size_t>        connected{ start };
    std::unordered_set<std::size_t> seen{ start };
    for (std::size_t next = 0; next < connected.size(); ++next)
    {
      m_Search.ForEachNeighborOf(connected[next], [&](std::size_t m, double) {
        if (isPart(m) && seen.insert(m).second)
        {
          connected.push_back(m);
        }
      });
    }
    return connected;
  }

  /** Removes the cross-section at a path voxel, excluding other branches, and returns its center. Connectivity includes
   * the adjacent bins, since the farthest voxels at the end of a bore form a ring. */
  Eigen::Vector3d
  TakeAcross(std::size_t onWay)
  {
    Eigen::Vector3d   sum = Eigen::Vector3d::Zero();
    double            count = 0.0;
    const std::size_t bin = m_Bins[onWay];
    const auto        isNear = [&](std::size_t k) { return std::max(m_Bins[k], bin) - std::min(m_Bins[k], bin) <= 1; };
    for (const std::size_t m : this->Connected(onWay, isNear))
    {
      if (m_Bins[m] == bin)
      {
        m_IsTaken[m] = 1;
        sum += m_Grid.Position(m_Voxels[m]);
        count += 1.0;
      }
    }
    return sum / count;
  }

  const ColonGrid &        m_Grid;
  const VoxelSet &         m_Voxels;
  WaysWithin               m_Search;
  double                   m_Step;   ///< mm; large enough to avoid empty bins
  double                   m_Length; ///< mm
  std::vector<std::size_t> m_Bins;   ///< position of each voxel along the path, in steps
  BoreAxis                 m_Middle; ///< centers, from the end to the start
  std::vector<char>        m_IsTaken;
};

/** Finds centerlines along the longest paths of a piece and its branches, excluding those that are too short or too
 * wide for a bore. */
std::vector<BoreAxis>
AxesOf(const ColonGrid & grid, VoxelSet && piece, double leastLength)
{
  constexpr double      thinnest = 2.0; // mm^2, minimum mean cross-section; chosen
  const auto            least = static_cast<std::size_t>(thinnest * leastLength / grid.VoxelVolume());
  std::vector<BoreAxis> axes;
  std::vector<VoxelSet> pieces{ std::move(piece) };
  while (!pieces.empty())
  {
    const VoxelSet voxels = std::move(pieces.back());
    pieces.pop_back();
    if (voxels.size() < least)
    {
      continue;
    }
    Trunk trunk(grid, voxels);
    if (trunk.Length() < leastLength)
    {
      continue;
    }
    if (trunk.Section() <= Pi * LargestBoreRadius * LargestBoreRadius)
    {
      axes.push_back(trunk.Axis());
    }
    for (VoxelSet & branch : trunk.Branches())
    {
      pieces.push_back(std::move(branch));
    }
  }
  return axes;
}
} // namespace

TubeBores::TubeBores(const ColonGrid & grid, std::vector<unsigned char> && gas)
  : m_Grid(grid), m_Gas(std::move(gas)), m_SquaredDepth(SquaredDistanceToBackground(grid, m_Gas))
{}

std::vector<BoreAxis>
TubeBores::Find(double reach, double leastLength) const
{
  std::vector<VoxelSet>              pieces = PiecesOf(m_Grid, WithoutBalls(m_Grid, m_Gas, m_SquaredDepth, reach));
  std::vector<std::vector<BoreAxis>> axes(pieces.size());
  ParallelFor(pieces.size(), [&](std::size_t i) { axes[i] = AxesOf(m_Grid, std::move(pieces[i]), leastLength); });
  std::vector<BoreAxis> bores;
  for (auto & ofPiece : axes)
  {
    std::move(ofPiece.begin(), ofPiece.end(), std::back_inserter(bores));
  }
  return bores;
}
} // namespace shapeton
