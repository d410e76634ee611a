#ifndef shapetonFlatRaster_h
#define shapetonFlatRaster_h

#include "shapetonSurfaceMesh.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** Vertex coordinates snapped to fractions of a pixel, so shared edges are identical for both faces. */
struct SnappedMap
{
  static constexpr int          bits = 14;
  static constexpr std::int64_t unit = std::int64_t{ 1 } << bits; ///< a pixel
  std::vector<std::int64_t>     u;
  std::vector<std::int64_t>     v;
};

/** Snaps the vertices. Copies of one vertex along the cut, which differ in v by whole turns, differ by exact multiples
 * of the rows. A copy that is elsewhere keeps its own place. */
SnappedMap
SnapMap(const Eigen::MatrixX2d & uv, const std::vector<int> & sourceOfVertex, double pixelSize, int rows);

/** The face of each pixel, row by row, -1 outside all faces; v is taken modulo the rows. Faces whose sign of area is
 * `sign` have priority, then the lower index. */
std::vector<int>
RasterizeFaces(const SnappedMap & map, const FaceMatrix & faces, int columns, int rows, int sign);
} // namespace shapeton

#endif
