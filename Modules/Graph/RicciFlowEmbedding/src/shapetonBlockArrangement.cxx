#include "shapetonBlockArrangement.h"

#include "shapetonBlockMaps.h"
#include "shapetonNodesMetTwice.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** Length and unique number of a face; see BlockMaps::FaceLengths(). */
using FaceKey = std::pair<int, int>;

/** Outer face of each block, see ArrangeBlocks(). */
std::vector<FaceKey>
OuterFaces(const CombinatorialMap & map, const BlockMaps & blocks, const std::vector<FaceKey> & faces)
{
  const int                     number = 1 + *std::max_element(blocks.blockOfEdge.begin(), blocks.blockOfEdge.end());
  std::vector<std::vector<int>> halfEdges(number);
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    halfEdges[blocks.blockOfEdge[h / 2]].push_back(h);
  }
  std::vector<int> bySize(number);
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(
    bySize.begin(), bySize.end(), [&](int a, int b) { return halfEdges[a].size() > halfEdges[b].size(); });
  std::vector<FaceKey> outer(number, { 0, 0 });
  std::vector<char>    isMet(map.Nodes(), 0);
  for (const int root : bySize)
  {
    if (outer[root].first > 0)
    {
      continue;
    }
    for (const int h : halfEdges[root])
    {
      outer[root] = std::max(outer[root], faces[h]);
    }
    std::vector<int> found{ root };
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      for (const int h : halfEdges[found[i]])
      {
        if (isMet[map.Node(h)])
        {
          continue;
        }
        isMet[map.Node(h)] = 1;
        for (const int onward : map.Around(map.Node(h)))
        {
          const int block = blocks.blockOfEdge[onward / 2];
          if (block == found[i])
          {
            continue;
          }
          if (outer[block].first == 0)
          {
            found.push_back(block);
          }
          outer[block] = std::max(outer[block], faces[onward]);
        }
      }
    }
  }
  return outer;
}

/** Half-edges of a block around a node, starting after the corner of the outer face (or of the longest face, if the
 * outer face does not meet the node). */
std::vector<int>
FromOuterFace(const BlockMaps & blocks, const std::vector<FaceKey> & faces, const FaceKey & outer, int any)
{
  const auto rank = [&](int h) { return std::pair<bool, FaceKey>(faces[h] == outer, faces[h]); };
  int        best = any;
  for (int h = blocks.next[any]; h != any; h = blocks.next[h])
  {
    best = rank(h) > rank(best) ? h : best;
  }
  std::vector<int> order;
  int              h = blocks.next[best];
  for (; h != best; h = blocks.next[h])
  {
    order.push_back(h);
  }
  order.push_back(best);
  return order;
}

/** Whether the map is a single block: a node that joins blocks has several corners in one face. */
bool
IsOneBlock(const CombinatorialMap & map)
{
  bool hasCutNode = map.Components() != 1;
  ForEachNodeMetTwice(map, [&hasCutNode](int, int) { hasCutNode = true; });
  return !hasCutNode;
}
} // namespace

CombinatorialMap
ArrangeBlocks(const CombinatorialMap & map)
{
  if (map.Edges() == 0 || IsOneBlock(map))
  {
    return map;
  }
  const BlockMaps            blocks(map);
  const std::vector<FaceKey> faces = blocks.FaceLengths();
  const std::vector<FaceKey> outer = OuterFaces(map, blocks, faces);
  std::vector<int>           next(map.HalfEdges());
  std::vector<int>           lastNode(outer.size(), -1);
  for (int node = 0; node < map.Nodes(); ++node)
  {
    std::vector<int> order;
    for (const int h : map.Around(node))
    {
      const int block = blocks.blockOfEdge[h / 2];
      if (lastNode[block] != node)
      {
        lastNode[block] = node;
        const std::vector<int> own = FromOuterFace(blocks, faces, outer[block], h);
        order.insert(order.end(), own.begin(), own.end());
      }
    }
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      next[order[i]] = order[(i + 1) % order.size()];
    }
  }
  std::vector<std::array<int, 2>> edges = map.ToGraph().edges;
  return { map.Nodes(), edges, next };
}
} // namespace shapeton
