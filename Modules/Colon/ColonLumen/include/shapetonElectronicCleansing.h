#ifndef shapetonElectronicCleansing_h
#define shapetonElectronicCleansing_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** A CT without tagged fluid, and the occupancy from which the wall is extracted. See CleanseColon().
 * \ingroup ColonLumen */
struct CleansedColon
{
  /** The input with fluid and the layer under the gas replaced by gas; what is not lumen keeps its values. On the
   * input's grid. */
  itk::Image<float, 3>::Pointer ct;
  /** The share of lumen, 0..1, that the scanner saw in each voxel; the wall's surface is where it passes 0.5. On the
   * part of the input's grid around the lumen, with the geometry of that part; starts at index 0. Zero on its border
   * unless the input's own border cuts the lumen. */
  itk::Image<float, 3>::Pointer occupancy;
};

/** Removes the tagged fluid of a colon from its CT.
 *
 * What a voxel holds is g gas, f fluid and the rest tissue, and its value is their mean: near gas alone or fluid alone
 * the occupancy is linear in the value. Where a level meets the wall, the level's height, known far more finely than
 * the voxels, says how the lumen's part is shared between gas and fluid; where their mixture looks like tissue, the
 * occupancy continues from above and below. `ct` is the image that `lumen` comes from; std::invalid_argument when the
 * sizes differ.
 * \ingroup ColonLumen */
ColonLumen_EXPORT CleansedColon
CleanseColon(const itk::Image<float, 3> * ct, const ColonLumen & lumen, const Progress & progress = {});
} // namespace shapeton

#endif
