#ifndef shapetonTestGraphs_h
#define shapetonTestGraphs_h

#include "shapetonGraphGenus.h"

#include <gtest/gtest.h>

#include <algorithm>

/** Graphs and maps made of others. */
namespace graphtest
{
/** A planar embedding; that of a 3-connected graph is unique up to its mirror image. */
inline shapeton::CombinatorialMap
PlanarMap(const shapeton::Graph & graph)
{
  shapeton::CombinatorialMap map;
  EXPECT_TRUE(shapeton::FindPlanarEmbedding(graph, map));
  return map;
}

/** The rotation system with ascending half-edges at each node; in general, its genus is high. */
inline shapeton::CombinatorialMap
AnyMap(const shapeton::Graph & graph)
{
  shapeton::Rotation rotation(graph.nodes);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    rotation[graph.edges[e][0]].push_back(static_cast<int>(2 * e));
    rotation[graph.edges[e][1]].push_back(static_cast<int>(2 * e + 1));
  }
  return { graph, rotation };
}

/** The map with only the edges for which `isKept` is true, in their order. */
template <typename TCondition>
shapeton::CombinatorialMap
MapOfEdges(const shapeton::CombinatorialMap & map, const TCondition & isKept)
{
  std::vector<int> number(map.Edges(), -1);
  shapeton::Graph  graph{ map.Nodes(), {}, {} };
  for (int e = 0; e < map.Edges(); ++e)
  {
    if (isKept(e))
    {
      number[e] = static_cast<int>(graph.edges.size());
      graph.edges.push_back({ map.Node(2 * e), map.Node(2 * e + 1) });
    }
  }
  shapeton::Rotation rotation = map.GetRotation();
  for (std::vector<int> & around : rotation)
  {
    around.erase(std::remove_if(around.begin(), around.end(), [&](int h) { return number[h / 2] < 0; }), around.end());
    std::for_each(around.begin(), around.end(), [&](int & h) { h = 2 * number[h / 2] + h % 2; });
  }
  return { graph, rotation };
}

/** A triangulation of the sphere: each node after the first three is joined to the corners of a triangle. `choose`
 * takes the number of triangles and gives the index of one. */
template <typename TChoice>
shapeton::Graph
StackedTriangles(int nodes, TChoice && choose)
{
  shapeton::Graph                 graph{ 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {} };
  std::vector<std::array<int, 3>> triangles{ { 0, 1, 2 }, { 0, 2, 1 } };
  for (; graph.nodes < nodes; ++graph.nodes)
  {
    std::array<int, 3> & triangle = triangles[choose(static_cast<int>(triangles.size()))];
    const auto [a, b, c] = triangle;
    const int node = graph.nodes;
    graph.edges.insert(graph.edges.end(), { { a, node }, { b, node }, { c, node } });
    triangle = { a, b, node };
    triangles.insert(triangles.end(), { { b, c, node }, { c, a, node } });
  }
  return graph;
}

/** The graph with its nodes in another order. */
inline shapeton::Graph
Shuffled(const shapeton::Graph & graph)
{
  std::vector<int> image(graph.nodes);
  for (int v = 0; v < graph.nodes; ++v)
  {
    image[v] = static_cast<int>((7919LL * v + 11) % graph.nodes); // 7919 is a prime
  }
  return shapeton::RelabeledGraph(graph, image);
}

/** The graph with the names n0, n1, ... */
inline shapeton::Graph
WithNames(shapeton::Graph graph)
{
  for (int v = 0; v < graph.nodes; ++v)
  {
    graph.names.push_back("n" + std::to_string(v));
  }
  return graph;
}
} // namespace graphtest

#endif
