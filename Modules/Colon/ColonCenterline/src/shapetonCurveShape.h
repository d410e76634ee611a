#ifndef shapetonCurveShape_h
#define shapetonCurveShape_h

#include "shapetonLumenDistance.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** Points of a curve in LumenGrid coordinates, mm. */
using CurvePoints = std::vector<Eigen::Vector3d>;

/** Interpolated distances to the wall, 0 outside. */
class DistanceField
{
public:
  explicit DistanceField(const LumenDistanceImage * image);

  /** Trilinear interpolation; positions in LumenGrid coordinates, mm. */
  double
  At(const Eigen::Vector3d & position) const;

  /** Trilinear interpolation of the mask: 1 in lumen voxels, 0 elsewhere; the wall is at 0.5. */
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

/** Resamples to equal steps of about `step` mm; both ends remain fixed. */
CurvePoints
ResampleCurve(const CurvePoints & points, double step);

/** Binomial smoothing that approximates a Gaussian of `sigma` mm for points `step` mm apart. Both ends, and points that
 * would leave the lumen, remain fixed. */
CurvePoints
SmoothCurve(const CurvePoints & points, double step, double sigma, const DistanceField * field = nullptr);

/** Inner points of a cubic curve from a to b with unit tangents `out` at a and `in` at b. */
CurvePoints
BridgeGap(const Eigen::Vector3d & a,
          const Eigen::Vector3d & out,
          const Eigen::Vector3d & b,
          const Eigen::Vector3d & in,
          double                  step);
} // namespace shapeton

#endif
