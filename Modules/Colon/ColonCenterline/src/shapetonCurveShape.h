#ifndef shapetonCurveShape_h
#define shapetonCurveShape_h

#include "shapetonLumenDistance.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** Points of a curve in the frame of a LumenGrid, mm. */
using CurvePoints = std::vector<Eigen::Vector3d>;

/** Interpolated distances to the wall, 0 outside. */
class DistanceField
{
public:
  explicit DistanceField(const LumenDistanceImage * image);

  /** Trilinear; positions count from the first voxel along the axes of the image. */
  double
  At(const Eigen::Vector3d & position) const;

  /** Share of lumen at a position, trilinear between 1 for a lumen voxel and 0; the wall is at 0.5. */
  double
  Occupancy(const Eigen::Vector3d & position) const;

private:
  /** Calls add(weight, value) for the voxels around a position. */
  template <typename TAdd>
  void
  Interpolate(const Eigen::Vector3d & position, const TAdd & add) const;

  const float *   m_Values;
  Eigen::Array3i  m_Size;
  Eigen::Vector3d m_Spacing;
};

double
CurveLength(const CurvePoints & points);

/** Resamples with equal steps of about `step` mm; both ends are kept. */
CurvePoints
ResampleCurve(const CurvePoints & points, double step);

/** Binomial smoothing, close to a Gaussian of `sigma` mm for points `step` mm apart; both ends are kept. A point that
 * would leave the lumen does not move. */
CurvePoints
SmoothCurve(const CurvePoints & points, double step, double sigma, const DistanceField * field = nullptr);

/** A cubic curve from a to b that leaves along `out` and arrives along `in` (unit vectors), without a and b. */
CurvePoints
BridgeGap(const Eigen::Vector3d & a,
          const Eigen::Vector3d & out,
          const Eigen::Vector3d & b,
          const Eigen::Vector3d & in,
          double                  step);
} // namespace shapeton

#endif
