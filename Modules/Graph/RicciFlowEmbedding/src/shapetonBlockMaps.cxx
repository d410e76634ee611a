#include "shapetonBlockMaps.h"

#include "shapetonGraphStructure.h"

namespace shapeton
{
BlockMaps::BlockMaps(const CombinatorialMap & map)
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

std::vector<std::pair<int, int>>
BlockMaps::FaceLengths() const
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
} // namespace shapeton
