#ifndef shapetonColonCylinder_h
#define shapetonColonCylinder_h

#include "ShapetonSupineProneExport.h"

#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"

namespace shapeton
{
/** A position on the unrolled wall of a colon. \ingroup ShapetonSupineProne */
struct CylinderPlace
{
  /** Distance along the centerline, mm. */
  double s{ 0.0 };
  /** Angle around the tube in turns, modulo 1, increasing downward in the view from inside the lumen. */
  double turn{ 0.0 };
};

/** The difference of two angles in turns, in [-0.5, 0.5). \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT double
TurnDifference(double turn, double from);

/** \class ColonCylinder
 * \brief The wall of a colon as a cylinder: distance along the centerline and angle on the flat map.
 *
 * The length of the conformal flat map depends on folds and caliber; lengths along the centerline agree much better
 * between the two positions of a colon. The distance is DistanceOfColumns() of the grid column, made strictly
 * ascending. The two conversions are exact inverses. The flat colon must outlive this object.
 * \ingroup ShapetonSupineProne */
class ShapetonSupineProne_EXPORT ColonCylinder
{
public:
  /** \param centerline with the point array arcLength, mm; required if the grid lacks it. Throws InputError if neither
   * has arcLength. */
  ColonCylinder(const FlatColon & flat, const CurveSet & centerline);

  double
  Begin() const
  {
    return m_Arc.front();
  }
  double
  End() const
  {
    return m_Arc.back();
  }
  /** Mean circumference (mm) of the tube without folds: the length of a turn. */
  double
  Around() const
  {
    return m_Around;
  }
  /** mm along the centerline at a position in columns (0.5 is the center of the first column); extrapolated beyond the
   * ends. */
  double
  ArcOfColumn(double column) const;
  double
  ColumnOfArc(double s) const;
  CylinderPlace
  PlaceOfUv(const Eigen::Vector2d & uv) const;
  /** v in [0, circumference). */
  Eigen::Vector2d
  UvOfPlace(const CylinderPlace & place) const;
  /** Point on the wall, LPS, mm, interpolated between pixel centers; beyond the ends, at the nearest column. NaN in
   * holes of the grid. */
  Eigen::Vector3d
  PointOfPlace(const CylinderPlace & place) const;
  const FlatColonGrid &
  Grid() const
  {
    return *m_Grid;
  }
  /** Mean distance from the center to the wall in each column, mm. */
  const Eigen::VectorXd &
  Radii() const
  {
    return m_Radii;
  }

private:
  const FlatColonGrid * m_Grid;
  /** Distances of the column centers. */
  std::vector<double> m_Arc;
  Eigen::VectorXd     m_Radii;
  double              m_Around{ 1.0 };
};
} // namespace shapeton

#endif
