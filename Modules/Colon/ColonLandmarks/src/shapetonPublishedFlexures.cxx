#include "shapetonPi.h"
#include "shapetonPublishedFlexures.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace shapeton
{
namespace
{
constexpr double leastBend = 50.0;  // degrees between chords of 40 mm; chosen
constexpr double chord = 40.0;      // mm; chosen
constexpr double spread = 25.0;     // mm; chosen: at most one bend within this distance
constexpr double sameBend = 20.0;   // mm between its places in the two projections; chosen
constexpr double comparable = 25.0; // mm front to back; chosen, "comparable y" is undefined

/** Angle (degrees) between the chords before and after a point, projected onto the plane of two axes. */
double
BendInPlane(const VertexMatrix & points, int i, int reach, int first, int second)
{
  const Eigen::RowVector3d before = points.row(i) - points.row(i - reach);
  const Eigen::RowVector3d behind = points.row(i + reach) - points.row(i);
  const double angle = std::atan2(behind[second], behind[first]) - std::atan2(before[second], before[first]);
  return std::abs(std::remainder(angle, TwoPi)) * 180.0 / Pi;
}

std::vector<int>
BendsInPlane(const VertexMatrix & points, int first, int second)
{
  const int        reach = static_cast<int>(chord / CenterlineShape::Step);
  const int        window = static_cast<int>(spread / CenterlineShape::Step);
  const int        size = static_cast<int>(points.rows());
  Eigen::VectorXd  bend = Eigen::VectorXd::Zero(size);
  std::vector<int> peaks;
  for (int i = reach; i < size - reach; ++i)
  {
    bend[i] = BendInPlane(points, i, reach, first, second);
  }
  for (int i = reach; i < size - reach; ++i)
  {
    const int begin = std::max(0, i - window);
    const int end = std::min(size, i + window + 1);
    if (bend[i] > leastBend && bend[i] == bend.segment(begin, end - begin).maxCoeff())
    {
      peaks.push_back(i);
    }
  }
  return peaks;
}

/** Bends of both projections in order; of bends closer than sameBend, only the first is kept. */
std::vector<int>
MajorBends(const VertexMatrix & points)
{
  std::set<int> both;
  for (const int second : { 0, 1 })
  {
    const std::vector<int> peaks = BendsInPlane(points, second, 2);
    both.insert(peaks.begin(), peaks.end());
  }
  std::vector<int> result;
  for (const int i : both)
  {
    if (result.empty() || (i - result.back()) * CenterlineShape::Step >= sameBend)
    {
      result.push_back(i);
    }
  }
  return result;
}
} // namespace

std::array<int, 4>
PublishedFlexures(const CenterlineShape & shape)
{
  std::array<int, 4>     result{ -1, -1, -1, -1 };
  const VertexMatrix &   points = shape.Points();
  const std::vector<int> bends = MajorBends(shape.Smoothed(12.0));
  if (bends.size() < 3)
  {
    return result;
  }
  std::vector<int> byHeight = bends;
  std::stable_sort(byHeight.begin(), byHeight.end(), [&](int a, int b) { return points(a, 2) > points(b, 2); });
  // The line starts at the rectum, so the splenic flexure is the first of the two.
  result[2] = std::min(byHeight[0], byHeight[1]);
  result[3] = std::max(byHeight[0], byHeight[1]);
  result[0] = byHeight.back();
  for (const int i : byHeight)
  {
    const bool isTaken = std::find(result.begin(), result.end(), i) != result.end();
    if (!isTaken && std::abs(points(i, 1) - points(result[2], 1)) < comparable)
    {
      result[1] = i;
      break;
    }
  }
  return result;
}
} // namespace shapeton
