#include "shapetonGraphStructure.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace shapeton
{
Incidence::Incidence(const Graph & graph) : start(graph.nodes + 1, 0), halfEdges(2 * graph.edges.size())
{
  RequireEnds(graph, "the graph");
  for (const auto & edge : graph.edges)
  {
    ++start[edge[0] + 1];
    ++start[edge[1] + 1];
  }
  for (int v = 0; v < graph.nodes; ++v)
  {
    start[v + 1] += start[v];
  }
  std::vector<int> place(start.begin(), start.end() - 1);
  for (std::size_t h = 0; h < halfEdges.size(); ++h)
  {
    halfEdges[place[graph.edges[h / 2][h % 2]]++] = static_cast<int>(h);
  }
}

namespace
{
int
HeadOf(const Graph & graph, int halfEdge)
{
  return graph.edges[halfEdge / 2][1 - halfEdge % 2];
}

/** The component of each node. */
std::vector<int>
ComponentOfEachNode(const Graph & graph, const Incidence & incidence, int & components)
{
  std::vector<int> component(graph.nodes, -1);
  std::vector<int> stack;
  components = 0;
  for (int start = 0; start < graph.nodes; ++start)
  {
    if (component[start] >= 0)
    {
      continue;
    }
    component[start] = components;
    stack.push_back(start);
    while (!stack.empty())
    {
      const int node = stack.back();
      stack.pop_back();
      for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
      {
        const int head = HeadOf(graph, incidence.halfEdges[i]);
        if (component[head] < 0)
        {
          component[head] = components;
          stack.push_back(head);
        }
      }
    }
    ++components;
  }
  return component;
}
} // namespace

std::vector<Subgraph>
ConnectedComponents(const Graph & graph)
{
  int                    components = 0;
  const std::vector<int> component = ComponentOfEachNode(graph, Incidence(graph), components);
  std::vector<Subgraph>  parts(components);
  std::vector<int>       index(graph.nodes);
  for (int v = 0; v < graph.nodes; ++v)
  {
    Subgraph & part = parts[component[v]];
    index[v] = part.graph.nodes++;
    part.nodes.push_back(v);
    if (!graph.names.empty())
    {
      part.graph.names.push_back(graph.names[v]);
    }
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    const auto & edge = graph.edges[e];
    Subgraph &   part = parts[component[edge[0]]];
    part.graph.edges.push_back({ index[edge[0]], index[edge[1]] });
    part.edges.push_back(static_cast<int>(e));
  }
  return parts;
}

namespace
{
/** Tarjan's block search with a stack of edges, without recursion. */
class BlockSearch
{
public:
  explicit BlockSearch(const Graph & graph)
    : m_Graph(graph)
    , m_Incidence(graph)
    , m_Number(graph.nodes, -1)
    , m_Low(graph.nodes, -1)
    , m_EdgeToParent(graph.nodes, -1)
    , m_Place(m_Incidence.start.begin(), m_Incidence.start.end() - 1)
    , m_Seen(graph.edges.size(), false)
  {}

  std::vector<std::vector<int>>
  Run()
  {
    for (int v = 0; v < m_Graph.nodes; ++v)
    {
      if (m_Number[v] < 0)
      {
        SearchFrom(v);
      }
    }
    for (auto & block : m_Blocks)
    {
      std::sort(block.begin(), block.end());
    }
    std::sort(m_Blocks.begin(), m_Blocks.end());
    return std::move(m_Blocks);
  }

private:
  void
  Enter(int node)
  {
    m_Number[node] = m_Low[node] = m_Count++;
    m_Path.push_back(node);
  }

  void
  SearchFrom(int root)
  {
    Enter(root);
    while (!m_Path.empty())
    {
      const int node = m_Path.back();
      if (m_Place[node] < m_Incidence.start[node + 1])
      {
        Follow(node, m_Incidence.halfEdges[m_Place[node]++]);
      }
      else
      {
        m_Path.pop_back();
        if (!m_Path.empty())
        {
          Leave(node, m_Path.back());
        }
      }
    }
  }

  void
  Follow(int node, int halfEdge)
  {
    const int edge = halfEdge / 2;
    if (m_Seen[edge])
    {
      return;
    }
    m_Seen[edge] = true;
    const int head = HeadOf(m_Graph, halfEdge);
    if (head == node)
    {
      m_Blocks.push_back({ edge });
      return;
    }
    m_Edges.push_back(edge);
    if (m_Number[head] < 0)
    {
      m_EdgeToParent[head] = edge;
      Enter(head);
    }
    else
    {
      m_Low[node] = std::min(m_Low[node], m_Number[head]);
    }
  }

  void
  Leave(int node, int parent)
  {
    m_Low[parent] = std::min(m_Low[parent], m_Low[node]);
    if (m_Low[node] < m_Number[parent])
    {
      return;
    }
    std::vector<int> block;
    do
    {
      block.push_back(m_Edges.back());
      m_Edges.pop_back();
    } while (block.back() != m_EdgeToParent[node]);
    m_Blocks.push_back(std::move(block));
  }

  const Graph &                 m_Graph;
  const Incidence               m_Incidence;
  std::vector<int>              m_Number;
  std::vector<int>              m_Low;
  std::vector<int>              m_EdgeToParent;
  std::vector<int>              m_Place;
  std::vector<bool>             m_Seen;
  std::vector<int>              m_Path;
  std::vector<int>              m_Edges;
  std::vector<std::vector<int>> m_Blocks;
  int                           m_Count{ 0 };
};
} // namespace

std::vector<std::vector<int>>
BlocksOf(const Graph & graph)
{
  return BlockSearch(graph).Run();
}

Subgraph
SubgraphOfEdges(const Graph & graph, const std::vector<int> & edges)
{
  Subgraph part;
  part.edges = edges;
  for (const int e : edges)
  {
    part.nodes.insert(part.nodes.end(), graph.edges[e].begin(), graph.edges[e].end());
  }
  std::sort(part.nodes.begin(), part.nodes.end());
  part.nodes.erase(std::unique(part.nodes.begin(), part.nodes.end()), part.nodes.end());
  part.graph.nodes = static_cast<int>(part.nodes.size());
  const bool hasAllNodes = part.graph.nodes == graph.nodes;
  const auto indexOf = [&part, hasAllNodes](int node) {
    return hasAllNodes
             ? node
             : static_cast<int>(std::lower_bound(part.nodes.begin(), part.nodes.end(), node) - part.nodes.begin());
  };
  part.graph.edges.reserve(edges.size());
  for (const int e : edges)
  {
    part.graph.edges.push_back({ indexOf(graph.edges[e][0]), indexOf(graph.edges[e][1]) });
  }
  for (const int v : part.nodes)
  {
    if (!graph.names.empty())
    {
      part.graph.names.push_back(graph.names[v]);
    }
  }
  return part;
}

std::vector<int>
FirstParallels(const Graph & graph)
{
  struct Entry
  {
    std::int64_t ends;
    int          edge;
    bool
    operator<(const Entry & other) const
    {
      return ends != other.ends ? ends < other.ends : edge < other.edge;
    }
  };
  std::vector<Entry> entries(graph.edges.size());
  for (std::size_t e = 0; e < entries.size(); ++e)
  {
    const auto [low, high] = std::minmax(graph.edges[e][0], graph.edges[e][1]);
    entries[e] = { static_cast<std::int64_t>(low) * graph.nodes + high, static_cast<int>(e) };
  }
  std::sort(entries.begin(), entries.end());
  std::vector<int> first(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const int  e = entries[i].edge;
    const bool again = i > 0 && entries[i].ends == entries[i - 1].ends;
    first[e] = graph.edges[e][0] == graph.edges[e][1] ? -1 : again ? first[entries[i - 1].edge] : e;
  }
  return first;
}

namespace
{
/** Minimum possible cycle length: 3 without loops and parallel edges. */
int
LeastGirth(const Graph & graph)
{
  int                    least = 3;
  const std::vector<int> first = FirstParallels(graph);
  for (std::size_t e = 0; e < first.size(); ++e)
  {
    least = std::min(least, first[e] < 0 ? 1 : first[e] != static_cast<int>(e) ? 2 : 3);
  }
  return least;
}
} // namespace

int
Girth(const Graph & graph)
{
  const Incidence  incidence(graph);
  const int        least = LeastGirth(graph);
  const int        none = std::numeric_limits<int>::max();
  int              girth = none;
  std::vector<int> distance(graph.nodes, -1);
  std::vector<int> edgeToParent(graph.nodes, -1);
  std::vector<int> queue;
  for (int start = 0; start < graph.nodes && girth > least; ++start)
  {
    queue.assign(1, start);
    distance[start] = 0;
    edgeToParent[start] = -1;
    for (std::size_t head = 0; head < queue.size() && 2 * distance[queue[head]] < girth; ++head)
    {
      const int node = queue[head];
      for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
      {
        const int halfEdge = incidence.halfEdges[i];
        const int neighbor = HeadOf(graph, halfEdge);
        if (distance[neighbor] < 0)
        {
          distance[neighbor] = distance[node] + 1;
          edgeToParent[neighbor] = halfEdge / 2;
          queue.push_back(neighbor);
        }
        else if (edgeToParent[node] != halfEdge / 2)
        {
          girth = std::min(girth, distance[node] + distance[neighbor] + 1);
        }
      }
    }
    for (const int node : queue)
    {
      distance[node] = -1;
    }
  }
  return girth == none ? 0 : girth;
}
} // namespace shapeton
