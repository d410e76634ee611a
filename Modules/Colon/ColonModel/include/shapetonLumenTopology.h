#ifndef shapetonLumenTopology_h
#define shapetonLumenTopology_h

#include "shapetonCurveSet.h"
#include "shapetonTopologyPreservingGrowth.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Share of lumen in each voxel, 0 to 1; the wall is the 0.5 isosurface. \ingroup ShapetonColonModel */
using OccupancyImage = itk::Image<float, 3>;

/** Findings and changes of RepairLumenTopology(). Volumes in ml. \ingroup ShapetonColonModel */
struct LumenTopologyReport
{
  /** Handles of the largest piece before the repair. */
  std::int64_t handlesBefore{ 0 };
  std::int64_t handlesAfter{ 0 };
  /** Cavities enclosed by the largest piece; they are filled. */
  std::int64_t cavities{ 0 };
  /** Pieces that are not face-connected to the largest one; they are dropped. */
  std::int64_t droppedPieces{ 0 };
  double       lumenVolume{ 0.0 };
  double       droppedVolume{ 0.0 };
  double       cavityVolume{ 0.0 };
  /** Volume cut away to remove all handles. */
  double cutVolume{ 0.0 };
};

struct LumenTopology
{
  /** On the grid of the occupancy; a topological ball: one piece, no cavity, no handle. */
  LumenMaskImage::Pointer mask;
  LumenTopologyReport     report;
};

/** Computes a mask of the voxels of at least 0.5 without handles and cavities, with minimal changes.
 *
 * The largest piece is kept and its cavities are filled. Then an object of one voxel grows by simple points: first
 * along the centerline, if there is one, so that the lumen itself is never cut across, then in the order of the
 * distance to the wall. Fronts around a handle meet where it is thinnest, and the membrane left there cuts it.
 *
 * \param centerline in LPS mm; if empty, the growth starts at the widest place, and a stretch of the lumen narrower
 *        than a leak between its neighbors can be cut instead of the leak.
 * Throws InputError when no voxel reaches 0.5. Time: about 1 microsecond per lumen voxel.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT LumenTopology
RepairLumenTopology(const OccupancyImage * occupancy, const CurveSet & centerline);

/** Converts a mask to an occupancy of 0 and 1; nonzero voxels are lumen. With `sigma` (mm) greater than 0, the field is
 * smoothed by a Gaussian and shifted to keep the number of voxels of at least 0.5: stairs vanish, the volume stays.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT OccupancyImage::Pointer
                 OccupancyFromMask(const LumenMaskImage * mask, double sigma = 0.0);
} // namespace shapeton

#endif
