#ifndef shapetonWallBulges_h
#define shapetonWallBulges_h

#include "shapetonSurfaceShape.h"

#include <vector>

namespace shapeton
{
/** A part of the wall that bulges into the lumen in all directions, like the head of a polyp and unlike the crest of a
 * fold. \ingroup ShapetonPolypCandidates */
struct WallBulge
{
  /** Vertices, ascending. */
  std::vector<int> vertices;
  /** Center of its surface, LPS, mm. */
  Eigen::Vector3d center{ Eigen::Vector3d::Zero() };
  /** The most prominent vertex, LPS, mm. */
  Eigen::Vector3d apex{ Eigen::Vector3d::Zero() };
  /** Mean normal, a unit vector into the lumen. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** Area, mm^2. */
  double area{ 0.0 };
  /** Integral of the Gaussian curvature: the solid angle of its normals, sr. 2 pi for half an ellipsoid of any
   * flatness, up to 4 pi for a ball on a thin stalk; small for a dent of any size. */
  double solidAngle{ 0.0 };
  /** Mean weighted by the smaller curvature: any bulge is a ridge near its rim, where the weight falls to 0. */
  double shapeIndex{ 0.0 };
  /** Area-weighted mean. */
  double curvedness{ 0.0 };
  /** Largest and smallest width across the axis, mm. */
  double greatestWidth{ 0.0 };
  double leastWidth{ 0.0 };
  /** Height of the apex above the plane of the foot, mm: the plane across the axis through the center of the ring 1 to
   * 2 mm around the bulge. */
  double height{ 0.0 };
  /** Area-weighted mean of the smaller principal curvature of the wall within 2 mm around the bulge, 1/mm. Negative
   * where the wall turns up into the bulge: on all sides of a head, hardly for a bump on the crest of a fold, which
   * continues along the crest, or for a ripple. */
  double footCurvature{ 0.0 };
};

/** Parts of a wall below these limits are left out. \ingroup ShapetonPolypCandidates */
struct WallPartLimits
{
  /** Minimum solid angle, sr. */
  double leastSolidAngle{ 0.08 };
  /** Minimum width, mm. */
  double leastWidth{ 2.0 };
};

/** Measures the connected parts of a wall where `level`, given at its vertices and linear within faces, is positive, in
 * the order of their first vertices. Rims cross faces; areas, means and widths are those within the rims.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<WallBulge>
                       MeasureWallParts(const SurfaceMesh &         wall,
                                        const SurfaceConnectivity & connectivity,
                                        const SurfaceShape &        shape,
                                        const Eigen::VectorXd &     level,
                                        const WallPartLimits &      limits = {});

/** Finds the parts of the wall where the smaller principal curvature, and so both, is above `leastCurvature` (1/mm).
 * `isLeftOut`, one for each vertex, excludes bridges and rims. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<WallBulge>
                       FindWallBulges(const SurfaceMesh &         wall,
                                      const SurfaceConnectivity & connectivity,
                                      const SurfaceShape &        shape,
                                      const std::vector<char> &   isLeftOut,
                                      double                      leastCurvature);
} // namespace shapeton

#endif
