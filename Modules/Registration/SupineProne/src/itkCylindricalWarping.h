#ifndef itkCylindricalWarping_h
#define itkCylindricalWarping_h

#include "itkCylinderPicture.h"
#include "itkStartFrame.h"

namespace itk
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
  /** Cost of what a row shows, whether the other one shows it or not. */
  double contentWeight{ 0.3 };
  /** Places of the source that the path must not carry over to the other side, mm; in the frame they are the same for
   * the target. */
  std::vector<double> breaks;
  /** Standard deviation of the smoothing of the path, rows. */
  double smoothing{ 3.0 };
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
 * to row 0 to 3 target rows are passed (0 to 8 where nothing is seen) and the rotation changes by one step at most. The
 * best path is found exactly. \param rotation turns at each row of the source; empty allows all. \param target in the
 * coordinate of the source: its rows begin where those of the source do. */
CylindricalWarp
WarpCylinder(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const PiecewiseLine &             frame,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options = {});
} // namespace itk

#endif
