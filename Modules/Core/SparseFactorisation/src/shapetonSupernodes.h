#ifndef shapetonSupernodes_h
#define shapetonSupernodes_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** The symbolic analysis of a sparse symmetric matrix: order of elimination, elimination tree, supernodes.
 *
 * A supernode is a run of columns that are eliminated together as one dense front. Its front has its own columns first,
 * then its rows: the later columns that the factor has below it. Small supernodes are merged with their parents where a
 * larger dense front costs less than two; the zeros that this adds are treated as elements. Wide ones are cut into
 * chains of panels of at most maximalWidth columns. The supernodes are numbered in postorder: those of a subtree follow
 * one another and end with its root. */
struct Supernodes
{
  static constexpr int maximalWidth = 48;

  /** `order`: see OrderOfElimination(). */
  Supernodes(std::vector<int> order, const std::vector<std::array<int, 2>> & edges);

  int
  Number() const
  {
    return static_cast<int>(parent.size());
  }
  int
  Width(int s) const
  {
    return firstColumn[s + 1] - firstColumn[s];
  }
  int
  NumberOfRows(int s) const
  {
    return static_cast<int>(rowBegin[s + 1] - rowBegin[s]);
  }
  /** Products of the elimination and the selected inversion of a supernode. */
  double
  Products(int s) const;

  /** The vertex of each column. */
  std::vector<int> order;
  /** One for each supernode, and the number of columns. */
  std::vector<int> firstColumn;
  /** The supernode of the first row; -1 for a root. */
  std::vector<int> parent;
  /** The first supernode of the subtree that ends with this one. */
  std::vector<int> firstDescendant;
  std::vector<int> numberOfChildren;
  /** The children of each one as a list, from the last to the first; -1 at its end. */
  std::vector<int>         lastChild;
  std::vector<int>         sibling;
  std::vector<std::size_t> rowBegin;
  /** Columns, ascending. */
  std::vector<int> rows;
  /** Where each row is in the front of the parent: a column of its own, or the parent's width + a row. */
  std::vector<int> placeInParent;

  /** An element of the matrix that belongs to a supernode's front. */
  struct Entry
  {
    int row;    ///< in the front: below the width one of the own columns
    int column; ///< of the supernode
    int source; ///< the edge, or -1 - vertex for a diagonal element
  };
  std::vector<std::size_t> entryBegin;
  std::vector<Entry>       entries;

private:
  void
  BuildRows(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges);
  void
  CutWideOnes();
  void
  BuildPlaces();
  void
  BuildEntries(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges);
  void
  BuildSubtrees();
  std::vector<int>
  SupernodeOfColumns() const;
};
} // namespace shapeton

#endif
