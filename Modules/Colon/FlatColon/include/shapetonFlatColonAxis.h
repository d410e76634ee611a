#ifndef shapetonFlatColonAxis_h
#define shapetonFlatColonAxis_h

#include "shapetonCurveSet.h"
#include "shapetonFlatColonGrid.h"

namespace shapeton
{
/** \class FlatColonAxis
 * \brief The tube without its folds, column by column of the grid: what relief is measured against.
 * \ingroup FlatColon */
struct FlatColonAxis
{
  /** The middle of the wall, smoothed along the tube; LPS, mm. */
  VertexMatrix centres;
  /** Unit vectors towards larger u. */
  VertexMatrix tangents;
  /** Mean distance of the wall from the middle, smoothed, mm. */
  Eigen::VectorXd radii;
};

/** Right (along u), down (around) and towards the axis: the frame of the smooth tube at a point of the wall. Right,
 * down and towards are perpendicular unit vectors. \ingroup FlatColon */
struct FlatColonFrame
{
  Eigen::Vector3d right;
  Eigen::Vector3d down;
  Eigen::Vector3d towards;
};

/** `smoothing` is a standard deviation in mm of the map; 0 takes a fifth of the circumference. Columns without a face
 * take what their neighbours have; throws InputError where there is none. \ingroup FlatColon */
FlatColon_EXPORT FlatColonAxis
MakeFlatColonAxis(const FlatColonGrid & grid, double smoothing = 0.0);

/** Direction and turn at a point of the wall in a column of the grid, with respect to the axis of the tube.
 * \ingroup FlatColon */
FlatColon_EXPORT FlatColonFrame
FrameAt(const FlatColonAxis & axis, int column, const Eigen::Vector3d & point);

/** The distance along the centreline of each column, mm, never falling: the mean of arcLength over the column, of which
 * the best fit that does not fall is taken. Empty where the surface has no arcLength. \ingroup FlatColon */
FlatColon_EXPORT std::vector<double>
                 DistanceOfColumns(const FlatColonGrid & grid);

/** The same from a centreline with the point array arcLength (mm): the columns' middles are assigned to its vertices in
 * their order, so that the squared distances are least and no column lies before the one to its left. Loops of the
 * colon that touch do not mislead it. Throws InputError where the centreline has no arcLength. \ingroup FlatColon
 */
FlatColon_EXPORT std::vector<double>
                 DistanceOfColumns(const FlatColonAxis & axis, const CurveSet & centreline);
} // namespace shapeton

#endif
