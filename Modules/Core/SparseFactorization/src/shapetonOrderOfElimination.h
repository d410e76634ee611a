#ifndef shapetonOrderOfElimination_h
#define shapetonOrderOfElimination_h

#include "shapetonSymbolicFactorization.h"

namespace shapeton
{
/** A fill-reducing elimination order of a graph. Element i is the i-th eliminated vertex. Edges list each pair of
 * different vertices once. Deterministic. */
std::vector<int>
OrderOfElimination(int numberOfVertices, const std::vector<std::array<int, 2>> & edges, EliminationOrder order);
} // namespace shapeton

#endif
