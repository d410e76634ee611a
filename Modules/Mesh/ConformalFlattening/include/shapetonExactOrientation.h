#ifndef shapetonExactOrientation_h
#define shapetonExactOrientation_h

#include "ConformalFlatteningExport.h"

#include <Eigen/Core>

namespace shapeton
{
/** The sign of twice the area of a triangle in the plane: 1 where a, b, c are counterclockwise, -1 where clockwise, 0
 * where they lie on one line. It is that of the numbers as they are, without rounding: a bound of the error decides
 * where it can, else the six products are summed as expansions (Shewchuk, Adaptive precision floating-point arithmetic
 * and fast robust geometric predicates, 1997). \pre Products of coordinates neither overflow nor underflow: those that
 * are not 0 lie between 1e-140 and 1e150. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT int
ExactOrientation(const Eigen::RowVector2d & a, const Eigen::RowVector2d & b, const Eigen::RowVector2d & c);
} // namespace shapeton

#endif
