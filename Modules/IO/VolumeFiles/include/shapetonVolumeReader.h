#ifndef shapetonVolumeReader_h
#define shapetonVolumeReader_h

#include "ShapetonVolumeFilesExport.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolume.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** Options of the reader, with the allowed repairs. By default an irregular series is rejected.
 * \ingroup ShapetonVolumeFiles */
struct VolumeReadOptions
{
  /** Series Instance UID to read; required if a folder contains two or more usable volumes. "UID#2" selects the
   * second part of a mixed series, as numbered by DicomSeriesInspector. */
  std::string seriesUID;
  /** Fill gaps and uneven spacing by linear interpolation along the slice axis. Slices on the new grid are kept
   * unchanged. */
  bool resampleGaps{ false };
  /** Resample a sheared (tilted) volume onto a grid with perpendicular axes: each slice keeps its plane and is
   * shifted within it by linear interpolation; voxels not covered by a slice get the lowest intensity. */
  bool deshear{ false };
  /** Keep the first of several slices at the same position. */
  bool dropDuplicates{ false };
  /** Read a single DICOM slice as a volume of one slice; its spacing is its Slice Thickness, or 1 mm if that is
   * missing. */
  bool allowSingleSlice{ false };
  /** The repairs that messages may advise; fewer if other objects reference the original slices. */
  enum class Advice
  {
    none,
    deshear,
    allRepairs
  };
  Advice advice{ Advice::allRepairs };
  /** Receives the progress for each file and each slice of a DICOM series. It may throw to abort. */
  Progress progress;
};

/** The series of a folder that ReadVolume() would read with these options. Throws InputError like ReadVolume().
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT const DicomSeries &
SelectDicomSeries(const DicomScan & scan, const VolumeReadOptions & options = {});

/** The grid of the volume that ReadVolume() creates from a series without gaps and duplicates; with `isDesheared`,
 * that of the repair `deshear`. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT itk::ImageBase<3>::Pointer
                   GridOfDicomSeries(const DicomSeries & series, bool isDesheared = false);

/** Throws InputError for a folder or file without an image, with its actual contents and advice. `wanted` is the
 * advice if it contains no DICOM. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
RequireDicomImages(const DicomScan & scan, const std::string & wanted = "name the folder that holds the series");

/** Reads a folder (searched recursively), one DICOM file, or one NRRD, NIfTI or MetaImage file.
 *
 * A folder: a single usable series is read, with a note on skipped localizers, other images or irregular series; two
 * or more require VolumeReadOptions::seriesUID. One DICOM file: only that file, with all frames of an enhanced
 * multi-frame image, never the other files of its folder. Pixel Padding Value becomes the lowest other intensity of
 * the volume.
 *
 * NRRD (.nrrd, .nhdr), NIfTI (.nii, .nii.gz) and MetaImage (.mha, .mhd): three-dimensional scalar images with positive
 * finite spacing, perpendicular axes and finite voxels. A fourth dimension must have the size 1. Left-handed axes, as
 * most NIfTI files have, are kept.
 *
 * Throws InputError that names the file or series, the defect and the slices concerned, and what to do;
 * ParameterError if a series is selected in a file without series. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options = {});
} // namespace shapeton

#endif
