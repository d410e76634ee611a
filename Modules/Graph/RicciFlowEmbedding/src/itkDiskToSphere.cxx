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

/** The image of (zeta, w) under a motion, as a Lorentz transformation of three dimensions. */
struct Minkowski
{
  Minkowski(const PlaneMotion & m, double zeta, double w)
    : zeta(m.a * m.a * zeta + m.b * m.b * zeta + 2.0 * w * m.a * m.b)
    , w((std::norm(m.a) + std::norm(m.b)) * w + 2.0 * zeta * (m.a * std::conj(m.b)).real())
  {}
  Complex zeta;
  double  w;
};

/** The circle around the image of the origin. */
SphereCircle
FromCircle(const PlaneMotion & motion, double radius)
{
  const Minkowski centre(motion, 0.0, 1.0);
  const double    s = std::sinh(radius);
  return { centre.zeta.real() / s, centre.zeta.imag() / s, -std::cosh(radius) / s, centre.w / s };
}

/** What lies ahead of the geodesic that crosses the real axis at the origin. */
SphereCircle
FromGeodesic(const PlaneMotion & motion)
{
  const Minkowski normal(motion, 1.0, 0.0);
  return { normal.zeta.real(), normal.zeta.imag(), 0.0, normal.w };
}

/** The horocycle at the end of the real axis that is orthogonal to the circle of this radius around the origin. */
SphereCircle
FromHorocycle(const PlaneMotion & motion, double radius)
{
  const Minkowski end(motion, 1.0, 1.0);
  const double    scale = std::cosh(radius);
  return { scale * end.zeta.real(), scale * end.zeta.imag(), -1.0, scale * end.w };
}

std::array<double, 3>
FromPoint(const PlaneMotion & motion)
{
  const Minkowski point(motion, 0.0, 1.0);
  return { point.zeta.real() / point.w, point.zeta.imag() / point.w, -1.0 / point.w };
}

/** Places everything that a finite node touches. */
class DiskLayout
{
public:
  DiskLayout(const CombinatorialMap & map, const CirclePacking & packing)
    : m_Map(map), m_Packing(packing), m_Angles(HalfEdgeAngles(map, packing)), m_Frames(map.Nodes())
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
  sphere.nodes[node] = FromCircle(m_Frames[node], m_Packing.nodeRadii[node]);
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
  sphere.touchPoints[halfEdge / 2] = FromPoint(touch);
  if (std::isinf(m_Packing.nodeRadii[other]))
  {
    sphere.nodes[other] = FromGeodesic(touch);
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
    sphere.faces[face] = FromHorocycle(ahead, own);
    return;
  }
  const double distance = std::asinh(std::hypot(std::sinh(own) * std::cosh(radius), std::sinh(radius)));
  sphere.faces[face] = FromCircle(ahead * Advance(distance), radius);
}
} // namespace

SphericalPacking
DiskToSphere(const CombinatorialMap & map, const CirclePacking & packing, int boundaryFace)
{
  DiskLayout       layout(map, packing);
  const LayoutTree tree = LayoutTree::OfLargestCircles(map, packing);
  for (const int node : tree.order)
  {
    layout.Place(node, tree.arrival[node]);
  }
  SphericalPacking sphere = std::move(layout.sphere);
  sphere.faces[boundaryFace] = { 0.0, 0.0, 1.0, 0.0 };
  // The edges of the boundary face join geodesics: they touch at the end of the horocycle beside them.
  for (const int h : map.Boundary(boundaryFace))
  {
    const SphereCircle & horocycle = sphere.faces[map.Face(CombinatorialMap::Twin(h))];
    sphere.touchPoints[h / 2] = { horocycle[0] / horocycle[3], horocycle[1] / horocycle[3], 0.0 };
  }
  return sphere;
}
} // namespace itk
