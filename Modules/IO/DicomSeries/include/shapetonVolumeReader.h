#ifndef shapetonVolumeReader_h
#define shapetonVolumeReader_h

#include "DicomSeriesExport.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolume.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
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
  /** The repairs that messages may advise; fewer where others refer to the slices as they are. */
  enum class Advice
  {
    none,
    deshear,
    allRepairs
  };
  Advice advice{ Advice::allRepairs };
  /** Told of each file and of each slice of a DICOM series. It may throw in order to abort. */
  Progress progress;
};

/** The series of a folder that ReadVolume() would read with these options. Throws InputError as it does.
 * \ingroup DicomSeries */
DicomSeries_EXPORT const DicomSeries &
SelectDicomSeries(const DicomScan & scan, const VolumeReadOptions & options = {});

/** The grid of the volume that ReadVolume() makes of a series without gaps and duplicates; with `isDesheared`, of the
 * repair `deshear`. \ingroup DicomSeries */
DicomSeries_EXPORT itk::ImageBase<3>::Pointer
                   GridOfDicomSeries(const DicomSeries & series, bool isDesheared = false);

/** Throws InputError for a folder or file without an image: what it holds instead, and what to do. `wanted` is the
 * advice where it holds nothing of DICOM. \ingroup DicomSeries */
DicomSeries_EXPORT void
RequireDicomImages(const DicomScan & scan, const std::string & wanted = "name the folder that holds the series");

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
 * Throws InputError that names the file or series, the defect and the slices concerned, and what to do; ParameterError
 * when a series is chosen from a file that has none. \ingroup DicomSeries */
DicomSeries_EXPORT Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options = {});
} // namespace shapeton

#endif
