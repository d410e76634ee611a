#ifndef shapetonConformalMap_h
#define shapetonConformalMap_h

#include "shapetonRemarks.h"
#include "shapetonFlatDistortion.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonQuadrilateralMap.h"
#include "shapetonSlitMap.h"

namespace shapeton
{
/** Where to map a surface. \ingroup ConformalFlattening */
enum class ConformalDomain
{
  /** One boundary: a rectangle with four corners. Several: the logarithm of the slit map, a strip cut open from the
   * outer to the inner boundary, in which slits are segments of constant u. */
  Rectangle,
  /** An outer and one inner boundary: concentric circles. */
  Annulus,
  /** An outer and any number of inner boundaries: an annulus with concentric circular slits, one for each choice of the
   * boundary that becomes the inner circle. */
  Slit
};

/** Domain, boundaries and metric for MapConformally(). \ingroup ConformalFlattening */
struct ConformalMapOptions
{
  ConformalDomain domain{ ConformalDomain::Slit };
  /** Numbers of boundaries from 1 in the order of BoundaryLoopsByLength(); 0: the longest one as outer, and the longest
   * one left as inner. */
  int outerBoundary{ 0 };
  int innerBoundary{ 0 };
  /** Four vertices of the only boundary as for MapQuadrilateral(); none: SpreadCorners(). */
  std::vector<int> corners;
  /** Lengths of the edges in another metric; empty for the straight ones. */
  Eigen::VectorXd edgeLengths;
  /** It may throw in order to abort. */
  Progress progress;
};

/** A surface on the plane, and how well. \ingroup ConformalFlattening */
struct ConformalMap
{
  /** As in shapetonFlatSurface.h, with `uv` in mm, counterclockwise as seen from outside, u to the right and v up.
   * - Rectangle of one boundary: from (0, 0) on; height over width is the geometric mean of the two moduli, and the
   *   area is that of the surface.
   * - Rectangle of several: u from 0 at the outer boundary, one turn is `circumference`, the mean length of the level
   *   sets of the radius; u at the inner boundary is `length`, circumference over the geometric mean of the moduli. The
   * cut is straight in space, not in the plane.
   * - Annulus, slit: around (0, 0); the annulus has the area of the surface. No vertex is duplicated, and `slitMap1`,
   *   `slitMap2`, ... hold the maps that have boundary 1, 2, ... as the inner circle (Slit alone). */
  SurfaceMesh     flat;
  ConformalDomain domain{ ConformalDomain::Slit };
  /** 0 unless there are handles. */
  int                       genus{ 0 };
  std::vector<BoundaryLoop> loops;
  /** Elements of `loops`; the inner one is -1 where there is one boundary. */
  int outer{ 0 };
  int inner{ -1 };
  /** Of the rectangle of one boundary; none otherwise. */
  std::vector<int> corners;
  /** Height over width of the rectangle, or 2 pi / ln(R / r) of the annulus, as in QuadrilateralMap and SlitMap. */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
  /** The map of `inner`, and with Slit those of all inner boundaries; none for a rectangle of one boundary. */
  std::vector<SlitMap> slitMaps;
  /** In the metric of the map. */
  FlatDistortion distortion;
  /** Faces that the map gives no area, see EarsOfLoops() (and, with four corners, those on one side); they are no
   * flips.
   */
  std::vector<int> ears;
  /** Flipped faces that are no ears. */
  int flips{ 0 };
  /** Those of them that touch a slit: at its ends the map is a square root, which no triangle can be. */
  int flipsAtSlits{ 0 };
  /** Over the faces that are neither. */
  DistortionQuantiles dilatation;
  /** How often the map was computed: again, with weights of edges brought nearer to 1, where faces away from slits were
   * flipped, though there is no handle. */
  int     solves{ 1 };
  Remarks warnings;

  /** modulusU / modulusV - 1. */
  ConformalFlattening_EXPORT double
  ModulusGap() const;
};

/** Maps a surface to the plane. One with handles is mapped with a warning: the map is conformal away from them as far
 * as they are small. Throws InputError, which begins with `what`, where the surface is not one manifold, oriented
 * component, has too few or too many boundaries for the domain, a boundary or corner does not exist, and as
 * MakeSurfaceLaplacian() does. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT ConformalMap
MapConformally(const SurfaceMesh & mesh, const ConformalMapOptions & options, const std::string & what);

/** The figures for programs. Keys, whose names stay: faces, genus, domain, boundaries (a list of number, vertices,
 * length in mm, role), outerBoundary, innerBoundary, corners, modulusU, modulusV, modulusGap, flips, flipsAtSlits,
 * solves, ears, dilatation (median, p95, p99), slitMaps (a list of innerBoundary, modulusU, modulusV, and for each
 * boundary logRadius and turns). \ingroup ConformalFlattening */
ConformalFlattening_EXPORT Json
ConformalMapToJson(const ConformalMap & map);
} // namespace shapeton

#endif
