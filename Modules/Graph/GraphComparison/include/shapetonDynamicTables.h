#ifndef shapetonDynamicTables_h
#define shapetonDynamicTables_h

#include "shapetonCsvTable.h"
#include "shapetonDynamicEmbedding.h"
#include "shapetonJsonForward.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A sequence of embedded graphs and their file names. \ingroup ShapetonGraphComparison */
struct DynamicSequence
{
  std::vector<std::string> files;
  std::vector<DynamicStep> steps;
};

/** One row for each step: step, file, nodes, edges, addedNodes, removedNodes, addedEdges, removedEdges, changedNodes,
 * genus, embeddedAnew (0 or 1), meanDisplacement, largestDisplacement (radians; empty for the first step and on
 * surfaces other than the sphere), smallestRadius of a circle of the graph. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT CsvTable
TableOfSteps(const DynamicSequence & sequence);

/** One row for each step and each of these nodes: step, file, node, present (0 or 1), x, y, z (z is set on the sphere
 * only), radius, degree, neighbors (names, separated by spaces). Throws ParameterError if a name does not occur in
 * any step. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT CsvTable
TableOfTrackedNodes(const DynamicSequence & sequence, const std::vector<std::string> & names);

/** JSON with `steps` (the changes of each step, by node names) and `stability` (mean and largest displacement over all
 * steps, number of steps embedded anew). \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT Json
SequenceToJson(const DynamicSequence & sequence);
} // namespace shapeton

#endif
