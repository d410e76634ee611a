#include "shapetonHeldEmbedding.h"

#include "shapetonGraphGenus.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Nodes near the ends of missing edges. */
class OpenRegion
{
public:
  explicit OpenRegion(const IncrementalMap & map) : m_Map(map), m_IsInside(map.Nodes(), 0)
  {
    for (int h = 0; h < 2 * map.Edges(); ++h)
    {
      m_IsInside[map.Node(h)] |= map.Contains(h / 2) ? 0 : 1;
    }
  }
  bool
  Contains(int node) const
  {
    return m_IsInside[node] != 0;
  }
  /** Grows by the nodes within the given number of steps along the incident faces. Returns false if no node remains
   * outside. */
  bool
  Grow(int steps)
  {
    const std::vector<char> before = m_IsInside;
    for (int h = 0; h < 2 * m_Map.Edges(); ++h)
    {
      if (m_Map.Contains(h / 2) && before[m_Map.Node(h)])
      {
        this->Walk(h, steps, before, [this](int k) { return m_Map.FaceNext(k); });
        this->Walk(h, steps, before, [this](int k) { return m_Map.NextAround(k) ^ 1; });
      }
    }
    return std::count(m_IsInside.begin(), m_IsInside.end(), 0) > 0;
  }

private:
  /** Stops at nodes that were already inside, because other walks start there. */
  template <typename TNext>
  void
  Walk(int halfEdge, int steps, const std::vector<char> & before, const TNext & next)
  {
    int h = next(halfEdge);
    for (int step = 0; step < steps && !before[m_Map.Node(h)]; ++step, h = next(h))
    {
      m_IsInside[m_Map.Node(h)] = 1;
    }
  }

  const IncrementalMap & m_Map;
  std::vector<char>      m_IsInside;
};

Graph
GraphOf(const IncrementalMap & map)
{
  Graph graph{ map.Nodes(), {}, {} };
  for (int e = 0; e < map.Edges(); ++e)
  {
    graph.edges.push_back({ map.Node(2 * e), map.Node(2 * e + 1) });
  }
  return graph;
}

/** Inserts wheels into the face of a half-edge: one for each row of corners outside the region. The rim of a wheel has
 * a node for each corner, which fixes the order of the corners. */
void
AddWheels(const IncrementalMap & map, const OpenRegion & region, int halfEdge, Graph & graph)
{
  const auto isHeld = [&](int h) { return !region.Contains(map.Node(h)); };
  int        start = halfEdge; // row ends, unless all corners are held
  do
  {
    start = map.FaceNext(start);
  } while (start != halfEdge && !(isHeld(start) && !isHeld(map.NextAround(start) ^ 1)));
  const bool isWhole = isHeld(start) && isHeld(map.NextAround(start) ^ 1);
  int        hub = -1;
  const int  first = graph.nodes + 1;
  int        h = start;
  do
  {
    if (!isHeld(h))
    {
      hub = -1;
    }
    else
    {
      const bool continues = hub >= 0;
      hub = continues ? hub : graph.nodes++;
      const int rim = graph.nodes++;
      graph.edges.push_back({ hub, rim });
      graph.edges.push_back({ rim, map.Node(h) });
      if (continues)
      {
        graph.edges.push_back({ rim - 1, rim });
      }
    }
    h = map.FaceNext(h);
  } while (h != start);
  if (isWhole && graph.nodes - first > 2)
  {
    graph.edges.push_back({ graph.nodes - 1, first });
  }
}

Graph
WithWheels(const IncrementalMap & map, const OpenRegion & region)
{
  Graph             graph = GraphOf(map);
  std::vector<char> isDone(map.FaceLabels(), 0);
  for (int h = 0; h < 2 * map.Edges(); ++h)
  {
    if (map.Contains(h / 2) && !isDone[map.Face(h)])
    {
      isDone[map.Face(h)] = 1;
      AddWheels(map, region, h, graph);
    }
  }
  return graph;
}

/** Restricts a map to a graph that consists of its first nodes and edges. */
CombinatorialMap
PartOf(const CombinatorialMap & map, const Graph & graph)
{
  Rotation rotation(graph.nodes);
  for (int node = 0; node < graph.nodes; ++node)
  {
    for (const int h : map.Around(node))
    {
      if (h < static_cast<int>(2 * graph.edges.size()))
      {
        rotation[node].push_back(h);
      }
    }
  }
  return { graph, rotation };
}
} // namespace

CombinatorialMap
TurnedTo(const IncrementalMap & carried, const CombinatorialMap & fresh)
{
  int same = 0;
  int mirrored = 0;
  for (int h = 0; h < fresh.HalfEdges(); ++h)
  {
    same += fresh.NextAround(h) == carried.NextAround(h) ? 1 : 0;
    mirrored += fresh.PreviousAround(h) == carried.NextAround(h) ? 1 : 0;
  }
  return mirrored > same ? fresh.Mirrored() : fresh;
}

bool
EmbedHeld(const IncrementalMap & map, CombinatorialMap & embedded)
{
  const Graph graph = GraphOf(map);
  if (!FindPlanarEmbedding(graph, embedded))
  {
    return false;
  }
  OpenRegion region(map);
  for (int steps = 1; region.Grow(steps); steps *= 2)
  {
    CombinatorialMap held;
    if (FindPlanarEmbedding(WithWheels(map, region), held))
    {
      embedded = TurnedTo(map, PartOf(held, graph));
      return true;
    }
  }
  return false;
}
} // namespace shapeton
