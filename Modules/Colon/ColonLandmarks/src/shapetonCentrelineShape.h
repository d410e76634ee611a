#ifndef shapetonCentrelineShape_h
#define shapetonCentrelineShape_h

#include "shapetonCurveSet.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** A centreline in equal steps, with what its bends are measured by. */
class CentrelineShape
{
public:
  static constexpr double Step = 2.0; ///< mm

  /** Throws InputError unless there is one curve whose arcLength ascends. */
  explicit CentrelineShape(const CurveSet & centreline);

  int
  Size() const
  {
    return static_cast<int>(m_Points.rows());
  }
  /** mm, of the whole line. */
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
  /** Of a patient whose left is right. */
  CentrelineShape
  Mirrored() const;
  /** From its end to its beginning. */
  CentrelineShape
  Reversed() const;
  /** The nearest point. */
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
  /** Gaussian with this standard deviation, mm. */
  VertexMatrix
  Smoothed(double deviation) const;
  /** Of the smoothed line, unit vectors. */
  VertexMatrix
  Tangents(double deviation) const;
  /** Degrees between the chords of `chord` mm before and behind each point of the smoothed line. Shorter at the ends.
   */
  Eigen::VectorXd
  Turning(double chord, double deviation) const;
  /** Places of the points in the box of the line, 0 to 1: x to the left, y to the back, z to the head. */
  VertexMatrix
  PlacesInBox() const;

private:
  VertexMatrix m_Points;
  double       m_Begin{ 0.0 };
};

/** The only curve of a centreline, its points and arcLength (mm, ascending) in order; throws InputError otherwise. */
void
OrderedCentreline(const CurveSet & centreline, VertexMatrix & points, Eigen::VectorXd & arcLength);
} // namespace shapeton

#endif
