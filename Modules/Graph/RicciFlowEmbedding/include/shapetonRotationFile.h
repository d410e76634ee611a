#ifndef shapetonRotationFile_h
#define shapetonRotationFile_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <string>

namespace shapeton
{
/** Reads a rotation system of a graph, either from a certificate of the same graph (.json) or from text. The text
 * contains one line for each node with edges: its name and the names of its neighbors, counter-clockwise, separated by
 * blanks. A colon after the first name and lines that start with # are ignored. The text format requires a graph
 * without loops and multiple edges; a certificate does not.
 *
 * Throws InputError with the file, the line and the error: an unknown name, a repeated or missing node, or neighbors
 * that differ from the graph. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT CombinatorialMap
ReadRotation(const Graph & graph, const std::string & path);
} // namespace shapeton

#endif
