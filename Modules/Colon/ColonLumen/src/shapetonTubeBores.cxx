#include "shapetonTubeBores.h"

#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace shapeton
{
namespace
{
constexpr double AxisStep = 1.0;   // mm
constexpr double AxisSmooth = 3.0; // mm, standard deviation

/** The part of a mask that no ball inside of it covers. */
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

/** Indices of voxels of each piece. */
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

/** Lengths of ways within a set, mm, over faces, edges and corners of voxels. */
class WaysWithin
{
public:
  WaysWithin(const ColonGrid & grid, const VoxelSet & voxels) : m_Grid(grid), m_Voxels(voxels) {}

  /** From one voxel of the set, by its number, to each. */
  std::vector<double>
  From(std::size_t start) const
  {
    using Entry = std::pair<double, std::size_t>;
    std::vector<double>                                                 way(m_Voxels.size(), Far);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.emplace(way[start] = 0.0, start);
    RareInterruption interruption;
    while (!queue.empty())
    {
      interruption.Check();
      const auto [length, n] = queue.top();
      queue.pop();
      if (length > way[n])
      {
        continue;
      }
      this->ForEachNeighbourOf(n, [&](std::size_t m, double step) {
        if (length + step < way[m])
        {
          queue.emplace(way[m] = length + step, m);
        }
      });
    }
    return way;
  }

private:
  static constexpr double Far = std::numeric_limits<double>::max();

  template <typename TBody>
  void
  ForEachNeighbourOf(std::size_t n, const TBody & body) const
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

  const ColonGrid & m_Grid;
  const VoxelSet &  m_Voxels; ///< ascending
};

/** The same line by the same steps of its length, but for its end. */
BoreAxis
Resampled(const BoreAxis & line, double step)
{
  BoreAxis axis{ line.front() };
  double   before = 0.0; // from the last point of the axis to the start of the segment
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    const Eigen::Vector3d segment = line[n] - line[n - 1];
    const double          length = segment.norm();
    double                next = step - before;
    for (; next <= length; next += step)
    {
      axis.push_back(line[n - 1] + next / length * segment);
    }
    before = length - (next - step);
  }
  return axis;
}

/** Gaussian means along a line of even steps. Beyond its ends the line goes on as its mirror image in the end, so that
 * it is not drawn inwards. */
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

/** Means of the places of voxels whose ways are about the same. */
BoreAxis
MeansAlong(const ColonGrid & grid, const VoxelSet & voxels, const std::vector<double> & way, double step)
{
  const auto          bins = static_cast<std::size_t>(*std::max_element(way.begin(), way.end()) / step) + 1;
  BoreAxis            sums(bins, Eigen::Vector3d::Zero());
  std::vector<double> counts(bins, 0.0);
  for (std::size_t n = 0; n < voxels.size(); ++n)
  {
    const auto bin = static_cast<std::size_t>(way[n] / step);
    sums[bin] += grid.Position(voxels[n]);
    counts[bin] += 1.0;
  }
  BoreAxis means;
  for (std::size_t b = 0; b < bins; ++b)
  {
    if (counts[b] > 0.0)
    {
      means.push_back(sums[b] / counts[b]);
    }
  }
  return means;
}

/** The middle of a piece along its longest way; empty where it is shorter or wider than a bore. */
BoreAxis
AxisOf(const ColonGrid & grid, const VoxelSet & voxels, double leastLength)
{
  const WaysWithin ways(grid, voxels);
  const auto       fromAny = ways.From(0);
  const auto       way = ways.From(std::max_element(fromAny.begin(), fromAny.end()) - fromAny.begin());
  const double     length = *std::max_element(way.begin(), way.end());
  const double     section = voxels.size() * grid.VoxelVolume() / length;
  if (length < leastLength || section > Pi * LargestBoreRadius * LargestBoreRadius)
  {
    return {};
  }
  const double step = std::max(AxisStep, 1.5 * grid.spacing.maxCoeff()); // so that no bin is empty
  return Resampled(Smoothed(MeansAlong(grid, voxels, way, step), step), AxisStep);
}
} // namespace

TubeBores::TubeBores(const ColonGrid & grid, std::vector<unsigned char> && gas)
  : m_Grid(grid), m_Gas(std::move(gas)), m_SquaredDepth(SquaredDistanceToBackground(grid, m_Gas))
{}

std::vector<BoreAxis>
TubeBores::Find(double reach, double leastLength) const
{
  constexpr double            thinnest = 2.0; // mm^2, mean section of what is worth the search
  const std::vector<VoxelSet> pieces = PiecesOf(m_Grid, WithoutBalls(m_Grid, m_Gas, m_SquaredDepth, reach));
  std::vector<BoreAxis>       axes(pieces.size());
  ParallelFor(pieces.size(), [&](std::size_t i) {
    if (pieces[i].size() * m_Grid.VoxelVolume() >= thinnest * leastLength)
    {
      axes[i] = AxisOf(m_Grid, pieces[i], leastLength);
    }
  });
  std::vector<BoreAxis> bores;
  for (BoreAxis & axis : axes)
  {
    if (!axis.empty())
    {
      bores.push_back(std::move(axis));
    }
  }
  return bores;
}
} // namespace shapeton
