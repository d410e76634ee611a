#include "shapetonMiddleLine.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The middle of the lumen is taken over so many mm of it to both sides, so that single haustra do not bend the line.
 */
constexpr double slabRadii = 2.5;
/** Chord over arc of that stretch, at least. */
constexpr double straightness = 0.6;

/** The middle is no nearer to the wall (mm), where the path is not. */
constexpr double leastClearance = 2.5;
/** Share of lumen (DistanceField::Occupancy) that the line keeps. */
constexpr double safelyInside = 0.7;
/** The line ends so far from the pole of the caecum, mm. */
constexpr double beforePole = 3.0;

CurvePoints
PositionsOf(const LumenGrid & grid, const std::vector<int> & nodes)
{
  CurvePoints points;
  for (const int node : nodes)
  {
    points.push_back(grid.Position(node));
  }
  return points;
}

/** Of each node the nearest point of a curve within the lumen. */
std::vector<int>
NearestPoints(const LumenNetwork & network, const CurvePoints & points)
{
  std::vector<int> path;
  for (const Eigen::Vector3d & point : points)
  {
    path.push_back(network.grid.NodeOf(point));
  }
  return NearestOnPath(network.grid, network.cells, network.tree, path).indices;
}

/** The lumen across each point of a curve. */
struct Slabs
{
  /** Weighted sums of positions. */
  CurvePoints         sums;
  std::vector<double> weights;
};

/** Nodes count by their distance to the wall, so that haustra weigh little. */
Slabs
SlabsAcross(const LumenNetwork & network, const CurvePoints & points)
{
  const LumenGrid &      grid = network.grid;
  const std::vector<int> nearest = NearestPoints(network, points);
  Slabs                  slabs;
  slabs.sums.assign(points.size(), Eigen::Vector3d::Zero());
  slabs.weights.assign(points.size(), 0.0);
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    if (nearest[node] >= 0)
    {
      slabs.sums[nearest[node]] += grid.Distance(node) * grid.Position(node);
      slabs.weights[nearest[node]] += grid.Distance(node);
    }
  }
  return slabs;
}

/** The mean of numbers over so many neighbours to both sides. */
double
MeanAround(const std::vector<double> & values, int i, int number)
{
  const int from = std::max(0, i - number);
  const int to = std::min(static_cast<int>(values.size()) - 1, i + number);
  double    sum = 0.0;
  for (int k = from; k <= to; ++k)
  {
    sum += values[k];
  }
  return sum / (to - from + 1);
}

/** The mean of the slabs around each point, over a stretch of some radii of the lumen; both ends stay. */
CurvePoints
SlabMeans(const Slabs & slabs, const CurvePoints & points, const std::vector<double> & radii, double step)
{
  const int   last = static_cast<int>(points.size()) - 1;
  CurvePoints means = points;
  for (int i = 1; i < last; ++i)
  {
    // As far on both sides, or the end would pull.
    const double reach = slabRadii * MeanAround(radii, i, static_cast<int>(20.0 / step));
    int          number = std::min({ static_cast<int>(reach / step), i, last - i });
    // Less in a sharp bend, which the mean would cut.
    while (number > 1 && (points[i + number] - points[i - number]).norm() < straightness * 2.0 * number * step)
    {
      --number;
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double          weight = 0.0;
    for (int k = i - number; k <= i + number; ++k)
    {
      const double share = 1.0 - std::abs(k - i) / (number + 1.0);
      sum += share * slabs.sums[k];
      weight += share * slabs.weights[k];
    }
    means[i] = weight > 0.0 ? Eigen::Vector3d(sum / weight) : points[i];
  }
  return means;
}

/** Each point moved to the middle of the lumen across the curve, both ends kept. The mean goes over a stretch, so that
 * single haustra do not bend the line. */
CurvePoints
MoveToMiddle(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step)
{
  std::vector<double> radii;
  for (const Eigen::Vector3d & point : points)
  {
    radii.push_back(field.At(point));
  }
  const CurvePoints middle = SlabMeans(SlabsAcross(network, points), points, radii, step);
  CurvePoints       moved = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    // The mean of a bent slab may lie in a wall: back towards the path, as far as needed.
    const double least = std::min(leastClearance, 0.5 * radii[i]);
    for (double share = 1.0; share > 0.0; share -= 0.125)
    {
      const Eigen::Vector3d place = points[i] + share * (middle[i] - points[i]);
      if (field.At(place) >= least)
      {
        moved[i] = place;
        break;
      }
    }
  }
  return moved;
}

std::size_t
NearestIndex(const CurvePoints & nodes, const Eigen::Vector3d & point)
{
  const auto nearest =
    std::min_element(nodes.begin(), nodes.end(), [&point](const Eigen::Vector3d & a, const Eigen::Vector3d & b) {
      return (a - point).squaredNorm() < (b - point).squaredNorm();
    });
  return nearest - nodes.begin();
}

/** Stretches outside the lumen become those of the path again, which may wind more than the line. */
void
KeepInside(const DistanceField & field, const CurvePoints & nodes, CurvePoints & points)
{
  const auto isBad = [&](std::size_t i) {
    const Eigen::Vector3d halfway = 0.5 * (points[i] + points[std::min(i + 1, points.size() - 1)]);
    return std::min(field.Occupancy(points[i]), field.Occupancy(halfway)) < safelyInside;
  };
  CurvePoints kept;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!isBad(i) || i == 0)
    {
      kept.push_back(points[i]);
      continue;
    }
    const std::size_t from = NearestIndex(nodes, points[i - 1]);
    while (i + 1 < points.size() && isBad(i))
    {
      ++i;
    }
    const std::size_t to = NearestIndex(nodes, points[i]);
    if (from < to)
    {
      kept.insert(kept.end(), nodes.begin() + from + 1, nodes.begin() + to);
    }
    kept.push_back(points[i]);
  }
  points = kept;
}

bool
IsVisible(const DistanceField & field, const Eigen::Vector3d & from, const Eigen::Vector3d & to)
{
  const int steps = static_cast<int>((to - from).norm()) + 1;
  for (int i = 1; i < steps; ++i)
  {
    if (field.At(from + (to - from) * i / steps) < 1.0)
    {
      return false;
    }
  }
  return true;
}

/** The place before the wall that lies farthest along a direction and near the axis. */
Eigen::Vector3d
FindPole(const LumenNetwork &    network,
         const DistanceField &   field,
         const Eigen::Vector3d & base,
         const Eigen::Vector3d & along,
         double                  reach)
{
  Eigen::Vector3d pole = base;
  double          most = 0.0;
  for (int node = 0; node < network.grid.NumberOfNodes(); ++node)
  {
    const Eigen::Vector3d way = network.grid.Position(node) - base;
    const double          forward = way.dot(along);
    const double          score = forward - 0.5 * (way - forward * along).norm();
    if (score > most && way.norm() <= reach && network.grid.Distance(node) >= beforePole &&
        IsVisible(field, base, base + way))
    {
      most = score;
      pole = base + way;
    }
  }
  return pole;
}
} // namespace

CurvePoints
ShapeLine(const LumenNetwork &           network,
          const DistanceField &          field,
          const std::vector<int> &       nodes,
          const ColonCentrelineOptions & options)
{
  const auto smooth = [&](const CurvePoints & points) {
    return ResampleCurve(SmoothCurve(ResampleCurve(points, options.step), options.step, options.smoothing, &field),
                         options.step);
  };
  const CurvePoints path = smooth(PositionsOf(network.grid, nodes));
  CurvePoints       points = smooth(MoveToMiddle(network, field, path, options.step));
  KeepInside(field, PositionsOf(network.grid, nodes), points);
  return ResampleCurve(points, options.step);
}

void
LeadToPole(const LumenNetwork & network, const DistanceField & field, double step, CurvePoints & points)
{
  const auto   count = static_cast<int>(points.size());
  const double radius = field.At(points[std::max(0, count - 1 - static_cast<int>(25.0 / step))]);
  const int    base = count - 1 - static_cast<int>(radius / step);
  const int    before = base - static_cast<int>(20.0 / step);
  if (before < 0 || base == count - 1)
  {
    return;
  }
  const Eigen::Vector3d along = (points[base] - points[before]).normalized();
  const double          reach = 2.5 * std::max(radius, field.At(points[base]));
  const Eigen::Vector3d pole = FindPole(network, field, points[base], along, reach);
  const double          rest = (pole - points[base]).norm();
  if (rest < step)
  {
    return;
  }
  points.resize(base + 1);
  const CurvePoints last = BridgeGap(points[base], along, pole, (pole - points[base]) / rest, step);
  points.insert(points.end(), last.begin(), last.end());
  points.push_back(pole);
}

void
TrimEnds(const DistanceField & field, double step, CurvePoints & points)
{
  for (int e = 0; e < 2; ++e)
  {
    std::reverse(points.begin(), points.end());
    const std::size_t reach = std::min(points.size() / 3, static_cast<std::size_t>(10.0 / step));
    std::size_t       keep = 0;
    for (std::size_t i = 0; i < reach + keep && i + 2 < points.size() - reach; ++i)
    {
      const double halfway = field.Occupancy(0.5 * (points[i] + points[i + 1]));
      keep = std::min(field.Occupancy(points[i]), halfway) < safelyInside ? i + 1 : keep;
    }
    points.erase(points.begin(), points.begin() + keep);
  }
}

std::vector<double>
RadiiAlong(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step)
{
  const std::vector<int> nearest = NearestPoints(network, points);
  std::vector<double>    widest;
  for (const Eigen::Vector3d & point : points)
  {
    widest.push_back(field.At(point));
  }
  for (int node = 0; node < network.grid.NumberOfNodes(); ++node)
  {
    if (nearest[node] >= 0)
    {
      widest[nearest[node]] = std::max<double>(widest[nearest[node]], network.grid.Distance(node));
    }
  }
  const int           reach = static_cast<int>(2.0 / step);
  std::vector<double> radii;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    const int from = std::max(0, i - reach);
    const int to = std::min(static_cast<int>(points.size()) - 1, i + reach);
    radii.push_back(*std::max_element(widest.begin() + from, widest.begin() + to + 1));
  }
  return radii;
}
} // namespace shapeton
