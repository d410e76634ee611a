#include "shapetonPi.h"
#include "shapetonWallBulges.h"

#include "shapetonPrincipalAxes.h"
#include "shapetonWallPolygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

/** Extent (mm from the rim) of the ring that measures the foot: the whole ring for the curvature, the outer part beyond
 * the fillet for the height. */
constexpr double ringBegin = 1.0;
constexpr double ringEnd = 2.0;

/** Measures the parts of a wall where a level function, linear within faces, is positive. All measures are integrals or
 * extents within the exact rim, so they hardly depend on where the vertices are. */
class BulgeFinder
{
public:
  BulgeFinder(const SurfaceMesh &         wall,
              const SurfaceConnectivity & connectivity,
              const SurfaceShape &        shape,
              const Eigen::VectorXd &     level)
    : m_Wall(wall), m_Connectivity(connectivity), m_Shape(shape), m_Level(level)
  {}

  /** Finds the vertices connected to a seed and removes them from `isFree`. */
  std::vector<int>
  Grow(int seed, std::vector<char> & isFree) const
  {
    std::vector<int> found{ seed };
    isFree[seed] = 0;
    for (std::size_t next = 0; next < found.size(); ++next)
    {
      for (const int neighbor : m_Connectivity.NeighborsOfVertex(found[next]))
      {
        if (isFree[neighbor])
        {
          isFree[neighbor] = 0;
          found.push_back(neighbor);
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /** A bulge and the points at which its rim crosses edges. */
  struct Rimmed
  {
    WallBulge             bulge;
    std::vector<Vector3d> rim;
  };

  Rimmed
  Measure(std::vector<int> vertices) const
  {
    Rimmed part;
    part.bulge.vertices = std::move(vertices);
    this->SumUp(part);
    this->MeasureWidths(part);
    return part;
  }

  void
  MeasureFoot(Rimmed & part) const
  {
    WallBulge & bulge = part.bulge;
    const Foot  foot = this->FindFoot(part);
    double      most = -std::numeric_limits<double>::infinity();
    for (const int vertex : bulge.vertices)
    {
      const double above = (this->PointOf(vertex) - foot.middle).dot(bulge.axis);
      if (above > most)
      {
        most = above;
        bulge.apex = this->PointOf(vertex);
      }
    }
    bulge.height = std::max(0.0, most);
    bulge.footCurvature = foot.curvature;
  }

private:
  Vector3d
  PointOf(int vertex) const
  {
    return m_Wall.V.row(vertex).transpose();
  }

  WallPolygon
  PolygonOf(int face) const
  {
    WallPolygon polygon;
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = m_Wall.F(face, k);
      polygon.push_back({ this->PointOf(vertex),
                          m_Shape.inwardNormals.row(vertex).transpose(),
                          m_Shape.greater[vertex],
                          m_Shape.lesser[vertex] });
    }
    return polygon;
  }

  /** Level at the corners of a face, times `sign`. */
  std::vector<double>
  LevelsOf(int face, double sign) const
  {
    return { sign * m_Level[m_Wall.F(face, 0)], sign * m_Level[m_Wall.F(face, 1)], sign * m_Level[m_Wall.F(face, 2)] };
  }

  /** In ascending order. */
  std::vector<int>
  FacesAt(const std::vector<int> & vertices) const
  {
    std::vector<int> faces;
    for (const int vertex : vertices)
    {
      const IndexRange some = m_Connectivity.FacesOfVertex(vertex);
      faces.insert(faces.end(), some.begin(), some.end());
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  void
  SumUp(Rimmed & part) const
  {
    WallBulge & bulge = part.bulge;
    Vector3d    normal = Vector3d::Zero();
    double      weight = 0.0;
    for (const int face : this->FacesAt(bulge.vertices))
    {
      ForEachShare(WherePositive(this->PolygonOf(face), this->LevelsOf(face, 1.0), &part.rim),
                   [&](const WallPlace & place, double area) {
                     const double bulging = area * std::max(place.lesser, 0.0);
                     bulge.area += area;
                     bulge.center += area * place.point;
                     bulge.solidAngle += area * place.greater * place.lesser;
                     bulge.shapeIndex += bulging * ShapeIndex(place.greater, place.lesser);
                     bulge.curvedness += area * Curvedness(place.greater, place.lesser);
                     normal += area * place.inwardNormal;
                     weight += bulging;
                   });
    }
    bulge.center /= bulge.area;
    bulge.shapeIndex /= std::max(weight, 1e-12);
    bulge.curvedness /= bulge.area;
    bulge.axis = normal.normalized();
  }

  /** Points within and on the rim. */
  std::vector<Vector3d>
  PointsOf(const Rimmed & part) const
  {
    std::vector<Vector3d> points = part.rim;
    for (const int vertex : part.bulge.vertices)
    {
      points.push_back(this->PointOf(vertex));
    }
    return points;
  }

  /** Directions perpendicular to the axis are relative to the direction of largest spread, so that the widths are
   * invariant to rotation and reflection. */
  void
  MeasureWidths(Rimmed & part) const
  {
    constexpr int               directions = 36; // chosen: one per 5 degrees
    WallBulge &                 bulge = part.bulge;
    const std::vector<Vector3d> points = this->PointsOf(part);
    const Vector3d              right = WidestDirection(points, bulge.axis);
    const Vector3d              up = bulge.axis.cross(right);
    bulge.leastWidth = std::numeric_limits<double>::infinity();
    for (int i = 0; i < directions; ++i)
    {
      const double   angle = Pi * i / directions;
      const Vector3d direction = std::cos(angle) * right + std::sin(angle) * up;
      double         low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vector3d & point : points)
      {
        const double place = point.dot(direction);
        low = std::min(low, place);
        high = std::max(high, place);
      }
      bulge.greatestWidth = std::max(bulge.greatestWidth, high - low);
      bulge.leastWidth = std::min(bulge.leastWidth, high - low);
    }
  }

  static Vector3d
  WidestDirection(const std::vector<Vector3d> & points, const Vector3d & axis)
  {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d & point : points)
    {
      mean += point / static_cast<double>(points.size());
    }
    const Vector3d  right = axis.unitOrthogonal();
    const Vector3d  up = axis.cross(right);
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (const Vector3d & point : points)
    {
      const Eigen::Vector2d place((point - mean).dot(right), (point - mean).dot(up));
      second += place * place.transpose();
    }
    const Eigen::Vector2d widest = PrincipalAxes(second).vectors.col(1);
    return widest[0] * right + widest[1] * up;
  }

  static double
  DistanceTo(const std::vector<Vector3d> & rim, const Vector3d & point)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3d & other : rim)
    {
      least = std::min(least, (other - point).squaredNorm());
    }
    return std::sqrt(least);
  }

  /** Faces connected within `reach` mm (Euclidean distance) of the rim, including at least the faces at the vertices of
   * the bulge. */
  std::vector<int>
  FacesAround(const Rimmed & part, double reach) const
  {
    std::vector<int> reached = part.bulge.vertices;
    std::vector<int> known = reached;
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      for (const int neighbor : m_Connectivity.NeighborsOfVertex(reached[next]))
      {
        const auto place = std::lower_bound(known.begin(), known.end(), neighbor);
        if (place == known.end() || *place != neighbor)
        {
          known.insert(place, neighbor);
          if (DistanceTo(part.rim, this->PointOf(neighbor)) <= reach)
          {
            reached.push_back(neighbor);
          }
        }
      }
    }
    return this->FacesAt(reached);
  }

  /** The part of a face outside the rim. */
  WallPolygon
  OutsideOf(const Rimmed & part, int face) const
  {
    const auto isMember = [&](int vertex) {
      return std::binary_search(part.bulge.vertices.begin(), part.bulge.vertices.end(), vertex);
    };
    const auto corners = m_Wall.F.row(face);
    // A positive level in a face without a vertex of this bulge is part of another bulge.
    return isMember(corners[0]) || isMember(corners[1]) || isMember(corners[2])
             ? WherePositive(this->PolygonOf(face), this->LevelsOf(face, -1.0))
             : this->PolygonOf(face);
  }

  /** The part of a polygon within a distance (mm) of the rim. */
  static WallPolygon
  NearRim(const WallPolygon & polygon, const std::vector<Vector3d> & rim, double distance, double sign)
  {
    std::vector<double> values;
    for (const WallPlace & corner : polygon)
    {
      values.push_back(sign * (distance - DistanceTo(rim, corner.point)));
    }
    return WherePositive(polygon, values);
  }

  /** Measurements of the ring around a bulge. */
  struct Foot
  {
    Vector3d middle{ Vector3d::Zero() };
    double   curvature{ 0.0 };
  };

  Foot
  FindFoot(const Rimmed & part) const
  {
    Foot     foot;
    Vector3d all = Vector3d::Zero(), outer = Vector3d::Zero();
    double   area = 0.0, outerArea = 0.0;
    for (const int face : this->FacesAround(part, ringEnd))
    {
      const WallPolygon ring = NearRim(this->OutsideOf(part, face), part.rim, ringEnd, 1.0);
      ForEachShare(ring, [&](const WallPlace & place, double share) {
        area += share;
        all += share * place.point;
        foot.curvature += share * place.lesser;
      });
      ForEachShare(NearRim(ring, part.rim, ringBegin, -1.0), [&](const WallPlace & place, double share) {
        outerArea += share;
        outer += share * place.point;
      });
    }
    foot.curvature /= std::max(area, 1e-12);
    foot.middle = outerArea > 0.0 ? Vector3d(outer / outerArea)
                  : area > 0.0    ? Vector3d(all / area)
                                  : this->PointOf(part.bulge.vertices.front());
    return foot;
  }

  const SurfaceMesh &         m_Wall;
  const SurfaceConnectivity & m_Connectivity;
  const SurfaceShape &        m_Shape;
  const Eigen::VectorXd &     m_Level;
};

/** The smaller principal curvature minus a minimum (1/mm); negative where the wall is excluded. */
Eigen::VectorXd
LevelAbove(double leastCurvature, const SurfaceShape & shape, const std::vector<char> & isLeftOut)
{
  constexpr double outside = -1.0; // 1/mm, so that parts end at excluded wall
  Eigen::VectorXd  level = shape.lesser.array() - leastCurvature;
  for (Eigen::Index i = 0; i < level.size(); ++i)
  {
    level[i] = isLeftOut[i] ? outside : level[i];
  }
  return level;
}
} // namespace

std::vector<WallBulge>
MeasureWallParts(const SurfaceMesh &         wall,
                 const SurfaceConnectivity & connectivity,
                 const SurfaceShape &        shape,
                 const Eigen::VectorXd &     level,
                 const WallPartLimits &      limits)
{
  const BulgeFinder finder(wall, connectivity, shape, level);
  std::vector<char> isFree(level.size());
  for (Eigen::Index i = 0; i < level.size(); ++i)
  {
    isFree[i] = level[i] > 0.0;
  }
  std::vector<WallBulge> parts;
  for (int seed = 0; seed < level.size(); ++seed)
  {
    if (!isFree[seed])
    {
      continue;
    }
    BulgeFinder::Rimmed part = finder.Measure(finder.Grow(seed, isFree));
    const WallBulge &   bulge = part.bulge;
    if (bulge.area > 0.0 && bulge.solidAngle >= limits.leastSolidAngle && bulge.solidAngle < limits.solidAngleEnd &&
        bulge.leastWidth >= limits.leastWidth)
    {
      finder.MeasureFoot(part);
      parts.push_back(std::move(part.bulge));
    }
  }
  return parts;
}

std::vector<WallBulge>
FindWallBulges(const SurfaceMesh &         wall,
               const SurfaceConnectivity & connectivity,
               const SurfaceShape &        shape,
               const std::vector<char> &   isLeftOut,
               double                      leastCurvature)
{
  return MeasureWallParts(wall, connectivity, shape, LevelAbove(leastCurvature, shape, isLeftOut));
}

std::vector<WallBulge>
FindWallPlaques(const SurfaceMesh &         wall,
                const SurfaceConnectivity & connectivity,
                const SurfaceShape &        shape,
                const std::vector<char> &   isLeftOut)
{
  // The wall around a plaque is concave or straight, so any convex part is accepted. Narrower parts are ripples.
  constexpr double     leastCurvature = 0.0; // 1/mm
  constexpr double     leastWidth = 4.0;     // mm
  const WallPartLimits limits{ 0.0, leastWidth, LeastSolidAngleOfBulge };
  return MeasureWallParts(wall, connectivity, shape, LevelAbove(leastCurvature, shape, isLeftOut), limits);
}
} // namespace shapeton
