#ifndef shapetonValveBulges_h
#define shapetonValveBulges_h

#include "shapetonCecalRegion.h"

#include <limits>

namespace shapeton
{
/** A thick part of the wall that is convex toward the lumen in all directions. */
struct ValveBulge
{
  /** Center of its surface, LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** Unit vector into the lumen. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** Distance to the end of the line, mm. */
  double beforeEnd{ 0.0 };
  /** Area, mm^2. */
  double area{ 0.0 };
  /** Integral of the Gaussian curvature, sr; 2 pi for any half ellipsoid. */
  double solidAngle{ 0.0 };
  /** Maximum and minimum width perpendicular to the axis, mm. */
  double length{ 0.0 };
  double width{ 0.0 };
  /** Median HU inside, at least 2 mm from the lumen and at most half the width deep; NaN if there are no such voxels or
   * there is no CT. */
  double attenuation{ std::numeric_limits<double>::quiet_NaN() };
};

/** Finds the bulges of the wall within Reach of the region. The wall is the 0.5 level of the lumen after smoothing by a
 * Gaussian of 3 mm, which removes structures thinner than 4 mm, such as folds, but not a valve. */
std::vector<ValveBulge>
FindValveBulges(const CecalRegion & region);
} // namespace shapeton

#endif
