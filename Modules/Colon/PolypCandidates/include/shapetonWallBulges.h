#ifndef shapetonWallBulges_h
#define shapetonWallBulges_h

#include "shapetonSurfaceShape.h"

#include <vector>

namespace shapeton
{
/** A part of the wall that bulges into the lumen in all directions, as the head of a polyp does and the crest of a fold
 * does not. \ingroup PolypCandidates */
struct WallBulge
{
  /** Its vertices, ascending. */
  std::vector<int> vertices;
  /** The middle of its surface, LPS, mm. */
  Eigen::Vector3d centre{ Eigen::Vector3d::Zero() };
  /** The vertex that stands out farthest, LPS, mm. */
  Eigen::Vector3d apex{ Eigen::Vector3d::Zero() };
  /** Mean normal, a unit vector into the lumen. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** mm^2. */
  double area{ 0.0 };
  /** Integral of the Gaussian curvature: the solid angle of its normals, sr. 2 pi for half an ellipsoid of any
   * flatness, up to 4 pi for a ball on a thin stalk; little for a dent, whatever its size. */
  double solidAngle{ 0.0 };
  /** Mean weighted by the lesser curvature: towards the rim any bulge is a ridge, and there the weight falls to 0. */
  double shapeIndex{ 0.0 };
  /** Mean by area. */
  double curvedness{ 0.0 };
  /** Greatest and least width across the axis, mm. */
  double greatestWidth{ 0.0 };
  double leastWidth{ 0.0 };
  /** How far the apex stands above the plane of the foot, mm: the plane across the axis through the middle of the ring
   * 1 to 2 mm around the bulge. */
  double height{ 0.0 };
  /** Mean of the lesser principal curvature, by area, of the wall within 2 mm around the bulge, 1/mm. Negative: there
   * the wall turns up into the bulge. A head has it on all sides; a bump on the crest of a fold, which goes on along
   * the crest, and a ripple have little of it. */
  double footCurvature{ 0.0 };
};

/** What is left out of the parts of a wall. \ingroup PolypCandidates */
struct WallPartLimits
{
  /** sr. */
  double leastSolidAngle{ 0.08 };
  /** mm. */
  double leastWidth{ 2.0 };
};

/** The connected parts of a wall where `level`, given at its vertices and linear within faces, is positive, measured,
 * in the order of their first vertices. Rims cross faces; areas, means and widths are those within the rims.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<WallBulge>
                       MeasureWallParts(const SurfaceMesh &         wall,
                                        const SurfaceConnectivity & connectivity,
                                        const SurfaceShape &        shape,
                                        const Eigen::VectorXd &     level,
                                        const WallPartLimits &      limits = {});

/** The parts of the wall where the lesser principal curvature, and so both, is above `leastCurvature` (1/mm).
 * `isLeftOut`, one for each vertex, tells what is no wall (bridges, rims). \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<WallBulge>
                       FindWallBulges(const SurfaceMesh &         wall,
                                      const SurfaceConnectivity & connectivity,
                                      const SurfaceShape &        shape,
                                      const std::vector<char> &   isLeftOut,
                                      double                      leastCurvature);
} // namespace shapeton

#endif
