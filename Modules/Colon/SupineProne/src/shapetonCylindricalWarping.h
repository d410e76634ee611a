#ifndef shapetonCylindricalWarping_h
#define shapetonCylindricalWarping_h

#include "shapetonCylinderPicture.h"
#include "shapetonProgress.h"
#include "shapetonStartFrame.h"

namespace shapeton
{
struct CylindricalWarpingOptions
{
  /** mm that the path may leave the frame. */
  double band{ 60.0 };
  /** Turns that the rotation may leave the frame. */
  double rotationBand{ 0.125 };
  /** Cost of the squared difference of the rows passed, of two, and of a step of rotation. */
  double slopeWeight{ 0.3 };
  double rotationWeight{ 0.4 };
  /** A weak spring to the frame on each row: folds look alike, one too far is as good a partner. Its cost at
   * `frameDeviation` mm. */
  double frameDeviation{ 25.0 };
  double springWeight{ 0.05 };
  /** Both count so much less where rows are excluded. */
  double excludedEase{ 0.05 };
  /** Cost of a jump to any rotation and any place farther along, where a row is excluded in one of the pictures: the
   * centreline takes a short cut through a collapsed stretch, and the flat map turns there. And of each target row that
   * it leaps over. */
  double jumpCost{ 2.0 };
  double leapCost{ 0.1 };
  /** Cost of what a row shows, whether the other one shows it or not. */
  double contentWeight{ 0.3 };
  /** Of taeniae against folds, where both pictures have them. They look alike, so that they tell the rotation up to
   * thirds of a turn, wherever their tracks change from one to the next. */
  double taeniaWeight{ 0.0 };
  /** Places of the source that the path must not carry over to the other side, mm; in the frame they are the same for
   * the target. */
  std::vector<double> breaks;
  /** Standard deviation of the smoothing of the path, rows. */
  double   smoothing{ 3.0 };
  Progress progress;
};

/** For each row of the source picture its place in the target and the rotation. */
struct CylindricalWarp
{
  std::vector<double> s;
  /** mm along the target. */
  std::vector<double> targetS;
  /** Turns, without jumps. */
  std::vector<double> rotation;
  /** Mean cost of a row without that of the spring; rows that are excluded count 0. */
  double energy{ 0.0 };
};

/** Dynamic time warping on two cylinders (after Sakoe and Chiba 1978, with the rotation as part of the state): each row
 * of the source goes to a row of the target picture, whose rows are half as far apart and lie along the frame; from row
 * to row 0 to 3 target rows are passed (0 to 8 where nothing is seen) and the rotation changes by one step at most, but
 * for jumps where nothing is seen. The best path is found exactly. \param rotation turns at each row of the source;
 * empty allows all. \param target in the coordinate of the source: its rows begin where those of the source do. */
CylindricalWarp
WarpCylinder(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const PiecewiseLine &             frame,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options = {});
} // namespace shapeton

#endif
