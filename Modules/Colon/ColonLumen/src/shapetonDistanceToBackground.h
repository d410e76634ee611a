#ifndef shapetonDistanceToBackground_h
#define shapetonDistanceToBackground_h

#include "shapetonColonVolume.h"

namespace shapeton
{
/** SquaredDistances() of a mask on a working grid. */
std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask);
} // namespace shapeton

#endif
