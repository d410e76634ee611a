#include "shapetonLoopHomology.h"

#include "shapetonPhilox.h"
#include "shapetonSurfaceCut.h"

#include <algorithm>
#include <iterator>

namespace shapeton
{
namespace
{
/** Marks the edges of a breadth-first tree of the vertices. */
std::vector<char>
EdgesOfTree(const SurfaceConnectivity & connectivity)
{
  std::vector<char> isInTree(connectivity.NumberOfEdges(), 0);
  std::vector<char> isReached(connectivity.NumberOfVertices(), 0);
  std::vector<int>  reached{ connectivity.VerticesOfEdge(0)[0] };
  isReached[reached.front()] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const int vertex = reached[i];
    for (const int other : connectivity.NeighborsOfVertex(vertex))
    {
      if (!isReached[other])
      {
        isReached[other] = 1;
        isInTree[connectivity.FindEdge(vertex, other)] = 1;
        reached.push_back(other);
      }
    }
  }
  return isInTree;
}

/** The two dual nodes of each edge: its faces, or its face and the disc in its boundary. */
std::vector<std::array<int, 2>>
NodesOfEdges(const SurfaceConnectivity & connectivity)
{
  std::vector<int> loopOfVertex(connectivity.NumberOfVertices(), -1);
  const auto &     loops = connectivity.BoundaryLoops();
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
  {
    for (const int vertex : loops[loop])
    {
      loopOfVertex[vertex] = static_cast<int>(loop);
    }
  }
  std::vector<std::array<int, 2>> nodes;
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const IndexRange faces = connectivity.FacesOfEdge(edge);
    const int        disc = connectivity.NumberOfFaces() + loopOfVertex[connectivity.VerticesOfEdge(edge)[0]];
    nodes.push_back({ faces[0], faces.size() == 2 ? faces[1] : disc });
  }
  return nodes;
}

/** Edges of each dual node. */
std::vector<std::vector<int>>
EdgesOfNodes(const std::vector<std::array<int, 2>> & nodes, const std::vector<char> & isLeftOut, std::size_t number)
{
  std::vector<std::vector<int>> edges(number);
  for (std::size_t edge = 0; edge < nodes.size(); ++edge)
  {
    for (const int node : nodes[edge])
    {
      if (!isLeftOut[edge])
      {
        edges[node].push_back(static_cast<int>(edge));
      }
    }
  }
  return edges;
}
} // namespace

LoopHomology::LoopHomology(const SurfaceConnectivity & connectivity)
  : m_Connectivity(connectivity), m_NodesOfEdge(NodesOfEdges(connectivity)), m_Keys(connectivity.NumberOfEdges(), 0)
{
  const std::size_t number = connectivity.NumberOfFaces() + connectivity.BoundaryLoops().size();
  std::vector<char> isInTree = EdgesOfTree(connectivity);
  const auto        edgesOfNode = EdgesOfNodes(m_NodesOfEdge, isInTree, number);
  std::vector<int>  parentEdges(number, -1);
  std::vector<int>  depths(number, -1);
  std::vector<int>  reached{ 0 };
  depths[0] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const int edge : edgesOfNode[reached[i]])
    {
      const int other = this->NodeAcross(edge, reached[i]);
      if (depths[other] == -1)
      {
        depths[other] = depths[reached[i]] + 1;
        parentEdges[other] = edge;
        isInTree[edge] = 1;
        reached.push_back(other);
      }
    }
  }
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    if (!isInTree[edge])
    {
      m_Generators.push_back(edge);
    }
  }
  this->CrossLoops(parentEdges, depths);
}

int
LoopHomology::NodeAcross(int edge, int node) const
{
  const auto & nodes = m_NodesOfEdge[edge];
  return nodes[0] == node ? nodes[1] : nodes[0];
}

/** Each dual loop crosses its generator and the edges between the faces of the generator in the tree of faces. */
void
LoopHomology::CrossLoops(const std::vector<int> & parentEdges, const std::vector<int> & depths)
{
  for (std::size_t loop = 0; loop < m_Generators.size(); ++loop)
  {
    this->Cross(m_Generators[loop], static_cast<int>(loop));
    auto [a, b] = m_NodesOfEdge[m_Generators[loop]];
    while (a != b)
    {
      int & deeper = depths[a] >= depths[b] ? a : b;
      this->Cross(parentEdges[deeper], static_cast<int>(loop));
      deeper = this->NodeAcross(parentEdges[deeper], deeper);
    }
  }
  std::sort(m_Crossings.begin(), m_Crossings.end());
}

void
LoopHomology::Cross(int edge, int loop)
{
  m_Crossings.push_back({ edge, loop });
  const auto          words = Philox4x32(0, PhiloxWords<std::uint32_t>{ static_cast<std::uint32_t>(loop), 0, 0, 0 });
  const std::uint64_t high = words.a;
  m_Keys[edge] ^= (high << 32 | words.b) & ~std::uint64_t{ 1 };
}

/** An edge crosses the path if it leaves one of its vertices to the left: both faces have their corner there. */
void
LoopHomology::SetCut(const FaceMatrix & F, const std::vector<int> & path)
{
  std::vector<char> isLeft(3 * static_cast<std::size_t>(F.rows()), 0);
  for (const int corner : LeftCorners(F, m_Connectivity, path))
  {
    isLeft[corner] = 1;
  }
  for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
  {
    for (const int vertex : m_Connectivity.VerticesOfEdge(edge))
    {
      const IndexRange faces = m_Connectivity.FacesOfEdge(edge);
      const bool       leaves = std::all_of(faces.begin(), faces.end(), [&](int face) {
        const int k = F(face, 0) == vertex ? 0 : F(face, 1) == vertex ? 1 : 2;
        return isLeft[3 * static_cast<std::size_t>(face) + k] != 0;
      });
      m_Keys[edge] ^= leaves ? 1 : 0;
    }
  }
}

std::vector<int>
LoopHomology::ClassOf(const std::vector<int> & edges) const
{
  std::vector<int> loops;
  for (const int edge : edges)
  {
    for (auto crossing = std::lower_bound(m_Crossings.begin(), m_Crossings.end(), std::array<int, 2>{ edge, 0 });
         crossing != m_Crossings.end() && (*crossing)[0] == edge;
         ++crossing)
    {
      loops.push_back((*crossing)[1]);
    }
  }
  std::sort(loops.begin(), loops.end());
  std::vector<int> odd;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!odd.empty() && odd.back() == loops[i])
    {
      odd.pop_back();
    }
    else
    {
      odd.push_back(loops[i]);
    }
  }
  return odd;
}

bool
IndependentClasses::Add(std::vector<int> loops)
{
  for (const std::vector<int> & other : m_Reduced)
  {
    if (std::binary_search(loops.begin(), loops.end(), other.front()))
    {
      std::vector<int> sum;
      std::set_symmetric_difference(loops.begin(), loops.end(), other.begin(), other.end(), std::back_inserter(sum));
      loops = std::move(sum);
    }
  }
  if (loops.empty())
  {
    return false;
  }
  m_Reduced.push_back(std::move(loops));
  return true;
}
} // namespace shapeton
