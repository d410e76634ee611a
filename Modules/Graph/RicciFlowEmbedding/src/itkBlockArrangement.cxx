#include "itkBlockArrangement.h"

#include "itkBlockMaps.h"

#include <algorithm>

namespace itk
{
namespace
{
/** The half-edges of a block around a node, from the one after the corner of the longest face to the one before it. */
std::vector<int>
FromLongestFace(const BlockMaps & blocks, const std::vector<std::pair<int, int>> & lengths, int any)
{
  int best = any;
  for (int h = blocks.next[any]; h != any; h = blocks.next[h])
  {
    best = lengths[h] > lengths[best] ? h : best;
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
} // namespace

CombinatorialMap
ArrangeBlocks(const CombinatorialMap & map)
{
  const BlockMaps  blocks(map);
  const auto       lengths = blocks.FaceLengths();
  std::vector<int> next(map.HalfEdges());
  for (int node = 0; node < map.Nodes(); ++node)
  {
    std::vector<int> order;
    std::vector<int> seen;
    for (const int h : map.Around(node))
    {
      const int block = blocks.blockOfEdge[h / 2];
      if (std::find(seen.begin(), seen.end(), block) == seen.end())
      {
        seen.push_back(block);
        const std::vector<int> own = FromLongestFace(blocks, lengths, h);
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
} // namespace itk
