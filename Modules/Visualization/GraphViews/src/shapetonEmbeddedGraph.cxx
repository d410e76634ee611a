#include "shapetonEmbeddedGraph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
std::vector<Place>
PlacesOf(const std::vector<double> & numbers, EmbeddingGeometry geometry)
{
  const std::size_t  step = CoordinatesOf(geometry);
  std::vector<Place> places(numbers.size() / step);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = { numbers[step * i], numbers[step * i + 1], step == 3 ? numbers[step * i + 2] : 0.0 };
  }
  return places;
}
} // namespace

EmbeddedGraph::EmbeddedGraph(const EmbeddingCertificate & embedding)
  : certificate(embedding)
  , space(embedding.geometry)
  , map(MapOfRotation(embedding.packed, embedding.packedRotation))
  , nodes(PlacesOf(embedding.nodePositions, embedding.geometry))
  , faces(PlacesOf(embedding.facePositions, embedding.geometry))
{
  this->FindPlaces();
  this->FindVisibleEdges();
  this->FindDual();
}

void
EmbeddedGraph::FindPlaces()
{
  touch.resize(map.HalfEdges());
  corner.resize(map.HalfEdges());
  const bool       isSphere = space.Geometry() == EmbeddingGeometry::Spherical;
  std::vector<int> first(map.Nodes(), -1); // first half-edge in the rotation; start of the angle
  for (const int h : certificate.packedRotation)
  {
    int & start = first[map.Node(h)];
    start = start < 0 ? h : start;
  }
  for (int node = 0; node < map.Nodes(); ++node)
  {
    double angle = isSphere ? 0.0 : certificate.nodeAngles[node];
    int    h = first[node];
    for (bool isDone = h < 0; !isDone; isDone = h == first[node])
    {
      const double r = certificate.nodeRadii[node];
      const double s = certificate.faceRadii[map.Face(h)];
      if (isSphere)
      {
        touch[h] = ModelSpace::OnArc(nodes[node], nodes[map.Node(CombinatorialMap::Twin(h))], r);
        corner[h] = faces[map.Face(h)];
      }
      else
      {
        const double half = space.HalfKiteAngle(r, s);
        touch[h] = space.Walk(nodes[node], angle, r);
        corner[h] = space.Walk(nodes[node], angle + half, space.KiteDiagonal(r, s));
        angle += 2.0 * half;
      }
      h = map.NextAround(h);
    }
  }
}

void
EmbeddedGraph::FindVisibleEdges()
{
  edgeOf.assign(map.Edges(), -1);
  std::iota(edgeOf.begin(), edgeOf.begin() + static_cast<std::ptrdiff_t>(certificate.graph.edges.size()), 0);
  for (const std::vector<int> & path : certificate.subdivided)
  {
    for (const int h : path)
    {
      edgeOf[h / 2] = path.front() / 2;
    }
  }
  isVisibleEdge.assign(map.Edges(), 0);
  std::transform(edgeOf.begin(), edgeOf.end(), isVisibleEdge.begin(), [](int edge) { return edge >= 0 ? 1 : 0; });
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (isVisibleEdge[h / 2] != 0)
    {
      halfEdges.push_back({ nodes[map.Node(h)], touch[h] });
    }
  }
}

/** Segments from the tangency point of the edge to the centers of the faces on both sides. */
void
EmbeddedGraph::AddDualCrossing(int halfEdge)
{
  dual.push_back({ touch[halfEdge], corner[halfEdge] });
  const int twin = CombinatorialMap::Twin(halfEdge);
  dual.push_back({ touch[twin], corner[twin] });
}

/** Merges packed faces separated only by dummies into one face of the graph. The representative is the face with the
 * largest circle; the dual connects it from face to face. */
void
EmbeddedGraph::FindDual()
{
  std::vector<int> parent(map.Faces(), -2); // half-edge towards the representative; -1 at the representative
  std::vector<int> owner(map.Faces());
  std::vector<int> order(map.Faces());

  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return certificate.faceRadii[a] > certificate.faceRadii[b]; });
  isVisibleFace.assign(map.Faces(), 0);
  for (const int start : order)
  {
    if (parent[start] != -2)
    {
      continue;
    }
    parent[start] = -1;
    representatives.push_back(start);
    std::vector<int> queue{ start };
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      owner[queue[i]] = start;
      const int first = map.FirstOfFace(queue[i]);
      int       h = first;
      do
      {
        const int other = map.Face(CombinatorialMap::Twin(h));
        if (isVisibleEdge[h / 2] == 0 && parent[other] == -2)
        {
          parent[other] = CombinatorialMap::Twin(h);
          queue.push_back(other);
        }
        h = map.FaceNext(h);
      } while (h != first);
    }
    isVisibleFace[start] = queue.size() == 1 ? 1 : 0;
  }
  this->DrawDual(parent);
  if (space.Geometry() == EmbeddingGeometry::Spherical)
  {
    this->FindPole(owner);
    this->FindFront();
  }
}

/** A face of the graph contains the circles of its packed faces and of dummies that are not on an edge of the graph.
 * `owner` is the representative of each packed face. */
void
EmbeddedGraph::FindPole(const std::vector<int> & owner)
{
  struct Circle
  {
    int    face;
    double radius;
    Place  center;
  };
  std::vector<Circle> circles;
  for (int face = 0; face < map.Faces(); ++face)
  {
    circles.push_back({ owner[face], certificate.faceRadii[face], faces[face] });
  }
  for (int node = certificate.graph.nodes; node < map.Nodes(); ++node)
  {
    const std::vector<int> around = map.Around(node);
    if (std::none_of(around.begin(), around.end(), [this](int h) { return isVisibleEdge[h / 2] != 0; }))
    {
      circles.push_back({ owner[map.Face(around.front())], certificate.nodeRadii[node], nodes[node] });
    }
  }
  std::vector<double> area(map.Faces(), 0.0);
  for (const Circle & circle : circles)
  {
    area[circle.face] += 1.0 - std::cos(circle.radius);
  }
  const auto outer = static_cast<int>(std::max_element(area.begin(), area.end()) - area.begin());
  double     largest = 0.0;
  for (const Circle & circle : circles)
  {
    if (circle.face == outer && circle.radius > largest)
    {
      largest = circle.radius;
      pole = circle.center;
    }
  }
}

/** Mean direction of the nodes, weighted by radius, because many nodes are small and large ones dominate the view. If
 * the graph surrounds the sphere evenly, a direction from which polyhedra look solid. */
void
EmbeddedGraph::FindFront()
{
  constexpr double uneven = 0.05;               // least length of the mean position of nodes
  constexpr Place  oblique{ 0.48, -0.6, 0.64 }; // a unit vector off the axes, for evenly distributed nodes
  double           total = 0.0;
  Place            sum;
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    const double radius = certificate.nodeRadii[node];
    total += radius;
    sum = { sum.x + radius * nodes[node].x, sum.y + radius * nodes[node].y, sum.z + radius * nodes[node].z };
  }
  const double length = std::sqrt(Dot(sum, sum));
  front = length > uneven * total ? Place{ sum.x / length, sum.y / length, sum.z / length } : oblique;
}

/** The dual crosses each edge once, at the tangency point in the middle of its path, and then follows the
 * parents. */
void
EmbeddedGraph::DrawDual(const std::vector<int> & parent)
{
  std::vector<int> crossing(certificate.graph.edges.size());
  std::iota(crossing.begin(), crossing.end(), 0);
  for (const std::vector<int> & path : certificate.subdivided)
  {
    crossing[path.front() / 2] = path[path.size() / 2] / 2;
  }
  std::vector<char> isDrawn(map.Edges(), 0);
  for (const int edge : crossing)
  {
    crossings.push_back(2 * edge);
    this->AddDualCrossing(2 * edge);
    for (const int side : { 2 * edge, 2 * edge + 1 })
    {
      for (int h = parent[map.Face(side)]; h >= 0 && isDrawn[h / 2] == 0;
           h = parent[map.Face(CombinatorialMap::Twin(h))])
      {
        isDrawn[h / 2] = 1;
        this->AddDualCrossing(h);
      }
    }
  }
}
} // namespace shapeton
