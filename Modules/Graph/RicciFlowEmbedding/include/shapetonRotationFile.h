#ifndef shapetonRotationFile_h
#define shapetonRotationFile_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <string>

namespace shapeton
{
/** Reads a rotation system of a graph: from a certificate of the same graph (.json), or from text with one line for
 * each node that has edges, its name and then the names of its neighbours, counter-clockwise, in blanks; a colon after
 * the first name and lines that begin with # are passed over. The text needs a graph without loops and multiple edges;
 * a certificate does not.
 *
 * Throws InputError that names the file, the line, and what is wrong: a name that is no node, a node with two lines or
 * none, neighbours that are not those of the graph. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT CombinatorialMap
ReadRotation(const Graph & graph, const std::string & path);
} // namespace shapeton

#endif
