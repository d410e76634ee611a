#ifndef shapetonCatheterBalloon_h
#define shapetonCatheterBalloon_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** A place where a ray from the tube leaves the balloon around it. */
struct BalloonExit
{
  Eigen::Vector3d position;
  BehindLayer     into; ///< Gas or Fluid
};

/** The ball that fits a balloon. */
struct CatheterBalloon
{
  Eigen::Vector3d          centre;
  double                   radius{ 0.0 }; ///< mm, with its membrane
  std::vector<BalloonExit> exits;         ///< of the rays that see it
};

/** The balloon around a tube, filled with gas or with fluid.
 *
 * A ray that leaves the tube's wall into gas and then crosses a thin membrane into lumen leaves a balloon with gas
 * there; one that crosses more than a tube's wall leaves one with fluid. At least a third of the rays do so in each of
 * 8 consecutive sections (1 mm apart). Three quarters of these points lie within 1.5 mm (or twice the RMS residual) of
 * a fitted sphere whose radius exceeds the tube's by at least 2.5 mm. The RMS residual is at most .6 mm or a twelfth of
 * the radius, whichever is greater, and at most half of that of a cylinder along the tube, which excludes a septum
 * beside the rectum or a collar of tissue. A round lump of tissue with the tube in its middle cannot be told from a
 * balloon of water. */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
