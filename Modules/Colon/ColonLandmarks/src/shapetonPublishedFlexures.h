#ifndef shapetonPublishedFlexures_h
#define shapetonPublishedFlexures_h

#include "shapetonCenterlineShape.h"

#include <array>

namespace shapeton
{
/** The rule of the dissertation, 4.2.2: indices into the shape, from the rectosigmoid to the hepatic flexure; -1 if not
 * found. The order is checked only for the two upper ones. */
std::array<int, 4>
PublishedFlexures(const CenterlineShape & shape);
} // namespace shapeton

#endif
