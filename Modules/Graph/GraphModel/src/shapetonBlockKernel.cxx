#include "shapetonBlockKernel.h"

#include "shapetonPlanarRotation.h"

#include <algorithm>

namespace shapeton
{
namespace
{
long long
KeyOf(int a, int b)
{
  return (static_cast<long long>(std::min(a, b)) << 32) | std::max(a, b);
}
} // namespace

BlockKernel::BlockKernel(const Graph & block)
  : m_Incident(block.nodes), m_Degree(block.nodes, 0), m_HalfEdges(2 * block.edges.size())
{
  m_EdgeOfPair.reserve(block.edges.size());
  m_Edges.reserve(block.edges.size());
  for (int e = 0; e < static_cast<int>(block.edges.size()); ++e)
  {
    Add({ { block.edges[e][0], block.edges[e][1] }, { 2 * e, 2 * e + 1 } });
  }
  for (int v = 0; v < block.nodes; ++v)
  {
    m_Queue.push_back(v);
  }
  for (std::size_t i = 0; i < m_Queue.size(); ++i)
  {
    if (m_Degree[m_Queue[i]] == 2)
    {
      Suppress(m_Queue[i]);
    }
  }
  BuildKernel();
}

/** Drops an edge parallel to a kept one, and records the kept edge. */
void
BlockKernel::Add(const Edge & edge)
{
  const auto [place, isNew] =
    m_EdgeOfPair.try_emplace(KeyOf(edge.node[0], edge.node[1]), static_cast<int>(m_Edges.size()));
  if (!isNew)
  {
    const Edge & kept = m_Edges[place->second];
    const int    same = kept.node[0] == edge.node[0] ? 0 : 1;
    m_Steps.push_back(
      { true, { edge.halfEdge[0], edge.halfEdge[1] }, { kept.halfEdge[same], kept.halfEdge[1 - same] } });
    return;
  }
  for (const int node : edge.node)
  {
    m_Incident[node].push_back(static_cast<int>(m_Edges.size()));
    ++m_Degree[node];
  }
  m_Edges.push_back(edge);
  m_Alive.push_back(true);
}

void
BlockKernel::Suppress(int node)
{
  Edge joined{};
  int  own[2];
  int  found = 0;
  for (const int e : m_Incident[node])
  {
    if (m_Alive[e])
    {
      const Edge & edge = m_Edges[e];
      const int    at = edge.node[0] == node ? 0 : 1;
      own[found] = edge.halfEdge[at];
      joined.node[found] = edge.node[1 - at];
      joined.halfEdge[found] = edge.halfEdge[1 - at];
      ++found;
      m_Alive[e] = false;
      m_EdgeOfPair.erase(KeyOf(edge.node[0], edge.node[1]));
      --m_Degree[edge.node[1 - at]];
    }
  }
  m_Degree[node] = 0;
  m_Steps.push_back({ false, { own[0], own[1] }, { -1, -1 } });
  Add(joined);
  m_Queue.insert(m_Queue.end(), joined.node, joined.node + 2);
}

void
BlockKernel::BuildKernel()
{
  std::vector<int> index(m_Degree.size(), -1);
  for (std::size_t v = 0; v < m_Degree.size(); ++v)
  {
    if (m_Degree[v] > 0)
    {
      index[v] = m_Kernel.nodes++;
    }
  }
  for (std::size_t e = 0; e < m_Edges.size(); ++e)
  {
    if (m_Alive[e])
    {
      const Edge & edge = m_Edges[e];
      m_Kernel.edges.push_back({ index[edge.node[0]], index[edge.node[1]] });
      m_HalfEdgeOfKernel.insert(m_HalfEdgeOfKernel.end(), edge.halfEdge, edge.halfEdge + 2);
    }
  }
}

std::vector<int>
BlockKernel::Expand(const std::vector<int> & kernelNextAround) const
{
  std::vector<int> next(m_HalfEdges, -1);
  for (std::size_t h = 0; h < kernelNextAround.size(); ++h)
  {
    next[m_HalfEdgeOfKernel[h]] = m_HalfEdgeOfKernel[kernelNextAround[h]];
  }
  for (auto step = m_Steps.rbegin(); step != m_Steps.rend(); ++step)
  {
    if (step->isParallel)
    {
      // Adjacent to the kept edge: after it at one end, before it at the other.
      InsertAfter(next, step->lost[0], step->kept[0]);
      InsertAfter(next, step->lost[1], PreviousAround(next, step->kept[1]));
    }
    else
    {
      next[step->lost[0]] = step->lost[1];
      next[step->lost[1]] = step->lost[0];
    }
  }
  return next;
}
} // namespace shapeton
