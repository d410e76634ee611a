#include "itkLayoutTree.h"
#include "itkPlaneMotion.h"
#include "itkPlaneToSphere.h"

#include <cmath>

namespace itk
{
namespace
{
constexpr double pi = 3.14159265358979323846;

using Complex = std::complex<double>;

PlaneMotion
Turn(double angle)
{
  return PlaneMotion::Rotation(FlowGeometry::Hyperbolic, angle);
}

PlaneMotion
Advance(double length)
{
  return PlaneMotion::Translation(FlowGeometry::Hyperbolic, length);
}

/** The circle around the image of the origin. With its centre (zeta, w) on the hyperboloid it is (zeta, -cosh r, w) /
 * sinh r, and w - cosh r is computed without cancellation. */
SphereCircle
FromCircle(const PlaneMotion & m, double radius, double scale)
{
  const Complex zeta = 2.0 * m.a * m.b;
  const double  s = std::sinh(radius);
  const double  half = std::sinh(0.5 * radius);
  const double  out = 2.0 * std::norm(m.b);
  const double  up = 2.0 * half * half;
  return FromScaled(zeta.real() / s, zeta.imag() / s, (out - up) / s, (2.0 + out + up) / s, scale);
}

/** What lies ahead of the geodesic that crosses the real axis at the origin. */
SphereCircle
FromGeodesic(const PlaneMotion & m, double scale)
{
  const Complex zeta = m.a * m.a + m.b * m.b;
  const double  w = 2.0 * (m.a * std::conj(m.b)).real();
  return FromScaled(zeta.real(), zeta.imag(), w, w, scale);
}

/** The horocycle at the end of the real axis that is orthogonal to the circle of this radius around the origin: with
 * the light ray (zeta, w) it is (zeta cosh r, -1, w cosh r). */
SphereCircle
FromHorocycle(const PlaneMotion & m, double radius, double scale)
{
  const double  c = std::cosh(radius);
  const double  half = std::sinh(0.5 * radius);
  const Complex end = m.a + m.b;
  const Complex zeta = c * end * end;
  const double  above = 2.0 * std::norm(m.b) + 2.0 * (m.a * std::conj(m.b)).real() + 2.0 * half * half * std::norm(end);
  return FromScaled(zeta.real(), zeta.imag(), above, above + 2.0, scale);
}

std::array<double, 3>
FromPoint(const PlaneMotion & m, double scale)
{
  const Complex z = scale * m.b / std::conj(m.a);
  return PointOnSphere(z.real(), z.imag());
}

/** Places everything that a finite node touches. */
class DiskLayout
{
public:
  DiskLayout(const CombinatorialMap & map, const CirclePacking & packing, double scale)
    : m_Map(map), m_Packing(packing), m_Scale(scale), m_Angles(HalfEdgeAngles(map, packing)), m_Frames(map.Nodes())
  {
    sphere.nodes.resize(map.Nodes());
    sphere.faces.resize(map.Faces());
    sphere.touchPoints.assign(map.Edges(), { 0.0, 0.0, 0.0 });
    m_IsPlaced.assign(map.Faces(), 0);
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
  std::vector<double>      m_Angles;
  std::vector<PlaneMotion> m_Frames;
  std::vector<char>        m_IsPlaced;
};

void
DiskLayout::Place(int node, int arrival)
{
  m_Frames[node] = Turn(0.0);
  if (arrival >= 0)
  {
    const int    before = m_Map.Node(arrival);
    const double length = m_Packing.nodeRadii[before] + m_Packing.nodeRadii[node];
    m_Frames[node] = (m_Frames[before] * Turn(m_Angles[arrival]) * Advance(length) *
                      Turn(pi - m_Angles[CombinatorialMap::Twin(arrival)]))
                       .Normalised();
  }
  sphere.nodes[node] = FromCircle(m_Frames[node], m_Packing.nodeRadii[node], m_Scale);
  const int first = m_Map.FirstAround(node);
  int       h = first;
  do
  {
    this->PlaceAlong(node, h);
    if (!m_IsPlaced[m_Map.Face(h)])
    {
      m_IsPlaced[m_Map.Face(h)] = 1;
      this->PlaceFace(node, h);
    }
    h = m_Map.NextAround(h);
  } while (h != first);
}

/** The touch point on a half-edge, and the circle beyond it where that is a geodesic. */
void
DiskLayout::PlaceAlong(int node, int halfEdge)
{
  const int         other = m_Map.Node(CombinatorialMap::Twin(halfEdge));
  const PlaneMotion touch = m_Frames[node] * Turn(m_Angles[halfEdge]) * Advance(m_Packing.nodeRadii[node]);
  sphere.touchPoints[halfEdge / 2] = FromPoint(touch, m_Scale);
  if (std::isinf(m_Packing.nodeRadii[other]))
  {
    sphere.nodes[other] = FromGeodesic(touch, m_Scale);
  }
}

void
DiskLayout::PlaceFace(int node, int halfEdge)
{
  const int         face = m_Map.Face(halfEdge);
  const double      radius = m_Packing.faceRadii[face];
  const double      own = m_Packing.nodeRadii[node];
  const bool        isHorocycle = IsHorocycle(m_Packing, face);
  const double      angle = m_Angles[halfEdge] + HalfKiteAngle(FlowGeometry::Hyperbolic, own, radius, isHorocycle);
  const PlaneMotion ahead = m_Frames[node] * Turn(angle);
  if (isHorocycle)
  {
    sphere.faces[face] = FromHorocycle(ahead, own, m_Scale);
    return;
  }
  const double distance = std::asinh(std::hypot(std::sinh(own) * std::cosh(radius), std::sinh(radius)));
  sphere.faces[face] = FromCircle(ahead * Advance(distance), radius, m_Scale);
}
} // namespace

SphericalPacking
DiskToSphere(const CombinatorialMap & map, const CirclePacking & packing, int root, int boundaryFace)
{
  const double     scale = 1.0 / std::tanh(0.5 * packing.nodeRadii[root]);
  DiskLayout       layout(map, packing, scale);
  const LayoutTree tree = LayoutTree::OfLargestCircles(map, packing, root);
  for (const int node : tree.order)
  {
    layout.Place(node, tree.arrival[node]);
  }
  SphericalPacking sphere = std::move(layout.sphere);
  sphere.faces[boundaryFace] = FromScaled(0.0, 0.0, 1.0, -1.0, scale);
  // The edges of the boundary face join geodesics: they touch at the end of the horocycle beside them.
  for (const int h : map.Boundary(boundaryFace))
  {
    const SphereCircle & horocycle = sphere.faces[map.Face(CombinatorialMap::Twin(h))];
    const double         length = std::hypot(horocycle[0], horocycle[1]);
    sphere.touchPoints[h / 2] = PointOnSphere(scale * horocycle[0] / length, scale * horocycle[1] / length);
  }
  return sphere;
}
} // namespace itk
