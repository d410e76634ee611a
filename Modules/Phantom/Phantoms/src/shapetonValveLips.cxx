#include "shapetonValveLips.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr double c_Fillet = 1.0;      // mm, at the bottom of the cleft
constexpr double c_MiddleShare = 0.4; // distance of the center of a lip from the mouth, relative to the lip thickness
} // namespace

Vector3d
ValveLips::Middle(int side) const
{
  return base + side * c_MiddleShare * thickness * across;
}

Vector3d
ValveLips::Crest(int side) const
{
  return this->Middle(side) + height * axis;
}

// Ellipsoids centered on the wall, first-order accurate near their surface.
ColonDistance
ValveLips::Distance(const Vector3d & point) const
{
  const auto lip = [&](int side) {
    const Vector3d off = point - this->Middle(side);
    const Vector3d radii(0.5 * length, 0.5 * thickness, height);
    const Vector3d at(off.dot(slit), off.dot(across), off.dot(axis));
    const Vector3d scaled = at.cwiseQuotient(radii);
    const double   k = std::max(scaled.norm(), 1e-6);
    const Vector3d slope = scaled.cwiseQuotient(radii) / k;
    const double   size = std::max(slope.norm(), 1e-9);
    return ColonDistance{ (k - 1.0) / size, (slope[0] * slit + slope[1] * across + slope[2] * axis) / size };
  };
  return JoinTissue(lip(1), lip(-1), c_Fillet);
}

double
ValveLips::MouthHeight() const
{
  constexpr double above = 1.5; // lip heights, in the lumen
  double           inside = 0.0;
  double           outside = above * height;
  for (int round = 0; round < 50; ++round)
  {
    const double middle = 0.5 * (inside + outside);
    (this->Distance(base + middle * axis).value > 0 ? outside : inside) = middle;
  }
  return outside;
}
} // namespace shapeton
