#ifndef shapetonDiverticulumBody_h
#define shapetonDiverticulumBody_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonDistance.h"

#include <Eigen/Core>

namespace shapeton
{
/** A diverticulum in a position: a ball outside the wall, with a neck from the wall to its center. */
struct DiverticulumBody
{
  Eigen::Vector3d mouth; ///< on the wall
  Eigen::Vector3d sac;   ///< the center of the ball
  double          neckRadius;
  double          radius; ///< radius of the sac
  double          t;      ///< position of the mouth on the curve
  double          angle;
  int             plan; ///< index in the plan

  /** Distance to the flask, positive outside, with a round shoulder between neck and sac. */
  ColonDistance
  Distance(const Eigen::Vector3d & point) const;

  /** Radius of the bounding sphere around the center of the sac. */
  double
  Extent() const;
};

/** Converts a diverticulum of the ground truth, except for its position on the curve. */
DiverticulumBody
BodyOf(const ColonDiverticulum & diverticulum);
} // namespace shapeton

#endif
