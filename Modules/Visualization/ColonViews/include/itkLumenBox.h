#ifndef itkLumenBox_h
#define itkLumenBox_h

#include "itkColonPictures.h"

#include <array>

namespace itk
{
/** The voxels of the lumen in each slice across each axis of the volume. */
using LumenAreas = std::array<std::vector<std::size_t>, 3>;

/** \ingroup ColonViews */
ColonViews_EXPORT LumenAreas
AreasOf(const Image<unsigned char, 3> * lumen);

/** The lumen's voxels, in a box with a margin of so many mm inside of the volume. Throws std::invalid_argument where
 * there is no lumen. */
ColonViews_EXPORT ImageRegion<3>
LumenBox(const Image<unsigned char, 3> * lumen, const LumenAreas & areas, double margin);

/** Throws std::invalid_argument where there is no lumen, or the CT lies on another grid. */
ColonViews_EXPORT void
CheckParts(const ColonParts & colon);
} // namespace itk

#endif
