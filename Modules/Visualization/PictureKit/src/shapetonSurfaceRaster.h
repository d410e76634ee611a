#ifndef shapetonSurfaceRaster_h
#define shapetonSurfaceRaster_h

#include "shapetonScreenPart.h"

#include <limits>
#include <vector>

namespace shapeton
{
/** Visible color and coverage of a sample, before the background. */
struct SeenSample
{
  unsigned char color[3]{ 0, 0, 0 }; ///< premultiplied by coverage
  unsigned char coverage{ 0 };       ///< 255 is full coverage
  /** Depth of an opaque part with depth shading, mm; infinite for none. */
  float depth{ std::numeric_limits<float>::infinity() };
};

/** Draws all opaque and transparent parts into width x height pixels; returns rows of samples. The picture is divided
 * into bands of rows, one thread per band, and each sample processes the faces in order, so the bytes do not depend on
 * the number of threads. */
std::vector<SeenSample>
RasterizeParts(const std::vector<ScreenPart> & parts, unsigned int width, unsigned int height);
} // namespace shapeton

#endif
