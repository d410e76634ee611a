#ifndef BestNodes_h
#define BestNodes_h

#include "ReferenceParts.h"

/** Weight of the edge between two face neighbors. The sets that are connected by edges below a limit, for all limits,
 * are the nodes of a tree. */
enum class EdgeWeight
{
  NegativeMinimum, ///< max-tree: components of {value >= t}
  Maximum,         ///< min-tree: components of {value <= t}
  Difference       ///< quasi-flat zones
};

/** Best Dice of each part with a node of a tree of at least 64 voxels. Equal weights are merged one by one, and all
 * intermediate sets count as nodes. */
std::vector<double>
BestNodes(const float * values, EdgeWeight weight, const ReferenceParts & parts);

#endif
