#ifndef shapetonPolypTubes_h
#define shapetonPolypTubes_h

#include "shapetonColonWall.h"
#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <vector>

/** Closed straight lumens along x with a radius of 20 mm and bodies of known shape. */
namespace polyptubes
{
using Eigen::Vector3d;
/** Signed distance (mm) to a body of tissue, to first order; negative inside. */
using Body = std::function<double(const Vector3d &)>;

constexpr double radius = 20.0;
constexpr double halfLength = 28.0;

/** Wall point below the center. */
inline Vector3d
Base(double x)
{
  return { x, 0.0, -radius };
}

/** A half ellipsoid on the lower wall. */
inline Body
Ellipsoid(const Vector3d & middle, double halfWidth, double height)
{
  return [=](const Vector3d & p) {
    const Vector3d scaled = (p - middle).cwiseQuotient(Vector3d(halfWidth, halfWidth, height));
    const Vector3d slope = scaled.cwiseQuotient(Vector3d(halfWidth, halfWidth, height));
    return scaled.norm() * (scaled.norm() - 1.0) / std::max(1e-9, slope.norm());
  };
}

inline Body
Ball(const Vector3d & middle, double ballRadius)
{
  return [=](const Vector3d & p) { return (p - middle).norm() - ballRadius; };
}

/** A rounded plate across the lower half of the tube, 3 mm thick, like a fold. */
inline Body
Plate(double x, double height)
{
  return [=](const Vector3d & p) {
    const double          toCrest = radius - height - std::hypot(p.y(), p.z()); // negative inside the plate
    const double          sideways = std::max(0.0, p.z() + 4.0);
    const Eigen::Vector2d off(p.x() - x, std::max(0.0, toCrest + 1.5));
    return std::hypot(off.norm(), sideways) - 1.5;
  };
}

/** Distance to the wall (mm), positive in the lumen. */
inline double
Distance(const Vector3d & p, const std::vector<Body> & bodies)
{
  double distance = std::min(radius - std::hypot(p.y(), p.z()), halfLength - std::abs(p.x()));
  for (const Body & body : bodies)
  {
    distance = std::min(distance, body(p));
  }
  return distance;
}

template <typename TImage>
typename TImage::Pointer
MakeImage(double spacing, const std::function<double(double)> & valueOfDistance, const std::vector<Body> & bodies)
{
  const Vector3d            half(halfLength + 6.0, radius + 6.0, radius + 6.0);
  typename TImage::SizeType size;
  for (unsigned int k = 0; k < 3; ++k)
  {
    size[k] = static_cast<itk::SizeValueType>(2.0 * half[k] / spacing) + 1;
  }
  const auto image = basetest::NewImageInFrame<TImage>(size, Vector3d::Constant(spacing), -half);
  basetest::Sample(image.GetPointer(),
                   [&](const auto & point) { return valueOfDistance(Distance(basetest::ToEigen(point), bodies)); });
  return image;
}

inline shapeton::SurfaceMesh
MakeWall(const std::vector<Body> & bodies, double spacing = 0.8)
{
  const auto occupancy = MakeImage<shapeton::OccupancyImage>(
    spacing, [=](double d) { return std::min(1.0, std::max(0.0, 0.5 + 0.5 * d / spacing)); }, bodies);
  return shapeton::ExtractWall(occupancy);
}

/** The lumen as gas (1) or fluid (2). */
inline itk::Image<unsigned char, 3>::Pointer
MakeLumen(const std::vector<Body> & bodies, double label = 1.0)
{
  return MakeImage<itk::Image<unsigned char, 3>>(
    0.8, [label](double d) { return d > 0.0 ? label : 0.0; }, bodies);
}
} // namespace polyptubes

#endif
