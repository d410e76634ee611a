#ifndef shapetonSurfaceRaster_h
#define shapetonSurfaceRaster_h

#include "shapetonScreenPart.h"

#include <limits>
#include <vector>

namespace shapeton
{
/** What is seen in a sample, before the background. */
struct SeenSample
{
  unsigned char color[3]{ 0, 0, 0 }; ///< times its coverage
  unsigned char coverage{ 0 };       ///< 255 for all
  /** Of an opaque part with depth shading, mm; infinite for none. */
  float depth{ std::numeric_limits<float>::infinity() };
};

/** Draws all parts, opaque and see-through, into width x height pixels; returns rows of samples. The picture is cut
 * into bands of rows, each is drawn by one thread, and each sample meets the faces in their order: the bytes do not
 * depend on the threads. */
std::vector<SeenSample>
RasterizeParts(const std::vector<ScreenPart> & parts, unsigned int width, unsigned int height);
} // namespace shapeton

#endif
