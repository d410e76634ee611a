#ifndef shapetonRefluxedIleum_h
#define shapetonRefluxedIleum_h

#include "shapetonColonAnatomy.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** Distance (mm) between points of the axis of the ileum. */
constexpr double ileumAxisStep = 2.0;

/** Distance (mm) above the mouth at which the axis starts, to connect an open ileum to the colon. */
constexpr double ileumIntoColon = 1.5;

/** The axis of a long ileum that winds through the abdomen, from just inside the mouth of the valve.
 *
 * The seed determines the ileum at rest. In each position, the displaced colon pushes it aside. It is the same piece of
 * ileum in all positions. It ends where there is no room for it in supine or prone position, so it may be shorter than
 * the parameter ileumLength. */
std::vector<Eigen::Vector3d>
RefluxedIleumAxis(const ColonAnatomy & anatomy);
} // namespace shapeton

#endif
