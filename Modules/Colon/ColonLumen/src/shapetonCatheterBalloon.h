#ifndef shapetonCatheterBalloon_h
#define shapetonCatheterBalloon_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** Point at which a ray from the tube exits the surrounding balloon. */
struct BalloonExit
{
  Eigen::Vector3d position;
  BehindLayer     into; ///< Gas or Fluid
};

/** The sphere fitted to a balloon. */
struct CatheterBalloon
{
  Eigen::Vector3d          center;
  double                   radius{ 0.0 }; ///< mm, including the membrane
  std::vector<BalloonExit> exits;         ///< one per ray that crosses the balloon
};

/** Finds the balloon around a tube, filled with gas or fluid.
 *
 * Rays in a gas-filled balloon pass through the tube wall, gas, and a thin membrane into lumen. In a fluid-filled
 * balloon, the first layer is thicker than a tube wall. At least a third of the rays must exit a balloon in each of 8
 * consecutive sections (1 mm apart). Three quarters of the exit points must be within 1.5 mm (or twice the RMS
 * residual) of a fitted sphere whose radius exceeds the tube radius by at least 2.5 mm. The RMS residual must be at
 * most .6 mm or a twelfth of the radius, whichever is greater, and at most half the residual of a cylinder along the
 * tube. This excludes a septum next to the rectum and a collar of tissue. A round lump of tissue centered on the tube
 * cannot be distinguished from a balloon filled with water. */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
