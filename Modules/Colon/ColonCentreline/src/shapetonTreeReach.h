#ifndef shapetonTreeReach_h
#define shapetonTreeReach_h

#include <numeric>
#include <vector>

namespace shapeton
{
/** A passage of a tree of cells, seen from one of the two cells. */
struct TreeLink
{
  int    cell;
  int    passage;
  double length;
};

/** Of each cell. */
using TreeLinks = std::vector<std::vector<TreeLink>>;

/** The cells of one tree or of several in an order in which parents come first; of each cell the way from the start. */
struct TreeWalk
{
  /** Of no tree. */
  explicit TreeWalk(std::size_t cells) : length(cells, -1.0), depth(cells, -1), parent(cells, -1), passage(cells, -1) {}

  /** Adds the tree of a cell, from there. */
  void
  Visit(const TreeLinks & links, int cell);

  std::vector<int>    order;
  std::vector<double> length;
  /** Cells from the start; -1 of cells that the walk has not come to. */
  std::vector<int> depth;
  /** -1 at the start. */
  std::vector<int> parent;
  /** The passage to the parent. */
  std::vector<int> passage;
};

/** The way through a tree from its cell `cells.front()` to `cells.back()`. */
struct TreeRing
{
  std::vector<int> cells;
  /** From each cell to the next one. */
  std::vector<int>    passages;
  std::vector<double> lengths;

  double
  Length() const
  {
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
  }
};

/** \class TreeReach
 * \brief How far the core cells of a tree lie from each other, with and without some of its passages.
 *
 * What lies beyond each passage is gathered once, from the leaves and back, so a question about a cell takes as long as
 * the cell has links.
 */
class TreeReach
{
public:
  /** A walk over all trees, and which cells are core. */
  TreeReach(const TreeLinks & links, const TreeWalk & all, const std::vector<char> & isCore);

  /** The longest way between two core cells of the tree of `cell`; 0 where it has fewer. */
  double
  LongestWay(int cell) const
  {
    return this->Around(cell).longest;
  }

  /** Of each passage of a ring the longest way between two core cells of the tree in which that passage is exchanged
   * for one of `length` between the two ends of the ring. */
  std::vector<double>
  LongestWaysWithout(const TreeRing & ring, double length) const;

private:
  /** What a part of a tree has, seen from one of its cells. */
  struct Part
  {
    /** The way to the farthest core cell; where there is none, far below 0. */
    double deepest{ -1e300 };
    /** The longest way between two core cells. */
    double longest{ 0.0 };
  };

  static Part
  Farther(const Part & part, double length)
  {
    return { part.deepest + length, part.longest };
  }
  static Part
  Join(const Part & a, const Part & b);

  /** The tree around a cell but for what lies beyond two of its passages. */
  Part
  Around(int cell, int passage = -1, int other = -1) const;

  /** Of the first cell of a ring, of the first two and so on, with what hangs on them: seen from the first. */
  static std::vector<Part>
  FromTheFirst(const std::vector<Part> & hanging, const std::vector<double> & lengths);

  const TreeLinks &         m_Links;
  const TreeWalk &          m_Walk;
  const std::vector<char> & m_IsCore;
  /** Of each cell what lies beyond it, seen from it as one comes from its parent. */
  std::vector<Part> m_Below;
  /** The rest of its tree, seen from its parent. */
  std::vector<Part> m_Above;
};
} // namespace shapeton

#endif
