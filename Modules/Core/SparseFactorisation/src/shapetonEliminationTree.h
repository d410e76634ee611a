#ifndef shapetonEliminationTree_h
#define shapetonEliminationTree_h

#include <array>
#include <vector>

namespace shapeton
{
/** The elimination tree of a symmetric matrix in a given order, by columns, and what its factor has in each. */
struct EliminationTree
{
  /** `order`: the vertex of each column. It becomes a postorder of the tree: equivalent, and subtrees are runs. */
  EliminationTree(std::vector<int> & order, const std::vector<std::array<int, 2>> & edges);

  /** The first column below the diagonal; -1 for a root. */
  std::vector<int> parent;
  /** Elements of the factor below the diagonal. */
  std::vector<int> count;
};

/** Runs of columns to be eliminated together, in postorder. */
struct ColumnRuns
{
  std::vector<int> order;       ///< the vertex of each column, rearranged so that each supernode is a run
  std::vector<int> firstColumn; ///< of each supernode, and the number of columns
};

/** Columns of equal structure as one supernode, and small ones merged with their parents where that costs less. */
ColumnRuns
MergeColumns(const std::vector<int> & order, const EliminationTree & tree);

/** The numbers of each element of an order: place[order[i]] = i. */
std::vector<int>
PlacesOf(const std::vector<int> & order);
} // namespace shapeton

#endif
