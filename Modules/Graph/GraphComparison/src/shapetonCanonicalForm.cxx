#include "shapetonCanonicalForm.h"

#include <algorithm>
#include <map>
#include <numeric>

// In nauty 2.8 the headers declare thread-local variables in C11 syntax.
#define _Thread_local __thread
#include <nauty/traces.h>
#undef _Thread_local

namespace shapeton
{
namespace
{
/** A simple graph with colored nodes: the color of a node is its number of loops; a multiple edge gets a middle node,
 * colored by the multiplicity. */
struct ColoredGraph
{
  explicit ColoredGraph(const Graph & graph) : color(graph.nodes, 0)
  {
    std::map<std::array<int, 2>, int> multiplicity;
    for (const auto & edge : graph.edges)
    {
      if (edge[0] == edge[1])
      {
        ++color[edge[0]];
      }
      else
      {
        ++multiplicity[{ std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) }];
      }
    }
    for (const auto & [ends, count] : multiplicity)
    {
      if (count == 1)
      {
        edges.push_back(ends);
      }
      else
      {
        const int middle = static_cast<int>(color.size());
        color.push_back(-count);
        edges.push_back({ ends[0], middle });
        edges.push_back({ ends[1], middle });
      }
    }
  }

  std::vector<int>                color;
  std::vector<std::array<int, 2>> edges;
};

/** The nodes in canonical order. */
std::vector<int>
CanonicalOrder(const ColoredGraph & graph)
{
  const int           n = static_cast<int>(graph.color.size());
  std::vector<int>    degree(n, 0);
  std::vector<size_t> start(n + 1, 0);
  for (const auto & edge : graph.edges)
  {
    ++degree[edge[0]];
    ++degree[edge[1]];
  }
  for (int v = 0; v < n; ++v)
  {
    start[v + 1] = start[v] + degree[v];
  }
  std::vector<int>    neighbors(std::max<std::size_t>(1, 2 * graph.edges.size()));
  std::vector<size_t> place(start.begin(), start.end() - 1);
  for (const auto & edge : graph.edges)
  {
    neighbors[place[edge[0]]++] = edge[1];
    neighbors[place[edge[1]]++] = edge[0];
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return graph.color[a] < graph.color[b]; });
  std::vector<int> cellGoesOn(n, 0);
  for (int i = 0; i + 1 < n; ++i)
  {
    cellGoesOn[i] = graph.color[order[i]] == graph.color[order[i + 1]] ? 1 : 0;
  }
  SG_DECL(sparse);
  sparse.nv = n;
  sparse.nde = 2 * graph.edges.size();
  sparse.v = start.data();
  sparse.d = degree.data();
  sparse.e = neighbors.data();
  sparse.vlen = sparse.dlen = n;
  sparse.elen = neighbors.size();
  DEFAULTOPTIONS_TRACES(options);
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  TracesStats      statistics;
  std::vector<int> orbits(n);
  SG_DECL(canonical);
  Traces(&sparse, order.data(), cellGoesOn.data(), orbits.data(), &options, &statistics, &canonical);
  SG_FREE(canonical);
  return order;
}
} // namespace

CanonicalForm::CanonicalForm(const Graph & original) : rank(original.nodes)
{
  int next = 0;
  for (const int node : CanonicalOrder(ColoredGraph(original)))
  {
    if (node < original.nodes)
    {
      rank[node] = next++;
    }
  }
  graph = RelabeledGraph(original, rank);
  for (auto & edge : graph.edges)
  {
    edge = { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
  }
  std::sort(graph.edges.begin(), graph.edges.end());
}

std::vector<int>
Isomorphism(const CanonicalForm & a, const CanonicalForm & b)
{
  if (a.graph.nodes != b.graph.nodes || a.graph.edges != b.graph.edges)
  {
    return {};
  }
  std::vector<int> nodeOfRank(b.rank.size());
  for (std::size_t v = 0; v < b.rank.size(); ++v)
  {
    nodeOfRank[b.rank[v]] = static_cast<int>(v);
  }
  std::vector<int> image;
  for (const int r : a.rank)
  {
    image.push_back(nodeOfRank[r]);
  }
  return image;
}
} // namespace shapeton
