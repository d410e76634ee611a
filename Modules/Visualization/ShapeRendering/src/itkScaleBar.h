#ifndef itkScaleBar_h
#define itkScaleBar_h

#include "itkPicture.h"

namespace itk
{
/** Draws a bar of a round number of millimetres, at most `greatestLength` pixels long, with its lower left corner at
 * (left, bottom), and its length above it. */
void
DrawScaleBar(Picture *        picture,
             int              left,
             int              bottom,
             int              greatestLength,
             double           millimetresPerPixel,
             const RGBColor & color);
} // namespace itk

#endif
