#ifndef itkSampleComposition_h
#define itkSampleComposition_h

#include "itkDepthShading.h"

namespace itk
{
/** The mean of the samples of each pixel over the background. */
void
ComposeSamples(Picture *                       picture,
               const std::vector<SeenSample> & samples,
               const DepthShading &            shading,
               const RGBColor &                background);
} // namespace itk

#endif
