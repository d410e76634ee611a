#ifndef shapetonColonCylinder_h
#define shapetonColonCylinder_h

#include "SupineProneExport.h"

#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"

namespace shapeton
{
/** A place on the wall of a colon, unrolled. \ingroup SupineProne */
struct CylinderPlace
{
  /** Distance along the centreline, mm. */
  double s{ 0.0 };
  /** Around the tube in whole turns, growing downwards in the picture that an eye inside of the lumen sees; values that
   * differ by a whole number are the same place. */
  double turn{ 0.0 };
};

/** The difference of two angles in turns, in [-0.5, 0.5). \ingroup SupineProne */
SupineProne_EXPORT double
TurnDifference(double turn, double from);

/** \class ColonCylinder
 * \brief The wall of a colon as a cylinder: distance along the centreline and angle on the flat map.
 *
 * The flat map is conformal, so its length measures folds and calibre; two positions of one colon agree much better in
 * the length of the centreline. The place along it is that of the column of the grid (DistanceOfColumns()), made
 * strictly ascending. Both directions are exact inverses of each other. The flat colon must outlive this object.
 * \ingroup SupineProne */
class SupineProne_EXPORT ColonCylinder
{
public:
  /** \param centreline with the point array arcLength, mm; needed where the grid has none.
   * Throws InputError where neither tells the distance along the centreline. */
  ColonCylinder(const FlatColon & flat, const CurveSet & centreline);

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
  /** Mean circumference of the tube without folds, mm: what a turn counts for. */
  double
  Around() const
  {
    return m_Around;
  }
  /** mm along the centreline of a place in columns (0.5 is the middle of the first one); goes on beyond the ends. */
  double
  ArcOfColumn(double column) const;
  double
  ColumnOfArc(double s) const;
  CylinderPlace
  PlaceOfUv(const Eigen::Vector2d & uv) const;
  /** v in [0, circumference). */
  Eigen::Vector2d
  UvOfPlace(const CylinderPlace & place) const;
  /** On the wall, LPS, mm, between the middles of pixels; beyond the ends that of the nearest column. Not a number
   * where the grid has no face. */
  Eigen::Vector3d
  PointOfPlace(const CylinderPlace & place) const;
  const FlatColonGrid &
  Grid() const
  {
    return *m_Grid;
  }
  /** Mean distance of the wall from its middle, of each column, mm. */
  const Eigen::VectorXd &
  Radii() const
  {
    return m_Radii;
  }

private:
  const FlatColonGrid * m_Grid;
  /** Of the middles of the columns. */
  std::vector<double> m_Arc;
  Eigen::VectorXd     m_Radii;
  double              m_Around{ 1.0 };
};
} // namespace shapeton

#endif
