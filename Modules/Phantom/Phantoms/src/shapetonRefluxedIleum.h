#ifndef shapetonRefluxedIleum_h
#define shapetonRefluxedIleum_h

#include "shapetonColonAnatomy.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** Distance (mm) between points of the axis of the ileum. */
constexpr double ileumAxisStep = 2.0;

/** Start (mm) of the axis above the mouth, to connect an open ileum to the colon. */
constexpr double ileumIntoColon = 1.5;

/** The axis of a long ileum that winds through the abdomen, from just inside the mouth of the valve.
 *
 * The seed determines the ileum at rest. In a position, the moved colon pushes it aside. It is the same piece of ileum
 * in all positions, cut off where it lacks room in supine or prone position, so it may be shorter than the parameter
 * ileumLength. */
std::vector<Eigen::Vector3d>
RefluxedIleumAxis(const ColonAnatomy & anatomy);
} // namespace shapeton

#endif
