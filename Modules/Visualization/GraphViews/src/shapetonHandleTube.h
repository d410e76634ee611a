#ifndef shapetonHandleTube_h
#define shapetonHandleTube_h

#include "shapetonSphereWithHoles.h"

namespace shapeton
{
/** A round cross section of a tube: center + radius (cos(angle) first + sin(angle) second). */
struct TubeSection
{
  Eigen::Vector3d
  At(double angle) const
  {
    return center + radius * (std::cos(angle) * first + std::sin(angle) * second);
  }
  /** Angle of a point of the circle. */
  double
  AngleOf(const Eigen::Vector3d & point) const
  {
    return std::atan2((point - center).dot(second), (point - center).dot(first));
  }

  Eigen::Vector3d center;
  Eigen::Vector3d first;
  Eigen::Vector3d second; ///< first, second and the direction of the tube are right-handed
  double          radius;
};

/** \brief A tube outside the unit sphere from the rim of one hole to the rim of another.
 *
 * It rises radially from both holes as chimneys that narrow to `radius`, and bends from one to the other in the plane
 * of their axes, `lift` higher than the chimneys. */
struct HandleTube
{
  /** Sections from the first hole to the second, including both rims. */
  std::vector<TubeSection>
  Sections() const;

  SphereHole start;
  SphereHole end;
  double     radius;
  double     lift;
};

/** Disjoint tubes for pairs of holes. Tubes that would intersect use different heights; if this fails, all become
 * thinner. Throws InputError if no arrangement is found. */
std::vector<HandleTube>
PlaceTubes(const std::vector<std::array<SphereHole, 2>> & pairs);
} // namespace shapeton

#endif
