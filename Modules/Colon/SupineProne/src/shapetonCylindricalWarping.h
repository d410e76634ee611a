#ifndef shapetonCylindricalWarping_h
#define shapetonCylindricalWarping_h

#include "shapetonCylinderPicture.h"
#include "shapetonProgress.h"
#include "shapetonStartFrame.h"

namespace shapeton
{
struct CylindricalWarpingOptions
{
  /** Maximum deviation of the path from the frame, mm. */
  double band{ 60.0 };
  /** Maximum deviation of the rotation from the frame, turns. */
  double rotationBand{ 0.125 };
  /** Cost of the squared deviation from two rows per step, and of a step of rotation. */
  double slopeWeight{ 0.3 };
  double rotationWeight{ 0.4 };
  /** A weak spring to the frame on each row, since folds look alike and the next fold fits as well. Its cost at
   * `frameDeviation` mm. */
  double frameDeviation{ 25.0 };
  double springWeight{ 0.05 };
  /** Factor of both costs in excluded rows. */
  double excludedEase{ 0.05 };
  /** Cost of a jump to any rotation and any place farther along, where a row is excluded in one of the pictures: the
   * centerline takes a shortcut through a collapsed stretch, and the flat map rotates there. Second: cost of each
   * skipped target row. */
  double jumpCost{ 2.0 };
  double leapCost{ 0.1 };
  /** Cost of the content of a row, whether the other one shows it or not. */
  double contentWeight{ 0.3 };
  /** Weight of taeniae relative to folds, if both pictures have them. Taeniae look alike, so they determine the
   * rotation only up to thirds of a turn. */
  double taeniaWeight{ 0.0 };
  /** Places of the source that the path must not carry to the other side, mm; equal in the target under the frame. */
  std::vector<double> breaks;
  /** Standard deviation of the path smoothing, rows. */
  double   smoothing{ 3.0 };
  Progress progress;
};

/** For each row of the source picture its place in the target and the rotation. */
struct CylindricalWarp
{
  std::vector<double> s;
  /** mm along the target. */
  std::vector<double> targetS;
  /** Turns, continuous. */
  std::vector<double> rotation;
  /** Mean cost per row without the spring; excluded rows count as 0. */
  double energy{ 0.0 };
};

/** Dynamic time warping on two cylinders (after Sakoe and Chiba 1978, with the rotation as part of the state). Each row
 * of the source is assigned to a row of the target picture, whose rows are half as far apart and follow the frame. Per
 * row 0 to 3 target rows are passed (0 to 8 where the wall is not visible), and the rotation changes by at most one
 * step, except for jumps where the wall is not visible. The best path is exact. \param rotation turns at each row of
 * the source; empty allows all. \param target in the coordinate of the source, with the same first row. */
CylindricalWarp
WarpCylinder(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const PiecewiseLine &             frame,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options = {});
} // namespace shapeton

#endif
