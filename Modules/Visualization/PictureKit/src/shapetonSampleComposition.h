#ifndef shapetonSampleComposition_h
#define shapetonSampleComposition_h

#include "shapetonDepthShading.h"

namespace shapeton
{
/** Averages the samples of each pixel over the background. */
void
ComposeSamples(Picture *                       picture,
               const std::vector<SeenSample> & samples,
               const DepthShading &            shading,
               const RGBColor &                background);
} // namespace shapeton

#endif
