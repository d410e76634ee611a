#ifndef shapetonPolygonTriangulation_h
#define shapetonPolygonTriangulation_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
{
/** Cuts a simple polygon, convex or not and nearly plane, into triangles of its corners by cutting ears, the one with
 * the largest smallest angle first. Gives corners.size() - 2 triangles of indices into `corners`, in the direction of
 * the polygon; where no ear is left (a polygon that crosses itself) a fan of the rest. */
std::vector<std::array<int, 3>>
TriangulatePolygon(const std::vector<Eigen::Vector3d> & corners);
} // namespace shapeton

#endif
