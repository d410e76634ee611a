#include "itkSphericalPacking.h"

#include "itkCirclePacking.h"
#include "itkPlaneToSphere.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** The edge whose ends both have many neighbours: its four circles are large in a packing of even density, so the
 * others keep their sizes when these become straight lines. */
int
EdgeForInfinity(const CombinatorialMap & map)
{
  const std::vector<int> degrees = map.Degrees();
  const auto weight = [&](int edge) { return std::min(degrees[map.Node(2 * edge)], degrees[map.Node(2 * edge + 1)]); };
  int        best = 0;
  for (int edge = 1; edge < map.Edges(); ++edge)
  {
    best = weight(edge) > weight(best) ? edge : best;
  }
  return best;
}

CirclesAtInfinity
CirclesThrough(const CombinatorialMap & map, int edge)
{
  CirclesAtInfinity infinite;
  infinite.lineNodes.assign(map.Nodes(), 0);
  infinite.lineFaces.assign(map.Faces(), 0);
  for (int h = 2 * edge; h < 2 * edge + 2; ++h)
  {
    infinite.lineNodes[map.Node(h)] = 1;
    infinite.lineFaces[map.Face(h)] = 1;
  }
  return infinite;
}

int
LongestFace(const CombinatorialMap & map)
{
  const std::vector<int> lengths = map.FaceLengths();
  return static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
}

/** The circle of a face as the ideal boundary: its nodes become geodesics, the faces beside it horocycles. */
CirclesAtInfinity
CirclesAround(const CombinatorialMap & map, int face)
{
  CirclesAtInfinity infinite;
  infinite.lineNodes.assign(map.Nodes(), 0);
  infinite.lineFaces.assign(map.Faces(), 0);
  infinite.horocycleFaces.assign(map.Faces(), 0);
  infinite.lineFaces[face] = 1; // meets lines alone, and no kite is computed
  for (const int h : map.Boundary(face))
  {
    infinite.lineNodes[map.Node(h)] = 1;
    infinite.horocycleFaces[map.Face(CombinatorialMap::Twin(h))] = 1;
  }
  return infinite;
}
/** The printed projection sends the origin to the south pole, which is seen from the other side: counter-clockwise
 * turns would become clockwise ones. */
void
SeeFromOutside(SphericalPacking & sphere)
{
  for (auto * circles : { &sphere.nodes, &sphere.faces })
  {
    for (SphereCircle & circle : *circles)
    {
      circle[2] = -circle[2];
    }
  }
  for (auto & point : sphere.touchPoints)
  {
    point[2] = -point[2];
  }
}
} // namespace

std::array<double, 3>
CentreOf(const SphereCircle & circle)
{
  const double length = std::sqrt(circle[0] * circle[0] + circle[1] * circle[1] + circle[2] * circle[2]);
  return { circle[0] / length, circle[1] / length, circle[2] / length };
}

double
RadiusOf(const SphereCircle & circle)
{
  return std::atan2(1.0, circle[3]);
}

SphericalPacking
PackOnSphere(const CombinatorialMap & map, PointAtInfinity infinity)
{
  SphericalPacking sphere;
  CirclePacking    flat;
  if (infinity == PointAtInfinity::EdgeNode)
  {
    flat = PackCircles(map, FlowGeometry::Euclidean, CirclesThrough(map, EdgeForInfinity(map)));
    sphere = ToSphere(map, flat, PlaneLayout(map, flat));
  }
  else
  {
    const int face = LongestFace(map);
    flat = PackCircles(map, FlowGeometry::Hyperbolic, CirclesAround(map, face));
    sphere = DiskToSphere(map, flat, face);
  }
  SeeFromOutside(sphere);
  sphere.residual = flat.residual;
  sphere.steps = flat.steps;
  return sphere;
}
} // namespace itk
