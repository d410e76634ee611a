#ifndef shapetonVolumeReader_h
#define shapetonVolumeReader_h

#include "ShapetonVolumeFilesExport.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolume.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** Options of the reader, with the allowed repairs. By default, irregular series are rejected.
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
  /** Read a single DICOM slice as a volume of one slice; the spacing is the Slice Thickness, or 1 mm if missing. */
  bool allowSingleSlice{ false };
  /** The repairs that messages may suggest; restricted if other objects reference the original slices. */
  enum class Advice
  {
    none,
    deshear,
    allRepairs
  };
  Advice advice{ Advice::allRepairs };
  /** Reports progress for each file and each slice of a DICOM series; may throw to abort. */
  Progress progress;
};

/** The series of a folder that ReadVolume() would read with these options. Throws InputError like ReadVolume().
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT const DicomSeries &
SelectDicomSeries(const DicomScan & scan, const VolumeReadOptions & options = {});

/** The grid of the volume that ReadVolume() creates from a series without gaps and duplicates; with `isDesheared`, the
 * grid of the repair `deshear`. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT itk::ImageBase<3>::Pointer
                           GridOfDicomSeries(const DicomSeries & series, bool isDesheared = false);

/** Throws InputError for a folder or file without an image; the message lists the contents and gives advice. `wanted`
 * is the advice for contents other than DICOM. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
RequireDicomImages(const DicomScan & scan, const std::string & wanted = "use the folder that contains the series");

/** Reads a folder (searched recursively), one DICOM file, or one NRRD, NIfTI or MetaImage file.
 *
 * Folder: reads the only usable series, with a note on skipped localizers, other images or irregular series; several
 * series require VolumeReadOptions::seriesUID. DICOM file: reads all frames of this file, but not the other files in
 * its folder. Pixel Padding Value becomes the lowest other intensity of the volume.
 *
 * NRRD (.nrrd, .nhdr), NIfTI (.nii, .nii.gz) and MetaImage (.mha, .mhd): three-dimensional scalar images with positive
 * finite spacing, perpendicular axes and finite voxels. A fourth dimension must have size 1. Left-handed axes, as in
 * most NIfTI files, are kept.
 *
 * Throws InputError with the file or series, the defect, the affected slices and the remedy, and ParameterError if a
 * series is selected but the file is not a DICOM series. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options = {});
} // namespace shapeton

#endif
