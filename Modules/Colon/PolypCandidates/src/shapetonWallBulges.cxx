#include "shapetonWallBulges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

/** The ring around the bulge that tells of its foot, mm along edges: all of it for the curvature, the outer part,
 * beyond the fillet, for the height. */
constexpr double ringBegin = 1.0;
constexpr double ringEnd = 2.0;

class BulgeFinder
{
public:
  BulgeFinder(const VertexMatrix & V, const SurfaceConnectivity & connectivity, const SurfaceShape & shape)
    : m_V(V), m_Connectivity(connectivity), m_Shape(shape)
  {}

  /** The connected vertices around one; takes them out of `isFree`. */
  std::vector<int>
  Grow(int seed, std::vector<char> & isFree) const
  {
    std::vector<int> found{ seed };
    isFree[seed] = 0;
    for (std::size_t next = 0; next < found.size(); ++next)
    {
      for (const int neighbour : m_Connectivity.NeighboursOfVertex(found[next]))
      {
        if (isFree[neighbour])
        {
          isFree[neighbour] = 0;
          found.push_back(neighbour);
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  WallBulge
  Measure(std::vector<int> vertices) const
  {
    WallBulge bulge;
    bulge.vertices = std::move(vertices);
    this->SumUp(bulge);
    this->MeasureWidths(bulge);
    return bulge;
  }

  void
  MeasureFoot(WallBulge & bulge) const
  {
    const Foot foot = this->FindFoot(bulge.vertices);
    double     most = -std::numeric_limits<double>::infinity();
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
    return m_V.row(vertex).transpose();
  }

  void
  SumUp(WallBulge & bulge) const
  {
    Vector3d normal = Vector3d::Zero();
    for (const int vertex : bulge.vertices)
    {
      const double area = m_Shape.areas[vertex];
      const double greater = m_Shape.greater[vertex], lesser = m_Shape.lesser[vertex];
      bulge.area += area;
      bulge.centre += area * this->PointOf(vertex);
      bulge.solidAngle += area * greater * lesser;
      bulge.shapeIndex += area * ShapeIndex(greater, lesser);
      bulge.curvedness += area * Curvedness(greater, lesser);
      normal += area * m_Shape.inwardNormals.row(vertex).transpose();
    }
    bulge.centre /= bulge.area;
    bulge.shapeIndex /= bulge.area;
    bulge.curvedness /= bulge.area;
    bulge.axis = normal.normalized();
  }

  void
  MeasureWidths(WallBulge & bulge) const
  {
    constexpr int  directions = 36;
    const Vector3d right = bulge.axis.unitOrthogonal();
    const Vector3d up = bulge.axis.cross(right);
    bulge.leastWidth = std::numeric_limits<double>::infinity();
    for (int i = 0; i < directions; ++i)
    {
      const double   angle = M_PI * i / directions;
      const Vector3d direction = std::cos(angle) * right + std::sin(angle) * up;
      double         low = std::numeric_limits<double>::infinity(), high = -low;
      for (const int vertex : bulge.vertices)
      {
        const double place = m_V.row(vertex).dot(direction);
        low = std::min(low, place);
        high = std::max(high, place);
      }
      bulge.greatestWidth = std::max(bulge.greatestWidth, high - low);
      bulge.leastWidth = std::min(bulge.leastWidth, high - low);
    }
  }

  /** Vertices around the bulge within `reach` mm along edges, and all its neighbours where edges are longer; with the
   * way to each. */
  std::vector<std::pair<int, double>>
  Around(const std::vector<int> & vertices, double reach) const
  {
    std::vector<std::pair<int, double>> reached;
    std::vector<int>                    known(vertices);
    for (const int vertex : vertices)
    {
      reached.emplace_back(vertex, 0.0);
    }
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      const auto [vertex, way] = reached[next];
      for (const int neighbour : m_Connectivity.NeighboursOfVertex(vertex))
      {
        const double whole = way + (this->PointOf(neighbour) - this->PointOf(vertex)).norm();
        const auto   place = std::lower_bound(known.begin(), known.end(), neighbour);
        if (whole <= reach && (place == known.end() || *place != neighbour))
        {
          known.insert(place, neighbour);
          reached.emplace_back(neighbour, whole);
        }
      }
    }
    reached.erase(reached.begin(), reached.begin() + static_cast<std::ptrdiff_t>(vertices.size()));
    for (const int vertex : vertices)
    {
      for (const int neighbour : m_Connectivity.NeighboursOfVertex(vertex))
      {
        const auto place = std::lower_bound(known.begin(), known.end(), neighbour);
        if (place == known.end() || *place != neighbour)
        {
          known.insert(place, neighbour);
          reached.emplace_back(neighbour, (this->PointOf(neighbour) - this->PointOf(vertex)).norm());
        }
      }
    }
    return reached;
  }

  /** Of the ring around a bulge. */
  struct Foot
  {
    Vector3d middle{ Vector3d::Zero() };
    double   curvature{ 0.0 };
  };

  Foot
  FindFoot(const std::vector<int> & vertices) const
  {
    Foot       foot;
    Vector3d   sum = Vector3d::Zero(), rim = Vector3d::Zero();
    double     ringArea = 0.0, area = 0.0;
    const auto around = this->Around(vertices, ringEnd);
    for (const auto & [vertex, way] : around)
    {
      const double part = m_Shape.areas[vertex];
      area += part;
      foot.curvature += part * m_Shape.lesser[vertex];
      rim += this->PointOf(vertex) / static_cast<double>(around.size());
      if (way >= ringBegin && way <= ringEnd)
      {
        sum += part * this->PointOf(vertex);
        ringArea += part;
      }
    }
    foot.curvature /= std::max(area, 1e-12);
    foot.middle = ringArea > 0.0 ? Vector3d(sum / ringArea) : !around.empty() ? rim : this->PointOf(vertices.front());
    return foot;
  }

  const VertexMatrix &        m_V;
  const SurfaceConnectivity & m_Connectivity;
  const SurfaceShape &        m_Shape;
};
} // namespace

std::vector<WallBulge>
MeasureWallParts(const VertexMatrix &        V,
                 const SurfaceConnectivity & connectivity,
                 const SurfaceShape &        shape,
                 const std::vector<char> &   isMember,
                 const WallPartLimits &      limits)
{
  const BulgeFinder      finder(V, connectivity, shape);
  std::vector<char>      isFree = isMember;
  std::vector<WallBulge> parts;
  for (int seed = 0; seed < V.rows(); ++seed)
  {
    if (!isFree[seed])
    {
      continue;
    }
    WallBulge part = finder.Measure(finder.Grow(seed, isFree));
    if (part.area > 0.0 && part.solidAngle >= limits.leastSolidAngle && part.leastWidth >= limits.leastWidth)
    {
      finder.MeasureFoot(part);
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

std::vector<WallBulge>
FindWallBulges(const VertexMatrix &        V,
               const SurfaceConnectivity & connectivity,
               const SurfaceShape &        shape,
               const std::vector<char> &   isLeftOut,
               double                      leastCurvature)
{
  std::vector<char> isMember(V.rows());
  for (Eigen::Index i = 0; i < V.rows(); ++i)
  {
    isMember[i] = !isLeftOut[i] && shape.lesser[i] > leastCurvature;
  }
  return MeasureWallParts(V, connectivity, shape, isMember);
}
} // namespace shapeton
