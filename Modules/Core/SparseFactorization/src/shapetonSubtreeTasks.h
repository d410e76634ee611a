#ifndef shapetonSubtreeTasks_h
#define shapetonSubtreeTasks_h

#include "shapetonSupernodes.h"

namespace shapeton
{
/** Parts of the elimination tree that threads can process concurrently: subtrees, and the trunk above them. The
 * partition depends only on the tree. */
struct SubtreeTasks
{
  explicit SubtreeTasks(const Supernodes & supernodes);

  std::vector<int> roots; ///< roots of the subtrees, ascending
  std::vector<int> trunk; ///< the other supernodes, ascending
  double           products{ 0.0 };
};
} // namespace shapeton

#endif
