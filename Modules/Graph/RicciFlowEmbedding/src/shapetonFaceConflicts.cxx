#include "shapetonNodesMetTwice.h"
#include "shapetonPackedMap.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
/** Nodes of faces that are not triangles. */
std::vector<char>
NodesOfLongFaces(const CombinatorialMap & map)
{
  const std::vector<int> lengths = map.FaceLengths();
  std::vector<char>      isOne(map.Nodes(), 0);
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (lengths[map.Face(h)] != 3)
    {
      isOne[map.Node(h)] = 1;
    }
  }
  return isOne;
}

/** Graph of nodes and faces, with a single edge even if a face meets a node twice: node v is v, face f is Nodes() + f.
 * Contains only nodes that two faces in conflict may share. One of these faces is not a triangle, because two triangles
 * that share two nodes share the edge between them if there are no parallel edges. */
struct RadialGraph
{
  explicit RadialGraph(const CombinatorialMap & map) : neighbors(map.Nodes() + map.Faces())
  {
    const std::vector<char> isChosen = NodesOfLongFaces(map);
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      if (isChosen[map.Node(h)])
      {
        neighbors[map.Node(h)].push_back(map.Nodes() + map.Face(h));
        neighbors[map.Nodes() + map.Face(h)].push_back(map.Node(h));
      }
    }
    for (std::vector<int> & list : neighbors)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }
  std::vector<std::vector<int>> neighbors;
};

std::string
NameOf(const std::vector<std::string> & names, int node)
{
  return names.empty() ? std::to_string(node) : names[node].substr(0, LongestName);
}

/** Whether the two nodes are the ends of an edge between the two faces. */
bool
AreAcrossAnEdge(const CombinatorialMap & map, int node, int other, int face, int otherFace)
{
  const int first = map.FirstAround(node);
  int       h = first;
  do
  {
    if (map.Node(h ^ 1) == other && ((map.Face(h) == face && map.Face(h ^ 1) == otherFace) ||
                                     (map.Face(h) == otherFace && map.Face(h ^ 1) == face)))
    {
      return true;
    }
    h = map.NextAround(h);
  } while (h != first);
  return false;
}

/** For each pair with at least two common neighbors, lists all of them, starting from the member of higher degree. */
class FourCycles
{
public:
  explicit FourCycles(RadialGraph graph)
    : m_Neighbors(std::move(graph.neighbors)), m_Common(m_Neighbors.size()), m_Rank(m_Neighbors.size(), lastRank)
  {
    std::vector<int> order;
    for (std::size_t i = 0; i < m_Neighbors.size(); ++i)
    {
      if (m_Neighbors[i].size() > 1) // the others are not on any cycle
      {
        order.push_back(static_cast<int>(i));
      }
    }
    std::stable_sort(
      order.begin(), order.end(), [this](int a, int b) { return m_Neighbors[a].size() > m_Neighbors[b].size(); });
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      m_Rank[order[i]] = static_cast<int>(i);
    }
    // Neighbors of higher degree were processed earlier; they are at the end of the list and are cut off.
    for (std::vector<int> & list : m_Neighbors)
    {
      std::sort(list.begin(), list.end(), [this](int a, int b) { return m_Rank[a] > m_Rank[b]; });
    }
    m_Order = std::move(order);
  }

  template <typename TVisit>
  void
  ForEachPair(const TVisit & visit)
  {
    for (const int start : m_Order)
    {
      std::vector<int> met;
      for (const int middle : m_Neighbors[start])
      {
        if (m_Rank[middle] <= m_Rank[start])
        {
          break; // already processed, with its cycles
        }
        this->Gather(start, middle, met);
      }
      for (const int end : met)
      {
        if (m_Common[end].size() > 1)
        {
          visit(start, end, m_Common[end]);
        }
        m_Common[end].clear();
      }
    }
  }

private:
  void
  Gather(int start, int middle, std::vector<int> & met)
  {
    for (const int end : m_Neighbors[middle])
    {
      if (m_Rank[end] <= m_Rank[start])
      {
        break;
      }
      if (m_Common[end].empty())
      {
        met.push_back(end);
      }
      m_Common[end].push_back(middle);
    }
  }

  static constexpr int          lastRank = std::numeric_limits<int>::max();
  std::vector<std::vector<int>> m_Neighbors;
  std::vector<std::vector<int>> m_Common;
  std::vector<int>              m_Rank;
  std::vector<int>              m_Order;
};
} // namespace

FaceConflicts::FaceConflicts(const CombinatorialMap & map, const std::vector<std::string> & names)
  : meetsANodeTwice(map.Faces(), 0), sharesTwoNodes(map.Faces(), 0)
{
  ForEachNodeMetTwice(map, [&](int face, int node) {
    meetsANodeTwice[face] = 1;
    reason = reason.empty() ? "a face meets node " + NameOf(names, node) + " twice" : reason;
  });
  const int firstFace = map.Nodes();
  FourCycles(RadialGraph(map)).ForEachPair([&](int start, int end, const std::vector<int> & common) {
    const bool               startsAtNode = start < firstFace;
    const std::array<int, 2> first{ start, end };
    const auto &             nodes = startsAtNode ? first : std::array<int, 2>{ common[0], common[1] };
    const auto &             faces = startsAtNode ? std::array<int, 2>{ common[0], common[1] } : first;
    if (common.size() == 2 && AreAcrossAnEdge(map, nodes[0], nodes[1], faces[0] - firstFace, faces[1] - firstFace))
    {
      return;
    }
    for (const int member : startsAtNode ? common : std::vector<int>{ start, end })
    {
      sharesTwoNodes[member - firstFace] = 1;
    }
    if (reason.empty())
    {
      reason = "two faces share the nodes " + NameOf(names, std::min(nodes[0], nodes[1])) + " and " +
               NameOf(names, std::max(nodes[0], nodes[1])) + ", which are not the ends of one edge between them";
    }
  });
}
} // namespace shapeton
