#ifndef shapetonPublishedFlexures_h
#define shapetonPublishedFlexures_h

#include "shapetonCenterlineShape.h"

#include <array>

namespace shapeton
{
/** Finds flexures by the rule of the dissertation, 4.2.2. Returns point indices from the rectosigmoid to the hepatic
 * flexure; -1 if not found. Only the order of the two upper flexures is checked. */
std::array<int, 4>
PublishedFlexures(const CenterlineShape & shape);
} // namespace shapeton

#endif
