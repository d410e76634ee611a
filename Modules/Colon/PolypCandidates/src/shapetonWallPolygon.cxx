#include "shapetonWallPolygon.h"

namespace shapeton
{
WallPlace
Between(const WallPlace & a, const WallPlace & b, double share)
{
  return { a.point + share * (b.point - a.point),
           a.inwardNormal + share * (b.inwardNormal - a.inwardNormal),
           a.greater + share * (b.greater - a.greater),
           a.lesser + share * (b.lesser - a.lesser) };
}

WallPolygon
WherePositive(const WallPolygon & polygon, const std::vector<double> & values, std::vector<Eigen::Vector3d> * rim)
{
  WallPolygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const std::size_t next = (i + 1) % polygon.size();
    if (values[i] > 0.0)
    {
      part.push_back(polygon[i]);
    }
    if ((values[i] > 0.0) != (values[next] > 0.0))
    {
      part.push_back(Between(polygon[i], polygon[next], values[i] / (values[i] - values[next])));
      if (rim != nullptr)
      {
        rim->push_back(part.back().point);
      }
    }
  }
  return part;
}
} // namespace shapeton
