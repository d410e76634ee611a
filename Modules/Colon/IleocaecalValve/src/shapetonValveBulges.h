#ifndef shapetonValveBulges_h
#define shapetonValveBulges_h

#include "shapetonCaecalRegion.h"

#include <limits>

namespace shapeton
{
/** A thick part of the wall that bulges into the lumen on all sides. */
struct ValveBulge
{
  /** Mean of its surface, LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** Into the lumen, of unit length. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** mm before the end of the line. */
  double beforeEnd{ 0.0 };
  /** mm^2. */
  double area{ 0.0 };
  /** Integral of the Gaussian curvature, sr: 2 pi for half an ellipsoid of any flatness. */
  double solidAngle{ 0.0 };
  /** Greatest and least width across the axis, mm. */
  double length{ 0.0 };
  double width{ 0.0 };
  /** Median HU inside, 2 mm and more from the lumen, no deeper than half of the width; not a number where there is no
   * such place, or no CT. */
  double attenuation{ std::numeric_limits<double>::quiet_NaN() };
};

/** The bulges of the wall within the reach of the region. The wall is the half level of the lumen smoothed by a
 * Gaussian of 3 mm: what is thinner than 4 mm, as folds are, is gone, and a valve stays. */
std::vector<ValveBulge>
FindValveBulges(const CaecalRegion & region);
} // namespace shapeton

#endif
