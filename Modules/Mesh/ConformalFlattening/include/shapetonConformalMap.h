#ifndef shapetonConformalMap_h
#define shapetonConformalMap_h

#include "shapetonConformalMapOptions.h"
#include "shapetonRemarks.h"
#include "shapetonFlatDistortion.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonQuadrilateralMap.h"
#include "shapetonSlitMap.h"

namespace shapeton
{
/** Options of MapConformally(), the metric and a progress callback. \ingroup ShapetonConformalFlattening */
struct ConformalMapSettings : ConformalMapOptions
{
  /** Edge lengths in another metric; empty for straight lengths. */
  Eigen::VectorXd edgeLengths;
  /** May throw to abort. */
  Progress progress;
};

/** Name of a field array with the four corners (vertices) of a surface that was cut open to become a rectangle; used if
 * no corners are given. \ingroup ShapetonConformalFlattening */
constexpr char CutCorners[] = "corners";

/** A conformal map of a surface to the plane, with its distortion. \ingroup ShapetonConformalFlattening */
struct ConformalMap
{
  /** As in shapetonFlatSurface.h, with `uv` in mm, counterclockwise as seen from outside, u to the right and v up.
   * - Rectangle, one boundary: starts at (0, 0); height over width is the geometric mean of the two moduli, and the
   * area equals the surface area.
   * - Rectangle, several boundaries: u is 0 at the outer boundary, and one turn has length `circumference`, the mean
   *   length of the level sets of the radius. At the inner boundary u is `length`, the circumference divided by the
   *   geometric mean of the moduli. The cut is straight in space, not in the plane.
   * - Annulus, slit: centered at (0, 0); the annulus has the area of the surface. No vertex is duplicated. For Slit,
   *   `slitMap1`, `slitMap2`, ... are the maps with boundary 1, 2, ... as the inner circle. */
  SurfaceMesh     flat;
  ConformalDomain domain{ ConformalDomain::Slit };
  /** 0 unless there are handles. */
  int                       genus{ 0 };
  std::vector<BoundaryLoop> loops;
  /** Indices into `loops`; the inner one is -1 for a surface with one boundary. */
  int outer{ 0 };
  int inner{ -1 };
  /** Corners of the rectangle of a surface with one boundary; empty otherwise. */
  std::vector<int> corners;
  /** Height over width of the rectangle, or 2 pi / ln(R / r) of the annulus, as in QuadrilateralMap and SlitMap. */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
  /** The slit map of `inner`; for Slit, the slit maps of all inner boundaries. Empty for a rectangle with one boundary.
   */
  std::vector<SlitMap> slitMaps;
  /** Distortion in the metric of the map. */
  FlatDistortion distortion;
  /** Faces with zero mapped area, see EarsOfLoops() (and, with four corners, those on one side). They do not count as
   * flips. */
  std::vector<int> ears;
  /** Flipped faces, ears excluded. */
  int flips{ 0 };
  /** Flipped faces that touch a slit. At slit ends the map behaves like a square root, which piecewise linear maps
   * cannot represent. */
  int flipsAtSlits{ 0 };
  /** Dilatation over faces that are neither flipped nor ears. */
  DistortionQuantiles dilatation;
  /** Number of times the map was computed. It is recomputed with edge weights closer to 1 if faces away from slits were
   * flipped although the surface has no handle. */
  int     solves{ 1 };
  Remarks warnings;

  /** modulusU / modulusV - 1. */
  ShapetonConformalFlattening_EXPORT double
  ModulusGap() const;
};

/** Maps a surface to the plane. A surface with handles is mapped with a warning: the map is conformal away from small
 * handles. Throws InputError with the prefix `what` if the surface is not a single oriented manifold component, the
 * domain does not allow its number of boundaries, or a boundary or corner does not exist; also throws as
 * MakeSurfaceLaplacian() does. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT ConformalMap
MapConformally(const SurfaceMesh & mesh, const ConformalMapSettings & options, const std::string & what);

/** Statistics as JSON. The keys are stable: faces, genus, domain, boundaries (a list of number, vertices, length in mm,
 * role), outerBoundary, innerBoundary, corners, modulusU, modulusV, modulusGap, flips, flipsAtSlits, solves, ears,
 * dilatation (median, p95, p99), slitMaps (a list of innerBoundary, modulusU, modulusV, and for each boundary
 * logRadius and turns). \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT Json
ConformalMapToJson(const ConformalMap & map);
} // namespace shapeton

#endif
