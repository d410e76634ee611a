#include "shapetonGraphGenus.h"

#include "shapetonGraphStructure.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max() / 8; // a count whose sums do not overflow

/** Counts cycles by walks from their lowest node. */
class CycleCount
{
public:
  CycleCount(const Graph & graph, int length)
    : m_Incidence(graph), m_Neighbors(m_Incidence.halfEdges), m_OnWalk(graph.nodes, false), m_Length(length)
  {
    for (int & neighbor : m_Neighbors) // still the half-edge to this node
    {
      neighbor = graph.edges[neighbor / 2][1 - neighbor % 2];
    }
  }

  /** Counts with at most this number of walks; returns `unlimited` if that is not sufficient. */
  std::int64_t
  Count(std::int64_t walks)
  {
    m_WalksLeft = walks;
    for (m_Start = 0; m_Start < static_cast<int>(m_OnWalk.size()); ++m_Start)
    {
      Extend(m_Start, 1);
      if (m_WalksLeft < 0)
      {
        return unlimited;
      }
    }
    return m_Closed / 2; // each cycle was traversed in both directions
  }

private:
  void
  Extend(int node, int nodes)
  {
    m_OnWalk[node] = true;
    for (int i = m_Incidence.start[node]; i < m_Incidence.start[node + 1]; ++i)
    {
      const int next = m_Neighbors[i];
      if (nodes == m_Length)
      {
        m_Closed += next == m_Start ? 1 : 0;
      }
      else if (next > m_Start && !m_OnWalk[next] && --m_WalksLeft >= 0)
      {
        Extend(next, nodes + 1);
      }
    }
    m_OnWalk[node] = false;
  }

  Incidence         m_Incidence;
  std::vector<int>  m_Neighbors; ///< in the order of the half-edges
  std::vector<bool> m_OnWalk;
  int               m_Length;
  int               m_Start{ 0 };
  std::int64_t      m_Closed{ 0 };
  std::int64_t      m_WalksLeft{ 0 };
};

/** Maximum number of faces: assigns the half-edges to short cycles first, while any remain. */
std::int64_t
GreatestNumberOfFaces(const Graph & graph)
{
  constexpr std::int64_t mostWalks = 20000000;
  constexpr int          longestCounted = 5; // a longer face boundary need not be a cycle
  const int              girth = Girth(graph);
  std::int64_t           edgesLeft = 2 * static_cast<std::int64_t>(graph.edges.size());
  std::int64_t           faces = 0;
  int                    length = girth;
  for (; length <= longestCounted; ++length)
  {
    const std::int64_t most = edgesLeft / length;
    const std::int64_t taken = std::min(most, CycleCount(graph, length).Count(mostWalks));
    faces += taken;
    edgesLeft -= taken * length;
    if (taken == most)
    {
      return faces;
    }
  }
  return faces + edgesLeft / length;
}
} // namespace

int
GenusLowerBound(const Graph & graph)
{
  const std::int64_t handles =
    2 - graph.nodes + static_cast<std::int64_t>(graph.edges.size()) - GreatestNumberOfFaces(graph);
  return static_cast<int>(std::max<std::int64_t>(0, (handles + 1) / 2));
}
} // namespace shapeton
