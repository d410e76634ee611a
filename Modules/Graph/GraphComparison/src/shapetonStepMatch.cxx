#include "shapetonStepMatch.h"

#include "shapetonCarriedRotation.h"

#include <algorithm>

namespace shapeton
{
StepMatch::StepMatch(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map)
  : nodeOf(NodesOfSameName(before, after))
  , oldNode(after.nodes, -1)
  , halfEdgeOf(packed.map.HalfEdges(), -1)
  , oldHalfEdge(map.HalfEdges(), -1)
{
  std::vector<int> edgeOf = EdgesOfSameEnds(before, after, nodeOf);
  for (const std::vector<int> & path : packed.subdivided)
  {
    edgeOf[path.front() / 2] = -1;
  }
  for (std::size_t e = 0; e < edgeOf.size(); ++e)
  {
    if (edgeOf[e] >= 0)
    {
      const int old = static_cast<int>(2 * e);
      const int turned = after.edges[edgeOf[e]][0] == nodeOf[before.edges[e][0]] ? 0 : 1;
      for (int end = 0; end < 2; ++end)
      {
        halfEdgeOf[old + end] = 2 * edgeOf[e] + (end + turned) % 2;
        oldHalfEdge[halfEdgeOf[old + end]] = old + end;
      }
    }
  }
  for (int v = 0; v < before.nodes; ++v)
  {
    if (nodeOf[v] >= 0)
    {
      const std::vector<int> around = map.Around(nodeOf[v]);
      const bool             stays =
        around.empty() || std::any_of(around.begin(), around.end(), [this](int h) { return oldHalfEdge[h] >= 0; });
      nodeOf[v] = stays ? nodeOf[v] : -1;
      if (stays)
      {
        oldNode[nodeOf[v]] = v;
      }
    }
  }
}
} // namespace shapeton
