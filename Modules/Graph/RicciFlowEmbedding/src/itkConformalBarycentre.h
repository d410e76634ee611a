#ifndef itkConformalBarycentre_h
#define itkConformalBarycentre_h

#include "itkSphericalPacking.h"

namespace itk
{
/** Moves the packing so that the touch points of these edges have their centre of mass at the centre of the sphere. */
void
CentrePacking(SphericalPacking & packing, const std::vector<int> & edges);
} // namespace itk

#endif
