#ifndef shapetonExactOrientation_h
#define shapetonExactOrientation_h

#include "ShapetonConformalFlatteningExport.h"

#include <Eigen/Core>

namespace shapeton
{
/** Exact orientation of a triangle in the plane: 1 if a, b, c are counterclockwise, -1 if clockwise, 0 if collinear. A
 * floating-point filter decides most cases; otherwise the six products are summed as expansions (Shewchuk, Adaptive
 * precision floating-point arithmetic and fast robust geometric predicates, 1997). \pre Products of coordinates
 * neither overflow nor underflow: nonzero products are between 1e-140 and 1e150. \ingroup ShapetonConformalFlattening
 */
ShapetonConformalFlattening_EXPORT int
ExactOrientation(const Eigen::RowVector2d & a, const Eigen::RowVector2d & b, const Eigen::RowVector2d & c);
} // namespace shapeton

#endif
