#ifndef shapetonMinimalPath_h
#define shapetonMinimalPath_h

#include "shapetonCellTree.h"

#include <limits>

namespace shapeton
{
/** Minimal paths from one node to all that can be reached. */
struct PathTree
{
  /** The nodes by growing cost; the start is the first. */
  std::vector<int> order;
  /** Of each node; -1 for the start and where nothing leads. */
  std::vector<int> parents;
  /** Of the path to each node, mm; -1 where nothing leads. */
  std::vector<float> lengths;

  /** The nodes from the start to this one. */
  std::vector<int>
  PathTo(int node) const;
};

/** Dijkstra's algorithm on 26 neighbours; one mm costs 1 / (d + 0.1 mm)^exponent, d the distance to the wall. Paths go
 * from cell to cell only where the tree allows it. Equal costs are told apart by the order of the nodes. With `last`
 * the tree ends when it has come to that node. */
PathTree
GrowPathTree(const LumenGrid &  grid,
             const LumenCells & cells,
             const CellTree &   tree,
             int                start,
             int                exponent,
             int                last = -1);

/** Of each node the index of the path's node that is nearest within the lumen, -1 where nothing leads, and how far away
 * that is, mm. */
struct NearestPlaces
{
  std::vector<int>   indices;
  std::vector<float> distances;
};

/** Nodes of the path that are -1 are passed over. Nothing leads farther than `reach` mm. */
NearestPlaces
NearestOnPath(const LumenGrid &        grid,
              const LumenCells &       cells,
              const CellTree &         tree,
              const std::vector<int> & path,
              double                   reach = std::numeric_limits<double>::infinity());
} // namespace shapeton

#endif
