#ifndef shapetonTreeReach_h
#define shapetonTreeReach_h

#include <numeric>
#include <vector>

namespace shapeton
{
/** A passage of a tree of cells, directed from one of its two cells. */
struct TreeLink
{
  int    cell;
  int    passage;
  double length;
};

/** Links of each cell. */
using TreeLinks = std::vector<std::vector<TreeLink>>;

/** The cells of one or more trees, parents first, and the path length from the start to each cell. */
struct TreeWalk
{
  /** Creates an empty walk. */
  explicit TreeWalk(std::size_t cells) : length(cells, -1.0), depth(cells, -1), parent(cells, -1), passage(cells, -1) {}

  /** Adds the tree that contains a cell, starting at that cell. */
  void
  Visit(const TreeLinks & links, int cell);

  std::vector<int>    order;
  std::vector<double> length;
  /** Number of cells from the start; -1 for unvisited cells. */
  std::vector<int> depth;
  /** Parent cell; -1 at the start. */
  std::vector<int> parent;
  /** Passage to the parent. */
  std::vector<int> passage;
};

/** The path through a tree from `cells.front()` to `cells.back()`. */
struct TreeRing
{
  std::vector<int> cells;
  /** The passage from each cell to the next. */
  std::vector<int>    passages;
  std::vector<double> lengths;

  double
  Length() const
  {
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
  }
};

/** \class TreeReach
 * \brief Longest paths between core cells of a tree, as it is or with some passages removed.
 *
 * The part beyond each passage is summarized once, in an upward and a downward pass; a query then takes time linear in
 * the number of links of the cell.
 */
class TreeReach
{
public:
  /** A walk over all trees, and a flag for core cells. */
  TreeReach(const TreeLinks & links, const TreeWalk & all, const std::vector<char> & isCore);

  /** Length of the longest path between two core cells of the tree of `cell`; 0 for fewer than two. */
  double
  LongestWay(int cell) const
  {
    return this->Around(cell).longest;
  }

  /** For each passage of a ring: the longest path between two core cells after the passage is replaced by one of length
   * `length` between the ends of the ring. */
  std::vector<double>
  LongestWaysWithout(const TreeRing & ring, double length) const;

private:
  /** Summary of a part of a tree relative to one of its cells. */
  struct Part
  {
    /** Path length to the farthest core cell; a large negative value if there is none. */
    double deepest{ -1e300 };
    /** Longest path between two core cells. */
    double longest{ 0.0 };
  };

  static Part
  Farther(const Part & part, double length)
  {
    return { part.deepest + length, part.longest };
  }
  static Part
  Join(const Part & a, const Part & b);

  /** The tree around a cell, excluding the parts beyond two of its passages. */
  Part
  Around(int cell, int passage = -1, int other = -1) const;

  /** Cumulative summaries of the cells of a ring and their branches, relative to the first cell. */
  static std::vector<Part>
  FromTheFirst(const std::vector<Part> & hanging, const std::vector<double> & lengths);

  const TreeLinks &         m_Links;
  const TreeWalk &          m_Walk;
  const std::vector<char> & m_IsCore;
  /** Subtree below each cell, relative to the cell. */
  std::vector<Part> m_Below;
  /** The rest of the tree, relative to the parent. */
  std::vector<Part> m_Above;
};
} // namespace shapeton

#endif
