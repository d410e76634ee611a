#ifndef shapetonSubtreeTasks_h
#define shapetonSubtreeTasks_h

#include "shapetonSupernodes.h"

namespace shapeton
{
/** Parts of the elimination tree that threads can work on at the same time: subtrees, and the trunk above them. The
 * cut depends on the tree alone. */
struct SubtreeTasks
{
  explicit SubtreeTasks(const Supernodes & supernodes);

  std::vector<int> roots; ///< of the subtrees, ascending
  std::vector<int> trunk; ///< the other supernodes, ascending
  double           products{ 0.0 };
};
} // namespace shapeton

#endif
