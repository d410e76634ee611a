#ifndef itkPublishedFlexures_h
#define itkPublishedFlexures_h

#include "itkCentrelineShape.h"

#include <array>

namespace itk
{
/** The rule of the dissertation, 4.2.2: indices into the shape, from the rectosigmoid to the hepatic flexure; -1 where
 * it has none. Not checked for their order but for that of the two upper ones. */
std::array<int, 4>
PublishedFlexures(const CentrelineShape & shape);
} // namespace itk

#endif
