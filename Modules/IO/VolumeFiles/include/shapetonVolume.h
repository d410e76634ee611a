#ifndef shapetonVolume_h
#define shapetonVolume_h

#include "VolumeFilesExport.h"
#include "shapetonRemarks.h"

#include "itkImage.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A volume with its geometry (LPS, mm) and where it comes from.
 * \ingroup VolumeFiles */
struct Volume
{
  using ImageType = itk::Image<float, 3>;
  /** Rescaled intensities; Hounsfield units for CT. */
  ImageType::Pointer image;
  /** "CT", "MR", ...; empty for formats that do not say. */
  std::string modality;
  /** DICOM Patient Position, for example "HFS"; empty when not known. */
  std::string patientPosition;
  std::string seriesUID;
  /** "seriesInstanceUID:..." or "sha256:..." of the file. */
  std::string identity;
  /** Repairs that were made, in words; part of the provenance. */
  std::vector<std::string> repairs;
  /** Remarks for the user, for example "2 localizer images were left out". */
  Remarks notes;
};

/** Volume::identity of a DICOM series. `selector` is that of DicomSeries: the UID, with "#part" for a part of a mixed
 * series. \ingroup VolumeFiles */
VolumeFiles_EXPORT std::string
                   IdentityOfSeries(const std::string & selector);

/** The selector in such an identity; empty for the identity of anything else. \ingroup VolumeFiles */
VolumeFiles_EXPORT std::string
                   SeriesOfIdentity(const std::string & identity);

/** Whether two volumes have the same size and all their voxels lie at the same places, to a hundredth of the smallest
 * spacing. \ingroup VolumeFiles */
VolumeFiles_EXPORT bool
HaveSameGrid(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b);

/** 1 where the voxels of a volume are not 0. Throws InputError, with `path` in front, when there are none.
 * \ingroup VolumeFiles */
VolumeFiles_EXPORT itk::Image<unsigned char, 3>::Pointer
                   MaskOfVolume(const Volume & volume, const std::string & path);

/** MaskOfVolume() of a volume that was read from `path` for an image. Throws InputError where it has another grid than
 * the image, or no voxel other than 0. \ingroup VolumeFiles */
VolumeFiles_EXPORT itk::Image<unsigned char, 3>::Pointer
                   MaskForImage(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image);
} // namespace shapeton

#endif
