#ifndef shapetonBlockMaps_h
#define shapetonBlockMaps_h

#include "shapetonCombinatorialMap.h"

#include <utility>
#include <vector>

namespace shapeton
{
/** The blocks of a map as maps of their own, in one permutation. */
struct BlockMaps
{
  explicit BlockMaps(const CombinatorialMap & map);

  /** Of each half-edge, the number of half-edges of the face to its left, and the smallest of them, negative: the
   * greater of two pairs is that of the longer face, and of equal ones always of the same. */
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
