#ifndef shapetonVolumeReader_h
#define shapetonVolumeReader_h

#include "ShapetonVolumeFilesExport.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonVolume.h"
#include "shapetonVolumeReadOptions.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
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
 * finite spacing, perpendicular axes and finite voxel values. A fourth dimension must have size 1. Left-handed axes, as
 * in most NIfTI files, are kept. All spaces of a patient in NRRD become LPS, all units mm. Voxels may be split into
 * several files and, in NRRD, compressed by gzip or bzip2; more data than the header describes are noted.
 *
 * `progress` receives each file and each slice of a DICOM series; it may throw to abort.
 *
 * Throws InputError with the file or series, the defect, the affected slices and the remedy, and ParameterError if a
 * series is selected but the file is not a DICOM series. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT Volume
ReadVolume(const std::string & path, const VolumeReadOptions & options = {}, const Progress & progress = {});
} // namespace shapeton

#endif
