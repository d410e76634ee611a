#ifndef shapetonFlatColonAxis_h
#define shapetonFlatColonAxis_h

#include "shapetonCurveSet.h"
#include "shapetonFlatColonGrid.h"

namespace shapeton
{
/** \class FlatColonAxis
 * \brief The axis of the tube for each grid column, to which heights of the wall refer.
 * \ingroup ShapetonFlatColon */
struct FlatColonAxis
{
  /** Centers of the wall, smoothed along the tube; LPS, mm. */
  VertexMatrix centers;
  /** Unit vectors toward larger u. */
  VertexMatrix tangents;
  /** Smoothed mean distance from the center to the wall, mm. */
  Eigen::VectorXd radii;
};

/** Orthonormal frame of the smooth tube at a point of the wall: right (along u), down (around) and toward the axis.
 * \ingroup ShapetonFlatColon */
struct FlatColonFrame
{
  Eigen::Vector3d right;
  Eigen::Vector3d down;
  Eigen::Vector3d towards;
};

/** Computes the axis. `smoothing` is a standard deviation in mm of the map; 0 uses a fifth of the circumference.
 * Columns without faces are interpolated; throws InputError if all columns are empty.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT FlatColonAxis
MakeFlatColonAxis(const FlatColonGrid & grid, double smoothing = 0.0);

/** Frame at a point of the wall in a column of the grid, relative to the axis of the tube.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT FlatColonFrame
FrameAt(const FlatColonAxis & axis, int column, const Eigen::Vector3d & point);

/** Distance (mm) of each column along the centerline: the nondecreasing isotonic fit to the mean arcLength of the
 * columns. Empty if the surface lacks arcLength. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<double>
                         DistanceOfColumns(const FlatColonGrid & grid);

/** Distance (mm) of each column along a centerline with the point array arcLength. Column centers are assigned to line
 * vertices in nondecreasing order such that the sum of squared distances is minimal; this is robust to touching loops
 * of the colon. Throws InputError if the centerline lacks arcLength.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<double>
                         DistanceOfColumns(const FlatColonAxis & axis, const CurveSet & centerline);
} // namespace shapeton

#endif
