#ifndef shapetonPolygonTriangulation_h
#define shapetonPolygonTriangulation_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
{
/** Triangulates a simple, nearly planar polygon (convex or not) by ear clipping, starting with the ear whose smallest
 * angle is largest. Returns corners.size() - 2 triangles of indices into `corners`, in the direction of the polygon. If
 * no ear remains (a self-intersecting polygon), the rest becomes a fan. */
std::vector<std::array<int, 3>>
TriangulatePolygon(const std::vector<Eigen::Vector3d> & corners);
} // namespace shapeton

#endif
