#ifndef shapetonCellTree_h
#define shapetonCellTree_h

#include "shapetonLumenCells.h"
#include "shapetonTreeReach.h"

namespace shapeton
{
/** \class CellTree
 * \brief Classifies passages between cells as colon or as holes between touching loops.
 *
 * Loops of the colon touch and thin septa leak, so the graph of cells contains cycles. The maximum spanning tree
 * excludes each hole between parts connected by wider passages. Where the colon is narrower than a hole, the tree would
 * pass through the hole and leave two dead ends. Therefore a hole is replaced by a narrower passage if this makes the
 * longest path of the tree clearly longer. Passages outside the tree that close a short ring (around a fold or within
 * wide lumen) are open; those that close a long ring are merges. */
class CellTree
{
public:
  /** Longest paths end only in cells of at least `coreRadius` (mm). */
  CellTree(const LumenCells & cells, double coreRadius);

  /** Whether paths may use the passage. */
  bool
  IsOpen(int a, int b) const;

  /** The end cells of the longest path in the tree of `member`; identical if there is only one core cell. */
  std::array<int, 2>
  Ends(int member) const;

  /** For each cell, the first cell connected to it. */
  std::vector<int>
  Groups() const;

  /** The cells on the path between two cells. */
  std::vector<int>
  Way(int from, int to) const;

  /** Total length (mm) of the side branches of a path. Each contributes its core length beyond the lumen around the
   * path, or its volume / `area` (mm^2) if that is larger, as for a wide pouch. Small branches are ignored. */
  double
  SideBranches(const std::vector<int> & way, double area) const;

  /** Score for holes in septa on a path: 1 - clearance / (minimum clearance expected from the lumen on both sides),
   * summed over narrow passages; 0 for a path within the colon. */
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

  /** Classifies the passages outside the final tree as open or merge. */
  void
  SortOut();

  struct Merge
  {
    /** Index into LumenCells::passages. */
    int passage;
    /** Length (mm) of the tree path that the passage would bypass; 0 if no other path exists. */
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
  /** A replacement of one tree passage by another, and the excess (mm) of its gain in path length over the minimum
   * gain. */
  struct Swap
  {
    int    in;
    int    out;
    double surplus;
  };
  /** The best swap that adds `in`, which closes a ring; `out` is unset if no gain is sufficient. */
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
  /** A walk over all trees, each starting at its first cell. */
  TreeWalk
  WalkAll() const;
  int
  FarthestCore(const TreeWalk & walk) const;
  /** The tree path between the two cells of a passage; empty if there is none. */
  TreeRing
  Ring(const TreeWalk & all, int passage) const;
  /** Radius of the widest cell of a path within the search distance from index i, forward or backward. */
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
