#ifndef shapetonVolume_h
#define shapetonVolume_h

#include "ShapetonVolumeFilesExport.h"
#include "shapetonRemarks.h"

#include "itkImage.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** A volume with its geometry (LPS, mm) and provenance.
 * \ingroup ShapetonVolumeFiles */
struct Volume
{
  using ImageType = itk::Image<float, 3>;
  /** Rescaled intensities; Hounsfield units for CT. Its MetaDataDictionary has the fields of shapetonDicomFields.h. */
  ImageType::Pointer image;
  /** "CT", "MR", ...; empty if unknown. */
  std::string modality;
  /** DICOM Patient Position, for example "HFS"; empty if unknown. */
  std::string patientPosition;
  /** DICOM Slice Thickness, mm; 0 if unknown. It may differ from the slice spacing. */
  double      sliceThickness{ 0.0 };
  std::string seriesUID;
  /** "seriesInstanceUID:..." or "sha256:..." of the file. */
  std::string identity;
  /** Descriptions of the applied repairs; part of the provenance. */
  std::vector<std::string> repairs;
  /** Remarks for the user, for example on skipped localizer images. */
  Remarks notes;
};

/** Volume::identity of a DICOM series. `selector` is the UID, with "#part" for a part of a mixed series; see
 * DicomSeries. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT std::string
                           IdentityOfSeries(const std::string & selector);

/** The selector contained in a series identity; empty for any other identity. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT std::string
                           SeriesOfIdentity(const std::string & identity);

/** Modality, Patient Position and Slice Thickness as metadata for the header of an NRRD or MetaImage file, under the
 * keys of shapetonDicomFields.h; unknown ones are left out. ReadVolume() reads them. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT std::vector<std::pair<std::string, std::string>>
                           DicomMetadata(const Volume & volume);

/** A mask that is 1 where the volume is not 0. Throws InputError, prefixed by `path`, if all voxels are 0.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT itk::Image<unsigned char, 3>::Pointer
                           MaskOfVolume(const Volume & volume, const std::string & path);

/** MaskOfVolume() of a volume read from `path`, for use with an image. Throws InputError if its grid differs from that
 * of the image or all its voxels are 0. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT itk::Image<unsigned char, 3>::Pointer
MaskForImage(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image);
} // namespace shapeton

#endif
