#ifndef shapetonConformalBarycenter_h
#define shapetonConformalBarycenter_h

#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** Moves the center of mass of the touch points of these edges to the center of the sphere. Returns the rapidity of the
 * motion: lengths and their errors may grow by up to e^rapidity. Stops if it exceeds `mostRapidity`. */
double
CenterPacking(SphericalPacking & packing, const std::vector<int> & edges, double mostRapidity);

/** Minimizes the sum of the fourth roots of cot(angle / 2) over the caps of nodes marked in `isVisible` instead. Each
 * summand is e^(d / 4), where d is the distance from the ball center to the hyperbolic plane bounded by the circle; d
 * is convex if the cap is at most a hemisphere. */
double
EnlargeSmallCaps(SphericalPacking & packing, const std::vector<char> & isVisible, double mostRapidity);
} // namespace shapeton

#endif
