#ifndef shapetonElectronicCleansing_h
#define shapetonElectronicCleansing_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** A CT without tagged fluid, and the occupancy from which the wall is extracted. See CleanseColon().
 * \ingroup ShapetonColonLumen */
struct CleansedColon
{
  /** The input with fluid and the layer under the gas replaced by gas; other voxels keep their values. On the grid of
   * the input. */
  itk::Image<float, 3>::Pointer ct;
  /** Partial volume of lumen in each voxel, 0..1; the wall is the 0.5 isosurface. Covers the part of the input grid
   * around the lumen, with the geometry of that part; starts at index 0. Zero on its border unless the border of the
   * input cuts the lumen. */
  itk::Image<float, 3>::Pointer occupancy;
};

/** Removes the tagged fluid of a colon from its CT.
 *
 * A voxel contains a fraction g of gas, f of fluid and the rest tissue, and its value is their mean: near gas alone or
 * fluid alone the occupancy is linear in the value. Where a level meets the wall, the height of the level, known with
 * subvoxel accuracy, determines how the lumen fraction is split into gas and fluid. Where their mixture looks like
 * tissue, the occupancy is continued from above and below. `ct` is the image that `lumen` was computed from;
 * std::invalid_argument when the sizes differ.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT CleansedColon
CleanseColon(const itk::Image<float, 3> * ct, const ColonLumen & lumen, const Progress & progress = {});
} // namespace shapeton

#endif
