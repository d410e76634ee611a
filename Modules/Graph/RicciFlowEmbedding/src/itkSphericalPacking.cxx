#include "itkSphericalPacking.h"

#include "itkCirclePacking.h"
#include "itkLayoutTree.h"
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
  infinite.infiniteNodes.assign(map.Nodes(), 0);
  infinite.infiniteFaces.assign(map.Faces(), 0);
  for (int h = 2 * edge; h < 2 * edge + 2; ++h)
  {
    infinite.infiniteNodes[map.Node(h)] = 1;
    infinite.infiniteFaces[map.Face(h)] = 1;
  }
  return infinite;
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
PackOnSphere(const CombinatorialMap & map, PointAtInfinity)
{
  const int           edge = EdgeForInfinity(map);
  const CirclePacking flat = PackCircles(map, FlowGeometry::Euclidean, CirclesThrough(map, edge));
  const PlaneLayout   layout(map, flat);
  SphericalPacking    packing = ToSphere(map, flat, layout);
  packing.residual = flat.residual;
  packing.steps = flat.steps;
  return packing;
}
} // namespace itk
