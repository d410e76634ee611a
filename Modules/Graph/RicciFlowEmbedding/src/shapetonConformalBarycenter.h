#ifndef shapetonConformalBarycenter_h
#define shapetonConformalBarycenter_h

#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** Moves the center of mass of the touch points of these edges to the center of the sphere. Returns the rapidity of the
 * motion: it may scale lengths, and their errors, by up to e^rapidity. Stops if it exceeds `mostRapidity`. */
double
CenterPacking(SphericalPacking & packing, const std::vector<int> & edges, double mostRapidity);

/** The same for the least sum of the fourth roots of cot(angle / 2) over the caps of nodes marked in `isVisible`. With
 * d the distance from the ball center to the hyperbolic plane bounded by the circle, these are e^(d / 4), and d is
 * convex if the cap is at most a hemisphere. */
double
EnlargeSmallCaps(SphericalPacking & packing, const std::vector<char> & isVisible, double mostRapidity);
} // namespace shapeton

#endif
