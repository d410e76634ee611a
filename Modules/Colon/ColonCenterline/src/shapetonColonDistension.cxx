#include "shapetonColonDistension.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Adds the part of a step along the line that is within the stretch. */
void
AddStep(double from, double to, double caliber, bool isGap, ColonDistension & stretch)
{
  const double part = std::min(to, stretch.end) - std::max(from, stretch.begin);
  if (part <= 0.0)
  {
    return;
  }
  stretch.share += caliber >= LeastDistendedCaliber ? part : 0.0;
  stretch.meanCaliber += part * caliber;
  stretch.leastCaliber = std::min(stretch.leastCaliber, caliber);
  stretch.largestCaliber = std::max(stretch.largestCaliber, caliber);
  stretch.collapsedLength += isGap ? part : 0.0;
}
} // namespace

double
EndOfAnalCanal(const Eigen::VectorXd & arcLength, const Eigen::VectorXd & radius)
{
  double end = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0;
       i < radius.size() && 2.0 * radius[i] < LeastDistendedCaliber && arcLength[i] - arcLength[0] <= AnalCanalLength;
       ++i)
  {
    end = arcLength[i];
  }
  return end;
}

ColonDistension
MeasureDistension(const CurveSet & curve, double begin, double end)
{
  RequireParameter(end >= begin, "the end of a stretch of the colon must not precede its beginning");
  const Eigen::VectorXd arc = PointValues(curve, "arcLength", "the centerline");
  const Eigen::VectorXd radius = PointValues(curve, "radius", "the centerline");
  const Eigen::VectorXd gap = PointValues(curve, "gap", "the centerline");
  const Eigen::Index    last = arc.size() - 1;
  if (last < 1 || !(arc[last] > arc[0]))
  {
    throw InputError("the centerline has zero length: distension cannot be measured. Give a line of several points.");
  }
  ColonDistension distension;
  distension.begin = std::clamp(begin, arc[0], arc[last]);
  distension.end = std::clamp(end, arc[0], arc[last]);
  distension.leastCaliber = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < last; ++i)
  {
    const bool   isGap = gap[i] != 0.0 || gap[i + 1] != 0.0;
    const double caliber = isGap ? 0.0 : radius[i] + radius[i + 1];
    AddStep(arc[i], arc[i + 1], caliber, isGap, distension);
  }
  const double length = distension.end - distension.begin;
  distension.share = length > 0.0 ? distension.share / length : 0.0;
  distension.meanCaliber = length > 0.0 ? distension.meanCaliber / length : 0.0;
  distension.leastCaliber = length > 0.0 ? distension.leastCaliber : 0.0;
  return distension;
}
} // namespace shapeton
