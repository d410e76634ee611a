#ifndef shapetonSupernodes_h
#define shapetonSupernodes_h

#include <array>
#include <cstddef>
#include <vector>

namespace shapeton
{
/** The symbolic analysis of a sparse symmetric matrix: order of elimination, elimination tree, supernodes.
 *
 * A supernode is a range of columns eliminated together as one dense front. Its front has its own columns first,
 * then its rows: the later columns with factor elements below it. Small supernodes are merged with their parents if
 * one larger dense front is cheaper than two; the added zeros are treated as elements. Wide ones are divided into
 * chains of panels of at most maximalWidth columns. Supernodes are numbered in postorder, so a subtree is consecutive
 * and ends with its root. */
struct Supernodes
{
  static constexpr int maximalWidth = 48; // columns; chosen, bounds the dense work on one panel

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
  /** Multiplications of the elimination and the selected inversion of a supernode. */
  double
  Products(int s) const;

  /** The vertex of each column. */
  std::vector<int> order;
  /** One for each supernode, then the number of columns. */
  std::vector<int> firstColumn;
  /** Parent: the supernode of the first row; -1 for a root. */
  std::vector<int> parent;
  /** The first supernode of the subtree that ends with this one. */
  std::vector<int> firstDescendant;
  std::vector<int> numberOfChildren;
  /** The children of each supernode as a linked list, from the last to the first, terminated by -1. */
  std::vector<int>         lastChild;
  std::vector<int>         sibling;
  std::vector<std::size_t> rowBegin;
  /** Column indices, ascending. */
  std::vector<int> rows;
  /** Index of each row in the front of the parent: one of its own columns, or the parent's width + a row. */
  std::vector<int> placeInParent;

  /** A matrix element that is assembled into a supernode's front. */
  struct Entry
  {
    int row;    ///< row in the front: one of the own columns if below the width
    int column; ///< column in the supernode
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
