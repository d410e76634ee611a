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

/** The nearer of two bodies of tissue, with a round fillet in the corner between them. */
ColonDistance
JoinTissue(const ColonDistance & a, const ColonDistance & b, double fillet);
} // namespace shapeton

#endif
