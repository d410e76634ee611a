#ifndef shapetonConformalBarycentre_h
#define shapetonConformalBarycentre_h

#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** Moves the packing so that the touch points of these edges have their centre of mass at the centre of the sphere.
 * Returns the rapidity of the way: what was of size s may have become e^rapidity s, with its errors. Stops where that
 * exceeds `mostRapidity`. */
double
CentrePacking(SphericalPacking & packing, const std::vector<int> & edges, double mostRapidity);

/** The same for the least sum of the fourth roots of cot(angle / 2) over the caps of the nodes that `isVisible` marks.
 * With the distance d from the centre of the ball to the plane of hyperbolic space that the circle bounds these are
 * e^(d / 4), and d is convex where the cap is no more than a hemisphere. */
double
EnlargeSmallCaps(SphericalPacking & packing, const std::vector<char> & isVisible, double mostRapidity);
} // namespace shapeton

#endif
