#include "shapetonLayoutTree.h"
#include "shapetonPi.h"
#include "shapetonPlaneMotion.h"
#include "shapetonPlaneToSphere.h"

#include <cmath>

namespace shapeton
{
namespace
{

template <typename TReal>
BasicPlaneMotion<TReal>
Turn(TReal angle)
{
  return BasicPlaneMotion<TReal>::Rotation(FlowGeometry::Hyperbolic, angle);
}

template <typename TReal>
BasicPlaneMotion<TReal>
Advance(TReal length)
{
  return BasicPlaneMotion<TReal>::Translation(FlowGeometry::Hyperbolic, length);
}

/** The circle around the image of the origin. With its center (zeta, w) on the hyperboloid it is (zeta, -cosh r, w) /
 * sinh r; w - cosh r is computed without cancellation. */
template <typename TReal>
std::array<TReal, 4>
FromCircle(const BasicPlaneMotion<TReal> & m, TReal radius, TReal scale)
{
  const std::complex<TReal> zeta = TReal(2) * m.a * m.b;
  const TReal               s = std::sinh(radius);
  const TReal               half = std::sinh(TReal(0.5) * radius);
  const TReal               out = TReal(2) * std::norm(m.b);
  const TReal               up = TReal(2) * half * half;
  return FromScaled(zeta.real() / s, zeta.imag() / s, (out - up) / s, (TReal(2) + out + up) / s, scale);
}

/** The half plane ahead of the geodesic that crosses the real axis at the origin. */
template <typename TReal>
std::array<TReal, 4>
FromGeodesic(const BasicPlaneMotion<TReal> & m, TReal scale)
{
  const std::complex<TReal> zeta = m.a * m.a + m.b * m.b;
  const TReal               w = TReal(2) * (m.a * std::conj(m.b)).real();
  return FromScaled(zeta.real(), zeta.imag(), w, w, scale);
}

/** The horocycle at the end of the real axis orthogonal to the circle of this radius around the origin: with the light
 * ray (zeta, w) it is (zeta cosh r, -1, w cosh r). */
template <typename TReal>
std::array<TReal, 4>
FromHorocycle(const BasicPlaneMotion<TReal> & m, TReal radius, TReal scale)
{
  const TReal               c = std::cosh(radius);
  const TReal               half = std::sinh(TReal(0.5) * radius);
  const std::complex<TReal> end = m.a + m.b;
  const std::complex<TReal> zeta = c * end * end;
  const TReal               above =
    TReal(2) * std::norm(m.b) + TReal(2) * (m.a * std::conj(m.b)).real() + TReal(2) * half * half * std::norm(end);
  return FromScaled(zeta.real(), zeta.imag(), above, above + TReal(2), scale);
}

template <typename TReal>
std::array<double, 3>
FromPoint(const BasicPlaneMotion<TReal> & m, TReal scale)
{
  const std::complex<TReal> z = scale * m.b / std::conj(m.a);
  return PointOnSphere(static_cast<double>(z.real()), static_cast<double>(z.imag()));
}

/** Computes all circles and points at finite nodes. Only the node frames are chained; a circle or point is computed
 * from the frame of its first or last node in tree order. */
template <typename TReal>
class DiskLayout
{
public:
  using Motion = BasicPlaneMotion<TReal>;
  using Circle = std::array<TReal, 4>;
  DiskLayout(const CombinatorialMap & map, const CirclePacking & packing, const LayoutTree & tree, TReal scale)
    : nodes(map.Nodes())
    , faces(map.Faces())
    , touchPoints(map.Edges(), { 0.0, 0.0, 0.0 })
    , m_Map(map)
    , m_Packing(packing)
    , m_Scale(scale)
    , m_Angles(HalfEdgeAngles<TReal>(map, packing))
    , m_Frames(map.Nodes())
    , m_Rank(map.Nodes(), -1)
  {
    for (std::size_t i = 0; i < tree.order.size(); ++i)
    {
      m_Rank[tree.order[i]] = static_cast<int>(i);
    }
    this->PlaceFrames(tree);
    ParallelForBlocks(nodes.size(), [this](std::size_t node) { this->PlaceNode(static_cast<int>(node)); });
    ParallelForBlocks(faces.size(), [this](std::size_t face) { this->PlaceFace(static_cast<int>(face)); });
    ParallelForBlocks(touchPoints.size(), [this](std::size_t edge) { this->PlaceEdge(static_cast<int>(edge)); });
  }

  std::vector<Circle>                nodes;
  std::vector<Circle>                faces;
  std::vector<std::array<double, 3>> touchPoints;

private:
  void
  PlaceFrames(const LayoutTree & tree);
  void
  PlaceNode(int node);
  void
  PlaceEdge(int edge);
  void
  PlaceFace(int face);

  int
  RankBefore(int halfEdge) const
  {
    return m_Rank[m_Map.Node(halfEdge)];
  }
  /** Frame at the touch point on a half-edge. */
  Motion
  TouchFrame(int halfEdge) const
  {
    const int node = m_Map.Node(halfEdge);
    return m_Frames[node] * Turn(m_Angles[halfEdge]) * Advance(NodeRadius<TReal>(m_Packing, node));
  }

  const CombinatorialMap & m_Map;
  const CirclePacking &    m_Packing;
  TReal                    m_Scale;
  std::vector<TReal>       m_Angles;
  std::vector<Motion>      m_Frames;
  std::vector<int>         m_Rank; ///< in tree order; -1 for infinite nodes
};

template <typename TReal>
void
DiskLayout<TReal>::PlaceFrames(const LayoutTree & tree)
{
  for (const int node : tree.order)
  {
    const int arrival = tree.arrival[node];
    m_Frames[node] = Turn(TReal(0));
    if (arrival >= 0)
    {
      const int   before = m_Map.Node(arrival);
      const TReal length = NodeRadius<TReal>(m_Packing, before) + NodeRadius<TReal>(m_Packing, node);
      m_Frames[node] = (m_Frames[before] * Turn(m_Angles[arrival]) * Advance(length) *
                        Turn(PiOf<TReal> - m_Angles[CombinatorialMap::Twin(arrival)]))
                         .Normalized();
    }
  }
}

/** An infinite node is a geodesic beyond the last of its neighbors. */
template <typename TReal>
void
DiskLayout<TReal>::PlaceNode(int node)
{
  if (m_Rank[node] >= 0)
  {
    nodes[node] = FromCircle(m_Frames[node], NodeRadius<TReal>(m_Packing, node), m_Scale);
    return;
  }
  const int first = m_Map.FirstAround(node);
  int       last = CombinatorialMap::Twin(first);
  for (int h = m_Map.NextAround(first); h != first; h = m_Map.NextAround(h))
  {
    const int twin = CombinatorialMap::Twin(h);
    last = this->RankBefore(twin) > this->RankBefore(last) ? twin : last;
  }
  nodes[node] = FromGeodesic(this->TouchFrame(last), m_Scale);
}

template <typename TReal>
void
DiskLayout<TReal>::PlaceEdge(int edge)
{
  const int h = this->RankBefore(2 * edge) > this->RankBefore(2 * edge + 1) ? 2 * edge : 2 * edge + 1;
  if (this->RankBefore(h) >= 0)
  {
    touchPoints[edge] = FromPoint(this->TouchFrame(h), m_Scale);
  }
}

template <typename TReal>
void
DiskLayout<TReal>::PlaceFace(int face)
{
  int       first = m_Map.FirstOfFace(face);
  const int begin = first;
  for (int h = m_Map.FaceNext(begin); h != begin; h = m_Map.FaceNext(h))
  {
    const bool isBefore = this->RankBefore(first) < 0 || this->RankBefore(h) < this->RankBefore(first);
    first = this->RankBefore(h) >= 0 && isBefore ? h : first;
  }
  if (this->RankBefore(first) < 0)
  {
    return; // ideal boundary
  }
  const TReal  radius = FaceRadius<TReal>(m_Packing, face);
  const TReal  own = NodeRadius<TReal>(m_Packing, m_Map.Node(first));
  const bool   isHorocycle = IsHorocycle(m_Packing, face);
  const TReal  angle = m_Angles[first] + HalfKiteAngle(FlowGeometry::Hyperbolic, own, radius, isHorocycle);
  const Motion ahead = m_Frames[m_Map.Node(first)] * Turn(angle);
  if (isHorocycle)
  {
    faces[face] = FromHorocycle(ahead, own, m_Scale);
    return;
  }
  const TReal distance = std::asinh(std::hypot(std::sinh(own) * std::cosh(radius), std::sinh(radius)));
  faces[face] = FromCircle(ahead * Advance(distance), radius, m_Scale);
}

/** Rounds the values and stores the residuals. */
void
Split(const std::vector<std::array<long double, 4>> & circles,
      std::vector<SphereCircle> &                     rounded,
      std::vector<SphereCircle> &                     rests)
{
  for (const std::array<long double, 4> & circle : circles)
  {
    SphereCircle rest{};
    rounded.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      rounded.back()[k] = static_cast<double>(circle[k]);
      rest[k] = static_cast<double>(circle[k] - static_cast<long double>(rounded.back()[k]));
    }
    rests.push_back(rest);
  }
}

/** Overload without rounding. */
void
Split(std::vector<SphereCircle> & circles, std::vector<SphereCircle> & rounded, std::vector<SphereCircle> & /*rests*/)
{
  rounded = std::move(circles);
}

template <typename TReal>
SphericalPacking
LayOutDisk(const CombinatorialMap & map, const CirclePacking & packing, int root, int boundaryFace)
{
  const TReal       scale = TReal(1) / std::tanh(TReal(0.5) * NodeRadius<TReal>(packing, root));
  DiskLayout<TReal> layout(map, packing, LayoutTree::OfLargestCircles(map, packing, root), scale);
  layout.faces[boundaryFace] = FromScaled(TReal(0), TReal(0), TReal(1), TReal(-1), scale);
  // The edges of the boundary face join geodesics, which touch at the end of the adjacent horocycle.
  for (const int h : map.Boundary(boundaryFace))
  {
    const std::array<TReal, 4> & horocycle = layout.faces[map.Face(CombinatorialMap::Twin(h))];
    const TReal                  length = std::hypot(horocycle[0], horocycle[1]);
    layout.touchPoints[h / 2] = PointOnSphere(static_cast<double>(scale * horocycle[0] / length),
                                              static_cast<double>(scale * horocycle[1] / length));
  }
  SphericalPacking sphere;
  Split(layout.nodes, sphere.nodes, sphere.nodeRests);
  Split(layout.faces, sphere.faces, sphere.faceRests);
  sphere.touchPoints = std::move(layout.touchPoints);
  return sphere;
}
} // namespace

SphericalPacking
DiskToSphere(const CombinatorialMap & map,
             const CirclePacking &    packing,
             int                      root,
             int                      boundaryFace,
             PackingPrecision         precision)
{
  return precision == PackingPrecision::Double ? LayOutDisk<double>(map, packing, root, boundaryFace)
                                               : LayOutDisk<long double>(map, packing, root, boundaryFace);
}
} // namespace shapeton
