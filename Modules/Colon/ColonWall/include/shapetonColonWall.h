#ifndef shapetonColonWall_h
#define shapetonColonWall_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonLumenTopology.h"
#include "shapetonSurfaceQuality.h"

#include <functional>

namespace shapeton
{
/** An occupancy whose pieces are joined by tubes. \ingroup ColonWall */
struct BridgedOccupancy
{
  /** The given field itself where there is no tube; else a copy, on a larger grid where a tube needs it. */
  OccupancyImage::ConstPointer occupancy;
  /** Axes of the tubes: pairs of points in LPS mm. */
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axes;
  double                                                   radius{ 2.0 };
  /** Stretches of the centreline that run outside the lumen although they are no gap; they got a tube, too. */
  Remarks warnings;
};

/** Joins the pieces of a lumen by tubes around the centreline wherever its point array `gap` is 1, and wherever it
 * runs outside the lumen.
 *
 * \param centreline LPS mm, with point arrays `gap` and `arcLength`.
 * \param radius of the tubes, mm, greater than 0; at least one voxel is needed for a tube that holds together.
 * Throws InputError as RequireSound() does and when an array is missing, ParameterError for a radius out of range.
 * \ingroup ColonWall */
ColonWall_EXPORT BridgedOccupancy
AddBridges(const OccupancyImage * occupancy, const CurveSet & centreline, double radius = 2.0);

/** The wall as a closed surface: the 0.5 level by marching cubes.
 *
 * vtkFlyingEdges3D; beyond the image there is nothing. Of several pieces the one that encloses the greatest volume is
 * kept. Faces look outwards from the lumen (counterclockwise where seen from outside it), on left-handed grids, too.
 * Vertices lie where the field passes 0.5 between two voxels; values nearer than 0.001 to 0.5 are moved that far, so
 * that no face is without area.
 *
 * \param mask nullptr, or the repaired topology on the same grid: a voxel on the wrong side of 0.5 gets one minus its
 *        value, so the surface has the topology of the mask and all other vertices stay where they are.
 * Throws InputError when no voxel reaches 0.5; std::invalid_argument when the sizes differ.
 * \ingroup ColonWall */
ColonWall_EXPORT SurfaceMesh
ExtractWall(const OccupancyImage * occupancy, const LumenMaskImage * mask = nullptr);

/** How far the vertices of a wall may move when it is smoothed. See SmoothWall(). \ingroup ColonWall */
struct WallSmoothingOptions
{
  /** Pairs of a shrinking and a growing step (Taubin: A signal processing approach to fair surface design, 1995), from
   * 0.
   */
  int iterations{ 10 };
  /** No vertex moves further than this along its normal, mm, from 0. */
  double normalLimit{ 0.15 };
  /** Nor further than this along the surface, mm, from 0. */
  double tangentialLimit{ 0.5 };
};

/** Moves vertices so that triangles become well shaped and stairs flat; same faces and arrays. Any number of threads
 * gives the same bytes. Vertices of a boundary stay. \ingroup ColonWall */
ColonWall_EXPORT SurfaceMesh
SmoothWall(const SurfaceMesh & mesh, const WallSmoothingOptions & options);

/** The discs that are cut out of a closed wall at rectum and caecum. See OpenColonEnds(). \ingroup ColonWall */
struct OpenEndsOptions
{
  /** Of the disc to cut out at each end, measured along the edges of the surface, mm; straight paths on it are about a
   * tenth shorter. */
  double radius{ 20.0 };
  /** The disc is made smaller by steps of 1 mm, down to this, until it is one. */
  double leastRadius{ 2.0 };
  /** Whether vertices of the rims move, within their neighbourhood, so that the rims are smooth. */
  bool smoothRims{ true };
};

/** A wall that is open at rectum and caecum: a tube. See OpenColonEnds(). \ingroup ColonWall */
struct OpenWall
{
  /** One component with two boundary loops and the genus of the closed surface. Field arrays `rectumLoop` and
   * `caecumLoop`: indices of the vertices of the loops in order. */
  SurfaceMesh mesh;
  /** Of the discs, mm. */
  double rectumRadius{ 0.0 };
  double caecumRadius{ 0.0 };
  int    genus{ 0 };
};

/** Opens a closed surface at both ends of the centreline.
 *
 * The pole is where the outward tangent at the end leaves the surface. The greatest geodesic disc around it is cut out
 * that is a disc also by its topology: connected, Euler number 1, one simple boundary.
 *
 * \param centreline one curve, from the rectum to the caecum, LPS mm.
 * Throws InputError when the surface is not closed, the centreline has no two points, or even the smallest disc is
 * none. \ingroup ColonWall */
ColonWall_EXPORT OpenWall
OpenColonEnds(const SurfaceMesh & closed, const CurveSet & centreline, const OpenEndsOptions & options = {});

/** Size, bridges, ends and smoothing of the walls that BuildColonWall() gives. \ingroup ColonWall */
struct ColonWallOptions
{
  /** Of the simplified surface; 0: FacesForDiffusion() by the area and the narrowest radius of that with 55,000. */
  int faces{ 0 };
  /** Of the tubes through gaps, mm. */
  double          bridgeRadius{ 2.0 };
  OpenEndsOptions ends;
  /** How far smoothing moves vertices of the repaired surface along their normals, as a share of the smallest spacing.
   */
  double normalLimit{ 0.2 };
  /** And along the surface, so that no triangle is a needle. Vertices of the raw surface move along the surface only.
   */
  double tangentialLimit{ 0.7 };
  /** Leave the pieces of a broken lumen apart: the faces of the tubes are taken out again, so each piece is a component
   * that is open where they were, and there are more than two loops. */
  bool keepPieces{ false };
  /** Standard deviation of the smoothing of a mask, as a share of the mean spacing, from 0. */
  double maskSmoothing{ 0.7 };
  /** Of all three surfaces, see SurfaceMesh::facts. */
  std::vector<std::pair<std::string, std::string>> facts;
  /** Told the share that is done, from 0 to 1. */
  Progress progress;
  /** Called on another thread with the raw and the repaired surface while the simplified one is made; where there is
   * one thread alone, after it. For what takes long, such as writing them. */
  std::function<void(const SurfaceMesh & raw, const SurfaceMesh & repaired)> besideSimplification;
};

/** What BuildColonWall() changed and counted on the way from the occupancy to the walls. \ingroup ColonWall */
struct ColonWallReport
{
  LumenTopologyReport topology;
  int                 rawGenus{ 0 };
  int                 repairedGenus{ 0 };
  int                 rawFaces{ 0 };
  int                 repairedFaces{ 0 };
  int                 simplifiedFaces{ 0 };
  /** Of the discs that were cut out, mm. */
  double rectumRadius{ 0.0 };
  double caecumRadius{ 0.0 };
  int    bridgedFaces{ 0 };
  /** Of the surfaces as they are given. */
  SurfaceQuality rawQuality;
  SurfaceQuality repairedQuality;
  SurfaceQuality simplifiedQuality;
  Remarks        warnings;
};

/** The wall in three forms, each with two boundary loops (the raw one may stay closed, with a warning), point array
 * `arcLength` (of the closest point of the centreline within the lumen, mm), cell array `bridged` (1 on the tubes) and
 * field arrays `rectumLoop`, `caecumLoop`; where the centreline has the array `notAssessable`, a cell array of it, too.
 * \ingroup ColonWall
 */
struct ColonWall
{
  /** The 0.5 level with all its handles; its vertices have been moved along the surface only. */
  SurfaceMesh raw;
  /** Without handles, smoothed within the limits. */
  SurfaceMesh repaired;
  /** The repaired one with fewer faces. */
  SurfaceMesh     simplified;
  ColonWallReport report;
};

/** Bridges, repairs, extracts, opens and simplifies the wall.
 *
 * \param occupancy lumen where at least 0.5, on a grid cropped to it; let go of when the surfaces have been extracted,
 * so that a caller who moves his pointer here has the room back. \param centreline one curve from rectum to caecum with
 * point arrays `arcLength` and `gap`. \param repairedOccupancy the field for the repaired surface where it is another
 * one, for example a smoothed mask; on the same grid. Throws InputError as its parts do, and when the simplified
 * surface has another genus or other loops. \ingroup ColonWall */
ColonWall_EXPORT ColonWall
BuildColonWall(OccupancyImage::ConstPointer occupancy,
               const CurveSet &             centreline,
               const ColonWallOptions &     options = {},
               OccupancyImage::ConstPointer repairedOccupancy = nullptr);

/** The same from a mask: the raw surface is that of 0 and 1, the repaired one that of the smoothed mask.
 * \ingroup ColonWall */
ColonWall_EXPORT ColonWall
BuildColonWallFromMask(const LumenMaskImage * mask, const CurveSet & centreline, const ColonWallOptions & options = {});
} // namespace shapeton

#endif
