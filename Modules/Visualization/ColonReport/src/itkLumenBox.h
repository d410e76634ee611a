#ifndef itkLumenBox_h
#define itkLumenBox_h

#include "itkColonPictures.h"

namespace itk
{
/** The voxels of the lumen in each slice across an axis of the volume. */
std::vector<std::size_t>
LumenAreas(const Image<unsigned char, 3> * lumen, unsigned int axis);

/** The lumen's voxels, in a box with a margin of so many mm inside of the volume. Throws std::invalid_argument where
 * there is no lumen. */
ImageRegion<3>
LumenBox(const Image<unsigned char, 3> * lumen, double margin);

/** Throws std::invalid_argument where there is no lumen, or the CT lies on another grid. */
void
CheckParts(const ColonParts & colon);
} // namespace itk

#endif
