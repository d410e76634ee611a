#ifndef shapetonGenusGenetic_h
#define shapetonGenusGenetic_h

#include "shapetonGraph.h"
#include "shapetonPhiloxStream.h"

#include <functional>
#include <vector>

namespace shapeton
{
/** The genetic algorithm of section 6.3.1, for a connected graph: a population of rotation systems with random orders;
 * a child takes the order of each node from one of two parents that won a tournament; then the orders of some nodes
 * that lie several times in a face are changed; it replaces the worst one when it has no fewer faces. Returns the
 * half-edge after each one of the best after so many children. \ingroup GraphGenus */
std::vector<int>
SearchGenetically(const Graph &                 graph,
                  PhiloxStream                  random,
                  std::int64_t                  children,
                  const std::function<bool()> & isInVain);
} // namespace shapeton

#endif
