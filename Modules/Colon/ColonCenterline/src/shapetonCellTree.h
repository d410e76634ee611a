#ifndef shapetonCellTree_h
#define shapetonCellTree_h

#include "shapetonLumenCells.h"
#include "shapetonTreeReach.h"

namespace shapeton
{
/** \class CellTree
 * \brief Decides which passages between cells belong to the colon, and which join touching loops.
 *
 * Loops of the colon touch, and thin septa leak, so the cells form a graph with handles. The maximum spanning tree
 * takes the widest passages first and so leaves out each hole between parts connected by wider passages. Where the
 * colon itself is narrower than a hole, the tree would contain the hole and leave two dead ends. Therefore a hole is
 * swapped for a narrower passage if that makes the longest path of the tree clearly longer. Passages outside the tree
 * that close a short ring (around a fold, within a wide place) are open; those that close a long ring are merges.
 */
class CellTree
{
public:
  /** The longest path does not end in cells narrower than `coreRadius` (mm). */
  CellTree(const LumenCells & cells, double coreRadius);

  /** Whether a path may enter the next cell. */
  bool
  IsOpen(int a, int b) const;

  /** The cells at both ends of the longest path through the tree of `member`; equal without a second core cell. */
  std::array<int, 2>
  Ends(int member) const;

  /** For each cell the first cell connected to it. */
  std::vector<int>
  Groups() const;

  /** The cells on the path between two cells. */
  std::vector<int>
  Way(int from, int to) const;

  /** Length (mm) missed by a path: for each side branch the length of its core beyond the lumen around the path, or its
   * volume over `area` (mm^2) if that is more, as for a wide pouch. Small branches are ignored. */
  double
  SideBranches(const std::vector<int> & way, double area) const;

  /** Likelihood that the passages of a path are holes in septa: the sum over its narrow places of 1 - clearance / least
   * clearance expected from the lumen on both sides; 0 for a path through colon. */
  double
  Holes(const std::vector<int> & way) const;

  /** A passage of the tree, and the smaller of the two volumes it joins, mm^3. */
  struct Neck
  {
    int    passage;
    double volume;
  };
  /** The passages of the tree that may be holes. */
  std::vector<Neck>
  Necks() const;

  /** Minimum gain in path length (mm) for treating a passage as a hole. */
  double
  LeastGain(int passage) const;

  /** Removes a passage from the tree, or restores it. */
  void
  Cut(int passage)
  {
    this->RemoveLink(passage);
  }
  void
  Mend(int passage)
  {
    this->AddLink(passage);
  }

  /** Classifies the passages outside the tree as open or merge; call it when the tree is final. */
  void
  SortOut();

  struct Merge
  {
    /** Index into LumenCells::passages. */
    int passage;
    /** Length of the tree path that the passage would shortcut, mm; 0 without another path. */
    double loop;
  };
  /** Widest first. */
  const std::vector<Merge> &
  Merges() const
  {
    return m_Merges;
  }

private:
  void
  SpanWidest();
  /** A passage that replaces another one in the tree, and its gain in the longest path beyond the minimum, mm. */
  struct Swap
  {
    int    in;
    int    out;
    double surplus;
  };
  /** The best swap that adds `in`, which closes a ring; without `out` if none gains enough. */
  Swap
  BestSwap(int in, const TreeRing & ring, const TreeReach & reach) const;
  bool
  Exchange();
  void
  AddLink(int passage);
  void
  RemoveLink(int passage);
  TreeWalk
  WalkFrom(int cell) const;
  /** Walk over all trees, each from its first cell. */
  TreeWalk
  WalkAll() const;
  int
  FarthestCore(const TreeWalk & walk) const;
  /** The tree path between the two cells of a passage; empty if there is none. */
  TreeRing
  Ring(const TreeWalk & all, int passage) const;
  /** The widest cell of a path within the reach of a hole from index i, forward or backward. */
  double
  WidestOnWay(const std::vector<int> & way, int i, int direction) const;
  double
  Length(int passage) const;
  bool
  IsLongRing(const TreeRing & ring, int passage) const;

  const LumenCells &            m_Cells;
  double                        m_CoreRadius;
  TreeLinks                     m_Links;
  std::vector<char>             m_IsInTree;
  std::vector<std::vector<int>> m_Open;
  std::vector<Merge>            m_Merges;
};
} // namespace shapeton

#endif
