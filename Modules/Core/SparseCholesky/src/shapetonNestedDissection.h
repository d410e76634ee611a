#ifndef shapetonNestedDissection_h
#define shapetonNestedDissection_h

#include "SparseCholeskyExport.h"

#include <array>
#include <vector>

namespace shapeton
{
/** An order of elimination of a graph with little fill: nested dissection (METIS). Element i is the vertex that is
 * eliminated as number i. The edges name each pair of different vertices once. The same graph gives the same order:
 * METIS takes its random numbers from std::rand(), which is seeded for it and left changed; calls take turns, and
 * nobody else should call it meanwhile. */
SparseCholesky_EXPORT std::vector<int>
                      NestedDissection(int numberOfVertices, const std::vector<std::array<int, 2>> & edges);
} // namespace shapeton

#endif
