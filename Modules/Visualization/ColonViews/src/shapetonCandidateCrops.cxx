#include "shapetonCandidateCrops.h"

#include "shapetonParallelFor.h"

#include "itkLinearInterpolateImageFunction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

/** Width of a crop (mm): the head with its surroundings. */
double
WidthOf(const PolypCandidate & candidate)
{
  constexpr double least = 60.0, timesHead = 2.5;
  return std::max(least, timesHead * std::max(candidate.diameter, candidate.height));
}

Vector3d
AxisOf(const itk::ImageBase<3> * volume, unsigned int axis, bool isReversed)
{
  const auto & direction = volume->GetDirection();
  const double sign = isReversed ? -1.0 : 1.0;
  return { sign * direction[0][axis], sign * direction[1][axis], sign * direction[2][axis] };
}

CandidatePlane
AnatomicPlane(const itk::ImageBase<3> * volume, SlicePlane kind, const PolypCandidate & candidate)
{
  const SliceAxes axes = AxesOf(volume, kind);
  const auto      index = volume->TransformPhysicalPointToIndex(itk::Point<double, 3>(candidate.position.data()));
  const auto &    region = volume->GetLargestPossibleRegion();
  CandidatePlane  plane;
  plane.title = NameOf(kind) + ", slice " + std::to_string(index[axes.through] - region.GetIndex(axes.through) + 1) +
                " of " + std::to_string(region.GetSize(axes.through));
  plane.title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(plane.title[0])));
  plane.center = candidate.position;
  plane.right = AxisOf(volume, axes.across, axes.isAcrossReversed);
  plane.up = -AxisOf(volume, axes.down, axes.isDownReversed);
  plane.width = WidthOf(candidate);
  return plane;
}

/** Direction from the head to the wall around it, perpendicular to the axis: toward the foot of a bent stalk. */
Vector3d
TowardFoot(const SurfaceMesh & wall, const PolypCandidate & candidate)
{
  const double radius = 0.5 * std::max(candidate.diameter, candidate.height);
  const double reach = 3.0 * radius;
  Vector3d     sum = Vector3d::Zero();
  double       weights = 0.0;
  for (Eigen::Index i = 0; i < wall.V.rows(); ++i)
  {
    const Vector3d way = wall.V.row(i).transpose() - candidate.position;
    const double   distance = way.norm();
    if (distance > radius && distance < reach)
    {
      sum += way / (distance * distance); // nearer wall counts more
      weights += 1.0 / distance;
    }
  }
  const Vector3d mean = weights > 0.0 ? Vector3d(sum / weights) : Vector3d::Zero();
  return mean - mean.dot(candidate.axis) * candidate.axis;
}

CandidatePlane
ObliquePlane(const SurfaceMesh & wall, const PolypCandidate & candidate)
{
  constexpr double leastShare = 0.2; // of the distance; below, the foot is directly below the head
  const Vector3d   foot = TowardFoot(wall, candidate);
  return { "Oblique, along the axis",
           candidate.position,
           foot.norm() > leastShare ? foot.normalized() : candidate.axis.unitOrthogonal(),
           candidate.axis,
           WidthOf(candidate) };
}
} // namespace

Eigen::Vector2d
CandidatePlane::PixelOf(const Vector3d & point, unsigned int size) const
{
  const Vector3d way = point - center;
  const double   middle = 0.5 * (size - 1.0);
  return { middle + way.dot(right) * size / width, middle - way.dot(up) * size / width };
}

std::vector<CandidatePlane>
PlanesOf(const SurfaceMesh & wall, const itk::ImageBase<3> * volume, const PolypCandidate & candidate)
{
  return { AnatomicPlane(volume, SlicePlane::Axial, candidate),
           AnatomicPlane(volume, SlicePlane::Coronal, candidate),
           AnatomicPlane(volume, SlicePlane::Sagittal, candidate),
           ObliquePlane(wall, candidate) };
}

Picture::Pointer
PaintPlane(const CandidatePlane &       plane,
           const itk::Image<float, 3> * ct,
           const IntensityWindow &      window,
           unsigned int                 size)
{
  const auto interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double>::New();
  interpolator->SetInputImage(ct);
  const auto   picture = NewPicture(size, size, MakeColor(0, 0, 0));
  const double step = plane.width / size;
  const double middle = 0.5 * (size - 1.0);
  ParallelFor(size, [&](std::size_t y) {
    for (unsigned int x = 0; x < size; ++x)
    {
      const Vector3d point =
        plane.center + (x - middle) * step * plane.right + (middle - static_cast<double>(y)) * step * plane.up;
      const itk::Point<double, 3> place(point.data());
      if (interpolator->IsInsideBuffer(place))
      {
        const double share = (interpolator->Evaluate(place) - window.lower) / (window.upper - window.lower);
        const auto   gray = static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
        picture->GetBufferPointer()[y * size + x] = MakeColor(gray, gray, gray);
      }
    }
  });
  return picture;
}
} // namespace shapeton
