#ifndef shapetonDiverticulumBody_h
#define shapetonDiverticulumBody_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonDistance.h"

#include <Eigen/Core>

namespace shapeton
{
/** A diverticulum in a position: a ball outside of the wall and a neck from the wall to its middle. */
struct DiverticulumBody
{
  Eigen::Vector3d mouth; ///< on the wall
  Eigen::Vector3d sac;   ///< the middle of the ball
  double          neckRadius;
  double          radius; ///< of the sac
  double          t;      ///< place of the mouth on the curve
  double          angle;
  int             plan; ///< its number in the plan

  /** Distance to the flask, positive outside, with a round shoulder between neck and sac. */
  ColonDistance
  Distance(const Eigen::Vector3d & point) const;

  /** No point of the flask is farther from the middle of its sac. */
  double
  Extent() const;
};

/** Where a diverticulum of the truth is; without its place on the curve. */
DiverticulumBody
BodyOf(const ColonDiverticulum & diverticulum);
} // namespace shapeton

#endif
