#include "itkBlockArrangement.h"

#include "itkGraphStructure.h"

#include <algorithm>
#include <utility>

namespace itk
{
namespace
{
/** The blocks of a map as maps of their own, in one permutation. */
struct BlockMaps
{
  explicit BlockMaps(const CombinatorialMap & map)
    : next(map.HalfEdges()), previous(map.HalfEdges()), blockOfEdge(map.Edges())
  {
    const std::vector<std::vector<int>> blocks = BlocksOf(map.ToGraph());
    for (std::size_t block = 0; block < blocks.size(); ++block)
    {
      for (const int edge : blocks[block])
      {
        blockOfEdge[edge] = static_cast<int>(block);
      }
    }
    std::vector<int> last(blocks.size(), -1);
    std::vector<int> first(blocks.size(), -1);
    for (int node = 0; node < map.Nodes(); ++node)
    {
      const std::vector<int> around = map.Around(node);
      for (const int h : around)
      {
        const int block = blockOfEdge[h / 2];
        first[block] = first[block] < 0 ? h : first[block];
        this->Link(last[block] < 0 ? h : last[block], h);
        last[block] = h;
      }
      for (const int h : around)
      {
        const int block = blockOfEdge[h / 2];
        if (first[block] >= 0)
        {
          this->Link(last[block], first[block]);
          first[block] = last[block] = -1;
        }
      }
    }
  }
  void
  Link(int one, int other)
  {
    next[one] = other;
    previous[other] = one;
  }
  /** Of each half-edge, the number of half-edges of the face to its left, and the smallest of them, negative: the
   * greater of two pairs is that of the longer face, and of equal ones always of the same. */
  std::vector<std::pair<int, int>>
  FaceLengths() const
  {
    std::vector<std::pair<int, int>> lengths(next.size());
    for (std::size_t start = 0; start < next.size(); ++start)
    {
      int length = 0;
      for (int h = static_cast<int>(start); lengths[h].first == 0; h = previous[CombinatorialMap::Twin(h)])
      {
        lengths[h].first = -1;
        ++length;
      }
      for (int h = static_cast<int>(start); lengths[h].first == -1; h = previous[CombinatorialMap::Twin(h)])
      {
        lengths[h] = { length, -static_cast<int>(start) };
      }
    }
    return lengths;
  }

  std::vector<int> next;
  std::vector<int> previous;
  std::vector<int> blockOfEdge;
};

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
