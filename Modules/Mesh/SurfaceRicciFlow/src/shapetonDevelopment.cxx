#include "shapetonDevelopment.h"

#include "shapetonExceptions.h"
#include "shapetonTrianglesOfGeometry.h"

#include <algorithm>
#include <deque>

namespace shapeton
{
namespace
{
/** Isometry of the disk that maps a to 0. */
PlanePoint
ToOrigin(PlanePoint a, PlanePoint z)
{
  return (z - a) / (1.0 - std::conj(a) * z);
}

/** Moves the corners of a face near the origin of its chart. */
void
Recenter(RicciGeometry geometry, PlanePoint * corners)
{
  const PlanePoint center = (corners[0] + corners[1] + corners[2]) / 3.0;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = geometry == RicciGeometry::Hyperbolic ? ToOrigin(center, corners[k]) : corners[k] - center;
  }
}

/** The four corners a, b, c, d of the quadrilateral of a side a b, in the chart of its face. */
std::array<PlanePoint, 4>
Quadrilateral(const IntrinsicTriangulation &  triangulation,
              const std::vector<PlanePoint> & charts,
              RicciGeometry                   geometry,
              int                             side)
{
  const int        next = IntrinsicTriangulation::Next(side), twin = triangulation.Twin(side);
  const PlanePoint a = charts[side], b = charts[next];
  const PlanePoint d = Carried(geometry,
                               charts[IntrinsicTriangulation::Next(twin)],
                               charts[twin],
                               a,
                               b,
                               charts[IntrinsicTriangulation::Previous(twin)]);
  return { a, b, charts[IntrinsicTriangulation::Previous(side)], d };
}

void
SetFace(std::vector<PlanePoint> & charts, int side, RicciGeometry geometry, PlanePoint a, PlanePoint b, PlanePoint c)
{
  charts[side] = a;
  charts[IntrinsicTriangulation::Next(side)] = b;
  charts[IntrinsicTriangulation::Previous(side)] = c;
  Recenter(geometry, &charts[side - side % 3]);
}

/** Coordinates in which geodesics are straight lines. */
PlanePoint
Straight(RicciGeometry geometry, PlanePoint z)
{
  return geometry == RicciGeometry::Hyperbolic ? 2.0 * z / (1.0 + std::norm(z)) : z;
}

/** Flips edges across the axis of a double until none is left. */
void
FlipCrossingEdges(IntrinsicTriangulation &  triangulation,
                  std::vector<PlanePoint> & charts,
                  const std::vector<char> & sideOfVertices,
                  RicciGeometry             geometry)
{
  const auto crosses = [&](int e) {
    const int side = triangulation.SideOf(e);
    return sideOfVertices[triangulation.Origin(side)] + sideOfVertices[triangulation.End(side)] == 3;
  };
  std::deque<int> waiting;
  for (int e = 0; e < triangulation.NumberOfEdges(); ++e)
  {
    if (crosses(e))
    {
      waiting.push_back(e);
    }
  }
  std::size_t idle = 0;
  while (!waiting.empty())
  {
    const int edge = waiting.front();
    waiting.pop_front();
    const int side = triangulation.SideOf(edge), twin = triangulation.Twin(side);
    const auto [a, b, c, d] = Quadrilateral(triangulation, charts, geometry, side);
    if (!IsCounterclockwise(geometry, d, c, a) || !IsCounterclockwise(geometry, c, d, b))
    {
      waiting.push_back(edge);
      if (++idle > waiting.size())
      {
        throw InputError("the metric of the flow is too degenerate to separate the two halves of the doubled surface");
      }
      continue;
    }
    idle = 0;
    triangulation.Flip(side);
    SetFace(charts, side, geometry, d, c, a);
    SetFace(charts, twin, geometry, c, d, b);
    if (crosses(edge))
    {
      waiting.push_back(edge);
    }
  }
}
} // namespace

double
DistanceInPlane(RicciGeometry geometry, PlanePoint a, PlanePoint b)
{
  return geometry == RicciGeometry::Hyperbolic ? 2.0 * std::atanh(std::abs(ToOrigin(a, b))) : std::abs(b - a);
}

bool
IsCounterclockwise(RicciGeometry geometry, PlanePoint a, PlanePoint b, PlanePoint c)
{
  const PlanePoint p = Straight(geometry, b) - Straight(geometry, a), q = Straight(geometry, c) - Straight(geometry, a);
  return (std::conj(p) * q).imag() > 1e-12 * std::abs(p) * std::abs(q);
}

PlanePoint
Carried(RicciGeometry geometry, PlanePoint a, PlanePoint b, PlanePoint toA, PlanePoint toB, PlanePoint z)
{
  if (geometry != RicciGeometry::Hyperbolic)
  {
    const PlanePoint turn = (toB - toA) / (b - a);
    return toA + turn / std::abs(turn) * (z - a);
  }
  const PlanePoint turn = ToOrigin(toA, toB) / ToOrigin(a, b);
  return ToOrigin(-toA, turn / std::abs(turn) * ToOrigin(a, z));
}

std::vector<PlanePoint>
ChartsOfFaces(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths, RicciGeometry geometry)
{
  std::vector<PlanePoint> charts(triangulation.NumberOfSides());
  for (int side = 0; side < triangulation.NumberOfSides(); side += 3)
  {
    const std::array<double, 3> sides{ lengths[triangulation.EdgeOf(side)],
                                       lengths[triangulation.EdgeOf(side + 1)],
                                       lengths[triangulation.EdgeOf(side + 2)] };
    const double                angle = AnglesOfTriangle(geometry, sides).Angle(0);
    const auto                  radius = [geometry](double length) {
      return geometry == RicciGeometry::Hyperbolic ? std::tanh(0.5 * length) : length;
    };
    SetFace(charts, side, geometry, 0.0, radius(sides[0]), std::polar(radius(sides[2]), angle));
  }
  return charts;
}

void
UndoFlips(const std::vector<int> &  flips,
          RicciGeometry             geometry,
          IntrinsicTriangulation &  triangulation,
          std::vector<PlanePoint> & charts)
{
  for (auto side = flips.rbegin(); side != flips.rend(); ++side)
  {
    const int twin = triangulation.Twin(*side);
    const auto [d, c, a, b] = Quadrilateral(triangulation, charts, geometry, *side);
    triangulation.FlipBack(*side);
    SetFace(charts, *side, geometry, a, b, c);
    SetFace(charts, twin, geometry, b, a, d);
  }
}

int
InnermostFace(const IntrinsicTriangulation & triangulation, const std::vector<char> & isCut)
{
  std::vector<int>  order;
  std::vector<char> isSeen(triangulation.NumberOfFaces(), 0);
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    if (!isSeen[side / 3] && (triangulation.Twin(side) == -1 || isCut[triangulation.EdgeOf(side)]))
    {
      isSeen[side / 3] = 1;
      order.push_back(side / 3);
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (int side = 3 * order[i]; side < 3 * order[i] + 3; ++side)
    {
      const int twin = triangulation.Twin(side);
      if (twin != -1 && !isSeen[twin / 3])
      {
        isSeen[twin / 3] = 1;
        order.push_back(twin / 3);
      }
    }
  }
  return order.empty() ? 0 : order.back();
}

std::vector<PlanePoint>
LayOutFaces(const IntrinsicTriangulation &  triangulation,
            const std::vector<PlanePoint> & charts,
            const std::vector<char> &       isCut,
            RicciGeometry                   geometry,
            int                             root)
{
  std::vector<PlanePoint> places(charts.size());
  std::vector<char>       isPlaced(triangulation.NumberOfFaces(), 0);
  std::vector<int>        order{ root };
  std::copy_n(charts.begin() + 3 * root, 3, places.begin() + 3 * root);
  isPlaced[root] = 1;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (int side = 3 * order[i]; side < 3 * order[i] + 3; ++side)
    {
      const int twin = triangulation.Twin(side);
      if (twin == -1 || isCut[triangulation.EdgeOf(side)] || isPlaced[twin / 3])
      {
        continue;
      }
      const int  next = IntrinsicTriangulation::Next(twin), last = IntrinsicTriangulation::Previous(twin);
      const auto atA = places[side], atB = places[IntrinsicTriangulation::Next(side)];
      places[next] = atA;
      places[twin] = atB;
      places[last] = Carried(geometry, charts[next], charts[twin], atA, atB, charts[last]);
      isPlaced[twin / 3] = 1;
      order.push_back(twin / 3);
    }
  }
  return places;
}

GeodesicFaces
FacesOf(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths)
{
  GeodesicFaces result{ triangulation.Faces(), {} };
  result.sides.resize(result.F.rows(), 3);
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    result.sides(side / 3, side % 3) = lengths[triangulation.EdgeOf(side)];
  }
  return result;
}

GeodesicFaces
HalfOfDouble(IntrinsicTriangulation                                     triangulation,
             std::vector<PlanePoint>                                    charts,
             const std::vector<char> &                                  sideOfVertices,
             const std::vector<std::pair<std::array<int, 2>, double>> & axis,
             RicciGeometry                                              geometry)
{
  constexpr double sameLength = 1e-6; // relative; an edge beside the axis with the same ends is longer
  FlipCrossingEdges(triangulation, charts, sideOfVertices, geometry);
  const auto lengthOf = [&](int side) {
    return DistanceInPlane(geometry, charts[side], charts[IntrinsicTriangulation::Next(side)]);
  };
  const auto isOnAxis = [&](int side) {
    const std::array<int, 2> ends{ std::min(triangulation.Origin(side), triangulation.End(side)),
                                   std::max(triangulation.Origin(side), triangulation.End(side)) };
    const auto               first = std::lower_bound(
      axis.begin(), axis.end(), ends, [](const auto & entry, const auto & value) { return entry.first < value; });
    return first != axis.end() && first->first == ends &&
           std::abs(first->second - lengthOf(side)) <= sameLength * first->second;
  };
  std::vector<int>  faces;
  std::vector<char> isSeen(triangulation.NumberOfFaces(), 0);
  const auto        add = [&](int face) {
    if (!isSeen[face])
    {
      isSeen[face] = 1;
      faces.push_back(face);
    }
  };
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    if (sideOfVertices[triangulation.Origin(side)] == 1)
    {
      add(side / 3);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int side = 3 * faces[i]; side < 3 * faces[i] + 3; ++side)
    {
      if (!isOnAxis(side))
      {
        add(triangulation.Twin(side) / 3);
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  GeodesicFaces result;
  result.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  result.sides.resize(result.F.rows(), 3);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.F(static_cast<Eigen::Index>(i), k) = triangulation.Origin(3 * faces[i] + k);
      result.sides(static_cast<Eigen::Index>(i), k) = lengthOf(3 * faces[i] + k);
    }
  }
  return result;
}
} // namespace shapeton
