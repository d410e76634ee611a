#ifndef itkDistanceToBackground_h
#define itkDistanceToBackground_h

#include "itkColonVolume.h"

namespace itk
{
/** SquaredDistances() of a mask on a working grid. */
std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask);
} // namespace itk

#endif
