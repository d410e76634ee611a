#include "shapetonValveLogOdds.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The greatest one, and those around it. */
ValveEvidence
EvidenceOf(const std::vector<ValveBulge> & lips)
{
  const ValveBulge & greatest = lips.front();
  ValveEvidence      evidence;
  evidence.solidAngle = greatest.solidAngle;
  evidence.beforeEnd = greatest.beforeEnd;
  evidence.valve.width = greatest.width;
  evidence.valve.attenuation = greatest.attenuation;
  for (const ValveBulge & lip : lips)
  {
    evidence.area += lip.area;
    evidence.valve.position += lip.area * lip.place;
    evidence.valve.length =
      std::max(evidence.valve.length, (lip.place - greatest.place).norm() + 0.5 * (lip.length + greatest.length));
  }
  evidence.valve.position /= evidence.area;
  return evidence;
}

double
Squared(double value)
{
  return value * value;
}

/** From 0 to 1 about `middle`. */
double
Step(double value, double middle, double width)
{
  return 1.0 / (1.0 + std::exp(-(value - middle) / width));
}

/** How much likelier a valve has such an area than other bulges, whose number falls with it. A valve has about 200
 * mm^2; more than that is no further evidence, as large polyps have it, too. */
double
LogOddsOfSize(double area)
{
  constexpr double typical = 200.0, most = 260.0, decay = 55.0, offset = -1.5;
  const double     spread = area < typical ? 0.5 : 0.6;
  return offset + std::min(area, most) / decay - 0.5 * Squared(std::log(area / typical) / spread);
}

/** How much likelier a valve has such an inside than other bulges: lips hold fat in most patients, but so does what
 * lies behind a thin wall; gas and tagged matter are no tissue. */
double
LogOddsOfContent(double hounsfield)
{
  constexpr double ofFat = 0.7, ofSoftTissue = -0.5, ofOthers = -4.0;
  if (!std::isfinite(hounsfield))
  {
    return 0.0;
  }
  const double isTissue = Step(hounsfield, -250.0, 30.0) * (1.0 - Step(hounsfield, 200.0, 25.0));
  const double isFat = 1.0 - Step(hounsfield, -5.0, 10.0);
  return isTissue * (isFat * ofFat + (1.0 - isFat) * ofSoftTissue) + (1.0 - isTissue) * ofOthers;
}
} // namespace

std::vector<ValveEvidence>
JoinLips(std::vector<ValveBulge> bulges)
{
  constexpr double reach = 18.0; // mm
  std::stable_sort(bulges.begin(), bulges.end(), [](const auto & a, const auto & b) { return a.area > b.area; });
  std::vector<ValveEvidence> places;
  while (!bulges.empty())
  {
    const Eigen::Vector3d middle = bulges.front().place;
    const auto            rest = std::stable_partition(
      bulges.begin(), bulges.end(), [&](const ValveBulge & bulge) { return (bulge.place - middle).norm() <= reach; });
    places.push_back(EvidenceOf({ bulges.begin(), rest }));
    bulges.erase(bulges.begin(), rest);
  }
  return places;
}

double
ValveLogOdds(const ValveEvidence & evidence)
{
  const double ofPlace = -0.5 * Squared((evidence.beforeEnd - 70.0) / 40.0);
  // A ball of any size has 4 pi: the head of a polyp on its stalk.
  const double ofBall = -4.0 * Step(evidence.solidAngle, 8.5, 0.7);
  return LogOddsOfSize(evidence.area) + ofPlace + ofBall + LogOddsOfContent(evidence.valve.attenuation);
}
} // namespace shapeton
