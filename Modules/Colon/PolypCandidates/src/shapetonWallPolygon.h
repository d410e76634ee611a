#ifndef shapetonWallPolygon_h
#define shapetonWallPolygon_h

#include "shapetonSurfaceShape.h"

#include <Eigen/Geometry>

#include <vector>

namespace shapeton
{
/** A point of a wall with values interpolated linearly within a face. */
struct WallPlace
{
  Eigen::Vector3d point;
  Eigen::Vector3d inwardNormal;
  /** Principal curvatures, 1/mm. */
  double greater;
  double lesser;
};

/** A planar part of a face, with ordered corners. */
using WallPolygon = std::vector<WallPlace>;

WallPlace
Between(const WallPlace & a, const WallPlace & b, double share);

/** Clips a polygon to the part where a linear function with these corner values is positive. New corners are appended
 * to `rim` if given. */
WallPolygon
WherePositive(const WallPolygon &            polygon,
              const std::vector<double> &    values,
              std::vector<Eigen::Vector3d> * rim = nullptr);

/** Calls body(point, area) for the quadrature points of a polygon (edge midpoints of its triangles); exact for
 * quadratic functions. */
template <typename TBody>
void
ForEachShare(const WallPolygon & polygon, const TBody & body)
{
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const WallPlace *     corners[] = { &polygon[0], &polygon[i - 1], &polygon[i] };
    const Eigen::Vector3d first = corners[1]->point - corners[0]->point;
    const Eigen::Vector3d second = corners[2]->point - corners[0]->point;
    const double          share = first.cross(second).norm() / 6.0;
    for (int k = 0; k < 3; ++k)
    {
      body(Between(*corners[k], *corners[(k + 1) % 3], 0.5), share);
    }
  }
}
} // namespace shapeton

#endif
