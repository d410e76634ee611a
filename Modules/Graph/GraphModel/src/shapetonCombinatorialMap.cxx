#include "shapetonCombinatorialMap.h"

#include "shapetonExceptions.h"

#include <numeric>

namespace shapeton
{
namespace
{
/** Creates the message only on demand, because this runs for every half-edge. */
template <typename TFault>
void
Require(bool condition, const TFault & fault)
{
  if (!condition)
  {
    throw InputError("the rotation system does not match the graph: " + fault());
  }
}

std::vector<int>
NextAroundOf(const Graph & graph, const Rotation & rotation)
{
  Require(rotation.size() == static_cast<std::size_t>(graph.nodes),
          [&] { return std::to_string(rotation.size()) + " orders for " + std::to_string(graph.nodes) + " nodes"; });
  const int        halfEdges = static_cast<int>(2 * graph.edges.size());
  std::vector<int> next(halfEdges, -1);
  for (const auto & order : rotation)
  {
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const int halfEdge = order[i];
      Require(halfEdge >= 0 && halfEdge < halfEdges, [&] { return "invalid half-edge " + std::to_string(halfEdge); });
      Require(next[halfEdge] < 0, [&] { return "half-edge " + std::to_string(halfEdge) + " is listed twice"; });
      next[halfEdge] = order[(i + 1) % order.size()];
    }
  }
  return next;
}

std::vector<int>
Counts(const std::vector<int> & group, int groups)
{
  std::vector<int> counts(groups, 0);
  for (const int g : group)
  {
    ++counts[g];
  }
  return counts;
}
} // namespace

CombinatorialMap::CombinatorialMap(const Graph & graph, const Rotation & rotation)
  : CombinatorialMap(graph.nodes, graph.edges, NextAroundOf(graph, rotation))
{}

CombinatorialMap::CombinatorialMap(int                                     nodes,
                                   const std::vector<std::array<int, 2>> & edges,
                                   std::vector<int>                        nextAround)
  : m_FirstAround(nodes, -1)
{
  m_Next = std::move(nextAround);
  Require(m_Next.size() == 2 * edges.size(),
          [&] { return std::to_string(m_Next.size()) + " half-edges for " + std::to_string(edges.size()) + " edges"; });
  m_Node.resize(m_Next.size());
  for (std::size_t h = 0; h < m_Node.size(); ++h)
  {
    m_Node[h] = edges[h / 2][h % 2];
    Require(m_Node[h] >= 0 && m_Node[h] < nodes, [&] { return "invalid node " + std::to_string(m_Node[h]); });
  }
  Build();
}

void
CombinatorialMap::Build()
{
  LinkNodes();
  TraceFaces();
  FindComponents();
}

/** Checks that the cycles of m_Next are the nodes: a permutation within each node, with one cycle per node. */
void
CombinatorialMap::LinkNodes()
{
  m_Previous.assign(HalfEdges(), -1);
  for (int h = 0; h < HalfEdges(); ++h)
  {
    const int next = m_Next[h];
    Require(next >= 0 && next < HalfEdges(), [&] {
      return "half-edge " + std::to_string(h) + ", which leaves node " + std::to_string(m_Node[h]) +
             ", is missing among the neighbors of this node (nodes count from 0)";
    });
    Require(m_Node[next] == m_Node[h], [&] { return "half-edge " + std::to_string(next) + " leaves another node"; });
    Require(m_Previous[next] < 0, [&] { return "half-edge " + std::to_string(next) + " is listed twice"; });
    m_Previous[next] = h;
  }
  std::vector<bool> seen(HalfEdges(), false);
  for (int h = 0; h < HalfEdges(); ++h)
  {
    if (seen[h])
    {
      continue;
    }
    Require(m_FirstAround[m_Node[h]] < 0, [&] { return "node " + std::to_string(m_Node[h]) + " has two orders"; });
    m_FirstAround[m_Node[h]] = h;
    for (int x = h; !seen[x]; x = m_Next[x])
    {
      seen[x] = true;
    }
  }
}

void
CombinatorialMap::TraceFaces()
{
  m_Face.assign(HalfEdges(), -1);
  for (int h = 0; h < HalfEdges(); ++h)
  {
    if (m_Face[h] >= 0)
    {
      continue;
    }
    for (int x = h; m_Face[x] < 0; x = FaceNext(x))
    {
      m_Face[x] = Faces();
    }
    m_FirstOfFace.push_back(h);
  }
}

void
CombinatorialMap::FindComponents()
{
  m_ComponentOfNode.assign(Nodes(), -1);
  std::vector<int> euler; // Euler characteristic of each component
  std::vector<int> stack;
  for (int start = 0; start < Nodes(); ++start)
  {
    if (m_ComponentOfNode[start] >= 0)
    {
      continue;
    }
    m_ComponentOfNode[start] = static_cast<int>(euler.size());
    euler.push_back(m_FirstAround[start] < 0 ? 1 : 0); // the face of an isolated node
    stack.push_back(start);
    while (!stack.empty())
    {
      const int node = stack.back();
      stack.pop_back();
      ++euler.back();
      for (int h = m_FirstAround[node]; h >= 0; h = m_Next[h] == m_FirstAround[node] ? -1 : m_Next[h])
      {
        const int neighbor = m_Node[Twin(h)];
        if (m_ComponentOfNode[neighbor] < 0)
        {
          m_ComponentOfNode[neighbor] = m_ComponentOfNode[node];
          stack.push_back(neighbor);
        }
      }
    }
  }
  for (int e = 0; e < Edges(); ++e)
  {
    --euler[m_ComponentOfNode[m_Node[2 * e]]];
  }
  for (const int h : m_FirstOfFace)
  {
    ++euler[m_ComponentOfNode[m_Node[h]]];
  }
  m_GenusOfComponent.clear();
  for (const int characteristic : euler)
  {
    m_GenusOfComponent.push_back((2 - characteristic) / 2);
  }
}

std::vector<int>
CombinatorialMap::Around(int node) const
{
  std::vector<int> result;
  const int        first = m_FirstAround[node];
  for (int h = first; h >= 0; h = m_Next[h] == first ? -1 : m_Next[h])
  {
    result.push_back(h);
  }
  return result;
}

std::vector<int>
CombinatorialMap::Boundary(int face) const
{
  std::vector<int> result;
  int              h = m_FirstOfFace[face];
  do
  {
    result.push_back(h);
    h = FaceNext(h);
  } while (h != m_FirstOfFace[face]);
  return result;
}

std::vector<int>
CombinatorialMap::Degrees() const
{
  return Counts(m_Node, Nodes());
}

std::vector<int>
CombinatorialMap::FaceLengths() const
{
  return Counts(m_Face, Faces());
}

int
CombinatorialMap::Genus() const
{
  return std::accumulate(m_GenusOfComponent.begin(), m_GenusOfComponent.end(), 0);
}

CombinatorialMap
CombinatorialMap::Dual() const
{
  CombinatorialMap dual;
  dual.m_Node = m_Face;
  dual.m_FirstAround.assign(Faces(), -1);
  dual.m_Next.resize(HalfEdges());
  for (int h = 0; h < HalfEdges(); ++h)
  {
    dual.m_Next[h] = FaceNext(h);
  }
  dual.Build();
  return dual;
}

CombinatorialMap
CombinatorialMap::Mirrored() const
{
  CombinatorialMap mirrored;
  mirrored.m_Node = m_Node;
  mirrored.m_FirstAround.assign(Nodes(), -1);
  mirrored.m_Next = m_Previous;
  mirrored.Build();
  return mirrored;
}

Rotation
CombinatorialMap::GetRotation() const
{
  Rotation rotation(Nodes());
  for (int node = 0; node < Nodes(); ++node)
  {
    rotation[node] = Around(node);
  }
  return rotation;
}

Graph
CombinatorialMap::ToGraph() const
{
  Graph graph;
  graph.nodes = Nodes();
  graph.edges.reserve(Edges());
  for (int h = 0; h < HalfEdges(); h += 2)
  {
    graph.edges.push_back({ m_Node[h], m_Node[Twin(h)] });
  }
  return graph;
}

OverlapGraph::OverlapGraph(const CombinatorialMap & original)
  : firstFaceNode(original.Nodes()), firstEdgeNode(original.Nodes() + original.Faces())
{
  const int                       n = original.HalfEdges();
  std::vector<std::array<int, 2>> edges(2 * n);
  std::vector<int>                next(4 * n);
  for (int h = 0; h < n; ++h)
  {
    edges[h] = { original.Node(h), NodeOfEdge(h / 2) };
    edges[n + h] = { NodeOfFace(original.Face(h)), NodeOfEdge(h / 2) };
    next[2 * h] = 2 * original.NextAround(h);
    next[2 * (n + h)] = 2 * (n + original.FaceNext(h));
    // Around the node of the edge: start node of h, face to its right, end node, face to its left.
    const int twin = CombinatorialMap::Twin(h);
    next[2 * h + 1] = 2 * (n + twin) + 1;
    next[2 * (n + twin) + 1] = 2 * twin + 1;
  }
  map = CombinatorialMap(original.Nodes() + original.Faces() + original.Edges(), edges, std::move(next));
}
} // namespace shapeton
