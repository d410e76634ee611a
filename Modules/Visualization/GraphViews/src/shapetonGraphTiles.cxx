#include "shapetonGraphTiles.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace shapeton
{
namespace
{
double
Gap(const Place & p, const Place & q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

int
RootOf(const EmbeddedGraph & graph)
{
  const auto & tree = graph.certificate.tree;
  return static_cast<int>(std::find(tree.begin(), tree.end(), -1) - tree.begin());
}

/** Whether both ends of the edge touch without a deck transformation. */
bool
IsInside(const EmbeddedGraph & graph, int halfEdge)
{
  const int    twin = CombinatorialMap::Twin(halfEdge);
  const Place  there = graph.touch[halfEdge];
  const double radius = std::min(Gap(graph.nodes[graph.map.Node(halfEdge)], there),
                                 Gap(graph.nodes[graph.map.Node(twin)], graph.touch[twin]));
  return Gap(there, graph.touch[twin]) < 1e-3 * radius;
}

struct Candidate
{
  Motion motion;
  Place  image;
  double distance;
};

/** Sort key of a motion by the displacement of the root. */
Candidate
CandidateOf(const EmbeddedGraph & graph, const Motion & motion, const Place & root)
{
  const Place  image = graph.space.Moved(motion, root);
  const double gap = Gap(image, root);
  const double distance =
    graph.space.Geometry() == EmbeddingGeometry::Euclidean
      ? gap
      : gap / std::sqrt((1.0 - std::hypot(image.x, image.y)) * (1.0 + std::hypot(image.x, image.y)));
  return { motion, image, distance };
}

bool
Contains(const std::vector<Candidate> & list, const Candidate & candidate)
{
  constexpr double sameDistance = 1e-5; // relative
  constexpr double samePlace = 1e-6;    // in the plane of the picture
  return std::any_of(list.begin(), list.end(), [&](const Candidate & other) {
    return std::abs(other.distance - candidate.distance) < sameDistance * (1.0 + candidate.distance) &&
           Gap(other.image, candidate.image) < samePlace;
  });
}
} // namespace

std::vector<Place>
DomainBoundary(const EmbeddedGraph & graph)
{
  std::vector<Place> boundary;
  if (graph.space.Geometry() == EmbeddingGeometry::Spherical)
  {
    return boundary;
  }
  const CombinatorialMap & map = graph.map;
  std::vector<char>        isInside(map.Edges());
  int                      first = -1;
  for (int edge = map.Edges() - 1; edge >= 0; --edge)
  {
    isInside[edge] = IsInside(graph, 2 * edge) ? 1 : 0;
    first = isInside[edge] != 0 ? first : 2 * edge;
  }
  if (first < 0)
  {
    return boundary;
  }
  int h = first;
  do
  {
    boundary.push_back(graph.touch[h]);
    boundary.push_back(graph.corner[h]);
    h = map.NextAround(h);
    while (isInside[h / 2] != 0)
    {
      h = map.NextAround(CombinatorialMap::Twin(h));
    }
  } while (h != first);
  return boundary;
}

/* Visits the nearest motion with unvisited neighbors next, as in Dijkstra's algorithm. */
std::vector<Motion>
TilesAround(const EmbeddedGraph & graph, int count)
{
  std::vector<Motion> steps;
  for (const DeckTransformation & generator : graph.certificate.generators)
  {
    steps.push_back({ generator.a, generator.b });
    steps.push_back(graph.space.Inverse(steps.back()));
  }
  if (steps.empty())
  {
    return { Motion{} };
  }
  const Place                              root = graph.nodes[RootOf(graph)];
  std::vector<Candidate>                   found{ CandidateOf(graph, {}, root) };
  std::set<std::pair<double, std::size_t>> front{ { 0.0, 0 } };
  std::vector<Motion>                      motions;
  while (!front.empty() && motions.size() < static_cast<std::size_t>(count))
  {
    const Motion nearest = found[front.begin()->second].motion;
    front.erase(front.begin());
    motions.push_back(nearest);
    for (const Motion & step : steps)
    {
      const Candidate more = CandidateOf(graph, graph.space.Product(nearest, step), root);
      if (std::isfinite(more.distance) && !Contains(found, more))
      {
        front.emplace(more.distance, found.size());
        found.push_back(more);
      }
    }
  }
  return motions;
}

std::vector<Place>
PolygonCorners(const EmbeddedGraph & graph)
{
  std::vector<Place> corners;
  if (graph.certificate.word.empty())
  {
    return corners;
  }
  const Place root = graph.nodes[RootOf(graph)];
  Motion      product;
  for (const int letter : graph.certificate.word)
  {
    const DeckTransformation & generator = graph.certificate.generators[std::abs(letter) - 1];
    const Motion               motion{ generator.a, generator.b };
    corners.push_back(graph.space.Moved(product, root));
    product = graph.space.Product(product, letter > 0 ? motion : graph.space.Inverse(motion));
  }
  return corners;
}
} // namespace shapeton
