#ifndef shapetonColonDistance_h
#define shapetonColonDistance_h

#include <Eigen/Core>

namespace shapeton
{
/** A distance and the direction in which it grows. */
struct ColonDistance
{
  double          value; ///< mm, positive in the lumen
  Eigen::Vector3d gradient;
};

/** From a ball, positive outside. */
ColonDistance
SphereDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & centre, double radius);

/** From all that is within `radius` of a straight piece, positive outside. */
ColonDistance
CapsuleDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & from, const Eigen::Vector3d & to, double radius);

/** The nearer of two bodies of tissue, with a round fillet in the corner between them. */
ColonDistance
JoinTissue(const ColonDistance & a, const ColonDistance & b, double fillet);
} // namespace shapeton

#endif
