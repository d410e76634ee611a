#include "shapetonPi.h"
#include "shapetonTaeniaEvidence.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

namespace shapeton
{
namespace
{
constexpr double windowLength = 150.0;  // mm; chosen: 120 to 180 mm worked on synthetic colons
constexpr int    leastEndsOfWindow = 5; // chosen: more than the three centers
constexpr int    iterations = 40;       // chosen: bounds the time
/** Lower bound of the squared distance from a point on the unit circle to a center, so that a fold end at a center does
 * not outweigh all others. */
constexpr double leastDistance = 1e-4;
/** Initial angles of the clustering: those of the previous window, rotated by up to stepOfStarts turns, or, in the
 * first window, firstStarts angles spread over a third of a turn. */
constexpr double stepOfStarts = 0.05;
constexpr int    firstStarts = 8;

using Complex = std::complex<double>;

Complex
OnCircle(double turns)
{
  return std::polar(1.0, TwoPi * turns);
}

/** Three centers on the circle; `spread` is the mean squared distance from each center to its members. */
struct Clusters
{
  TaeniaAngles          angles{};
  std::array<double, 3> spread{};
  double                objective{ 0.0 };
};

/** Fuzzy C-means (c = 3, m = 2) of points on the unit circle. */
Clusters
ClusterFrom(const std::vector<Complex> & points, const TaeniaAngles & start)
{
  std::array<Complex, 3> centers{ OnCircle(start[0]), OnCircle(start[1]), OnCircle(start[2]) };
  Clusters               result;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    std::array<Complex, 3> sums{};
    std::array<double, 3>  spread{};
    std::array<double, 3>  weights{};
    for (const Complex & point : points)
    {
      std::array<double, 3> distance{};
      double                total = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        distance[c] = std::norm(point - centers[c]) + leastDistance;
        total += 1.0 / distance[c];
      }
      for (int c = 0; c < 3; ++c)
      {
        const double membership = 1.0 / (distance[c] * total);
        const double weight = membership * membership;
        sums[c] += weight * point;
        spread[c] += weight * distance[c];
        weights[c] += weight;
      }
    }
    result.objective = (spread[0] + spread[1] + spread[2]) / static_cast<double>(points.size());
    for (int c = 0; c < 3; ++c)
    {
      centers[c] = sums[c] / (std::abs(sums[c]) + 1e-12);
      result.spread[c] = spread[c] / weights[c];
      result.angles[c] = std::arg(centers[c]) / TwoPi;
    }
  }
  return result;
}

/** Permutes the clusters to be closest to the previous ones and unwraps their angles. */
Clusters
Follow(const Clusters & clusters, const TaeniaAngles & before)
{
  std::array<int, 3> order{ 0, 1, 2 };
  std::array<int, 3> best = order;
  double             least = std::numeric_limits<double>::infinity();
  do
  {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      sum += std::abs(OnCircle(clusters.angles[order[c]]) - OnCircle(before[c]));
    }
    if (sum < least)
    {
      least = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  Clusters result = clusters;
  for (int c = 0; c < 3; ++c)
  {
    result.angles[c] = before[c] + TurnsBetween(clusters.angles[best[c]], before[c]);
    result.spread[c] = clusters.spread[best[c]];
  }
  return result;
}

Clusters
ClusterOf(const std::vector<Complex> & points, const std::optional<TaeniaAngles> & before)
{
  std::vector<TaeniaAngles> starts;
  const auto turned = [](const TaeniaAngles & a, double by) { return TaeniaAngles{ a[0] + by, a[1] + by, a[2] + by }; };
  for (int i = 0; before && i < 3; ++i)
  {
    starts.push_back(turned(*before, stepOfStarts * (i - 1)));
  }
  for (int i = 0; !before && i < firstStarts; ++i)
  {
    starts.push_back(turned({ 0.0, 1.0 / 3.0, 2.0 / 3.0 }, i / (3.0 * firstStarts)));
  }
  Clusters best;
  best.objective = std::numeric_limits<double>::infinity();
  for (const TaeniaAngles & start : starts)
  {
    const Clusters clusters = ClusterFrom(points, start);
    best = clusters.objective < best.objective ? clusters : best;
  }
  return before ? Follow(best, *before) : best;
}

struct Window
{
  double               middle{ 0.0 }; ///< arcLength, mm
  std::vector<Complex> points;
  Clusters             clusters;
};

std::vector<Window>
MakeWindows(const TaeniaEvidence & evidence)
{
  std::vector<Window> windows;
  const double        begin = evidence.arcLength.front();
  const double        end = evidence.arcLength.back();
  for (double middle = begin + 0.5 * windowLength; middle <= end - 0.5 * windowLength + 1.0;
       middle += 0.25 * windowLength)
  {
    Window window;
    window.middle = middle;
    for (const FoldEnd & e : evidence.ends)
    {
      if (std::abs(evidence.arcLength[static_cast<int>(e.row)] - middle) < 0.5 * windowLength)
      {
        window.points.push_back(OnCircle(e.angle));
      }
    }
    windows.push_back(std::move(window));
  }
  return windows;
}

void
TrackWindow(std::vector<Window> & windows, std::size_t at, std::size_t from)
{
  const Clusters & before = windows[from].clusters;
  windows[at].clusters = static_cast<int>(windows[at].points.size()) < leastEndsOfWindow
                           ? Clusters{ before.angles, before.spread, 0.0 }
                           : ClusterOf(windows[at].points, before.angles);
}

/** Tracks clusters in both directions from the window with the most fold ends. */
bool
TrackWindows(std::vector<Window> & windows)
{
  std::size_t start = 0;
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    start = windows[i].points.size() > windows[start].points.size() ? i : start;
  }
  if (windows.empty() || static_cast<int>(windows[start].points.size()) < 2 * leastEndsOfWindow)
  {
    return false;
  }
  windows[start].clusters = ClusterOf(windows[start].points, std::nullopt);
  for (std::size_t i = start + 1; i < windows.size(); ++i)
  {
    TrackWindow(windows, i, i - 1);
  }
  for (std::size_t i = start; i-- > 0;)
  {
    TrackWindow(windows, i, i + 1);
  }
  return true;
}

/** The most compact track, and two tracks one third and two thirds of the circumference away from it. */
void
ReplaceByThirds(std::vector<Window> & windows)
{
  std::array<double, 3> spread{};
  for (const Window & window : windows)
  {
    for (int c = 0; c < 3; ++c)
    {
      spread[c] += window.clusters.spread[c];
    }
  }
  const auto best = std::min_element(spread.begin(), spread.end()) - spread.begin();
  for (Window & window : windows)
  {
    const double angle = window.clusters.angles[best];
    window.clusters.angles = { angle, angle + 1.0 / 3.0, angle + 2.0 / 3.0 };
  }
}
} // namespace

TaeniaTracks
FuzzyTaeniae(const TaeniaEvidence & evidence, bool thirds)
{
  std::vector<Window> windows = MakeWindows(evidence);
  if (!TrackWindows(windows))
  {
    return {};
  }
  if (thirds)
  {
    ReplaceByThirds(windows);
  }
  TaeniaTracks tracks(evidence.rows);
  std::size_t  i = 0;
  for (int row = 0; row < evidence.rows; ++row)
  {
    const double s = evidence.arcLength[row];
    while (i + 2 < windows.size() && windows[i + 1].middle < s)
    {
      ++i;
    }
    const std::size_t next = std::min(i + 1, windows.size() - 1);
    const double      span = windows[next].middle - windows[i].middle;
    const double      t = span > 0.0 ? std::clamp((s - windows[i].middle) / span, 0.0, 1.0) : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      tracks[row][c] = (1.0 - t) * windows[i].clusters.angles[c] + t * windows[next].clusters.angles[c];
    }
  }
  return tracks;
}
} // namespace shapeton
