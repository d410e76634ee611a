#ifndef shapetonLumenTopology_h
#define shapetonLumenTopology_h

#include "shapetonCurveSet.h"
#include "shapetonTopologyPreservingGrowth.h"

namespace shapeton
{
/** Fraction of lumen in each voxel, 0 to 1; the wall is the 0.5 isosurface. \ingroup ShapetonColonModel */
using OccupancyImage = itk::Image<float, 3>;

/** Findings and changes of RepairLumenTopology(). Volumes in ml. \ingroup ShapetonColonModel */
struct LumenTopologyReport
{
  /** Number of handles in the largest piece before the repair. */
  std::int64_t handlesBefore{ 0 };
  std::int64_t handlesAfter{ 0 };
  /** Cavities in the largest piece, which are filled. */
  std::int64_t cavities{ 0 };
  /** Pieces not face-connected to the largest one, which are removed. */
  std::int64_t droppedPieces{ 0 };
  double       lumenVolume{ 0.0 };
  double       droppedVolume{ 0.0 };
  double       cavityVolume{ 0.0 };
  /** Volume removed to cut all handles. */
  double cutVolume{ 0.0 };
};

struct LumenTopology
{
  /** On the grid of the occupancy; a topological ball: one piece, no cavity, no handle. */
  LumenMaskImage::Pointer mask;
  LumenTopologyReport     report;
};

/** Computes a mask of the voxels with values of at least 0.5, with the minimal changes that remove handles and
 * cavities.
 *
 * The largest piece is kept and its cavities are filled. Then a single voxel is grown by simple points, first along the
 * centerline (if given), to avoid cuts across the lumen, then in order of decreasing distance to the wall. The fronts
 * around a handle meet where it is thinnest, and the remaining membrane cuts it.
 *
 * \param centerline in LPS mm. If empty, growth starts at the voxel with maximum distance to the wall, and a stretch of
 * lumen narrower than a leak may be cut instead of the leak. Throws InputError if all values are below 0.5. Takes about
 * 1 microsecond per lumen voxel.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT LumenTopology
RepairLumenTopology(const OccupancyImage * occupancy, const CurveSet & centerline);

/** Converts a mask to an occupancy of 0 and 1; nonzero voxels are lumen. For `sigma` (mm) greater than 0, the field is
 * smoothed by a Gaussian to remove stairs and shifted to preserve the number of voxels with values of at least 0.5.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT OccupancyImage::Pointer
                          OccupancyFromMask(const LumenMaskImage * mask, double sigma = 0.0);
} // namespace shapeton

#endif
