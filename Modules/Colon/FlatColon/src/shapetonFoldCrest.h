#ifndef shapetonFoldCrest_h
#define shapetonFoldCrest_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** Positions (column, row); rows continue beyond the last one where a fold crosses the cut. */
using FoldPlaces = std::vector<Eigen::Vector2d>;

/** The rows of a fold, continuous around the tube from one side to the other. */
FoldPlaces
UnrollFold(const FoldPixels & pixels, int rows);

/** The ellipse with the same second moments. */
struct FoldEllipse
{
  explicit FoldEllipse(const FoldPlaces & places);

  Eigen::Vector2d center;
  /** Unit vector of the long axis; rows increase along it. */
  Eigen::Vector2d axis;
  double          elongation;
  /** Half the long axis of a uniformly filled ellipse, pixels. */
  double longHalf;
};

/** The line on top of a fold. */
struct FoldCrest
{
  /** From one end to the other, in the direction of the ellipse axis. */
  FoldPlaces places;
  /** Curvature at its center, 1/mm. */
  double plateau{ 0.0 };

  /** Length in mm on the surface. */
  double
  Length(const FoldPicture & picture) const;
  /** Midpoint by length on the surface. */
  Eigen::Vector2d
  Middle(const FoldPicture & picture) const;
};

/** The long axis of the ellipse: the axial end points of the dissertation. */
FoldCrest
CrestOfEllipse(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse);

/** Traces the ridge of curvature within the fold, and beyond it at both ends while it keeps a fifth of the plateau. A
 * cut at one curvature for all folds shortens them, more for low folds than for high ones. Below `floor` (1/mm) there
 * are no folds. */
FoldCrest
TraceCrest(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse, double floor);

/** Pixels within 2 mm of the crest with at least half of its curvature; may contain duplicates. */
FoldPixels
PixelsAlongCrest(const FoldPicture & picture, const FoldCrest & crest);

/** Surface length of one pixel at a position, mm. */
double
MillimetersOfPixel(const FoldPicture & picture, const Eigen::Vector2d & place);
} // namespace shapeton

#endif
