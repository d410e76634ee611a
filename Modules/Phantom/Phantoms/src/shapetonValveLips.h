#ifndef shapetonValveLips_h
#define shapetonValveLips_h

#include "shapetonColonDistance.h"

#include <Eigen/Core>

namespace shapeton
{
/** The two lips of the ileocecal valve in a position: adjacent half ellipsoids on the wall, with a cleft in between and
 * the mouth at its bottom. */
struct ValveLips
{
  Eigen::Vector3d base;      ///< on the wall, below the mouth
  Eigen::Vector3d axis;      ///< unit vector into the lumen
  Eigen::Vector3d slit;      ///< unit vector around the colon, along the mouth
  Eigen::Vector3d across;    ///< unit vector along the colon, from the cecum to the ascending colon
  double          length;    ///< of both lips along the slit, mm
  double          height;    ///< above the wall, mm
  double          thickness; ///< of each lip, mm

  /** Distance to the lips, positive outside, with a rounded bottom of the cleft. */
  ColonDistance
  Distance(const Eigen::Vector3d & point) const;

  /** The middle of the crest of the lip toward the ascending colon (1) or the cecum (-1). */
  Eigen::Vector3d
  Crest(int side) const;

  /** Height (mm) of the bottom of the cleft above the base. */
  double
  MouthHeight() const;

private:
  Eigen::Vector3d
  Middle(int side) const;
};
} // namespace shapeton

#endif
