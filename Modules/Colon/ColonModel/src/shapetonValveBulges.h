#ifndef shapetonValveBulges_h
#define shapetonValveBulges_h

#include "shapetonCecalRegion.h"

#include <limits>

namespace shapeton
{
/** A thick part of the wall that bulges into the lumen on all sides. */
struct ValveBulge
{
  /** Center of its surface, LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** Unit vector into the lumen. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** Distance before the end of the line, mm. */
  double beforeEnd{ 0.0 };
  /** Area, mm^2. */
  double area{ 0.0 };
  /** Integral of the Gaussian curvature, sr: 2 pi for half an ellipsoid of any flatness. */
  double solidAngle{ 0.0 };
  /** Greatest and least width across the axis, mm. */
  double length{ 0.0 };
  double width{ 0.0 };
  /** Median HU inside, at least 2 mm from the lumen and at most half of the width deep; NaN without such voxels or a
   * CT. */
  double attenuation{ std::numeric_limits<double>::quiet_NaN() };
};

/** Finds the bulges of the wall within the reach of the region. The wall is the half level of the lumen smoothed by a
 * Gaussian of 3 mm: structures thinner than 4 mm, such as folds, vanish, and a valve remains. */
std::vector<ValveBulge>
FindValveBulges(const CecalRegion & region);
} // namespace shapeton

#endif
