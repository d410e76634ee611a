#ifndef itkVolumeReader_h
#define itkVolumeReader_h

#include "DicomSeriesExport.h"

#include "itkImage.h"

#include <string>
#include <vector>

namespace itk
{
class CommandLine;

/** What a reader may repair. By default an irregular series is refused.
 * \ingroup DicomSeries */
struct VolumeReadOptions
{
  /** The Series Instance UID to take; needed where a folder holds two or more usable volumes. "UID#2" takes the second
   * part of a mixed series, as DicomSeriesInspector numbers them. */
  std::string seriesUID;
  /** Fill gaps and uneven spacing by linear interpolation along the slice axis. Slices that lie on the new grid are
   * kept as they are. */
  bool resampleGaps{ false };
  /** Resample a sheared (tilted) volume onto a grid with perpendicular axes: each slice keeps its plane and is moved
   * within it by linear interpolation; what no slice covers gets the lowest intensity. */
  bool deshear{ false };
  /** Keep the first of several slices at one position. */
  bool dropDuplicates{ false };
  /** Take one DICOM slice as a volume of one slice; its thickness is its Slice Thickness, 1 mm where that is missing.
   */
  bool allowSingleSlice{ false };
};

/** A volume with its geometry (LPS, mm) and where it comes from.
 * \ingroup DicomSeries */
struct Volume
{
  using ImageType = Image<float, 3>;
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
  std::vector<std::string> notes;
};

/** Reads a folder (searched recursively), one DICOM file, or one NRRD, NIfTI or MetaImage file.
 *
 * A folder: one usable series beside localizers, other images or irregular series is taken with a note; two or more
 * need VolumeReadOptions::seriesUID. One DICOM file: that file alone, all frames of an enhanced multi-frame image,
 * never the other files of its folder. Pixel Padding Value becomes the lowest other intensity of the volume.
 *
 * NRRD (.nrrd, .nhdr), NIfTI (.nii, .nii.gz) and MetaImage (.mha, .mhd): three-dimensional scalar images with positive
 * finite spacing, perpendicular axes and finite voxels. A fourth dimension must have the size 1. Left-handed axes, as
 * most NIfTI files have, are kept.
 *
 * Throws InputError that names the file or series, the defect and the slices concerned, and what to do; UsageError when
 * a series is chosen from a file that has none.
 * \ingroup DicomSeries */
DicomSeries_EXPORT Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options = {});

/** ReadVolume for a tool: `parameter` names the input in the tool's XML, which also declares the options seriesUID,
 * resampleGaps, deshear and dropDuplicates. Adds identity and repairs to the provenance, notes to the warnings.
 * \ingroup DicomSeries */
DicomSeries_EXPORT Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice = false);
/** Whether two volumes have the same size and all their voxels lie at the same places, to a hundredth of the smallest
 * spacing. \ingroup DicomSeries */
DicomSeries_EXPORT bool
HaveSameGrid(const ImageBase<3> * a, const ImageBase<3> * b);

/** 1 where the voxels of a volume are not 0. Throws InputError, with `path` in front, when there are none.
 * \ingroup DicomSeries */
DicomSeries_EXPORT Image<unsigned char, 3>::Pointer
                   MaskOfVolume(const Volume & volume, const std::string & path);

/** Reads a mask for a tool: the voxels of the volume that the input `parameter` names, 1 where they are not 0. Adds its
 * identity to the provenance. Throws InputError where it has another grid than `image`, or no voxel other than 0.
 * \ingroup DicomSeries */
DicomSeries_EXPORT Image<unsigned char, 3>::Pointer
                   ReadMask(CommandLine & commandLine, const std::string & parameter, const ImageBase<3> * image);
} // namespace itk

#endif
