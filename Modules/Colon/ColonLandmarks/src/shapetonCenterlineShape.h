#ifndef shapetonCenterlineShape_h
#define shapetonCenterlineShape_h

#include "shapetonCurveSet.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** A centerline resampled to equal steps, with measures of its bends. */
class CenterlineShape
{
public:
  static constexpr double Step = 2.0; ///< mm

  /** Throws InputError unless there is one curve whose arcLength ascends. */
  explicit CenterlineShape(const CurveSet & centerline);

  int
  Size() const
  {
    return static_cast<int>(m_Points.rows());
  }
  /** Length of the whole line, mm. */
  double
  Length() const
  {
    return (this->Size() - 1) * Step;
  }
  double
  ArcLengthAt(int i) const
  {
    return m_Begin + i * Step;
  }
  /** The line with left and right swapped. */
  CenterlineShape
  Mirrored() const;
  /** The reversed line. */
  CenterlineShape
  Reversed() const;
  /** Index of the nearest point. */
  int
  IndexAt(double arcLength) const
  {
    return std::clamp(static_cast<int>(std::lround((arcLength - m_Begin) / Step)), 0, this->Size() - 1);
  }
  const VertexMatrix &
  Points() const
  {
    return m_Points;
  }
  /** Gaussian smoothing with this standard deviation, mm. */
  VertexMatrix
  Smoothed(double deviation) const;
  /** Unit tangents of the smoothed line. */
  VertexMatrix
  Tangents(double deviation) const;
  /** Angle (degrees) between the chords, `chord` mm long, before and after each point of the smoothed line; chords are
   * shorter at the ends. */
  Eigen::VectorXd
  Turning(double chord, double deviation) const;
  /** Relative positions of the points in the bounding box of the line, 0 to 1: x to the left, y to the back, z to the
   * head. */
  VertexMatrix
  PlacesInBox() const;

private:
  VertexMatrix m_Points;
  double       m_Begin{ 0.0 };
};

/** Points and ascending arcLength (mm) of the only curve; throws InputError otherwise. */
void
OrderedCenterline(const CurveSet & centerline, VertexMatrix & points, Eigen::VectorXd & arcLength);
} // namespace shapeton

#endif
