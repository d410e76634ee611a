#ifndef shapetonLumenBox_h
#define shapetonLumenBox_h

#include "shapetonColonPictures.h"

#include <array>

namespace shapeton
{
/** The voxels of the lumen in each slice across each axis of the volume. */
using LumenAreas = std::array<std::vector<std::size_t>, 3>;

/** Counts the voxels of the lumen in all slices. \ingroup ColonViews */
ColonViews_EXPORT LumenAreas
AreasOf(const itk::Image<unsigned char, 3> * lumen);

/** The lumen's voxels, in a box with a margin of so many mm inside of the volume. Throws std::invalid_argument where
 * there is no lumen. */
ColonViews_EXPORT itk::ImageRegion<3>
                  LumenBox(const itk::Image<unsigned char, 3> * lumen, const LumenAreas & areas, double margin);

/** Throws std::invalid_argument where there is no lumen, or the CT lies on another grid. */
ColonViews_EXPORT void
CheckParts(const ColonParts & colon);
} // namespace shapeton

#endif
