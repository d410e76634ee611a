#ifndef shapetonOrderOfElimination_h
#define shapetonOrderOfElimination_h

#include "shapetonSymbolicFactorisation.h"

namespace shapeton
{
/** An order of elimination of a graph with little fill. Element i is the vertex that is eliminated as number i. The
 * edges name each pair of different vertices once. The same graph gives the same order. */
std::vector<int>
OrderOfElimination(int numberOfVertices, const std::vector<std::array<int, 2>> & edges, EliminationOrder order);
} // namespace shapeton

#endif
