#ifndef GraphStability_h
#define GraphStability_h

#include "shapetonGraph.h"

/** Displacement of nodes when a few edges change. Lengths are in radii of the sphere or of the layout (the root mean
 * square distance of its nodes from their center). */
struct GraphStability
{
  int    unchangedNodes{ 0 };
  double moebius{ 0.0 };  ///< mean displacement after the best Moebius transformation, as in DynamicGraph
  double rotation{ 0.0 }; ///< mean displacement after the best rotation
  double sfdp{ -1.0 };    ///< force layout, after the best similarity; negative if not installed
};

/** Two steps of a graph. Each lacks a different set of `edits` / 2 edges, evenly spaced in the edge list, so edits /
 * 2 edges disappear and as many appear. */
GraphStability
MeasureStability(const shapeton::Graph & graph, int edits, bool withSfdp);

#endif
