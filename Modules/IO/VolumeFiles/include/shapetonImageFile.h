#ifndef shapetonImageFile_h
#define shapetonImageFile_h

#include "shapetonVolume.h"

#include <string>

namespace shapeton
{
/** True for the extensions of NRRD, NIfTI and MetaImage; for .img, an ambiguous extension, only next to an .hdr file.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT bool
IsImageFile(const std::string & path);

/** Reads a NRRD, NIfTI (1 or 2) or MetaImage file and sets image, identity and notes of the result. Supports
 * three-dimensional scalar images with positive finite spacing, orthogonal axes and finite voxel values; a fourth
 * dimension must have size 1. Throws InputError with the file name and the defect. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT Volume
ReadImageFile(const std::string & path);
} // namespace shapeton

#endif
