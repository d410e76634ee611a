#include "shapetonValveLogOdds.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double leastOfTissue = -250.0, mostOfTissue = 200.0; // HU; gas is below, tagged matter above

/** Whether a bulge may be a lip; unknown without a CT. */
bool
IsTissue(const ValveBulge & bulge)
{
  return std::isnan(bulge.attenuation) || (bulge.attenuation >= leastOfTissue && bulge.attenuation <= mostOfTissue);
}

/** Whether two bulges are adjacent and of similar size. The limits leave a margin around the lips of realistic 1 to 7:
 * 9 to 15 mm apart, 59 to 176 mm^2 each, area ratio up to 2.1. A polyp is one bulge. */
bool
AreTwoLips(const ValveBulge & a, const ValveBulge & b)
{
  constexpr double nearest = 7.0, farthest = 17.0; // mm
  constexpr double leastArea = 35.0;               // mm^2
  constexpr double mostRatio = 2.5;
  const double     distance = (a.place - b.place).norm();
  const auto       areas = std::minmax(a.area, b.area);
  return distance >= nearest && distance <= farthest && areas.first >= leastArea &&
         areas.second <= mostRatio * areas.first;
}

/** Evidence from the largest bulge, which is first, and its neighbors. */
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
    evidence.hasTwoLips |=
      std::any_of(lips.begin(), lips.end(), [&lip](const ValveBulge & other) { return AreTwoLips(lip, other); });
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

/** Smooth step from 0 to 1 at `middle`. */
double
Step(double value, double middle, double width)
{
  return 1.0 / (1.0 + std::exp(-(value - middle) / width));
}

/** Log-likelihood ratio of the area for a valve versus other bulges: other bulges become rarer as the area increases. A
 * valve covers about 200 mm^2; larger areas are not further evidence, since large polyps exist. */
double
LogOddsOfSize(double area)
{
  // Areas (mm^2) and log odds; chosen on the seeds and real colons named in colon-landmarks.md.
  constexpr double typical = 200.0, most = 260.0, decay = 55.0, offset = -1.5;
  const double     spread = area < typical ? 0.5 : 0.6;
  return offset + std::min(area, most) / decay - 0.5 * Squared(std::log(area / typical) / spread);
}

/** Log-likelihood ratio of the tissue for a valve versus other bulges. Lips contain fat in most patients, but so does
 * the tissue behind a thin wall. Gas and tagged matter are not tissue. */
double
LogOddsOfContent(double hounsfield)
{
  // Log odds; chosen on the seeds and real colons named in colon-landmarks.md.
  constexpr double ofFat = 0.7, ofSoftTissue = -0.5, ofOthers = -4.0;
  if (!std::isfinite(hounsfield))
  {
    return 0.0;
  }
  const double isTissue = Step(hounsfield, leastOfTissue, 30.0) * (1.0 - Step(hounsfield, mostOfTissue, 25.0));
  const double isFat = 1.0 - Step(hounsfield, -5.0, 10.0);
  return isTissue * (isFat * ofFat + (1.0 - isFat) * ofSoftTissue) + (1.0 - isTissue) * ofOthers;
}
} // namespace

std::vector<ValveEvidence>
JoinLips(std::vector<ValveBulge> bulges)
{
  constexpr double reach = 18.0; // mm; maximum distance between the lips of a valve
  std::stable_sort(bulges.begin(), bulges.end(), [](const auto & a, const auto & b) { return a.area > b.area; });
  std::vector<ValveEvidence> places;
  while (!bulges.empty())
  {
    const Eigen::Vector3d middle = bulges.front().place;
    const bool            isTissue = IsTissue(bulges.front());
    const auto            rest = std::stable_partition(bulges.begin(), bulges.end(), [&](const ValveBulge & bulge) {
      return (bulge.place - middle).norm() <= reach && IsTissue(bulge) == isTissue;
    });
    places.push_back(EvidenceOf({ bulges.begin(), rest }));
    bulges.erase(bulges.begin(), rest);
  }
  return places;
}

double
ValveLogOdds(const ValveEvidence & evidence)
{
  const double ofPlace = -0.5 * Squared((evidence.beforeEnd - 70.0) / 40.0);
  // The solid angle of a ball, such as the head of a polyp on a stalk, is 4 pi.
  const double ofBall = -4.0 * Step(evidence.solidAngle, 8.5, 0.7);
  // Log odds; chosen: 17 of 18 valves of realistic 1 to 9 and 1011 have two lips, none of 20 other places. Valves
  // without separate lips exist.
  constexpr double ofTwoLips = 2.3;
  const double     ofLips = evidence.hasTwoLips ? ofTwoLips : 0.0;
  return LogOddsOfSize(evidence.area) + ofPlace + ofBall + ofLips + LogOddsOfContent(evidence.valve.attenuation);
}
} // namespace shapeton
