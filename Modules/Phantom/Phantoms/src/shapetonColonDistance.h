#ifndef shapetonColonDistance_h
#define shapetonColonDistance_h

#include <Eigen/Core>

namespace shapeton
{
/** A distance (mm) beyond all distances in a phantom. */
constexpr double beyondAll = 1e9;

/** A distance with its gradient direction. */
struct ColonDistance
{
  double          value; ///< mm, positive in the lumen
  Eigen::Vector3d gradient;
};

/** Distance to a ball, positive outside. */
ColonDistance
SphereDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & center, double radius);

/** Distance to a capsule of `radius` around a line segment, positive outside. */
ColonDistance
CapsuleDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & from, const Eigen::Vector3d & to, double radius);

/** Union of two bodies of tissue, with a round fillet in the corner between them. */
ColonDistance
JoinTissue(const ColonDistance & a, const ColonDistance & b, double fillet);
} // namespace shapeton

#endif
