#ifndef shapetonTubeMask_h
#define shapetonTubeMask_h

#include "shapetonLumenDistance.h"
#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <vector>

namespace shapeton
{
/** Points in LPS, mm. */
using TubePoints = std::vector<Eigen::Vector3d>;

/** An oblique orthonormal frame, optionally mirrored. */
inline Eigen::Matrix3d
ObliqueFrame(bool isLeftHanded = false)
{
  Eigen::Matrix3d frame =
    (Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.7, Eigen::Vector3d(1, 2, 3).normalized()))
      .toRotationMatrix();
  if (isLeftHanded)
  {
    frame.col(1) *= -1.0;
  }
  return frame;
}

/** Catmull-Rom curve through control points, with points at most 1 mm apart. */
inline TubePoints
CurveThrough(const TubePoints & control)
{
  TubePoints points;
  const int  last = static_cast<int>(control.size()) - 1;
  for (int i = 0; i < last; ++i)
  {
    const Eigen::Vector3d & p0 = control[std::max(0, i - 1)];
    const Eigen::Vector3d & p1 = control[i];
    const Eigen::Vector3d & p2 = control[i + 1];
    const Eigen::Vector3d & p3 = control[std::min(last, i + 2)];
    const int               steps = static_cast<int>(std::ceil(1.5 * (p2 - p1).norm()));
    for (int k = 0; k < steps; ++k)
    {
      const double t = static_cast<double>(k) / steps;
      points.push_back(0.5 * (2.0 * p1 + t * (p2 - p0) + t * t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) +
                              t * t * t * (3.0 * (p1 - p2) + p3 - p0)));
    }
  }
  points.push_back(control.back());
  return points;
}

/** A colon: rectum, a sigmoid loop that descends below the top of the rectum, descending, transverse, ascending,
 * cecum. */
inline TubePoints
ColonCurve()
{
  return CurveThrough({ { 0, 70, -180 },
                        { 0, 75, -130 },
                        { 10, 50, -90 },
                        { -30, 0, -100 },
                        { -10, -40, -150 },
                        { 50, -35, -140 },
                        { 90, 10, -90 },
                        { 110, 40, -20 },
                        { 115, 50, 60 },
                        { 80, 20, 110 },
                        { 40, -40, 60 },
                        { -20, -50, 50 },
                        { -80, -20, 80 },
                        { -110, 30, 50 },
                        { -115, 30, -20 },
                        { -100, 10, -80 } });
}

inline double
LengthOf(const TubePoints & points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

/** The part of a curve between two positions, given as fractions of its points. */
inline TubePoints
PartOf(const TubePoints & points, double from, double to)
{
  const auto n = static_cast<double>(points.size());
  return { points.begin() + static_cast<long>(from * n), points.begin() + static_cast<long>(to * n) };
}

/** \class TubeMask
 * \brief A mask of painted tubes on a grid around them.
 */
class TubeMask
{
public:
  TubeMask(const TubePoints &      around,
           double                  margin,
           const Eigen::Vector3d & spacing,
           const Eigen::Matrix3d & frame = Eigen::Matrix3d::Identity())
    : m_Spacing(spacing), m_Frame(frame)
  {
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(1e30);
    Eigen::Vector3d highest = -lowest;
    for (const auto & point : around)
    {
      lowest = lowest.cwiseMin(frame.transpose() * point);
      highest = highest.cwiseMax(frame.transpose() * point);
    }
    m_Lowest = lowest - Eigen::Vector3d::Constant(margin);
    const Eigen::Vector3d extent = highest - lowest + Eigen::Vector3d::Constant(2.0 * margin);
    LumenMask::SizeType   size;
    for (int a = 0; a < 3; ++a)
    {
      size[a] = static_cast<itk::SizeValueType>(std::ceil(extent[a] / spacing[a])) + 1;
    }
    m_Mask = basetest::NewImageInFrame<LumenMask>(size, spacing, frame * m_Lowest, frame);
  }

  /** Sets all voxels whose centers are within `radius` of the curve to the value. */
  void
  Paint(const TubePoints & points, const std::function<double(double)> & radiusOfShare, unsigned char value = 1)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->PaintBall(points[i], radiusOfShare(points.size() > 1 ? i / (points.size() - 1.0) : 0.0), value);
    }
  }
  void
  Paint(const TubePoints & points, double radius, unsigned char value = 1)
  {
    this->Paint(
      points, [radius](double) { return radius; }, value);
  }

  void
  PaintBall(const Eigen::Vector3d & center, double radius, unsigned char value = 1)
  {
    const Eigen::Vector3d at = m_Frame.transpose() * center - m_Lowest;
    itk::Index<3>         first, last, i;
    for (int a = 0; a < 3; ++a)
    {
      const auto size = static_cast<itk::IndexValueType>(m_Mask->GetBufferedRegion().GetSize(a));
      first[a] =
        std::max<itk::IndexValueType>(0, static_cast<itk::IndexValueType>(std::ceil((at[a] - radius) / m_Spacing[a])));
      last[a] = std::min<itk::IndexValueType>(
        size - 1, static_cast<itk::IndexValueType>(std::floor((at[a] + radius) / m_Spacing[a])));
    }
    for (i[2] = first[2]; i[2] <= last[2]; ++i[2])
    {
      for (i[1] = first[1]; i[1] <= last[1]; ++i[1])
      {
        for (i[0] = first[0]; i[0] <= last[0]; ++i[0])
        {
          const Eigen::Vector3d voxel(i[0] * m_Spacing[0], i[1] * m_Spacing[1], i[2] * m_Spacing[2]);
          if ((voxel - at).squaredNorm() <= radius * radius)
          {
            m_Mask->SetPixel(i, value);
          }
        }
      }
    }
  }

  LumenMask *
  Get() const
  {
    return m_Mask;
  }

private:
  Eigen::Vector3d    m_Spacing;
  Eigen::Matrix3d    m_Frame;
  Eigen::Vector3d    m_Lowest;
  LumenMask::Pointer m_Mask;
};
} // namespace shapeton

#endif
