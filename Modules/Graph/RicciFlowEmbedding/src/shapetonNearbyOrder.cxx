#include "shapetonNearbyOrder.h"

#include <cstdlib>

namespace shapeton
{
namespace
{
/** Maps with fewer edges fit the processor caches. */
constexpr int fewestEdges = 200'000;
/** Mean index distance between neighbors, as a fraction of the nodes; one third in random order. */
constexpr double mostScattered = 0.03;
} // namespace

bool
NearbyOrder::Pays(const CombinatorialMap & map)
{
  if (map.Edges() < fewestEdges)
  {
    return false;
  }
  double sum = 0.0;
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    sum += std::abs(map.Node(2 * edge) - map.Node(2 * edge + 1));
  }
  return sum > mostScattered * map.Nodes() * map.Edges();
}

NearbyOrder::NearbyOrder(const CombinatorialMap & map)
  : m_NodeOf(map.Nodes(), -1), m_EdgeOf(map.Edges(), -1), m_FaceOf(map.Faces())
{
  this->NumberBreadthFirst(map);
  const auto                      halfEdgeOf = [this](int h) { return 2 * m_EdgeOf[h / 2] + h % 2; };
  std::vector<std::array<int, 2>> edges(map.Edges());
  std::vector<int>                next(map.HalfEdges());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    edges[m_EdgeOf[h / 2]][h % 2] = m_NodeOf[map.Node(h)];
    next[halfEdgeOf(h)] = halfEdgeOf(map.NextAround(h));
  }
  m_Map = CombinatorialMap(map.Nodes(), edges, std::move(next));
  for (int face = 0; face < map.Faces(); ++face)
  {
    m_FaceOf[face] = m_Map.Face(halfEdgeOf(map.FirstOfFace(face)));
  }
}

void
NearbyOrder::NumberBreadthFirst(const CombinatorialMap & map)
{
  std::vector<int> queue{ 0 };
  int              edges = 0;
  queue.reserve(map.Nodes());
  m_NodeOf[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int first = map.FirstAround(queue[i]);
    int       h = first;
    do
    {
      const int other = map.Node(CombinatorialMap::Twin(h));
      if (m_NodeOf[other] < 0)
      {
        m_NodeOf[other] = static_cast<int>(queue.size());
        queue.push_back(other);
      }
      if (m_EdgeOf[h / 2] < 0)
      {
        m_EdgeOf[h / 2] = edges++;
      }
      h = map.NextAround(h);
    } while (h != first);
  }
}
} // namespace shapeton
