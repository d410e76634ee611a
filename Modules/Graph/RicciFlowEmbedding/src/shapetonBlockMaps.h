#ifndef shapetonBlockMaps_h
#define shapetonBlockMaps_h

#include "shapetonCombinatorialMap.h"

#include <utility>
#include <vector>

namespace shapeton
{
/** The blocks of a map as separate maps, stored in one permutation. */
struct BlockMaps
{
  explicit BlockMaps(const CombinatorialMap & map);

  /** For each half-edge, the number of half-edges of the face to its left, and the lowest of them, negated. Pairs
   * compare by face length; ties are broken consistently. */
  std::vector<std::pair<int, int>>
  FaceLengths() const;

  std::vector<int> next;
  std::vector<int> previous;
  std::vector<int> blockOfEdge;

private:
  void
  Link(int one, int other)
  {
    next[one] = other;
    previous[other] = one;
  }
};
} // namespace shapeton

#endif
