#include "shapetonGraph.h"

#include "shapetonExceptions.h"

#include <limits>

namespace shapeton
{
void
RequireSound(const Graph & graph, const std::string & what)
{
  const auto require = [&what](bool condition, const std::string & fault) {
    if (!condition)
    {
      throw InputError(what + ": " + fault);
    }
  };
  require(graph.nodes >= 1, "the graph has no nodes; use a graph with at least one");
  require(graph.edges.size() < std::numeric_limits<int>::max() / 8,
          "the graph has too many edges; use fewer than 2^28");
  require(graph.names.empty() || graph.names.size() == static_cast<std::size_t>(graph.nodes),
          "the graph has " + std::to_string(graph.nodes) + " nodes but " + std::to_string(graph.names.size()) +
            " names");
  RequireEnds(graph, what);
}

void
RequireEnds(const Graph & graph, const std::string & what)
{
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    for (const int node : graph.edges[e])
    {
      if (node < 0 || node >= graph.nodes)
      {
        throw InputError(what + ": edge " + std::to_string(e) + " names node " + std::to_string(node) +
                         ", but there are " + std::to_string(graph.nodes));
      }
    }
  }
}

std::string
NameOfNode(const Graph & graph, int node)
{
  return graph.names.empty() ? std::to_string(node) : graph.names.at(node);
}

Graph
RelabeledGraph(const Graph & graph, const std::vector<int> & image)
{
  Graph result{ graph.nodes, graph.edges, graph.names };
  for (auto & edge : result.edges)
  {
    edge = { image.at(edge[0]), image.at(edge[1]) };
  }
  for (std::size_t v = 0; v < graph.names.size(); ++v)
  {
    result.names.at(image.at(v)) = graph.names[v];
  }
  return result;
}
} // namespace shapeton
