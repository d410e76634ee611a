#include "shapetonGraphFamilies.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace shapeton
{
namespace
{
/** `nodes` as a double, which does not overflow. */
void
RequireCounts(std::initializer_list<int> counts, int least, double nodes)
{
  if (std::min(counts) < least || nodes > std::numeric_limits<int>::max())
  {
    throw ParameterError("a count of the graph is below " + std::to_string(least) +
                         ", or there are more than 2147483647 nodes");
  }
}
} // namespace

Graph
CompleteGraph(int nodes)
{
  RequireCounts({ nodes }, 0, nodes);
  Graph graph;
  graph.nodes = nodes;
  for (int i = 0; i < nodes; ++i)
  {
    for (int j = i + 1; j < nodes; ++j)
    {
      graph.edges.push_back({ i, j });
    }
  }
  return graph;
}

Graph
CompleteBipartiteGraph(int left, int right)
{
  RequireCounts({ left, right }, 0, static_cast<double>(left) + right);
  Graph graph;
  graph.nodes = left + right;
  for (int i = 0; i < left; ++i)
  {
    for (int j = 0; j < right; ++j)
    {
      graph.edges.push_back({ i, left + j });
    }
  }
  return graph;
}

Graph
HypercubeGraph(int dimension)
{
  RequireCounts({ dimension }, 0, std::ldexp(1.0, dimension));
  Graph graph;
  graph.nodes = 1 << dimension;
  for (int v = 0; v < graph.nodes; ++v)
  {
    for (int bit = 1; bit < graph.nodes; bit *= 2)
    {
      if ((v & bit) == 0)
      {
        graph.edges.push_back({ v, v | bit });
      }
    }
  }
  return graph;
}

Graph
PathGraph(int nodes)
{
  RequireCounts({ nodes }, 0, nodes);
  Graph graph;
  graph.nodes = nodes;
  for (int i = 0; i + 1 < nodes; ++i)
  {
    graph.edges.push_back({ i, i + 1 });
  }
  return graph;
}

Graph
CycleGraph(int nodes)
{
  RequireCounts({ nodes }, 1, nodes);
  Graph graph = PathGraph(nodes);
  graph.edges.push_back({ nodes - 1, 0 });
  return graph;
}

Graph
WheelGraph(int spokes)
{
  RequireCounts({ spokes }, 1, spokes + 1.0);
  Graph graph = CycleGraph(spokes);
  graph.nodes = spokes + 1;
  for (int i = 0; i < spokes; ++i)
  {
    graph.edges.push_back({ i, spokes });
  }
  return graph;
}

Graph
GeneralizedPetersenGraph(int n, int step)
{
  RequireCounts({ n }, 1, 2.0 * n);
  RequireCounts({ step, n - 1 - step }, 0, n);
  Graph graph;
  graph.nodes = 2 * n;
  for (int i = 0; i < n; ++i)
  {
    graph.edges.push_back({ i, (i + 1) % n });
    graph.edges.push_back({ i, n + i });
    graph.edges.push_back({ n + i, n + (i + step) % n });
  }
  return graph;
}

Graph
GridGraph(int columns, int rows)
{
  RequireCounts({ columns, rows }, 0, static_cast<double>(columns) * rows);
  Graph graph;
  graph.nodes = columns * rows;
  for (int r = 0; r < rows; ++r)
  {
    for (int c = 0; c < columns; ++c)
    {
      const int node = r * columns + c;
      if (c + 1 < columns)
      {
        graph.edges.push_back({ node, node + 1 });
      }
      if (r + 1 < rows)
      {
        graph.edges.push_back({ node, node + columns });
      }
    }
  }
  return graph;
}

namespace
{
/** A disk of a regular tiling that grows by rings of faces. */
class TilingDisk
{
public:
  TilingDisk(int sides, int degree)
    : m_Sides(sides), m_Degree(degree), m_Graph{ 1, {}, {} }, m_Boundary{ 0 }, m_Degrees{ 0 }
  {}

  void
  AddRing()
  {
    this->FindSpokes();
    const std::size_t number = m_Owners.size();
    std::size_t       first = 0; // does not share its end with the spoke before
    while (this->Rest((first + number - 1) % number) == 0)
    {
      ++first;
    }
    std::vector<int> boundary{ this->NewNode() };
    for (std::size_t k = 0; k < number; ++k)
    {
      const std::size_t spoke = (first + k) % number;
      const int         rest = this->Rest(spoke);
      this->Join(m_Boundary[m_Owners[spoke]], boundary.back());
      for (int i = 0; i < rest; ++i)
      {
        const bool isClosing = k + 1 == number && i + 1 == rest;
        const int  next = isClosing ? boundary.front() : this->NewNode();
        this->Join(boundary.back(), next);
        if (!isClosing)
        {
          boundary.push_back(next);
        }
      }
    }
    m_Boundary = boundary;
  }

  Graph
  Take()
  {
    return std::move(m_Graph);
  }

private:
  /** One entry per missing edge of a boundary node, counter-clockwise: the index of the node in the boundary. */
  void
  FindSpokes()
  {
    m_Owners.clear();
    for (std::size_t i = 0; i < m_Boundary.size(); ++i)
    {
      m_Owners.insert(m_Owners.end(), m_Degree - m_Degrees[m_Boundary[i]], static_cast<int>(i));
    }
  }

  /** Number of new edges that close the face after a spoke. */
  int
  Rest(std::size_t spoke) const
  {
    constexpr int spokes = 2;
    const auto    size = static_cast<int>(m_Boundary.size());
    const int     steps = m_Owners[(spoke + 1) % m_Owners.size()] - m_Owners[spoke];
    return m_Sides - spokes - (steps + size) % size;
  }

  int
  NewNode()
  {
    constexpr int most = 10000000; // 1 GB
    RequireParameter(m_Graph.nodes < most, "the tiling has more than 10000000 nodes; use fewer rings");
    m_Degrees.push_back(0);
    return m_Graph.nodes++;
  }

  void
  Join(int a, int b)
  {
    m_Graph.edges.push_back({ a, b });
    ++m_Degrees[a];
    ++m_Degrees[b];
  }

  int              m_Sides;
  int              m_Degree;
  Graph            m_Graph;
  std::vector<int> m_Boundary; ///< counter-clockwise
  std::vector<int> m_Degrees;
  std::vector<int> m_Owners;
};
} // namespace

Graph
RegularTilingGraph(int sides, int degree, int rings)
{
  RequireCounts({ sides, degree }, 3, 0.0);
  RequireCounts({ rings }, 1, 0.0);
  constexpr long long euclidean = 4; // (sides - 2) (degree - 2) of a tiling of the plane
  RequireParameter((sides - 2LL) * (degree - 2LL) >= euclidean,
                   std::to_string(degree) + " polygons of " + std::to_string(sides) +
                     " sides at a node tile a sphere, not a plane; use more sides or a higher degree");
  TilingDisk disk(sides, degree);
  for (int ring = 0; ring < rings; ++ring)
  {
    disk.AddRing();
  }
  return disk.Take();
}

CombinatorialMap
TorusGridMap(int columns, int rows, bool diagonals)
{
  RequireCounts({ columns, rows }, 1, static_cast<double>(columns) * rows);
  const int                       kinds = diagonals ? 3 : 2; // east, north, north-east
  const auto                      nodeOf = [&](int c, int r) { return (r % rows) * columns + c % columns; };
  std::vector<std::array<int, 2>> edges;
  for (int r = 0; r < rows; ++r)
  {
    for (int c = 0; c < columns; ++c)
    {
      edges.push_back({ nodeOf(c, r), nodeOf(c + 1, r) });
      edges.push_back({ nodeOf(c, r), nodeOf(c, r + 1) });
      if (diagonals)
      {
        edges.push_back({ nodeOf(c, r), nodeOf(c + 1, r + 1) });
      }
    }
  }
  std::vector<int> next(2 * edges.size());
  const auto       leaving = [&](int c, int r, int kind) { return 2 * (kinds * nodeOf(c, r) + kind); };
  for (int r = 0; r < rows; ++r)
  {
    for (int c = 0; c < columns; ++c)
    {
      const int        west = leaving(c + columns - 1, r, 0) + 1;
      const int        south = leaving(c, r + rows - 1, 1) + 1;
      std::vector<int> order{ leaving(c, r, 0), leaving(c, r, 1), west, south };
      if (diagonals)
      {
        const int southWest = leaving(c + columns - 1, r + rows - 1, 2) + 1;
        order = { leaving(c, r, 0), leaving(c, r, 2), leaving(c, r, 1), west, southWest, south };
      }
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        next[order[i]] = order[(i + 1) % order.size()];
      }
    }
  }
  return CombinatorialMap(columns * rows, edges, std::move(next));
}
} // namespace shapeton
