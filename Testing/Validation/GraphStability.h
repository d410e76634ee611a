#ifndef GraphStability_h
#define GraphStability_h

#include "shapetonGraph.h"

/** How far nodes move when a few edges change. Lengths are in radii of the sphere, or of the layout: the root mean
 * square distance of its nodes from their centre. */
struct GraphStability
{
  int    unchangedNodes{ 0 };
  double moebius{
    0.0
  }; ///< mean displacement, the sphere moved by the best Moebius transformation, as DynamicGraph does
  double rotation{ 0.0 }; ///< by the best rotation alone
  double sfdp{ -1.0 };    ///< of the layout by forces, moved by the best similarity; negative: not installed
};

/** Two steps of a graph: both lack `edits` / 2 edges, not the same ones, spread evenly over their list. So edits / 2
 * edges go and as many come. */
GraphStability
MeasureStability(const shapeton::Graph & graph, int edits, bool withSfdp);

#endif
