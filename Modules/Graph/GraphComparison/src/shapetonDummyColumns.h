#ifndef shapetonDummyColumns_h
#define shapetonDummyColumns_h

#include "shapetonParallelEdges.h"

namespace shapeton
{
/** Replaces each marked edge by a column of dummies between its ends, which then hardly move: without the edge, the
 * circles of its ends do not touch, but the many small circles between them keep them close. Edges that are paths along
 * dummies are only deleted. */
PackedGraph
WithColumns(const Graph & graph, const PackedMap & packed, const std::vector<char> & isDeleted);
} // namespace shapeton

#endif
