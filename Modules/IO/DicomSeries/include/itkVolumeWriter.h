#ifndef itkVolumeWriter_h
#define itkVolumeWriter_h

#include "DicomSeriesExport.h"

#include "itkImage.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
class CommandLine;

/** Key and value pairs kept in the header of formats that have room for them (NRRD, MetaImage).
 * \ingroup DicomSeries */
using VolumeMetadata = std::vector<std::pair<std::string, std::string>>;

/** The provenance of a tool's result as metadata: keys start with "Shapeton.".
 * \ingroup DicomSeries */
DicomSeries_EXPORT VolumeMetadata
ProvenanceMetadata(const CommandLine & commandLine);

/** `path`, when it is empty (no output is wanted) or WriteVolume can write it; UsageError otherwise. For a check before
 * a long computation. \ingroup DicomSeries */
DicomSeries_EXPORT const std::string &
                         RequireVolumeName(const std::string & path);

/** Writes NRRD, NIfTI or MetaImage by the extension of `path`; labels (integer pixels) compressed, float pixels raw.
 * The file is read back before the function returns, so that a full disk is noticed. Throws OutputError, and
 * UsageError for an extension that is none of .nrrd, .nii, .nii.gz, .mha.
 * Instantiated for float, short, unsigned char, unsigned short and unsigned int pixels.
 * \ingroup DicomSeries */
template <typename TPixel>
void
WriteVolume(const Image<TPixel, 3> * image, const std::string & path, const VolumeMetadata & metadata = {});

extern template DicomSeries_EXPORT void
WriteVolume(const Image<float, 3> *, const std::string &, const VolumeMetadata &);
extern template DicomSeries_EXPORT void
WriteVolume(const Image<short, 3> *, const std::string &, const VolumeMetadata &);
extern template DicomSeries_EXPORT void
WriteVolume(const Image<unsigned char, 3> *, const std::string &, const VolumeMetadata &);
extern template DicomSeries_EXPORT void
WriteVolume(const Image<unsigned short, 3> *, const std::string &, const VolumeMetadata &);
extern template DicomSeries_EXPORT void
WriteVolume(const Image<unsigned int, 3> *, const std::string &, const VolumeMetadata &);

/** The volume with 16-bit integers, or null when an intensity is no integer in their range.
 * \ingroup DicomSeries */
DicomSeries_EXPORT Image<short, 3>::Pointer
                   ToShort(const Image<float, 3> * image);
} // namespace itk

#endif
