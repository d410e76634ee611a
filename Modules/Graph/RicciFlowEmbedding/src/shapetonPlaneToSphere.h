#ifndef shapetonPlaneToSphere_h
#define shapetonPlaneToSphere_h

#include "shapetonCirclePacking.h"
#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** \name Converts packings of the plane and of the Poincare disk to packings of the sphere.
 * The circle of `root`, a finite node, becomes the unit circle of the plane, the equator. Everything is computed from
 * this circle, so accuracy is highest there for any circle size. Uses the stereographic projection (6.3.3) of the
 * dissertation. */
///@{
SphericalPacking
PlaneToSphere(const CombinatorialMap & map, const CirclePacking & packing, int root);
/** For a hyperbolic packing whose ideal boundary is the circle of a face. */
SphericalPacking
DiskToSphere(const CombinatorialMap & map,
             const CirclePacking &    packing,
             int                      root,
             int                      boundaryFace,
             PackingPrecision         precision);
///@}

/** A circle (x, y, t + n, t - n): in the plane center / radius, (|center|^2 - radius^2) / radius and 1 / radius.
 * Scaling multiplies these by 1, scale and 1 / scale, without loss. */
template <typename TReal>
std::array<TReal, 4>
FromScaled(TReal x, TReal y, TReal sum, TReal difference, TReal scale)
{
  return { x, y, (sum * scale - difference / scale) / 2, (sum * scale + difference / scale) / 2 };
}

/** The image of a point of the plane. */
inline std::array<double, 3>
PointOnSphere(double x, double y)
{
  const double square = x * x + y * y;
  return { 2.0 * x / (1.0 + square), 2.0 * y / (1.0 + square), (square - 1.0) / (square + 1.0) };
}
} // namespace shapeton

#endif
