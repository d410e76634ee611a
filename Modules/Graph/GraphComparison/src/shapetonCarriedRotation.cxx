#include "shapetonCarriedRotation.h"

#include "shapetonBlockArrangement.h"
#include "shapetonDisjointSets.h"
#include "shapetonHeldEmbedding.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace shapeton
{
std::vector<int>
NodesOfSameName(const Graph & a, const Graph & b)
{
  std::unordered_map<std::string, int> nodeOfName;
  for (int v = 0; v < b.nodes; ++v)
  {
    nodeOfName.emplace(NameOfNode(b, v), v);
  }
  std::vector<int> image(a.nodes, -1);
  for (int v = 0; v < a.nodes; ++v)
  {
    const auto found = nodeOfName.find(NameOfNode(a, v));
    image[v] = found == nodeOfName.end() ? -1 : found->second;
  }
  return image;
}

std::vector<int>
EdgesOfSameEnds(const Graph & a, const Graph & b, const std::vector<int> & image)
{
  std::map<std::pair<int, int>, std::vector<int>> edgesOfEnds; // last one first
  for (int e = static_cast<int>(b.edges.size()); e-- > 0;)
  {
    edgesOfEnds[std::minmax(b.edges[e][0], b.edges[e][1])].push_back(e);
  }
  std::vector<int> result(a.edges.size(), -1);
  for (std::size_t e = 0; e < a.edges.size(); ++e)
  {
    const int end0 = image[a.edges[e][0]];
    const int end1 = image[a.edges[e][1]];
    if (const auto found = edgesOfEnds.find(std::minmax(end0, end1));
        found != edgesOfEnds.end() && !found->second.empty())
    {
      result[e] = found->second.back();
      found->second.pop_back();
    }
  }
  return result;
}

namespace
{
/** Inserts edges into the map of the kept edges. */
class EdgeInsertion
{
public:
  EdgeInsertion(const Graph & before, const CombinatorialMap & map, const Graph & after);

  CombinatorialMap
  Run();

private:
  IncrementalMap
  KeptMap(const Graph & before, const CombinatorialMap & map);

  template <typename TBody>
  void
  ForCorners(int node, const TBody & body) const
  {
    const int first = m_Map.Any(node);
    for (int h = first; h >= 0; h = m_Map.NextAround(h) == first ? -1 : m_Map.NextAround(h))
    {
      body(h);
    }
  }
  int
  CornerOfLongestFace(int node) const;

  void
  Insert(int edge, int a, int b)
  {
    m_Map.Insert(m_IndexOfEdge[edge], a, b);
    m_Components.Join(m_After.edges[edge][0], m_After.edges[edge][1]);
    m_Pending.erase(edge);
  }

  bool
  InsertIfFree(int edge);
  bool
  InsertNodes();
  bool
  InsertNode(int node);
  bool
  InsertEdges();
  bool
  InsertAll();
  void
  InsertAnywhere(int edge)
  {
    Insert(edge, m_Map.Any(m_After.edges[edge][0]), m_Map.Any(m_After.edges[edge][1]));
  }

  std::vector<int>
  NextAround() const;

  const Graph &                 m_After;
  std::vector<int>              m_IndexOfEdge; // in m_Map, for each edge of m_After; -1 for new loops
  IncrementalMap                m_Map;
  DisjointSets<>                m_Components;
  std::vector<std::vector<int>> m_NewEdgesOf;
  std::set<int>                 m_Pending;
  bool                          m_MayBePlanar;
};

EdgeInsertion::EdgeInsertion(const Graph & before, const CombinatorialMap & map, const Graph & after)
  : m_After(after)
  , m_IndexOfEdge(after.edges.size(), -1)
  , m_Map(KeptMap(before, map))
  , m_Components(after.nodes)
  , m_NewEdgesOf(after.nodes)
  , m_MayBePlanar(map.Genus() == 0)
{
  for (int e = 0; e < static_cast<int>(after.edges.size()); ++e)
  {
    const auto [node0, node1] = after.edges[e];
    if (m_IndexOfEdge[e] >= 0)
    {
      m_Components.Join(node0, node1);
    }
    else if (node0 != node1)
    {
      m_IndexOfEdge[e] = m_Map.AddEdge(node0, node1);
      m_Pending.insert(e);
      m_NewEdgesOf[node0].push_back(e);
      m_NewEdgesOf[node1].push_back(e);
    }
  }
}

CombinatorialMap
EdgeInsertion::Run()
{
  while (!m_Pending.empty())
  {
    if (!InsertNodes() && !InsertEdges() && !InsertAll())
    {
      InsertAnywhere(*m_Pending.begin());
    }
  }
  return CombinatorialMap(m_After.nodes, m_After.edges, NextAround());
}

/** The old map without deleted elements; its edges are numbered in the order of `after`. */
IncrementalMap
EdgeInsertion::KeptMap(const Graph & before, const CombinatorialMap & map)
{
  const std::vector<int>          image = NodesOfSameName(before, m_After);
  const std::vector<int>          edgeImage = EdgesOfSameEnds(before, m_After, image);
  std::vector<int>                kept(m_After.edges.size(), 0);
  std::vector<std::array<int, 2>> edges;
  for (const int e : edgeImage)
  {
    if (e >= 0)
    {
      kept[e] = 1;
    }
  }
  for (std::size_t e = 0; e < kept.size(); ++e)
  {
    if (kept[e] == 1)
    {
      m_IndexOfEdge[e] = static_cast<int>(edges.size());
      edges.push_back(m_After.edges[e]);
    }
  }
  const auto imageOf = [&](int h) {
    const int e = edgeImage[h / 2];
    // Matches half-edges that start at the same node; for a loop, half-edges with the same number.
    const bool turned = e >= 0 && edges[m_IndexOfEdge[e]][h % 2] != image[map.Node(h)];
    return e < 0 ? -1 : 2 * m_IndexOfEdge[e] + (turned ? 1 - h % 2 : h % 2);
  };
  std::vector<int> next(2 * edges.size());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (imageOf(h) >= 0)
    {
      int after = map.NextAround(h);
      while (imageOf(after) < 0)
      {
        after = map.NextAround(after);
      }
      next[imageOf(h)] = imageOf(after);
    }
  }
  return IncrementalMap(CombinatorialMap(m_After.nodes, edges, std::move(next)));
}

/** Corner of the node in its longest face, where an edge joins another part; -1 for a node without edges. */
int
EdgeInsertion::CornerOfLongestFace(int node) const
{
  int longest = m_Map.Any(node);
  ForCorners(node, [&](int h) {
    const auto lengthAt = [this](int corner) { return m_Map.FaceLength(m_Map.Face(corner)); };
    longest = lengthAt(h) > lengthAt(longest) ? h : longest;
  });
  return longest;
}

/** Inserts an edge into a face that contains both ends, or between two components, without adding a handle. */
bool
EdgeInsertion::InsertIfFree(int edge)
{
  const auto [node0, node1] = m_After.edges[edge];
  if (m_Components.Find(node0) != m_Components.Find(node1))
  {
    Insert(edge, CornerOfLongestFace(node0), CornerOfLongestFace(node1));
    return true;
  }
  std::map<int, int> cornerOfFace;
  ForCorners(node1, [&](int h) { cornerOfFace.emplace(m_Map.Face(h), h); });
  int a = -1;
  int b = -1;
  ForCorners(node0, [&](int h) {
    const auto found = cornerOfFace.find(m_Map.Face(h));
    if (b < 0 && found != cornerOfFace.end())
    {
      a = h;
      b = found->second;
    }
  });
  if (b < 0)
  {
    return false;
  }
  Insert(edge, a, b);
  return true;
}

/** Inserts each unplaced node into the face with most of its neighbors. */
bool
EdgeInsertion::InsertNodes()
{
  bool progress = false;
  for (const int edge : std::vector<int>(m_Pending.begin(), m_Pending.end()))
  {
    for (const int node : m_After.edges[edge])
    {
      progress = (m_Pending.count(edge) > 0 && m_Map.Any(node) < 0 && InsertNode(node)) || progress;
    }
  }
  return progress;
}

bool
EdgeInsertion::InsertNode(int node)
{
  std::map<int, std::map<int, int>> cornersOfFace; // for each face, one corner of each neighbor
  const auto                        neighborBy = [&](int e) {
    return m_After.edges[e][0] == node ? m_After.edges[e][1] : m_After.edges[e][0];
  };
  for (const int e : m_NewEdgesOf[node])
  {
    ForCorners(neighborBy(e), [&](int h) { cornersOfFace[m_Map.Face(h)].emplace(neighborBy(e), h); });
  }
  if (cornersOfFace.empty())
  {
    return false;
  }
  const auto best = std::max_element(cornersOfFace.begin(), cornersOfFace.end(), [](const auto & a, const auto & b) {
    return a.second.size() < b.second.size();
  });
  for (const int e : m_NewEdgesOf[node])
  {
    if (const auto corner = best->second.find(neighborBy(e)); corner != best->second.end())
    {
      const bool isFirst = m_After.edges[e][0] == node;
      Insert(e, isFirst ? -1 : corner->second, isFirst ? corner->second : -1);
      return true;
    }
  }
  return false;
}

bool
EdgeInsertion::InsertEdges()
{
  bool progress = false;
  for (const int edge : std::vector<int>(m_Pending.begin(), m_Pending.end()))
  {
    progress = InsertIfFree(edge) || progress;
  }
  return progress;
}

/** Inserts the remaining edges where no handle is needed; parts may flip. */
bool
EdgeInsertion::InsertAll()
{
  CombinatorialMap all;
  if (!m_MayBePlanar || !EmbedHeld(m_Map, all))
  {
    m_MayBePlanar = false;
    return false;
  }
  m_Map = IncrementalMap(all);
  m_Pending.clear();
  return true;
}

/** Result in the numbering of `after`, with each new loop in a separate corner. */
std::vector<int>
EdgeInsertion::NextAround() const
{
  std::vector<int> edgeOfIndex(m_Map.Edges());
  std::vector<int> next(2 * m_After.edges.size());
  std::vector<int> any(m_After.nodes, -1);
  for (std::size_t e = 0; e < m_IndexOfEdge.size(); ++e)
  {
    if (m_IndexOfEdge[e] >= 0)
    {
      edgeOfIndex[m_IndexOfEdge[e]] = static_cast<int>(e);
    }
  }
  for (std::size_t h = 0; h < next.size(); ++h)
  {
    if (const int index = m_IndexOfEdge[h / 2]; index >= 0)
    {
      const int after = m_Map.NextAround(2 * index + static_cast<int>(h % 2));
      next[h] = 2 * edgeOfIndex[after / 2] + after % 2;
      any[m_After.edges[h / 2][h % 2]] = static_cast<int>(h);
    }
  }
  for (std::size_t e = 0; e < m_IndexOfEdge.size(); ++e)
  {
    if (m_IndexOfEdge[e] < 0)
    {
      const int loop = 2 * static_cast<int>(e);
      int &     corner = any[m_After.edges[e][0]];
      next[loop] = loop + 1;
      next[loop + 1] = corner < 0 ? loop : next[corner];
      if (corner >= 0)
      {
        next[corner] = loop;
      }
      corner = loop + 1;
    }
  }
  return next;
}
} // namespace

CarriedRotation
CarryRotation(const Graph & before, const CombinatorialMap & map, const Graph & after, const GenusSettings & options)
{
  RequireSound(after, "changed graph");
  CarriedRotation  result{ EdgeInsertion(before, map, after).Run(), false };
  const int        genus = result.map.Genus();
  CombinatorialMap fresh;
  if (genus > map.Genus())
  {
    fresh = FindEmbedding(after, options).map;
  }
  else if (genus == 0 || !FindPlanarEmbedding(after, fresh))
  {
    return result;
  }
  if (fresh.Genus() < genus)
  {
    result = { TurnedTo(IncrementalMap(result.map), ArrangeBlocks(fresh)), true };
  }
  return result;
}
} // namespace shapeton
