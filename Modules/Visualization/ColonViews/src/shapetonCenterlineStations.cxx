#include "shapetonCenterlineStations.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
std::vector<CenterlineStation>
StationsOf(const CurveSet & centerline)
{
  const std::string              what = "the centerline";
  const Eigen::VectorXd          distance = PointValues(centerline, "arcLength", what);
  const Eigen::VectorXd          radius = PointValues(centerline, "radius", what);
  const auto *                   gap = FindSurfaceArray(centerline.pointArrays, "gap");
  std::vector<CenterlineStation> stations;
  for (const std::vector<int> & curve : centerline.curves)
  {
    for (const int vertex : curve)
    {
      stations.push_back({ centerline.V.row(vertex).transpose(),
                           vertex,
                           distance[vertex],
                           2.0 * radius[vertex],
                           gap && gap->values(vertex, 0) != 0.0 });
    }
  }
  if (stations.empty())
  {
    throw InputError("the centerline has no points");
  }
  return stations;
}

ColorScale
DistanceScale(const std::vector<CenterlineStation> & stations)
{
  ColorScale scale;
  scale.title = "distance from the anal verge (cm)";
  scale.shownPerValue = MillimetersAsCentimeters;
  for (const CenterlineStation & station : stations)
  {
    scale.upper = std::max(scale.upper, station.distance);
  }
  return scale;
}

RGBColor
GapColor()
{
  return MakeColor(255, 255, 255);
}
} // namespace shapeton
