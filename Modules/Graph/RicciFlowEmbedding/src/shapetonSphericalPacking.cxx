#include "shapetonSphericalPacking.h"

#include "shapetonCirclePacking.h"
#include "shapetonConformalBarycenter.h"
#include "shapetonLayoutTree.h"
#include "shapetonNearbyOrder.h"
#include "shapetonPlaneToSphere.h"
#include "shapetonExceptions.h"
#include "shapetonOpenEndedProgress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace shapeton
{
namespace
{
/** Maximum scaling of a layout in one motion, e^9; beyond it the layout is recomputed from the circles that became
 * large. Below e^2 the layout is accurate enough. */
constexpr double mostRapidity = 9.0;
constexpr double smallRapidity = 2.0;
constexpr int    mostLayouts = 40;

/** Largest accepted layout error, and the largest error accepted in double precision before recomputation (radians). */
constexpr double worstTangency = 1e-9;
constexpr double goodTangency = 5e-11;

/** The edge whose ends both have many neighbors. Its four circles are large in a packing of uniform density, so the
 * other circles keep their sizes when these become straight lines. */
int
EdgeForInfinity(const CombinatorialMap & map)
{
  const std::vector<int> degrees = map.Degrees();
  const auto weight = [&](int edge) { return std::min(degrees[map.Node(2 * edge)], degrees[map.Node(2 * edge + 1)]); };
  int        best = 0;
  for (int edge = 1; edge < map.Edges(); ++edge)
  {
    best = weight(edge) >= weight(best) ? edge : best;
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

/** The longest face; ties go to the face whose nodes have the most neighbors, then to the last one, because the central
 * dummies of rings are last and have large circles. */
int
LongestFace(const CombinatorialMap & map)
{
  const std::vector<int> lengths = map.FaceLengths();
  const std::vector<int> degrees = map.Degrees();
  std::array<int, 3>     best{ -1, -1, -1 };
  int                    longest = -1;
  for (int face = 0; face < map.Faces(); ++face)
  {
    std::array<int, 3> weight{ lengths[face], map.HalfEdges(), map.Nodes() };
    const int          first = map.FirstOfFace(face);
    int                h = first;
    do
    {
      weight[1] = std::min(weight[1], degrees[map.Node(h)]);
      weight[2] = std::min(weight[2], map.Node(h));
      h = map.FaceNext(h);
    } while (h != first);
    if (weight >= best)
    {
      best = weight;
      longest = face;
    }
  }
  return longest;
}

/** Makes the circle of a face the ideal boundary: its nodes become geodesics, the adjacent faces horocycles. */
CirclesAtInfinity
CirclesAround(const CombinatorialMap & map, int face)
{
  CirclesAtInfinity infinite;
  infinite.lineNodes.assign(map.Nodes(), 0);
  infinite.lineFaces.assign(map.Faces(), 0);
  infinite.horocycleFaces.assign(map.Faces(), 0);
  infinite.lineFaces[face] = 1; // meets only lines, and no kite is computed
  for (const int h : map.Boundary(face))
  {
    infinite.lineNodes[map.Node(h)] = 1;
    infinite.horocycleFaces[map.Face(CombinatorialMap::Twin(h))] = 1;
  }
  return infinite;
}

/** The published projection maps the origin to the south pole, which would reverse the orientation. */
void
SeeFromOutside(SphericalPacking & sphere)
{
  for (auto * circles : { &sphere.nodes, &sphere.faces, &sphere.nodeRests, &sphere.faceRests })
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
CenterOf(const SphereCircle & circle)
{
  const double length = std::sqrt(circle[0] * circle[0] + circle[1] * circle[1] + circle[2] * circle[2]);
  return { circle[0] / length, circle[1] / length, circle[2] / length };
}

double
RadiusOf(const SphereCircle & circle)
{
  return std::atan2(1.0, circle[3]);
}

namespace
{
/** A packing with a layout on the sphere from any finite node. */
class FlatPacking
{
public:
  FlatPacking(const CombinatorialMap & map, PointAtInfinity infinity, OpenEndedProgress & steps)
    : m_Map(map)
    , m_Steps(steps)
    , m_Boundary(infinity == PointAtInfinity::Circle ? LongestFace(map) : -1)
    , m_Circles(this->Packed())
    , m_Root(LargestFiniteNode(m_Circles))
  {}
  /** Uses extended precision from here on if the radii have it. */
  void
  Refine()
  {
    m_Precision = PackingPrecision::Extended;
    if (m_Circles.nodeRests.empty())
    {
      m_Circles = this->Packed();
    }
  }
  SphericalPacking
  LaidOut() const
  {
    m_Steps.Step();
    SphericalPacking sphere = m_Boundary < 0 ? PlaneToSphere(m_Map, m_Circles, m_Root)
                                             : DiskToSphere(m_Map, m_Circles, m_Root, m_Boundary, m_Precision);
    SeeFromOutside(sphere);
    return sphere;
  }
  const CirclePacking &
  Circles() const
  {
    return m_Circles;
  }
  /** Start node of the layout. */
  int
  Root() const
  {
    return m_Root;
  }
  void
  SetRoot(int root)
  {
    m_Root = root;
  }

private:
  CirclePacking
  Packed() const
  {
    return m_Boundary < 0
             ? PackCircles(m_Map,
                           FlowGeometry::Euclidean,
                           CirclesThrough(m_Map, EdgeForInfinity(m_Map)),
                           m_Precision,
                           m_Steps.NextStep())
             : PackCircles(
                 m_Map, FlowGeometry::Hyperbolic, CirclesAround(m_Map, m_Boundary), m_Precision, m_Steps.NextStep());
  }

  const CombinatorialMap & m_Map;
  OpenEndedProgress &      m_Steps;
  int                      m_Boundary; ///< face; -1 for an edge node at infinity
  PackingPrecision         m_Precision{ PackingPrecision::Double };
  CirclePacking            m_Circles;
  int                      m_Root;
};

/** The largest cap among those finite in the flat packing. */
int
LargestOnSphere(const SphericalPacking & sphere, const CirclePacking & flat)
{
  int largest = -1;
  for (std::size_t node = 0; node < sphere.nodes.size(); ++node)
  {
    // The cotangent decreases with the angle.
    if (!std::isinf(flat.nodeRadii[node]) && (largest < 0 || sphere.nodes[node][3] < sphere.nodes[largest][3]))
    {
      largest = static_cast<int>(node);
    }
  }
  return largest;
}

double
AngleBetween(const std::array<double, 3> & a, const std::array<double, 3> & b)
{
  const double difference = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const double sum = std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
  return 2.0 * std::atan2(difference, sum);
}

/** Largest gap between circles that should touch (radians). */
double
WorstTangency(const CombinatorialMap & map, const SphericalPacking & sphere)
{
  double worst = 0.0;
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    const SphereCircle & one = sphere.nodes[map.Node(2 * edge)];
    const SphereCircle & other = sphere.nodes[map.Node(2 * edge + 1)];
    const double miss = std::abs(AngleBetween(CenterOf(one), CenterOf(other)) - RadiusOf(one) - RadiusOf(other));
    worst = miss <= worst ? worst : miss; // propagates NaN
  }
  return worst;
}

/** A packing moved into position by `move`. It is laid out again from the circle that became largest, until the motion
 * is short. `move` returns its rapidity and may stop early. */
template <typename TMove>
SphericalPacking
LayOut(FlatPacking & flat, const TMove & move)
{
  SphericalPacking sphere = flat.LaidOut();
  double           rapidity = move(sphere);
  for (int layout = 1; layout < mostLayouts && rapidity > smallRapidity; ++layout)
  {
    const int next = LargestOnSphere(sphere, flat.Circles());
    if (next == flat.Root())
    {
      break;
    }
    flat.SetRoot(next);
    sphere = flat.LaidOut();
    rapidity = move(sphere);
  }
  return sphere;
}

bool
HasSmallCap(const SphericalPacking & sphere, const std::vector<char> & isVisible)
{
  for (std::size_t node = 0; node < isVisible.size(); ++node)
  {
    if (isVisible[node] && RadiusOf(sphere.nodes[node]) < smallestCapOfBarycenter)
    {
      return true;
    }
  }
  return false;
}

/** Moves the packing to the position documented in PackOnSphere(). */
SphericalPacking
Positioned(FlatPacking & flat, const std::vector<int> & edges, const std::vector<char> & isVisible)
{
  SphericalPacking sphere = LayOut(flat, [&](SphericalPacking & s) { return CenterPacking(s, edges, mostRapidity); });
  if (HasSmallCap(sphere, isVisible))
  {
    sphere = LayOut(flat, [&](SphericalPacking & s) { return EnlargeSmallCaps(s, isVisible, mostRapidity); });
  }
  return sphere;
}

SphericalPacking
PackInGivenOrder(const CombinatorialMap &  map,
                 PointAtInfinity           infinity,
                 std::vector<int>          edges,
                 const std::vector<char> & isVisible,
                 const Progress &          progress)
{
  if (edges.size() < 3)
  {
    edges.resize(map.Edges());
    std::iota(edges.begin(), edges.end(), 0);
  }
  OpenEndedProgress steps(progress, 1.0);
  FlatPacking       flat(map, infinity, steps);
  SphericalPacking  sphere = Positioned(flat, edges, isVisible);
  if (!(WorstTangency(map, sphere) <= goodTangency))
  {
    flat.Refine();
    sphere = Positioned(flat, edges, isVisible);
  }
  sphere.residual = flat.Circles().residual;
  sphere.steps = flat.Circles().steps;
  if (const double miss = WorstTangency(map, sphere); !(miss <= worstTangency))
  {
    char text[200];
    std::snprintf(text,
                  sizeof(text),
                  "the radii are accurate to %.1e rad, but neighboring circles are %.1e rad apart on the sphere: "
                  "circle sizes differ too much for double precision",
                  sphere.residual,
                  miss);
    throw InputError(text);
  }
  sphere.nodeRests.clear(); // the rotation would invalidate them
  sphere.faceRests.clear();
  return sphere;
}

SphericalPacking
PackInNearbyOrder(const CombinatorialMap &  map,
                  PointAtInfinity           infinity,
                  std::vector<int>          edges,
                  const std::vector<char> & isVisible,
                  const Progress &          progress)
{
  const NearbyOrder order(map);
  for (int & edge : edges)
  {
    edge = order.Edge(edge);
  }
  std::sort(edges.begin(), edges.end());
  SphericalPacking sphere = PackInGivenOrder(
    order.Map(), infinity, std::move(edges), isVisible.empty() ? isVisible : order.NodesThere(isVisible), progress);
  sphere.nodes = order.NodesBack(sphere.nodes);
  sphere.faces = order.FacesBack(sphere.faces);
  sphere.touchPoints = order.EdgesBack(sphere.touchPoints);
  return sphere;
}
} // namespace

SphericalPacking
PackOnSphere(const CombinatorialMap &  map,
             PointAtInfinity           infinity,
             std::vector<int>          edges,
             const std::vector<char> & isVisible,
             const Progress &          progress)
{
  return NearbyOrder::Pays(map) ? PackInNearbyOrder(map, infinity, std::move(edges), isVisible, progress)
                                : PackInGivenOrder(map, infinity, std::move(edges), isVisible, progress);
}
} // namespace shapeton
