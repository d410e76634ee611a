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

  /** The nodes from the start to this one. */
  std::vector<int>
  PathTo(int node) const;
};

/** Dijkstra's algorithm on 26 neighbors; one mm costs 1 / (d + 0.1 mm)^exponent, d the distance to the wall. Paths
 * change cells only where the tree allows it. Ties are broken by the order of the nodes. With `last` the search stops
 * at that node. */
PathTree
GrowPathTree(const LumenGrid &  grid,
             const LumenCells & cells,
             const CellTree &   tree,
             int                start,
             int                exponent,
             int                last = -1);

/** For each node the index of the nearest path node within the lumen, -1 if unreachable, and its distance, mm. */
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
