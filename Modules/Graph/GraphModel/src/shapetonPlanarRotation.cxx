#include "shapetonPlanarRotation.h"

#include "shapetonGraphGenus.h"
#include "shapetonGraphStructure.h"
#include "shapetonLeftRightPlanarity.h"

namespace shapeton
{
namespace
{
/** Embeds the first of each set of parallel edges; returns false if this is impossible. */
bool
EmbedSimple(const Graph & graph, const std::vector<int> & first, std::vector<int> & next)
{
  std::vector<bool> isUsed(first.size());
  for (std::size_t e = 0; e < first.size(); ++e)
  {
    isUsed[e] = first[e] == static_cast<int>(e);
  }
  LeftRightPlanarity planarity(graph, isUsed);
  if (planarity.IsPlanar())
  {
    planarity.WriteNextAround(next);
  }
  return planarity.IsPlanar();
}

/** Inserts each additional parallel edge next to the first one; both bound a face of two edges. */
void
AddParallels(const Graph & graph, const std::vector<int> & first, std::vector<int> & next)
{
  std::vector<int> previous(next.size(), -1);
  for (std::size_t h = 0; h < next.size(); ++h)
  {
    if (next[h] >= 0)
    {
      previous[next[h]] = static_cast<int>(h);
    }
  }
  const auto insert = [&](int halfEdge, int after) {
    InsertAfter(next, halfEdge, after);
    previous[halfEdge] = after;
    previous[next[halfEdge]] = halfEdge;
  };
  for (int e = 0; e < static_cast<int>(first.size()); ++e)
  {
    if (first[e] >= 0 && first[e] != e)
    {
      const int turned = graph.edges[e][0] == graph.edges[first[e]][0] ? 0 : 1;
      insert(2 * e + turned, 2 * first[e]);
      insert(2 * e + 1 - turned, previous[2 * first[e] + 1]);
    }
  }
}

/** Inserts each loop so that it bounds a separate face. */
void
AddLoops(const Graph & graph, const std::vector<int> & first, std::vector<int> & next)
{
  std::vector<int> any(graph.nodes, -1);
  for (std::size_t h = 0; h < next.size(); ++h)
  {
    if (next[h] >= 0)
    {
      any[graph.edges[h / 2][h % 2]] = static_cast<int>(h);
    }
  }
  for (int e = 0; e < static_cast<int>(first.size()); ++e)
  {
    if (first[e] >= 0)
    {
      continue;
    }
    int & corner = any[graph.edges[e][0]];
    next[2 * e] = 2 * e + 1;
    next[2 * e + 1] = 2 * e;
    if (corner >= 0)
    {
      SpliceOrders(next, corner, 2 * e);
    }
    corner = 2 * e;
  }
}
} // namespace

int
PreviousAround(const std::vector<int> & nextAround, int halfEdge)
{
  int h = halfEdge;
  while (nextAround[h] != halfEdge)
  {
    h = nextAround[h];
  }
  return h;
}

std::vector<int>
PlanarNextAround(const Graph & graph)
{
  std::vector<int>       next(2 * graph.edges.size(), -1);
  const std::vector<int> first = FirstParallels(graph);
  if (!EmbedSimple(graph, first, next))
  {
    return {};
  }
  AddParallels(graph, first, next);
  AddLoops(graph, first, next);
  return next;
}

bool
FindPlanarEmbedding(const Graph & graph, CombinatorialMap & map)
{
  RequireSound(graph, "planar embedding");
  std::vector<int> next = PlanarNextAround(graph);
  if (next.size() != 2 * graph.edges.size())
  {
    return false;
  }
  map = CombinatorialMap(graph.nodes, graph.edges, std::move(next));
  return true;
}
} // namespace shapeton
