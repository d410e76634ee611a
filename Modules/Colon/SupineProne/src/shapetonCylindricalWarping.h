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
  /** Cost per squared deviation from an advance of two target rows per row, and cost per rotation step. */
  double slopeWeight{ 0.3 };
  double rotationWeight{ 0.4 };
  /** Cost per row of a weak spring to the frame at a deviation of `frameDeviation` mm; the spring is needed because
   * neighboring folds are similar. */
  double frameDeviation{ 25.0 };
  double springWeight{ 0.05 };
  /** Factor for the slope and rotation costs in excluded rows. */
  double excludedEase{ 0.05 };
  /** Cost of a jump to any rotation and any later row where a row is excluded in one of the pictures, and cost of each
   * skipped target row. Jumps are required because, in a collapsed stretch, the centerline takes a shortcut and the
   * flat map rotates. */
  double jumpCost{ 2.0 };
  double leapCost{ 0.1 };
  /** Cost of the content of a row, independent of the other picture. */
  double contentWeight{ 0.3 };
  /** Weight of taeniae relative to folds, if both pictures have taeniae. Taeniae look alike, so they determine the
   * rotation only up to a third of a turn. */
  double taeniaWeight{ 0.0 };
  /** Segment borders (mm) that the path must not cross, in source coordinates. */
  std::vector<double> breaks;
  /** Standard deviation of the path smoothing, rows. */
  double   smoothing{ 3.0 };
  Progress progress;
};

/** Target position and rotation of each row of the source picture. */
struct CylindricalWarp
{
  std::vector<double> s;
  /** mm along the target. */
  std::vector<double> targetS;
  /** Turns, unwrapped. */
  std::vector<double> rotation;
  /** Mean cost per row, excluding the spring; excluded rows contribute 0. */
  double energy{ 0.0 };
};

/** Dynamic time warping of two cylinders (after Sakoe and Chiba 1978, with rotation as part of the state). Each row of
 * the source is assigned to a row of the target picture, whose row spacing is half as large and follows the frame. Per
 * row, the path advances by 0 to 3 target rows (0 to 8 where the wall is not visible) and at most one rotation step,
 * except for jumps where the wall is not visible. The path is optimal. \param rotation turns at each row of the source;
 * if empty, all rotations are allowed. \param target in the coordinate of the source, with the same first row. */
CylindricalWarp
WarpCylinder(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const PiecewiseLine &             frame,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options = {});
} // namespace shapeton

#endif
