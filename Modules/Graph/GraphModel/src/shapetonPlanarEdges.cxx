#include "shapetonGraphGenus.h"

namespace shapeton
{
namespace
{
/** Adds those edges from `first` to `last` - 1 that form a planar graph with the kept edges. Planarity is inherited by
 * subgraphs, so a range that is planar as a whole can be kept as a whole. */
void
KeepPlanar(const Graph & graph, int first, int last, std::vector<int> & kept)
{
  const std::size_t before = kept.size();
  for (int edge = first; edge < last; ++edge)
  {
    kept.push_back(edge);
  }
  CombinatorialMap map;
  if (first == last || FindPlanarEmbedding(GraphWithEdges(graph, kept), map))
  {
    return;
  }
  kept.resize(before);
  if (last - first > 1)
  {
    const int middle = first + (last - first) / 2;
    KeepPlanar(graph, first, middle, kept);
    KeepPlanar(graph, middle, last, kept);
  }
}
} // namespace

Graph
GraphWithEdges(const Graph & graph, const std::vector<int> & edges)
{
  Graph part{ graph.nodes, {}, graph.names };
  part.edges.reserve(edges.size());
  for (const int edge : edges)
  {
    part.edges.push_back(graph.edges[edge]);
  }
  return part;
}

std::vector<int>
PlanarEdges(const Graph & graph)
{
  std::vector<int> kept;
  KeepPlanar(graph, 0, static_cast<int>(graph.edges.size()), kept);
  return kept;
}
} // namespace shapeton
