#ifndef shapetonFoldCrest_h
#define shapetonFoldCrest_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** Positions (column, row); rows exceed the last row where a fold crosses the cut. */
using FoldPlaces = std::vector<Eigen::Vector2d>;

/** The pixel positions of a fold, with rows unwrapped around the tube. */
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
  /** Half the long axis of the ellipse, pixels. */
  double longHalf;
};

/** The ridge line of a fold. */
struct FoldCrest
{
  /** Points from end to end, in the direction of the ellipse axis. */
  FoldPlaces places;
  /** Curvature at the center, 1/mm. */
  double plateau{ 0.0 };

  /** Length in mm on the surface. */
  double
  Length(const FoldPicture & picture) const;
  /** Midpoint by length on the surface. */
  Eigen::Vector2d
  Middle(const FoldPicture & picture) const;
};

/** The crest along the long axis of the ellipse; its ends are the axial end points of the dissertation. */
FoldCrest
CrestOfEllipse(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse);

/** Traces the ridge of curvature within the fold and extends it at both ends down to a fifth of the plateau curvature,
 * since a common threshold shortens folds, especially low ones. Curvature below `floor` (1/mm) is wall. */
FoldCrest
TraceCrest(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse, double floor);

/** Pixels within 2 mm of the crest that have at least half of its curvature; may contain duplicates. */
FoldPixels
PixelsAlongCrest(const FoldPicture & picture, const FoldCrest & crest);

/** Surface length (mm) of one pixel at a position. */
double
MillimetersOfPixel(const FoldPicture & picture, const Eigen::Vector2d & place);
} // namespace shapeton

#endif
