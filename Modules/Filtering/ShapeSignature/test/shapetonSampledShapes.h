#ifndef shapetonSampledShapes_h
#define shapetonSampledShapes_h

#include "shapetonLabelShapes.h"
#include "shapetonPi.h"
#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <functional>

namespace signaturetest
{
using Solid = std::function<bool(const Eigen::Vector3d &)>; // in mm from the center of the image
using Image = shapeton::LabelMap;

/** An empty image centered at the origin. */
inline Image::Pointer
MakeImage(const std::array<int, 3> &    size,
          const std::array<double, 3> & spacing = { 1.0, 1.0, 1.0 },
          const Eigen::Matrix3d &       direction = Eigen::Matrix3d::Identity())
{
  const Eigen::Vector3d distances(spacing.data());
  const Eigen::Vector3d middle = 0.5 * distances.cwiseProduct(Eigen::Vector3d(size[0] - 1, size[1] - 1, size[2] - 1));
  Image::SizeType       voxels;
  std::copy(size.begin(), size.end(), voxels.begin());
  return basetest::NewImageInFrame<Image>(voxels, distances, -direction * middle, direction);
}

/** Labels the voxels whose center is in the solid. */
inline void
Draw(Image * image, const Solid & solid, float label = 1.0F)
{
  basetest::ForVoxels(image, [&](const itk::Index<3> & index, const auto & point) {
    image->SetPixel(index, solid(basetest::ToEigen(point)) ? label : image->GetPixel(index));
  });
}

inline Solid
Ball(double radius, const Eigen::Vector3d & center = Eigen::Vector3d::Zero())
{
  return [=](const Eigen::Vector3d & p) { return (p - center).norm() <= radius; };
}

inline Solid
Box(const Eigen::Vector3d & sides)
{
  return [=](const Eigen::Vector3d & p) { return (2.0 * p.cwiseAbs() - sides).maxCoeff() <= 0.0; };
}

inline Solid
Scaled(const Solid & solid, double scale)
{
  return [=](const Eigen::Vector3d & p) { return solid(p / scale); };
}

inline Solid
Turned(const Solid & solid, double degrees, const Eigen::Vector3d & axis)
{
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-degrees * shapeton::Pi / 180.0, axis.normalized()).toRotationMatrix();
  return [=](const Eigen::Vector3d & p) { return solid(back * p); };
}

/** An asymmetric solid: a block with a rod and a knob at its end. Equivalent ball radius: 11 mm. */
inline Solid
Hammer()
{
  return [](const Eigen::Vector3d & p) {
    const Eigen::Vector3d q = Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.6, 0.0, 0.8)) * p; // oblique
    const bool            isBlock = std::abs(q[0]) <= 14.0 && std::abs(q[1]) <= 7.0 && std::abs(q[2] + 10.0) <= 5.5;
    const bool            isRod = std::hypot(q[0] - 4.0, q[1] - 1.0) <= 4.0 && q[2] >= -10.0 && q[2] <= 14.0;
    return isBlock || isRod || (q - Eigen::Vector3d(5.0, 2.0, 14.0)).norm() <= 5.5;
  };
}
} // namespace signaturetest

#endif
