#ifndef shapetonEliminationTree_h
#define shapetonEliminationTree_h

#include <array>
#include <vector>

namespace shapeton
{
/** Elimination tree of a symmetric matrix in a given order, by columns, and the number of factor elements per
 * column. */
struct EliminationTree
{
  /** `order`: the vertex of each column. It is replaced by a postorder of the tree: equivalent, with contiguous
   * subtrees. */
  EliminationTree(std::vector<int> & order, const std::vector<std::array<int, 2>> & edges);

  /** Parent column: row of the first element below the diagonal; -1 for a root. */
  std::vector<int> parent;
  /** Number of factor elements below the diagonal. */
  std::vector<int> count;
};

/** Runs of columns to be eliminated together, in postorder. */
struct ColumnRuns
{
  std::vector<int> order;       ///< the vertex of each column, rearranged so that each supernode is contiguous
  std::vector<int> firstColumn; ///< for each supernode, then the number of columns
};

/** Columns of equal structure form a supernode; small ones are merged with their parents if that is cheaper. */
ColumnRuns
MergeColumns(const std::vector<int> & order, const EliminationTree & tree);

/** The inverse permutation of an order: place[order[i]] = i. */
std::vector<int>
PlacesOf(const std::vector<int> & order);
} // namespace shapeton

#endif
