#ifndef shapetonVolumeWriter_h
#define shapetonVolumeWriter_h

#include "ShapetonVolumeFilesExport.h"

#include "itkImage.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Key and value pairs stored in the header of formats that support them (NRRD, MetaImage), such as
 * ProvenanceMetadata().
 * \ingroup ShapetonVolumeFiles */
using VolumeMetadata = std::vector<std::pair<std::string, std::string>>;

/** Returns `path` if it is empty (no output requested) or WriteVolume can write it; throws ParameterError otherwise.
 * For use before a long computation. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT const std::string &
                                 RequireVolumeName(const std::string & path);

/** Writes NRRD, NIfTI or MetaImage, depending on the extension of `path`; labels (integer pixels) are compressed, float
 * pixels are not. The file is read back to detect a full disk. Throws OutputError, and ParameterError for an extension
 * other than .nrrd, .nii, .nii.gz, .mha. Instantiated for float, short, unsigned char, unsigned short and unsigned int
 * pixels.
 * \ingroup ShapetonVolumeFiles */
template <typename TPixel>
void
WriteVolume(const itk::Image<TPixel, 3> * image, const std::string & path, const VolumeMetadata & metadata = {});

extern template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<float, 3> *, const std::string &, const VolumeMetadata &);
extern template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<short, 3> *, const std::string &, const VolumeMetadata &);
extern template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned char, 3> *, const std::string &, const VolumeMetadata &);
extern template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned short, 3> *, const std::string &, const VolumeMetadata &);
extern template ShapetonVolumeFiles_EXPORT void
WriteVolume(const itk::Image<unsigned int, 3> *, const std::string &, const VolumeMetadata &);

/** The volume as 16-bit integers, or null if an intensity is not an integer in the 16-bit range.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT itk::Image<short, 3>::Pointer
                           ToShort(const itk::Image<float, 3> * image);
} // namespace shapeton

#endif
