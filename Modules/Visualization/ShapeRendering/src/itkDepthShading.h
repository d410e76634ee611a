#ifndef itkDepthShading_h
#define itkDepthShading_h

#include "itkSurfaceRaster.h"

namespace itk
{
/** Darkens pixels that lie farther away than the mean of their surroundings (Luft, Colditz, Deussen: Image enhancement
 * by unsharp masking the depth buffer, 2006). Pixels without anything opaque take no part. */
void
ShadeByDepth(std::vector<SeenPixel> & pixels,
             unsigned int             width,
             unsigned int             height,
             double                   millimetresPerPixel,
             double                   strength);
} // namespace itk

#endif
