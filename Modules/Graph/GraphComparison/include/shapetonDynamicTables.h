#ifndef shapetonDynamicTables_h
#define shapetonDynamicTables_h

#include "shapetonCsvTable.h"
#include "shapetonDynamicEmbedding.h"
#include "shapetonJsonForward.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A sequence of embedded graphs and the names of the files it was read from. \ingroup GraphComparison */
struct DynamicSequence
{
  std::vector<std::string> files;
  std::vector<DynamicStep> steps;
};

/** One row for each step: step, file, nodes, edges, addedNodes, removedNodes, addedEdges, removedEdges, changedNodes,
 * genus, embeddedAnew (0 or 1), meanDisplacement, largestDisplacement (radians; empty for the first step and beyond the
 * sphere), smallestRadius of a circle of the graph. \ingroup GraphComparison */
GraphComparison_EXPORT CsvTable
TableOfSteps(const DynamicSequence & sequence);

/** For each step and each of these nodes: step, file, node, present (0 or 1), x, y, z (z is empty beyond the sphere),
 * radius, degree, neighbours (names, separated by spaces). Throws ParameterError for a name that no step has.
 * \ingroup GraphComparison */
GraphComparison_EXPORT CsvTable
TableOfTrackedNodes(const DynamicSequence & sequence, const std::vector<std::string> & names);

/** `steps`, with the changes of each one by names, and `stability`: mean and largest displacement over all steps,
 * steps that were embedded anew. \ingroup GraphComparison */
GraphComparison_EXPORT Json
SequenceToJson(const DynamicSequence & sequence);
} // namespace shapeton

#endif
