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
 * there; one that crosses more than a tube's wall leaves one with fluid. A third of the rays do so in 8 mm of sections
 * next to each other. Three quarters of these places lie near a ball around the tube (within 1.5 mm, or twice the root
 * mean square), 2.5 mm wider than that at least; the root mean square of their distances is .6 mm or a twelfth of the
 * radius at most, and less than half of that from a cylinder along the tube: a septum beside the rectum or a collar of
 * tissue is no ball. A round lump of tissue with the tube in its middle cannot be told from a balloon of water. */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
