#ifndef itkConformalBarycentre_h
#define itkConformalBarycentre_h

#include "itkSphericalPacking.h"

namespace itk
{
/** Moves the packing so that the touch points of these edges have their centre of mass at the centre of the sphere.
 * Returns the rapidity of the way: what was of size s may have become e^rapidity s, with its errors. Stops where that
 * exceeds `mostRapidity`. */
double
CentrePacking(SphericalPacking & packing, const std::vector<int> & edges, double mostRapidity);
} // namespace itk

#endif
