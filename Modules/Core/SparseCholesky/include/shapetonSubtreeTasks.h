#ifndef shapetonSubtreeTasks_h
#define shapetonSubtreeTasks_h

#include "SparseCholeskyExport.h"
#include "shapetonSupernodes.h"

namespace shapeton
{
/** The products of elimination and selected inversion of a supernode. */
SparseCholesky_EXPORT double
ProductsOf(const Supernodes & supernodes, int s);

/** Parts of the elimination tree that threads can work on at the same time: subtrees, and the trunk above them. The
 * cut depends on the tree alone. */
struct SparseCholesky_EXPORT SubtreeTasks
{
  explicit SubtreeTasks(const Supernodes & supernodes);

  std::vector<int> roots; ///< of the subtrees, ascending
  std::vector<int> trunk; ///< the other supernodes, ascending
  double           products{ 0.0 };
};
} // namespace shapeton

#endif
