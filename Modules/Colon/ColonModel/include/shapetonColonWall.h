#ifndef shapetonColonWall_h
#define shapetonColonWall_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonLumenTopology.h"
#include "shapetonSurfaceQuality.h"

#include <functional>

namespace shapeton
{
/** An occupancy whose pieces are joined by tubes. \ingroup ShapetonColonModel */
struct BridgedOccupancy
{
  /** The input field itself if no tube was added; otherwise a copy, on a larger grid if a tube requires it. */
  OccupancyImage::ConstPointer occupancy;
  /** Tube axes: pairs of points in LPS mm. */
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axes;
  double                                                   radius{ 2.0 };
  /** Stretches of the centerline outside the lumen that are not marked as gaps; they also get a tube. */
  Remarks warnings;
};

/** Joins the pieces of a lumen by tubes around the centerline where its point array `gap` is 1 or it runs outside the
 * lumen.
 *
 * \param centerline LPS mm, with point arrays `gap` and `arcLength`.
 * \param radius of the tubes, mm, greater than 0; a connected tube needs at least one voxel.
 * Throws InputError when RequireSound() does or an array is missing, ParameterError for a radius out of range.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT BridgedOccupancy
AddBridges(const OccupancyImage * occupancy, const CurveSet & centerline, double radius = 2.0);

/** Extracts the wall as a closed surface: the 0.5 isosurface by marching cubes.
 *
 * Uses vtkFlyingEdges3D; values beyond the image are 0. Of several pieces, the one that encloses the greatest volume is
 * kept. Faces are oriented outward from the lumen (counterclockwise seen from outside), on left-handed grids, too.
 * Vertices are where the field crosses 0.5 between two voxels; values nearer than 0.001 to 0.5 are shifted to that
 * distance, to avoid degenerate faces.
 *
 * \param mask nullptr, or the repaired topology on the same grid: the value of a voxel on the wrong side of 0.5 is
 *        replaced by one minus the value, so the surface has the topology of the mask and other vertices do not move.
 * Throws InputError when no voxel reaches 0.5; std::invalid_argument when the sizes differ.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT SurfaceMesh
ExtractWall(const OccupancyImage * occupancy, const LumenMaskImage * mask = nullptr);

/** Limits on the motion of vertices during smoothing. See SmoothWall(). \ingroup ShapetonColonModel */
struct WallSmoothingOptions
{
  /** Number of pairs of a shrinking and a growing step (Taubin: A signal processing approach to fair surface design,
   * 1995), from 0. */
  int iterations{ 10 };
  /** Maximum displacement of a vertex along its normal, mm, from 0. */
  double normalLimit{ 0.15 };
  /** Maximum displacement along the surface, mm, from 0. */
  double tangentialLimit{ 0.5 };
};

/** Moves vertices to get well-shaped triangles and flat stairs; faces and arrays stay. The result is identical for any
 * number of threads. Boundary vertices stay. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT SurfaceMesh
SmoothWall(const SurfaceMesh & mesh, const WallSmoothingOptions & options);

/** The discs to cut out of a closed wall at rectum and cecum. See OpenColonEnds(). \ingroup ShapetonColonModel */
struct OpenEndsOptions
{
  /** Radius of the disc to cut out at each end, measured along the edges of the surface, mm; straight paths on it are
   * about a tenth shorter. */
  double radius{ 20.0 };
  /** The radius is reduced by steps of 1 mm, down to this, until the region is a disc. */
  double leastRadius{ 2.0 };
  /** Whether to smooth the rims by moving their vertices within their neighborhood. */
  bool smoothRims{ true };
};

/** A wall that is open at rectum and cecum: a tube. See OpenColonEnds(). \ingroup ShapetonColonModel */
struct OpenWall
{
  /** One component with two boundary loops and the genus of the closed surface. Field arrays `rectumLoop` and
   * `cecumLoop`: indices of the vertices of the loops in order. */
  SurfaceMesh mesh;
  /** Radii of the discs, mm. */
  double rectumRadius{ 0.0 };
  double cecumRadius{ 0.0 };
  int    genus{ 0 };
};

/** Opens a closed surface at both ends of the centerline.
 *
 * The pole is where the outward tangent at the end intersects the surface. The largest geodesic disc around it that is
 * also a topological disc is cut out: connected, Euler number 1, one simple boundary.
 *
 * \param centerline one curve, from the rectum to the cecum, LPS mm.
 * Throws InputError when the surface is not closed, the centerline has fewer than two points, or even the smallest
 * region is not a disc. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT OpenWall
OpenColonEnds(const SurfaceMesh & closed, const CurveSet & centerline, const OpenEndsOptions & options = {});

/** Options of BuildColonWall(): size, bridges, ends and smoothing. \ingroup ShapetonColonModel */
struct ColonWallOptions
{
  /** Number of faces of the simplified surface; 0: FacesForDiffusion() of its area and narrowest radius with 55,000. */
  int faces{ 0 };
  /** Radius of the tubes through gaps, mm. */
  double          bridgeRadius{ 2.0 };
  OpenEndsOptions ends;
  /** Maximum displacement of vertices of the repaired surface along their normals, as a share of the smallest
   * spacing. */
  double normalLimit{ 0.2 };
  /** Maximum displacement along the surface, which avoids needle triangles. Vertices of the raw surface move only along
   * the surface. */
  double tangentialLimit{ 0.7 };
  /** Keep the pieces of a broken lumen separate: the faces of the tubes are removed again, so each piece is a component
   * that is open there, and there are more than two loops. */
  bool keepPieces{ false };
  /** Standard deviation of the smoothing of a mask, as a share of the mean spacing, from 0. */
  double maskSmoothing{ 0.7 };
  /** Facts stored with all three surfaces, see SurfaceMesh::facts. */
  std::vector<std::pair<std::string, std::string>> facts;
  /** Called with the completed fraction, 0 to 1. */
  Progress progress;
  /** Called on another thread with the raw and the repaired surface during simplification; with a single thread, after
   * it. Use it for slow work such as writing them. */
  std::function<void(const SurfaceMesh & raw, const SurfaceMesh & repaired)> besideSimplification;
};

/** Changes and counts of BuildColonWall(). \ingroup ShapetonColonModel */
struct ColonWallReport
{
  LumenTopologyReport topology;
  int                 rawGenus{ 0 };
  int                 repairedGenus{ 0 };
  int                 rawFaces{ 0 };
  int                 repairedFaces{ 0 };
  int                 simplifiedFaces{ 0 };
  /** Radii of the discs cut out, mm. */
  double rectumRadius{ 0.0 };
  double cecumRadius{ 0.0 };
  int    bridgedFaces{ 0 };
  /** Quality of the final surfaces. */
  SurfaceQuality rawQuality;
  SurfaceQuality repairedQuality;
  SurfaceQuality simplifiedQuality;
  Remarks        warnings;
};

/** The wall in three forms, each with two boundary loops (the raw one may stay closed, with a warning), point array
 * `arcLength` (mm, of the closest point of the centerline within the lumen), cell array `bridged` (1 on the tubes) and
 * field arrays `rectumLoop`, `cecumLoop`; if the centerline has the array `notAssessable`, also a cell array of it.
 * \ingroup ShapetonColonModel
 */
struct ColonWall
{
  /** The 0.5 isosurface with all its handles; its vertices were moved only along the surface. */
  SurfaceMesh raw;
  /** Without handles, smoothed within the limits. */
  SurfaceMesh repaired;
  /** The repaired surface with fewer faces. */
  SurfaceMesh     simplified;
  ColonWallReport report;
};

/** Bridges, repairs, extracts, opens and simplifies the wall.
 *
 * \param occupancy lumen where at least 0.5, on a grid cropped to it; released after the surfaces are extracted, so a
 * caller who moves the pointer here frees its memory. \param centerline one curve from rectum to cecum with point
 * arrays `arcLength` and `gap`. \param repairedOccupancy a separate field for the repaired surface, for example a
 * smoothed mask; on the same grid. Throws the InputError of its parts, and InputError when the genus or the loops of
 * the simplified surface differ. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonWall
BuildColonWall(OccupancyImage::ConstPointer occupancy,
               const CurveSet &             centerline,
               const ColonWallOptions &     options = {},
               OccupancyImage::ConstPointer repairedOccupancy = nullptr);

/** Builds the wall from a mask: the raw surface from 0 and 1, the repaired one from the smoothed mask.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonWall
BuildColonWallFromMask(const LumenMaskImage * mask, const CurveSet & centerline, const ColonWallOptions & options = {});
} // namespace shapeton

#endif
