#include "shapetonPlaneToSphere.h"

#include "shapetonLayoutTree.h"
#include "shapetonPi.h"

#include <cmath>
#include <complex>

namespace shapeton
{
namespace
{

using Complex = std::complex<double>;

bool
IsFinite(double radius)
{
  return !std::isinf(radius);
}

SphereCircle
FromCircle(const Complex & center, double radius, double scale)
{
  return FromScaled(center.real() / radius,
                    center.imag() / radius,
                    (std::norm(center) - radius * radius) / radius,
                    1.0 / radius,
                    scale);
}

/** Half plane ahead of a point in a unit direction. */
SphereCircle
FromHalfPlane(const Complex & ahead, const Complex & point, double scale)
{
  const double offset = (std::conj(ahead) * point).real();
  return FromScaled(ahead.real(), ahead.imag(), 2.0 * offset, 0.0, scale);
}

/** Computes all circles and points at a finite node. */
class PlaneLayout
{
public:
  PlaneLayout(const CombinatorialMap & map, const CirclePacking & packing, double scale)
    : m_Map(map)
    , m_Packing(packing)
    , m_Scale(scale)
    , m_Directions(HalfEdgeAngles(map, packing))
    , m_Centers(map.Nodes())
    , m_IsPlaced(map.Faces(), 0)
  {
    sphere.nodes.resize(map.Nodes());
    sphere.faces.resize(map.Faces());
    sphere.touchPoints.assign(map.Edges(), { 0.0, 0.0, 1.0 }); // touch point of the two lines
  }
  void
  Place(int node, int arrival);

  SphericalPacking sphere;

private:
  void
  PlaceAlong(int node, int halfEdge);
  void
  PlaceFace(int node, int halfEdge);

  const CombinatorialMap & m_Map;
  const CirclePacking &    m_Packing;
  double                   m_Scale;
  std::vector<double>      m_Directions;
  std::vector<Complex>     m_Centers;
  std::vector<char>        m_IsPlaced;
};

void
PlaneLayout::Place(int node, int arrival)
{
  double turn = 0.0;
  if (arrival >= 0)
  {
    const int before = m_Map.Node(arrival);
    m_Centers[node] =
      m_Centers[before] + std::polar(m_Packing.nodeRadii[before] + m_Packing.nodeRadii[node], m_Directions[arrival]);
    turn = m_Directions[arrival] + Pi - m_Directions[CombinatorialMap::Twin(arrival)];
  }
  sphere.nodes[node] = FromCircle(m_Centers[node], m_Packing.nodeRadii[node], m_Scale);
  const int first = m_Map.FirstAround(node);
  int       h = first;
  do
  {
    m_Directions[h] = std::remainder(m_Directions[h] + turn, 2.0 * Pi);
    this->PlaceAlong(node, h);
    if (!m_IsPlaced[m_Map.Face(h)])
    {
      m_IsPlaced[m_Map.Face(h)] = 1;
      this->PlaceFace(node, h);
    }
    h = m_Map.NextAround(h);
  } while (h != first);
}

/** The touch point on a half-edge, and the circle beyond it if it is a line. */
void
PlaneLayout::PlaceAlong(int node, int halfEdge)
{
  const int     other = m_Map.Node(CombinatorialMap::Twin(halfEdge));
  const Complex ahead = std::polar(1.0, m_Directions[halfEdge]);
  const Complex touch = m_Centers[node] + m_Packing.nodeRadii[node] * ahead;
  sphere.touchPoints[halfEdge / 2] = PointOnSphere(m_Scale * touch.real(), m_Scale * touch.imag());
  if (!IsFinite(m_Packing.nodeRadii[other]))
  {
    sphere.nodes[other] = FromHalfPlane(ahead, touch, m_Scale);
  }
}

void
PlaneLayout::PlaceFace(int node, int halfEdge)
{
  const int     face = m_Map.Face(halfEdge);
  const double  radius = m_Packing.faceRadii[face];
  const double  own = m_Packing.nodeRadii[node];
  const Complex ahead = std::polar(1.0, m_Directions[halfEdge] + HalfKiteAngle(FlowGeometry::Euclidean, own, radius));
  sphere.faces[face] = IsFinite(radius) ? FromCircle(m_Centers[node] + std::hypot(radius, own) * ahead, radius, m_Scale)
                                        : FromHalfPlane(ahead, m_Centers[node], m_Scale);
}
} // namespace

SphericalPacking
PlaneToSphere(const CombinatorialMap & map, const CirclePacking & packing, int root)
{
  PlaneLayout      layout(map, packing, 1.0 / packing.nodeRadii[root]);
  const LayoutTree tree = LayoutTree::OfLargestCircles(map, packing, root);
  for (const int node : tree.order)
  {
    layout.Place(node, tree.arrival[node]);
  }
  return std::move(layout.sphere);
}
} // namespace shapeton
