#ifndef shapetonSampledShapes_h
#define shapetonSampledShapes_h

#include "shapetonLabelShapes.h"

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
  const auto           image = Image::New();
  Image::SizeType      voxels;
  Image::SpacingType   distances;
  Image::DirectionType cosines;
  Eigen::Vector3d      middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels[axis] = size[axis];
    distances[axis] = spacing[axis];
    middle[axis] = 0.5 * (size[axis] - 1) * spacing[axis];
    for (int column = 0; column < 3; ++column)
    {
      cosines(axis, column) = direction(axis, column);
    }
  }
  const Eigen::Vector3d first = -direction * middle;
  image->SetRegions(voxels);
  image->SetSpacing(distances);
  image->SetDirection(cosines);
  image->SetOrigin(itk::Point<double, 3>(first.data()));
  image->Allocate(true);
  return image;
}

/** Labels the voxels whose center is in the solid. */
inline void
Draw(Image * image, const Solid & solid, float label = 1.0F)
{
  const auto size = image->GetBufferedRegion().GetSize();
  float *    value = image->GetBufferPointer();
  for (itk::IndexValueType k = 0; k < static_cast<itk::IndexValueType>(size[2]); ++k)
  {
    for (itk::IndexValueType j = 0; j < static_cast<itk::IndexValueType>(size[1]); ++j)
    {
      for (itk::IndexValueType i = 0; i < static_cast<itk::IndexValueType>(size[0]); ++i, ++value)
      {
        itk::Point<double, 3> point;
        image->TransformIndexToPhysicalPoint(itk::Index<3>{ { i, j, k } }, point);
        *value = solid(Eigen::Vector3d(point[0], point[1], point[2])) ? label : *value;
      }
    }
  }
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
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-degrees * M_PI / 180.0, axis.normalized()).toRotationMatrix();
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
