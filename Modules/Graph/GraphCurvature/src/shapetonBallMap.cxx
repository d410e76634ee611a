#include "shapetonBallMap.h"

#include "shapetonExceptions.h"
#include "shapetonGraphGenus.h"

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
/** Distances of all nodes from the nearest of these nodes, in edges. */
std::vector<int>
DistancesFrom(const CombinatorialMap & map, std::vector<int> queue)
{
  std::vector<int> distances(map.Nodes(), -1);
  for (const int node : queue)
  {
    distances[node] = 0;
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const int h : map.Around(queue[i]))
    {
      const int other = map.Node(CombinatorialMap::Twin(h));
      if (distances[other] < 0)
      {
        distances[other] = distances[queue[i]] + 1;
        queue.push_back(other);
      }
    }
  }
  return distances;
}

std::vector<int>
NodesOfFace(const CombinatorialMap & map, int face)
{
  std::vector<int> nodes;
  for (const int h : map.Boundary(face))
  {
    nodes.push_back(map.Node(h));
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

int
DistanceOfFace(const CombinatorialMap & map, const std::vector<int> & distances, int face)
{
  int least = distances[map.Node(map.FirstOfFace(face))];
  for (const int h : map.Boundary(face))
  {
    least = std::min(least, distances[map.Node(h)]);
  }
  return least;
}

/** Restricts a planar map to a disk of its faces. */
class DiskCutter
{
public:
  DiskCutter(const RootedMap & rooted, std::vector<char> isInside)
    : m_Rooted(rooted), m_Map(rooted.Map()), m_IsInside(std::move(isInside))
  {}

  BallMap
  Cut()
  {
    this->NumberNodesAndEdges();
    BallMap ball{ {}, m_NewNode[m_Rooted.Root()], m_Nodes, m_Map.Nodes(), static_cast<int>(m_Edges.size()) };
    m_Next.assign(2 * m_Edges.size(), -1);
    for (int h = 0; h < m_Map.HalfEdges(); ++h)
    {
      if (m_NewEdge[h / 2] >= 0)
      {
        m_Next[this->New(h)] = this->New(this->NextInDisk(h));
        const int distance = m_Rooted.Distances()[m_Map.Node(h)];
        ball.radius = m_IsInside[m_Map.Face(h)] != 0 ? ball.radius : std::min(ball.radius, distance);
      }
    }
    this->JoinApex(ball.apex);
    ball.map = CombinatorialMap(m_Nodes + 1, m_Edges, std::move(m_Next));
    return ball;
  }

private:
  bool
  IsInDisk(int edge) const
  {
    return m_IsInside[m_Map.Face(2 * edge)] != 0 || m_IsInside[m_Map.Face(2 * edge + 1)] != 0;
  }

  int
  New(int halfEdge) const
  {
    return 2 * m_NewEdge[halfEdge / 2] + halfEdge % 2;
  }

  void
  NumberNodesAndEdges()
  {
    m_NewEdge.assign(m_Map.Edges(), -1);
    m_NewNode.assign(m_Map.Nodes(), -1);
    for (int edge = 0; edge < m_Map.Edges(); ++edge)
    {
      if (this->IsInDisk(edge))
      {
        m_NewNode[m_Map.Node(2 * edge)] = m_NewNode[m_Map.Node(2 * edge + 1)] = 0;
      }
    }
    for (int & node : m_NewNode)
    {
      node = node < 0 ? -1 : m_Nodes++;
    }
    for (int edge = 0; edge < m_Map.Edges(); ++edge)
    {
      if (this->IsInDisk(edge))
      {
        m_NewEdge[edge] = static_cast<int>(m_Edges.size());
        m_Edges.push_back({ m_NewNode[m_Map.Node(2 * edge)], m_NewNode[m_Map.Node(2 * edge + 1)] });
      }
    }
  }

  /** The next half-edge of the disk, counter-clockwise. */
  int
  NextInDisk(int halfEdge) const
  {
    int next = m_Map.NextAround(halfEdge);
    while (m_NewEdge[next / 2] < 0)
    {
      next = m_Map.NextAround(next);
    }
    return next;
  }

  /** Adds an edge from each outer corner to the apex: after the half-edge with the outside to its left. Along the
   * boundary with the outside to the left, the corners are counter-clockwise around the apex. */
  void
  JoinApex(int apex)
  {
    int first = 0;
    while (m_NewEdge[first / 2] < 0 || m_IsInside[m_Map.Face(first)] != 0)
    {
      ++first;
    }
    std::vector<int> previous(m_Next.size());
    for (std::size_t h = 0; h < previous.size(); ++h)
    {
      previous[m_Next[h]] = static_cast<int>(h);
    }
    const int        start = this->New(first);
    std::vector<int> corners;
    int              corner = start;
    do
    {
      corners.push_back(corner);
      corner = previous[CombinatorialMap::Twin(corner)];
    } while (corner != start);
    const int firstSpoke = static_cast<int>(m_Edges.size());
    const int spokes = static_cast<int>(corners.size());
    for (int i = 0; i < spokes; ++i)
    {
      const int outgoing = 2 * (firstSpoke + i);
      m_Edges.push_back({ m_Edges[corners[i] / 2][corners[i] % 2], apex });
      m_Next.push_back(m_Next[corners[i]]);
      m_Next.push_back(2 * (firstSpoke + (i + 1) % spokes) + 1);
      m_Next[corners[i]] = outgoing;
    }
  }

  const RootedMap &               m_Rooted;
  const CombinatorialMap &        m_Map;
  std::vector<char>               m_IsInside; ///< for each face
  std::vector<int>                m_NewNode;
  std::vector<int>                m_NewEdge;
  int                             m_Nodes{ 0 };
  std::vector<std::array<int, 2>> m_Edges;
  std::vector<int>                m_Next;
};

/** Marks the faces around the root, and those connected to them across edges without entering the outer face. */
std::vector<char>
FacesAroundRoot(const RootedMap & rooted)
{
  const CombinatorialMap & map = rooted.Map();
  std::vector<char>        isFound(map.Faces(), 0);
  std::vector<int>         queue;
  const auto               find = [&](int face) {
    if (isFound[face] == 0 && face != rooted.OuterFace())
    {
      isFound[face] = 1;
      queue.push_back(face);
    }
  };
  for (const int h : map.Around(rooted.Root()))
  {
    find(map.Face(h));
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const int h : map.Boundary(queue[i]))
    {
      find(map.Face(CombinatorialMap::Twin(h)));
    }
  }
  return isFound;
}

/** Marks all faces except those connected to the outer face across edges, without entering marked faces. */
void
FillHoles(const CombinatorialMap & map, int outerFace, std::vector<char> & isInside)
{
  std::vector<char> isOutside(map.Faces(), 0);
  std::vector<int>  queue{ outerFace };
  isOutside[outerFace] = 1;
  while (!queue.empty())
  {
    const int face = queue.back();
    queue.pop_back();
    for (const int h : map.Boundary(face))
    {
      const int other = map.Face(CombinatorialMap::Twin(h));
      if (isInside[other] == 0 && isOutside[other] == 0)
      {
        isOutside[other] = 1;
        queue.push_back(other);
      }
    }
  }
  for (int face = 0; face < map.Faces(); ++face)
  {
    isInside[face] = isOutside[face] == 0 ? 1 : 0;
  }
}
} // namespace

RootedMap::RootedMap(const Graph & graph, int root) : m_Root(root)
{
  if (!FindPlanarEmbedding(graph, m_Map))
  {
    throw InputError("the graph is not planar; use its planar part");
  }
  if (m_Map.Components() != 1 || m_Map.Faces() < 2)
  {
    throw InputError(m_Map.Components() != 1 ? "the graph is not connected; extract a component"
                                             : "the graph has no cycle, so it has no faces to pack");
  }
  const std::vector<int> lengths = m_Map.FaceLengths();
  if (m_Root >= 0)
  {
    m_Distances = DistancesFrom(m_Map, { m_Root });
  }
  std::array<int, 2> best{ 0, 0 };
  for (int face = 0; face < m_Map.Faces(); ++face)
  {
    const std::array<int, 2> rank{ lengths[face], m_Root < 0 ? 0 : DistanceOfFace(m_Map, m_Distances, face) };
    m_OuterFace = rank > best ? face : m_OuterFace;
    best = std::max(best, rank);
  }
  if (m_Root < 0)
  {
    const std::vector<int> depths = DistancesFrom(m_Map, NodesOfFace(m_Map, m_OuterFace));
    m_Root = static_cast<int>(std::max_element(depths.begin(), depths.end()) - depths.begin());
    m_Distances = DistancesFrom(m_Map, { m_Root });
  }
  if (this->DistanceOfOuterFace() < 1)
  {
    throw InputError("the longest face contains the root, so there is no ball around it; choose a root inside");
  }
}

int
RootedMap::DistanceOfOuterFace() const
{
  return DistanceOfFace(m_Map, m_Distances, m_OuterFace);
}

BallMap
BallAround(const RootedMap & rooted, int radius)
{
  const CombinatorialMap & map = rooted.Map();
  std::vector<char>        isInside(map.Faces(), 0);
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    if (rooted.Distances()[map.Node(h)] < radius)
    {
      isInside[map.Face(h)] = 1;
    }
  }
  FillHoles(map, rooted.OuterFace(), isInside);
  return DiskCutter(rooted, std::move(isInside)).Cut();
}

BallMap
WholeDisk(const RootedMap & rooted)
{
  std::vector<char> isInside = FacesAroundRoot(rooted);
  FillHoles(rooted.Map(), rooted.OuterFace(), isInside);
  return DiskCutter(rooted, std::move(isInside)).Cut();
}
} // namespace shapeton
