#include "shapetonCutGraph.h"

#include "shapetonDisjointSets.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace shapeton
{
namespace
{
std::vector<std::vector<std::array<int, 2>>>
NeighborsOf(const SurfaceConnectivity & connectivity)
{
  std::vector<std::vector<std::array<int, 2>>> neighbors(connectivity.NumberOfVertices()); // vertex, edge
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(e);
    neighbors[a].push_back({ b, e });
    neighbors[b].push_back({ a, e });
  }
  return neighbors;
}

/** Tree of shortest paths; boundary edges cost nothing, so that each boundary is reached once. */
struct PathTree
{
  std::vector<double> distances;
  std::vector<int>    edgeToParent; ///< -1 at the root
};

PathTree
MakePathTree(const std::vector<std::vector<std::array<int, 2>>> & neighbors,
             const SurfaceConnectivity &                          connectivity,
             const Eigen::VectorXd &                              lengths,
             int                                                  root)
{
  PathTree tree{ std::vector<double>(neighbors.size(), std::numeric_limits<double>::infinity()),
                 std::vector<int>(neighbors.size(), -1) };
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  tree.distances[root] = 0.0;
  queue.emplace(0.0, root);
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > tree.distances[vertex])
    {
      continue;
    }
    for (const auto & [other, edge] : neighbors[vertex])
    {
      const double next = distance + (connectivity.IsBoundaryEdge(edge) ? 0.0 : lengths[edge]);
      if (next < tree.distances[other])
      {
        tree.distances[other] = next;
        tree.edgeToParent[other] = edge;
        queue.emplace(next, other);
      }
    }
  }
  return tree;
}

/** Interior edges that are neither in the tree of paths nor crossed by a tree of faces. */
std::vector<int>
GeneratorsOf(const PathTree & tree, const SurfaceConnectivity & connectivity, const Eigen::VectorXd & lengths)
{
  std::vector<char> isInTree(connectivity.NumberOfEdges(), 0);
  for (const int e : tree.edgeToParent)
  {
    if (e != -1)
    {
      isInTree[e] = 1;
    }
  }
  std::vector<std::pair<double, int>> loops;
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    if (!isInTree[e] && !connectivity.IsBoundaryEdge(e))
    {
      const auto & [a, b] = connectivity.VerticesOfEdge(e);
      loops.emplace_back(-(tree.distances[a] + tree.distances[b] + lengths[e]), e);
    }
  }
  std::sort(loops.begin(), loops.end());
  DisjointSets<int> faces(connectivity.NumberOfFaces());
  std::vector<int>  generators;
  for (const auto & [length, e] : loops)
  {
    const IndexRange pair = connectivity.FacesOfEdge(e);
    if (!faces.Join(pair[0], pair[1]))
    {
      generators.push_back(e);
    }
  }
  std::sort(generators.begin(), generators.end());
  return generators;
}

/** Removes cut edges that end at an interior vertex that is not `kept`. */
void
Prune(const std::vector<std::vector<std::array<int, 2>>> & neighbors,
      const SurfaceConnectivity &                          connectivity,
      const std::vector<char> &                            isKept,
      std::vector<char> &                                  isCut)
{
  const auto       isWall = [&](int e) { return isCut[e] || connectivity.IsBoundaryEdge(e); };
  std::vector<int> waiting;
  for (int v = static_cast<int>(neighbors.size()) - 1; v >= 0; --v)
  {
    waiting.push_back(v);
  }
  while (!waiting.empty())
  {
    const int vertex = waiting.back();
    waiting.pop_back();
    int walls = 0, next = -1, last = -1;
    for (const auto & [other, edge] : neighbors[vertex])
    {
      if (isWall(edge))
      {
        ++walls;
        next = other;
        last = edge;
      }
    }
    if (walls == 1 && !isKept[vertex])
    {
      isCut[last] = 0;
      waiting.push_back(next);
    }
  }
}
} // namespace

CutGraph
FindCutGraph(const SurfaceConnectivity & connectivity,
             const Eigen::VectorXd &     lengths,
             const std::vector<int> &    vertices)
{
  const auto     neighbors = NeighborsOf(connectivity);
  const auto &   loops = connectivity.BoundaryLoops();
  const int      root = !loops.empty() ? loops.front().front() : vertices.empty() ? 0 : vertices.front();
  const PathTree tree = MakePathTree(neighbors, connectivity, lengths, root);
  CutGraph   result{ std::vector<char>(connectivity.NumberOfEdges(), 0), GeneratorsOf(tree, connectivity, lengths) };
  const auto cutToRoot = [&](int vertex) {
    while (tree.edgeToParent[vertex] != -1)
    {
      const int    edge = tree.edgeToParent[vertex];
      const auto & ends = connectivity.VerticesOfEdge(edge);
      result.isCut[edge] = connectivity.IsBoundaryEdge(edge) ? 0 : 1;
      vertex = ends[0] == vertex ? ends[1] : ends[0];
    }
  };
  for (const int e : result.generators)
  {
    result.isCut[e] = 1;
    cutToRoot(connectivity.VerticesOfEdge(e)[0]);
    cutToRoot(connectivity.VerticesOfEdge(e)[1]);
  }
  for (const auto & loop : loops)
  {
    cutToRoot(loop.front());
  }
  std::vector<char> isKept(connectivity.NumberOfVertices(), 0);
  for (const int v : vertices)
  {
    isKept[v] = 1;
    cutToRoot(v);
  }
  Prune(neighbors, connectivity, isKept, result.isCut);
  return result;
}
} // namespace shapeton
