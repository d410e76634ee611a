#ifndef itkSurfaceRaster_h
#define itkSurfaceRaster_h

#include "itkScreenPart.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** What is seen in a pixel, before the background. */
struct SeenPixel
{
  float color[3]{ 0.0F, 0.0F, 0.0F }; ///< 0 to 255, times its coverage
  float coverage{ 0.0F };             ///< 0 to 1
  float depth{ 0.0F };                ///< mm, mean of the samples below
  float solid{ 0.0F };                ///< share of samples of opaque parts with depth shading
};

/** Draws all parts, opaque and see-through, into width x height pixels. The picture is cut into bands of rows, each is
 * drawn by one thread, and each sample meets the faces in their order: the bytes do not depend on the threads. */
std::vector<SeenPixel>
RasterizeParts(const std::vector<ScreenPart> & parts, unsigned int width, unsigned int height);
} // namespace itk

#endif
