#ifndef shapetonCatheterBalloon_h
#define shapetonCatheterBalloon_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
constexpr double ThickestMembrane = 3.0; // mm, blurred

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
 * next to each other, and three quarters of these places lie within 1.5 mm of a ball around the tube, 2.5 mm wider than
 * that at least, with a root mean square of .6 mm (or a twelfth of the radius). The wall of the rectum alone is nowhere
 * thin, and a fold does not lie on a ball. */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
