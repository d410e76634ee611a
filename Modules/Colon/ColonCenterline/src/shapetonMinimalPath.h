#ifndef shapetonMinimalPath_h
#define shapetonMinimalPath_h

#include "shapetonCellTree.h"

#include <limits>

namespace shapeton
{
/** Minimal paths from one node to all reachable ones. */
struct PathTree
{
  /** Nodes by increasing cost, from the start. */
  std::vector<int> order;
  /** Parent of each node; -1 for the start and unreachable nodes. */
  std::vector<int> parents;
  /** Path length to each node, mm; -1 if unreachable. */
  std::vector<float> lengths;

  /** The nodes from the start to the given node. */
  std::vector<int>
  PathTo(int node) const;
};

/** Dijkstra's algorithm on 26 neighbors with cost 1 / (d + 0.1 mm)^exponent per mm, where d is the distance to the
 * wall. Paths cross only between cells connected in the tree. Ties are broken by node order. The search stops at `last`
 * if given. */
PathTree
GrowPathTree(const LumenGrid &  grid,
             const LumenCells & cells,
             const CellTree &   tree,
             int                start,
             int                exponent,
             int                last = -1);

/** For each node: the index of the path node nearest to it within the lumen (-1 if unreachable), and the distance,
 * mm. */
struct NearestPlaces
{
  std::vector<int>   indices;
  std::vector<float> distances;
};

/** Skips path nodes that are -1. The search stops at `reach` mm. */
NearestPlaces
NearestOnPath(const LumenGrid &        grid,
              const LumenCells &       cells,
              const CellTree &         tree,
              const std::vector<int> & path,
              double                   reach = std::numeric_limits<double>::infinity());
} // namespace shapeton

#endif
