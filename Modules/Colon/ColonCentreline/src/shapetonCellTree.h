#ifndef shapetonCellTree_h
#define shapetonCellTree_h

#include "shapetonLumenCells.h"
#include "shapetonTreeReach.h"

namespace shapeton
{
/** \class CellTree
 * \brief Which passages between cells belong to the colon, and which join loops that only touch.
 *
 * Loops of the colon touch, and thin septa leak, so the cells form a graph with handles. The maximum spanning tree
 * takes the widest passages first and so leaves out each hole between parts that wider passages connect. Where the
 * colon itself is narrower than a hole, the tree would go through the hole and leave two dead ends; therefore a hole is
 * exchanged for a narrower passage wherever that makes the longest way through the tree clearly longer. Passages
 * outside the tree that close a short ring (around a fold, within a wide place) are allowed; those that close a long
 * ring are merges.
 */
class CellTree
{
public:
  /** Cells narrower than `coreRadius` (mm) are no ends of the longest way. */
  CellTree(const LumenCells & cells, double coreRadius);

  /** Whether a path may go from a cell into the next one. */
  bool
  IsOpen(int a, int b) const;

  /** The cells at both ends of the longest way through the tree of `member`; equal where it has no second core cell. */
  std::array<int, 2>
  Ends(int member) const;

  /** Of each cell the first cell that it is connected to. */
  std::vector<int>
  Groups() const;

  /** The cells of the way between two of them. */
  std::vector<int>
  Way(int from, int to) const;

  /** What a way leaves out, mm: of each side branch the length of its core beyond the lumen around the way, or its
   * volume over `area` (mm^2) where that is more, such as that of a wide pouch. Small ones do not count. */
  double
  SideBranches(const std::vector<int> & way, double area) const;

  /** How much the passages of a way look like holes in septa: the sum over its narrow places of 1 - clearance / least
   * that is expected between lumen as wide as there is on both sides; 0 for a way through colon. */
  double
  Holes(const std::vector<int> & way) const;

  /** A passage of the tree, and the smaller of the volumes that it joins, mm^3. */
  struct Neck
  {
    int    passage;
    double volume;
  };
  /** The passages of the tree that may be holes. */
  std::vector<Neck>
  Necks() const;

  /** What taking a passage for a hole must gain at least, mm of the way through the colon. */
  double
  LeastGain(int passage) const;

  /** Takes a passage out of the tree, or puts it back. */
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

  /** Sorts the passages outside the tree into open ones and merges; to be called when the tree is final. */
  void
  SortOut();

  struct Merge
  {
    /** Index into LumenCells::passages. */
    int passage;
    /** Length of the way through the tree that the passage would cut short, mm; 0 where no other way leads. */
    double loop;
  };
  /** The widest first. */
  const std::vector<Merge> &
  Merges() const
  {
    return m_Merges;
  }

private:
  void
  SpanWidest();
  /** A passage that is taken into the tree for another one, and by how much more than the least gain that makes the
   * longest way longer, mm. */
  struct Swap
  {
    int    in;
    int    out;
    double surplus;
  };
  /** The best one of those that take in `in`, which closes a ring; without `out` where none gains enough. */
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
  /** Of all trees, each from its first cell. */
  TreeWalk
  WalkAll() const;
  int
  FarthestCore(const TreeWalk & walk) const;
  /** The way through the tree between the two cells of a passage; empty where there is none. */
  TreeRing
  Ring(const TreeWalk & all, int passage) const;
  /** The widest cell of a way within the reach of a hole from the place i on, forth or back. */
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
