#ifndef shapetonFlatTestCt_h
#define shapetonFlatTestCt_h

#include "shapetonFlatColonStrip.h"
#include "shapetonFlatTestColon.h"
#include "shapetonTestFrames.h"

#include <functional>

/** CTs of the colon of shapetonFlatTestColon.h. */
namespace flatcolon
{
using Ct = itk::Image<float, 3>;

/** CT of the wall: gas inside this radius, soft tissue outside, a boundary of about 1 mm. */
inline float
HuAt(const Eigen::Vector3d & point, double (*radiusAt)(double, double))
{
  const double r = std::hypot(point.x(), point.y());
  const double angle = std::atan2(point.y(), point.x());
  const double share = std::clamp((r - radiusAt(point.z(), angle)) / 1.2 + 0.5, 0.0, 1.0);
  return static_cast<float>(-1000.0 + 1040.0 * share);
}

/** A CT of the colon with these axes. */
inline Ct::Pointer
MakeCt(const Eigen::Matrix3d &                               axes,
       const Eigen::Vector3d &                               spacing,
       const std::function<float(const Eigen::Vector3d &)> & huAt)
{
  constexpr double      reach = 28.0;
  const Eigen::Vector3d center(0.0, 0.0, 0.5 * length);
  const Eigen::Vector3d half = axes.transpose().cwiseAbs() * Eigen::Vector3d(reach, reach, 0.5 * length + 8.0);
  Ct::SizeType          size;
  for (int k = 0; k < 3; ++k)
  {
    size[k] = static_cast<itk::SizeValueType>(2.0 * half[k] / spacing[k]) + 2;
  }
  const auto image = basetest::NewImageInFrame<Ct>(size, spacing, center - axes * half, axes);
  basetest::Sample(image.GetPointer(), [&](const auto & point) { return huAt(basetest::ToEigen(point)); });
  return image;
}

inline Ct::Pointer
MakeStraightCt(const std::function<float(const Eigen::Vector3d &)> & huAt)
{
  return MakeCt(Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.8, 0.8, 1.0), huAt);
}

inline double
SmoothTube(double, double)
{
  return radius;
}

struct Colon
{
  explicit Colon(double (*radiusAt)(double, double), double pixelSize = 1.0)
    : grid(Wall(radiusAt), { pixelSize, 0.0, 0.0 }), axis(MakeFlatColonAxis(grid))
  {}
  shapeton::Picture::Pointer
  Paint(const Ct * ct, const shapeton::FlatVolumeOptions & options = {}, const shapeton::DeviceUse & use = {}) const
  {
    return PaintFlatVolume(grid, axis, ct, options, use);
  }
  shapeton::FlatColonGrid grid;
  shapeton::FlatColonAxis axis;
};
} // namespace flatcolon

#endif
