#ifndef shapetonFlatRaster_h
#define shapetonFlatRaster_h

#include "shapetonSurfaceMesh.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** Vertex coordinates snapped to fractions of a pixel, so that shared edges are identical for both faces. */
struct SnappedMap
{
  static constexpr int          bits = 14; ///< chosen: products of coordinates up to 2^16 pixels fit into 64 bits
  static constexpr std::int64_t unit = std::int64_t{ 1 } << bits; ///< a pixel
  std::vector<std::int64_t>     u;
  std::vector<std::int64_t>     v;
};

/** Snaps the vertices. After snapping, duplicates along the cut whose v differs by whole turns differ by exact
 * multiples of the number of rows. Other duplicates are snapped independently. */
SnappedMap
SnapMap(const Eigen::MatrixX2d & uv, const std::vector<int> & sourceOfVertex, double pixelSize, int rows);

/** The face of each pixel in row-major order, -1 outside all faces; v is taken modulo the rows. Faces whose area has
 * the sign `sign` have priority, then lower indices. */
std::vector<int>
RasterizeFaces(const SnappedMap & map, const FaceMatrix & faces, int columns, int rows, int sign);
} // namespace shapeton

#endif
