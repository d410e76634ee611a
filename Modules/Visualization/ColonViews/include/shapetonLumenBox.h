#ifndef shapetonLumenBox_h
#define shapetonLumenBox_h

#include "shapetonColonPictures.h"

#include <array>

namespace shapeton
{
/** Number of lumen voxels in each slice along each axis of the volume. */
using LumenAreas = std::array<std::vector<std::size_t>, 3>;

/** Counts the voxels of the lumen in all slices. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT LumenAreas
AreasOf(const itk::Image<unsigned char, 3> * lumen);

/** Bounding box of the lumen, with a margin in mm, clipped to the volume. Throws std::invalid_argument without a
 * lumen. */
ShapetonColonViews_EXPORT itk::ImageRegion<3>
                          LumenBox(const itk::Image<unsigned char, 3> * lumen, const LumenAreas & areas, double margin);

/** Throws std::invalid_argument if there is no lumen or the CT has a different grid. */
ShapetonColonViews_EXPORT void
CheckParts(const ColonParts & colon);
} // namespace shapeton

#endif
