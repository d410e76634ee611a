#ifndef shapetonFoldCrest_h
#define shapetonFoldCrest_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** Places are (column, row); rows go on beyond the last one where a fold crosses the cut. */
using FoldPlaces = std::vector<Eigen::Vector2d>;

/** The rows that a fold takes, followed around the tube from one side to the other. */
FoldPlaces
UnrollFold(const FoldPixels & pixels, int rows);

/** The ellipse with the same moments of second order. */
struct FoldEllipse
{
  explicit FoldEllipse(const FoldPlaces & places);

  Eigen::Vector2d centre;
  /** Long, of unit length; rows grow along it. */
  Eigen::Vector2d axis;
  double          elongation;
  /** Pixels; half the long axis of an evenly filled ellipse. */
  double longHalf;
};

/** The line on top of a fold. */
struct FoldCrest
{
  /** From one end to the other, in the direction of the ellipse's axis. */
  FoldPlaces places;
  /** Curvature on the middle of it, 1/mm. */
  double plateau{ 0.0 };

  /** mm on the surface. */
  double
  Length(const FoldPicture & picture) const;
  /** The place in the middle of its length on the surface. */
  Eigen::Vector2d
  Middle(const FoldPicture & picture) const;
};

/** The long axis of the ellipse: the axial end points of the dissertation. */
FoldCrest
CrestOfEllipse(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse);

/** Follows the ridge of curvature within the fold, and beyond it at both ends for as long as it keeps a fifth of
 * the plateau: a cut at one curvature for all folds ends too early on them, by more for low folds than for high ones.
 * `floor` (1/mm): below, there is no fold. */
FoldCrest
TraceCrest(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse, double floor);

/** The pixels within 2 mm of the crest that have half of its curvature; some more than once. */
FoldPixels
PixelsAlongCrest(const FoldPicture & picture, const FoldCrest & crest);

/** The mm on the surface of 1 pixel there. */
double
MillimetresOfPixel(const FoldPicture & picture, const Eigen::Vector2d & place);
} // namespace shapeton

#endif
