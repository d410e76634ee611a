#ifndef shapetonCatheterBalloon_h
#define shapetonCatheterBalloon_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
constexpr double ThickestMembrane = 2.5; // mm

/** A ball around a balloon. */
struct CatheterBalloon
{
  Eigen::Vector3d centre;
  double          radius{ 0.0 }; ///< mm
};

/** The balloon around a tube. It shows in 10 mm of sections at least: there the rays that leave the tube's wall reach a
 * second layer 6 to 30 mm from the axis, at an even distance (ovality below .25), and a third of them find it thin,
 * with gas behind; the others reach the rectum's wall. That wall alone is nowhere thin, and a fold does not go round.
 */
std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region);
} // namespace shapeton

#endif
