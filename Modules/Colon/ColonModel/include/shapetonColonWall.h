#ifndef shapetonColonWall_h
#define shapetonColonWall_h

#include "shapetonColonWallOptions.h"
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
  /** The input image if no tube was added; otherwise a copy, on a larger grid if required by a tube. */
  OccupancyImage::ConstPointer occupancy;
  /** Tube axes: pairs of points in LPS mm. */
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axes;
  double                                                   radius{ 2.0 };
  /** Warnings about additional tubes for stretches outside the lumen that are not marked as gaps. */
  Remarks warnings;
};

/** Joins the pieces of a lumen by tubes around the centerline where the point array `gap` is 1, the line is outside the
 * lumen, or the line passes from one piece to another that touches it only at voxel edges.
 *
 * \param centerline LPS mm, with point arrays `gap` and `arcLength`.
 * \param radius of the tubes, mm, greater than 0; should be at least one voxel, otherwise the tube may be disconnected.
 * Throws InputError if RequireSound() fails or an array is missing, and ParameterError for a radius out of range.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT BridgedOccupancy
AddBridges(const OccupancyImage * occupancy, const CurveSet & centerline, double radius = 2.0);

/** Extracts the wall as a closed surface: the 0.5 isosurface by marching cubes.
 *
 * Uses vtkFlyingEdges3D with values of 0 outside the image. Only the piece that encloses the largest volume is kept.
 * Faces are oriented outward (counterclockwise seen from outside) for any handedness of the grid. Values closer than
 * 0.001 to 0.5 are shifted to that distance to avoid degenerate faces.
 *
 * \param mask nullptr, or the repaired topology on the same grid. Values on the wrong side of 0.5 are replaced by 1 -
 * value, so the surface has the topology of the mask; other vertices are unchanged. Throws InputError if all values are
 * below 0.5, and std::invalid_argument if the sizes differ.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT SurfaceMesh
ExtractWall(const OccupancyImage * occupancy, const LumenMaskImage * mask = nullptr);

/** Discs to remove from a closed wall at rectum and cecum. See OpenColonEnds(). \ingroup ShapetonColonModel */
struct OpenEndsOptions
{
  /** Radius (mm) of the disc to remove at each end, measured along surface edges; geodesic distances are about a tenth
   * shorter. What is removed is neither shown nor searched for polyps. Chosen: half of the smallest polyp that counts;
   * the map of a smaller opening is longer without showing more. */
  double radius{ 3.0 };
  /** Lower bound for reducing the radius in steps of 1 mm until the region is a disc. On a surface with edges so long
   * that none is one, the radius grows to at most twice the longest edge at the pole. */
  double leastRadius{ 2.0 };
  /** Whether to smooth the rims by moving their vertices locally. */
  bool smoothRims{ true };
};

/** A wall with openings at rectum and cecum: a tube. See OpenColonEnds(). \ingroup ShapetonColonModel */
struct OpenWall
{
  /** One component with two boundary loops and the genus of the closed surface. The field arrays `rectumLoop` and
   * `cecumLoop` are the ordered vertex indices of the loops. */
  SurfaceMesh mesh;
  /** Radii of the discs, mm. */
  double rectumRadius{ 0.0 };
  double cecumRadius{ 0.0 };
  int    genus{ 0 };
};

/** Opens a closed surface at both ends of the centerline.
 *
 * The pole is the intersection of the surface with the outward tangent at the end. The largest geodesic disc around it
 * that is a topological disc (connected, Euler number 1, one simple boundary) is removed.
 *
 * \param centerline one curve, from the rectum to the cecum, LPS mm.
 * Throws InputError if the surface is not closed, the centerline has fewer than two points, or even the smallest region
 * is not a disc. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT OpenWall
OpenColonEnds(const SurfaceMesh & closed, const CurveSet & centerline, const OpenEndsOptions & options = {});

/** Settings of BuildColonWall(). If `faces` is 0, FacesForDiffusion() computes the number from the area and the
 * smallest radius of a surface simplified to 55,000 faces. \ingroup ShapetonColonModel */
struct ColonWallSettings : ColonWallOptions
{
  OpenEndsOptions ends;
  /** Metadata stored with all three surfaces, see SurfaceMesh::facts. */
  std::vector<std::pair<std::string, std::string>> facts;
  /** Called with the completed fraction, 0 to 1. */
  Progress progress;
  /** Called on another thread with the raw and repaired surface during simplification (afterwards if single-threaded).
   * Intended for slow work such as writing them. */
  std::function<void(const SurfaceMesh & raw, const SurfaceMesh & repaired)> besideSimplification;
};

/** Changes made by BuildColonWall(), and counts. \ingroup ShapetonColonModel */
struct ColonWallReport
{
  LumenTopologyReport topology;
  int                 rawGenus{ 0 };
  int                 repairedGenus{ 0 };
  /** Genus of the simplified surface before and after its handles were cut; equal unless the topology is Denoised. */
  int simplifiedGenusBefore{ 0 };
  int simplifiedGenus{ 0 };
  int rawFaces{ 0 };
  int repairedFaces{ 0 };
  int simplifiedFaces{ 0 };
  /** Radii of the removed discs, mm. */
  double rectumRadius{ 0.0 };
  double cecumRadius{ 0.0 };
  int    bridgedFaces{ 0 };
  /** Quality of the final surfaces. */
  SurfaceQuality rawQuality;
  SurfaceQuality repairedQuality;
  SurfaceQuality simplifiedQuality;
  Remarks        warnings;
};

/** The wall in three versions, each with two boundary loops (the raw one may remain closed, with a warning), point
 * array `arcLength` (mm, that of the closest point of the centerline, measured within the lumen), cell array `bridged`
 * (1 on the tubes) and field arrays `rectumLoop`, `cecumLoop`. A point array `notAssessable` of the centerline is also
 * copied to a cell array.
 * \ingroup ShapetonColonModel
 */
struct ColonWall
{
  /** The 0.5 isosurface with all handles; vertices were moved only along the surface. */
  SurfaceMesh raw;
  /** The isosurface without handles, smoothed within the limits. */
  SurfaceMesh repaired;
  /** The wall to flatten, with fewer faces: the simplified repaired surface or, for topologies other than Repaired (see
   * ColonWallOptions), a surface from the same occupancy with the same smoothing but without that repair. */
  SurfaceMesh     simplified;
  ColonWallReport report;
};

/** Throws ParameterError unless `faces` of ColonWallOptions is 0 or at least 1000. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT void
RequireFacesOfWall(int faces);

/** Bridges, repairs, extracts, opens and simplifies the wall.
 *
 * \param occupancy the lumen is where values are at least 0.5; the grid is cropped to it. Released after surface
 * extraction; move the pointer here to free the memory early. \param centerline one curve from rectum to cecum with
 * point arrays `arcLength` and `gap`. \param repairedOccupancy a separate occupancy on the same grid for the repaired
 * surface, for example a smoothed mask. Throws InputError if a step fails, or if the genus or the loops of the
 * simplified surface differ.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonWall
BuildColonWall(OccupancyImage::ConstPointer occupancy,
               const CurveSet &             centerline,
               const ColonWallSettings &    options = {},
               OccupancyImage::ConstPointer repairedOccupancy = nullptr);

/** Builds the wall from a mask: the raw surface from the binary mask, and the repaired one from the smoothed mask.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonWall
BuildColonWallFromMask(const LumenMaskImage *    mask,
                       const CurveSet &          centerline,
                       const ColonWallSettings & options = {});
} // namespace shapeton

#endif
