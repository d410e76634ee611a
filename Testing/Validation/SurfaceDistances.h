#ifndef SurfaceDistances_h
#define SurfaceDistances_h

#include "shapetonLumenDistance.h"

/** Distances between the surfaces of two masks, in both directions.
 *
 * The surface of a mask consists of the centers of its voxels with a face neighbor outside of it (voxel resolution);
 * voxels at the border of the image do not count for that reason alone. The distance of a point is measured to the
 * nearest surface point of the other mask, in mm, exact for anisotropic and oblique grids. Sources: Heimann et al.,
 * IEEE TMI 28 (2009) 1251-1265; Maier-Hein et al., Metrics reloaded, Nature Methods 21 (2024) 195-212. */
struct SurfaceDistances
{
  /** Mean of the distances of the points of both surfaces: average symmetric surface distance (ASSD). */
  double average{ 0.0 };
  /** 95 % Hausdorff distance: 95th percentile of the distances of the points of a surface, the larger of both
   * directions. */
  double hausdorff95{ 0.0 };
};

/** Nonzero voxels belong to the masks. Infinite if one mask has no surface, 0 if both have none. Throws InputError if
 * the grids differ. */
SurfaceDistances
MeasureSurfaceDistances(const shapeton::LumenMask * first, const shapeton::LumenMask * second);

#endif
