#include "itkPlaneToSphere.h"

#include "itkLayoutTree.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr double pi = 3.14159265358979323846;

using Complex = std::complex<double>;

bool
IsFinite(double radius)
{
  return !std::isinf(radius);
}

/** A half-edge of the edge that leaves a finite node, or -1. */
int
FiniteHalfEdge(const CombinatorialMap & map, const CirclePacking & packing, int edge)
{
  const int h = 2 * edge;
  return IsFinite(packing.nodeRadii[map.Node(h)]) ? h : (IsFinite(packing.nodeRadii[map.Node(h + 1)]) ? h + 1 : -1);
}

/** A similarity of the plane, z -> scale (z - centre). */
struct Similarity
{
  Complex centre{ 0.0 };
  double  scale{ 1.0 };
  Complex
  operator()(const Complex & z) const
  {
    return scale * (z - centre);
  }
};

/** The mean of these points to the origin, half of them into the unit disk. */
Similarity
Normalisation(const std::vector<Complex> & points)
{
  Similarity similarity;
  for (const Complex & point : points)
  {
    similarity.centre += point / static_cast<double>(points.size());
  }
  std::vector<double> distances;
  for (const Complex & point : points)
  {
    distances.push_back(std::abs(point - similarity.centre));
  }
  const auto middle = distances.begin() + distances.size() / 2;
  std::nth_element(distances.begin(), middle, distances.end());
  similarity.scale = 1.0 / *middle;
  return similarity;
}

SphereCircle
FromCircle(const Complex & centre, double radius)
{
  const double power = std::norm(centre) - radius * radius;
  return {
    centre.real() / radius, centre.imag() / radius, (power - 1.0) / (2.0 * radius), (power + 1.0) / (2.0 * radius)
  };
}

/** The half plane of the points z with Re(conj(normal) z) > offset. */
SphereCircle
FromHalfPlane(const Complex & normal, double offset)
{
  return { normal.real(), normal.imag(), offset, offset };
}

double
Offset(const Complex & normal, const Complex & point)
{
  return (std::conj(normal) * point).real();
}

std::array<double, 3>
FromPoint(const Complex & z)
{
  const double square = std::norm(z);
  return { 2.0 * z.real() / (1.0 + square), 2.0 * z.imag() / (1.0 + square), (square - 1.0) / (square + 1.0) };
}
} // namespace

PlaneLayout::PlaneLayout(const CombinatorialMap & map, const CirclePacking & packing)
  : nodes(map.Nodes()), faces(map.Faces()), directions(HalfEdgeAngles(map, packing))
{
  std::vector<char> isPlaced(map.Faces(), 0);
  const LayoutTree  tree = LayoutTree::OfLargestCircles(map, packing);
  for (const int node : tree.order)
  {
    const double radius = packing.nodeRadii[node];
    const int    arrival = tree.arrival[node];
    double       turn = 0.0;
    if (arrival >= 0)
    {
      const int before = map.Node(arrival);
      nodes[node] = nodes[before] + std::polar(packing.nodeRadii[before] + radius, directions[arrival]);
      turn = directions[arrival] + pi - directions[CombinatorialMap::Twin(arrival)];
    }
    const int first = map.FirstAround(node);
    int       h = first;
    do
    {
      directions[h] = std::remainder(directions[h] + turn, 2.0 * pi);
      const int face = map.Face(h);
      if (!isPlaced[face] && IsFinite(packing.faceRadii[face]))
      {
        isPlaced[face] = 1;
        faces[face] = nodes[node] + std::polar(std::hypot(radius, packing.faceRadii[face]),
                                               directions[h] + std::atan2(packing.faceRadii[face], radius));
      }
      h = map.NextAround(h);
    } while (h != first);
  }
}

namespace
{
/** Fills in the circles that are straight lines, from a finite node beside each. */
void
AddHalfPlanes(const CombinatorialMap & map,
              const CirclePacking &    packing,
              const PlaneLayout &      layout,
              const Similarity &       similarity,
              SphericalPacking &       sphere)
{
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const int node = map.Node(h);
    const int other = map.Node(CombinatorialMap::Twin(h));
    if (!IsFinite(packing.nodeRadii[node]))
    {
      continue;
    }
    const Complex centre = layout.nodes[node];
    const Complex ahead = std::polar(1.0, layout.directions[h]);
    if (!IsFinite(packing.nodeRadii[other]))
    {
      const Complex touch = similarity(centre + packing.nodeRadii[node] * ahead);
      sphere.nodes[other] = FromHalfPlane(ahead, Offset(ahead, touch));
    }
    if (!IsFinite(packing.faceRadii[map.Face(h)]))
    {
      const Complex left = Complex(0.0, 1.0) * ahead;
      sphere.faces[map.Face(h)] = FromHalfPlane(left, Offset(left, similarity(centre)));
    }
  }
}
} // namespace

SphericalPacking
ToSphere(const CombinatorialMap & map, const CirclePacking & packing, const PlaneLayout & layout)
{
  std::vector<Complex> touch;
  std::vector<int>     touchOfEdge(map.Edges(), -1);
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    const int h = FiniteHalfEdge(map, packing, edge);
    if (h >= 0)
    {
      touchOfEdge[edge] = static_cast<int>(touch.size());
      touch.push_back(layout.nodes[map.Node(h)] + std::polar(packing.nodeRadii[map.Node(h)], layout.directions[h]));
    }
  }
  const Similarity similarity = Normalisation(touch);
  SphericalPacking sphere;
  sphere.nodes.resize(map.Nodes());
  sphere.faces.resize(map.Faces());
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    sphere.touchPoints.push_back(touchOfEdge[edge] < 0 ? std::array<double, 3>{ 0.0, 0.0, 1.0 }
                                                       : FromPoint(similarity(touch[touchOfEdge[edge]])));
  }
  for (int node = 0; node < map.Nodes(); ++node)
  {
    if (IsFinite(packing.nodeRadii[node]))
    {
      sphere.nodes[node] = FromCircle(similarity(layout.nodes[node]), similarity.scale * packing.nodeRadii[node]);
    }
  }
  for (int face = 0; face < map.Faces(); ++face)
  {
    if (IsFinite(packing.faceRadii[face]))
    {
      sphere.faces[face] = FromCircle(similarity(layout.faces[face]), similarity.scale * packing.faceRadii[face]);
    }
  }
  AddHalfPlanes(map, packing, layout, similarity, sphere);
  return sphere;
}
} // namespace itk
