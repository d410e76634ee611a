#ifndef shapetonWallBulges_h
#define shapetonWallBulges_h

#include "shapetonSurfaceShape.h"

#include <limits>
#include <vector>

namespace shapeton
{
/** A part of the wall that bulges into the lumen in all directions, like the head of a polyp but unlike the crest of a
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
  /** Integral of the Gaussian curvature, the solid angle of the normals, sr: 2 pi for any half ellipsoid, up to 4 pi
   * for a ball on a thin stalk, and small for ripples of any size. */
  double solidAngle{ 0.0 };
  /** Mean weighted by the smaller curvature, which is 0 at the rim, where any bulge resembles a ridge. */
  double shapeIndex{ 0.0 };
  /** Area-weighted mean. */
  double curvedness{ 0.0 };
  /** Largest and smallest width perpendicular to the axis, mm. */
  double greatestWidth{ 0.0 };
  double leastWidth{ 0.0 };
  /** Height (mm) of the apex above the foot: the plane perpendicular to the axis through the center of the ring 1 to 2
   * mm around the bulge. */
  double height{ 0.0 };
  /** Area-weighted mean of the smaller principal curvature of the wall within 2 mm around the bulge, 1/mm. Negative for
   * a concave foot. A head has a concave foot on all sides; a ripple or a bump on the crest of a fold has almost
   * none. */
  double footCurvature{ 0.0 };
};

/** Solid angle (sr) that separates bulges from plaques. \ingroup ShapetonPolypCandidates */
constexpr double LeastSolidAngleOfBulge = 0.08;

/** Limits on the size of parts of a wall. \ingroup ShapetonPolypCandidates */
struct WallPartLimits
{
  /** Minimum solid angle, sr. */
  double leastSolidAngle{ LeastSolidAngleOfBulge };
  /** Minimum width, mm. */
  double leastWidth{ 2.0 };
  /** Solid angle, sr; only parts below it are kept. */
  double solidAngleEnd{ std::numeric_limits<double>::infinity() };
};

/** Measures the connected parts of a wall where the vertex function `level`, linear within faces, is positive, in the
 * order of their first vertices. Rims cross faces; areas, means and widths refer to the part inside the rim.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<WallBulge>
                               MeasureWallParts(const SurfaceMesh &         wall,
                                                const SurfaceConnectivity & connectivity,
                                                const SurfaceShape &        shape,
                                                const Eigen::VectorXd &     level,
                                                const WallPartLimits &      limits = {});

/** Finds the parts of the wall where both principal curvatures are above `leastCurvature` (1/mm). `isLeftOut` (per
 * vertex) excludes bridges and rims. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<WallBulge>
                               FindWallBulges(const SurfaceMesh &         wall,
                                              const SurfaceConnectivity & connectivity,
                                              const SurfaceShape &        shape,
                                              const std::vector<char> &   isLeftOut,
                                              double                      leastCurvature);

/** Finds plaques: broad convex parts of the wall (both principal curvatures positive, at least 4 mm wide) whose solid
 * angle is too small for a bulge, such as flat polyps. A half ellipsoid 16 mm wide and 2.3 mm high, fused with a
 * concave wall, has a solid angle of 0.05 sr. A bulge is never a part of a plaque, because its solid angle is greater.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<WallBulge>
                               FindWallPlaques(const SurfaceMesh &         wall,
                                               const SurfaceConnectivity & connectivity,
                                               const SurfaceShape &        shape,
                                               const std::vector<char> &   isLeftOut);
} // namespace shapeton

#endif
