#include "shapetonCentrelineStations.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
std::vector<CentrelineStation>
StationsOf(const CurveSet & centreline)
{
  const std::string              what = "the centreline";
  const Eigen::VectorXd          distance = PointValues(centreline, "arcLength", what);
  const Eigen::VectorXd          radius = PointValues(centreline, "radius", what);
  const auto *                   gap = FindSurfaceArray(centreline.pointArrays, "gap");
  std::vector<CentrelineStation> stations;
  for (const std::vector<int> & curve : centreline.curves)
  {
    for (const int vertex : curve)
    {
      stations.push_back({ centreline.V.row(vertex).transpose(),
                           vertex,
                           distance[vertex],
                           2.0 * radius[vertex],
                           gap && gap->values(vertex, 0) != 0.0 });
    }
  }
  if (stations.empty())
  {
    throw InputError("the centreline has no points");
  }
  return stations;
}

ColorScale
DistanceScale(const std::vector<CentrelineStation> & stations)
{
  ColorScale scale;
  scale.title = "distance from the anal verge (mm)";
  for (const CentrelineStation & station : stations)
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
