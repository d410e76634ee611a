#ifndef shapetonColonCurve_h
#define shapetonColonCurve_h

#include "shapetonColonPath.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class ColonCurve
 * \brief The centerline: a uniform cubic B-spline with a frame and nearest-point search.
 *
 * The parameter t is in steps of about 2 mm of material length; material(t) = t * GetStep(). */
class ColonCurve
{
public:
  using Vector3d = Eigen::Vector3d;

  ColonCurve(const ColonPath & path, const std::vector<double> & twist);

  /** Number of steps for a path of this length. */
  static int
  NumberOfSteps(double length);

  int
  GetNumberOfSteps() const
  {
    return m_Steps;
  }
  /** mm of material length. */
  double
  GetStep() const
  {
    return m_Step;
  }

  struct Frame
  {
    Vector3d position;
    Vector3d first;  ///< derivative by t
    Vector3d second; ///< second derivative with respect to t
  };
  Frame
  At(double t) const;

  /** Unit normal that defines angle 0, perpendicular to the unit tangent. */
  Vector3d
  NormalAt(double t, const Vector3d & tangent) const;

  /** Unit vector from the centerline at this angle. */
  Vector3d
  Direction(double t, double angle) const;

  /** mm from the anal verge. */
  double
  ArcLengthAt(double t) const;
  double
  Length() const
  {
    return m_ArcLength.back();
  }
  /** The parameter t of an arc length. */
  double
  ParameterAt(double arcLength) const;

  /** Prepares the search; sample k is found only for points within `reach[k]` mm. */
  void
  BuildGrid(const std::vector<double> & reach);

  static constexpr int MostNear = 4; // stretches; chosen
  struct Near
  {
    int                          count;
    std::array<double, MostNear> t;
  };
  /** The nearest points of all stretches within reach; stretches are 40 mm apart along the curve. */
  void
  FindNear(const Vector3d & point, Near & near) const;

private:
  struct Range
  {
    int first;
    int last;
  };
  double
  Refine(const Vector3d & point, int sample) const;
  void
  FillFrames(const std::vector<double> & twist);
  void
  AddSampleToCells(int sample, double reach, std::vector<std::vector<Range>> & cells) const;

  int                   m_Steps;
  double                m_Step;
  std::vector<Vector3d> m_Control; ///< with one additional point at each end
  std::vector<Vector3d> m_Normal;  ///< with one additional normal at each end
  std::vector<double>   m_ArcLength;
  std::vector<Vector3d> m_Samples;

  std::vector<double>        m_Reach;
  Vector3d                   m_GridLow{ 0, 0, 0 };
  std::array<int, 3>         m_GridSize{ 0, 0, 0 };
  std::vector<std::uint32_t> m_CellBegin;
  std::vector<Range>         m_Ranges;
};
} // namespace shapeton

#endif
