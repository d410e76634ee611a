#ifndef shapetonFlatColonAxis_h
#define shapetonFlatColonAxis_h

#include "shapetonCurveSet.h"
#include "shapetonFlatColonGrid.h"

namespace shapeton
{
/** \class FlatColonAxis
 * \brief The tube without its folds, for each column of the grid: the reference for relief.
 * \ingroup ShapetonFlatColon */
struct FlatColonAxis
{
  /** Centers of the wall, smoothed along the tube; LPS, mm. */
  VertexMatrix centers;
  /** Unit vectors toward larger u. */
  VertexMatrix tangents;
  /** Smoothed mean distance of the wall from the center, mm. */
  Eigen::VectorXd radii;
};

/** Frame of the smooth tube at a point of the wall: right (along u), down (around) and toward the axis, perpendicular
 * unit vectors. \ingroup ShapetonFlatColon */
struct FlatColonFrame
{
  Eigen::Vector3d right;
  Eigen::Vector3d down;
  Eigen::Vector3d towards;
};

/** Computes the axis. `smoothing` is a standard deviation in mm of the map; 0 uses a fifth of the circumference.
 * Columns without faces are filled from their neighbors; throws InputError when no column has a face.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT FlatColonAxis
MakeFlatColonAxis(const FlatColonGrid & grid, double smoothing = 0.0);

/** Frame at a point of the wall in a column of the grid, relative to the axis of the tube.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT FlatColonFrame
FrameAt(const FlatColonAxis & axis, int column, const Eigen::Vector3d & point);

/** Distance along the centerline of each column, mm, nondecreasing: the isotonic fit to the mean arcLength of the
 * columns. Empty if the surface has no arcLength. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<double>
                 DistanceOfColumns(const FlatColonGrid & grid);

/** Distance of each column from a centerline with the point array arcLength (mm): the centers of the columns are
 * assigned to its vertices in order, with the least squared distances and no column before the one to its left.
 * Touching loops of the colon do not mislead it. Throws InputError when the centerline has no arcLength.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<double>
                 DistanceOfColumns(const FlatColonAxis & axis, const CurveSet & centerline);
} // namespace shapeton

#endif
