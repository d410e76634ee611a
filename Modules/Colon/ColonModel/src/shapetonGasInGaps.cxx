#include "shapetonGasInGaps.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double leastGap = 30.0;   // mm; chosen: shorter gaps need no repair
constexpr double leastMl = 10.0;    // ml; chosen: hard 104 supine lacked 31, see colon-surfaces.md
constexpr double leastRadius = 7.0; // mm; chosen: thinner gas is small bowel
constexpr double nearShare = 0.25;  // of the gap; chosen
constexpr double nearest = 20.0;    // mm; chosen

double
DistanceOf(const ColonLeftOut & gas, const itk::Point<double, 3> & end)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto & place : gas.places)
  {
    least = std::min(least, place.EuclideanDistanceTo(end));
  }
  return least;
}

bool
Joins(const ColonLeftOut & gas, const CenterlineGap & gap)
{
  const double close = std::min(nearest, nearShare * gap.distance);
  return gas.ml >= leastMl && gas.inscribedRadius >= leastRadius && DistanceOf(gas, gap.from) <= close &&
         DistanceOf(gas, gap.to) <= close;
}
} // namespace

std::vector<GasInGap>
FindGasInGaps(const ColonLumen & lumen, const ColonCenterline & line)
{
  std::vector<GasInGap> found;
  for (const CenterlineGap & gap : line.gaps)
  {
    const auto gas = std::find_if(lumen.leftOut.begin(), lumen.leftOut.end(), [&gap](const ColonLeftOut & one) {
      return gap.distance >= leastGap && Joins(one, gap);
    });
    if (gas != lumen.leftOut.end())
    {
      found.push_back({ gap, *gas });
    }
  }
  return found;
}

double
LengthOfGaps(const ColonCenterline & line)
{
  double length = 0.0;
  for (const CenterlineGap & gap : line.gaps)
  {
    length += gap.distance;
  }
  return length;
}
} // namespace shapeton
