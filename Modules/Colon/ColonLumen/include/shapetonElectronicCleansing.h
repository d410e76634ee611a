#ifndef shapetonElectronicCleansing_h
#define shapetonElectronicCleansing_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** A CT from which tagged fluid was removed, and the occupancy from which the wall is extracted. See CleanseColon().
 * \ingroup ShapetonColonLumen */
struct CleansedColon
{
  /** The input with fluid and the layer under the gas replaced by gas; other voxels are unchanged. */
  itk::Image<float, 3>::Pointer ct;
  /** Partial volume of lumen in each voxel, 0 to 1; the wall is the 0.5 isosurface. The image is cropped to the
   * surroundings of the lumen and starts at index 0. Border voxels are 0 unless the input border cuts the lumen. */
  itk::Image<float, 3>::Pointer occupancy;
};

/** Removes the tagged fluid of a colon from its CT.
 *
 * The value of a voxel is the mean of gas (fraction g), fluid (fraction f) and tissue (remainder). Near only gas or
 * only fluid, the occupancy is linear in the value. Where a level meets the wall, its subvoxel height determines the
 * ratio of gas to fluid. Where a mixture of gas and fluid resembles tissue, the occupancy is interpolated between the
 * voxels above and below. `ct` is the image from which `lumen` was computed. Throws std::invalid_argument if the sizes
 * differ.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT CleansedColon
CleanseColon(const itk::Image<float, 3> * ct, const ColonLumen & lumen, const Progress & progress = {});
} // namespace shapeton

#endif
