#ifndef shapetonDicomSeriesWriter_h
#define shapetonDicomSeriesWriter_h

#include "ShapetonVolumeFilesExport.h"

#include "itkImage.h"

#include <string>

namespace shapeton
{
/** Header values of a CT series. Strings are UTF-8, at most 64 characters (comments: 10240), without backslashes or
 * control characters.
 * \ingroup ShapetonVolumeFiles */
struct DicomSeriesDescription
{
  std::string patientName{ "Phantom^Shapeton" };
  std::string patientID{ "SHAPETON" };
  std::string studyDescription;
  std::string seriesDescription;
  /** Image Comments: origin of the pixels. */
  std::string comments;
  /** HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR or FFDL. */
  std::string patientPosition{ "HFS" };
  /** At least 0. */
  int seriesNumber{ 1 };
  /** Series with equal patientID, studyDescription and seed share one study and one frame of reference. */
  unsigned int seed{ 0 };
};

/** Writes a volume in Hounsfield units as a CT Image Storage series (explicit VR little endian), one file per slice,
 * IM0001.dcm and so on, into an existing folder.
 *
 * The image axes may have any orientation but must form a right-handed orthonormal frame: readers compute the third
 * axis as the cross product of the two axes in the header. Values must be in [-1024, 31743]; at least two slices, at
 * most 65535 rows and columns.
 *
 * UIDs have the prefix 2.25. UIDs of study and frame of reference are derived from patientID, studyDescription and
 * seed; UIDs of the series and its images from the description, the pixels and the geometry. Dates are fixed. Output is
 * deterministic, and different images have different UIDs.
 *
 * Positions, directions and spacings are written as Decimal Strings of up to 16 characters, that is, with at least 9
 * significant digits.
 *
 * Throws InputError for an image or a description that a CT series cannot represent, OutputError if a file cannot
 * be written. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
WriteDicomSeries(const itk::Image<short, 3> *   image,
                 const std::string &            folder,
                 const DicomSeriesDescription & description);

/** Calls WriteDicomSeries and creates the folder atomically.
 *
 * The slices are written to a hidden folder next to `folder`, and the hidden folder is then renamed in one step.
 * `folder` may be missing or empty, or it may contain only a series written by WriteDicomSeries, which is replaced and
 * then removed. A failed or interrupted run leaves the old series unchanged; the next run removes what a killed run has
 * left behind.
 *
 * Throws the exceptions of WriteDicomSeries, and OutputError if `folder` contains anything else.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
WriteDicomSeriesFolder(const itk::Image<short, 3> *   image,
                       const std::string &            folder,
                       const DicomSeriesDescription & description);

/** Checks the conditions of WriteDicomSeriesFolder before the image is computed; throws OutputError.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
CheckDicomSeriesFolder(const std::string & folder);
} // namespace shapeton

#endif
