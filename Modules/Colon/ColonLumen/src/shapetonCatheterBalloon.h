#ifndef shapetonCatheterBalloon_h
#define shapetonCatheterBalloon_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** Exit point of a ray from the tube through the surrounding balloon. */
struct BalloonExit
{
  Eigen::Vector3d position;
  BehindLayer     into; ///< Gas or Fluid
};

/** The ball fitted to a balloon. */
struct CatheterBalloon
{
  Eigen::Vector3d          center;
  double                   radius{ 0.0 }; ///< mm, with its membrane
  std::vector<BalloonExit> exits;         ///< of the rays that cross it
};

/** Finds the balloon around a tube, filled with gas or with fluid.
 *
 * A ray that leaves the wall of the tube into gas and then crosses a thin membrane into lumen exits a gas-filled
 * balloon; one that crosses more than a tube wall exits a fluid-filled one. At least a third of the rays must do so in
 * each of 8 consecutive sections (1 mm apart). Three quarters of these points must be within 1.5 mm (or twice the RMS
 * residual) of a fitted sphere whose radius exceeds that of the tube by at least 2.5 mm. The RMS residual must be at
 * most .6 mm or a twelfth of the radius, whichever is greater, and at most half of that of a cylinder along the tube,
 * which excludes a septum next to the rectum or a collar of tissue. A round lump of tissue centered on the tube cannot
 * be distinguished from a balloon of water. */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
