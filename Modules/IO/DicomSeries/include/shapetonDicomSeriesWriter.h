#ifndef shapetonDicomSeriesWriter_h
#define shapetonDicomSeriesWriter_h

#include "DicomSeriesExport.h"

#include "itkImage.h"

#include <string>

namespace shapeton
{
/** What the headers of a written CT series say. Texts are UTF-8, at most 64 characters (comments: 10240), without
 * backslash and control characters.
 * \ingroup DicomSeries */
struct DicomSeriesDescription
{
  std::string patientName{ "Phantom^Shapeton" };
  std::string patientID{ "SHAPETON" };
  std::string studyDescription;
  std::string seriesDescription;
  /** Image Comments: where the pixels come from. */
  std::string comments;
  /** HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR or FFDL. */
  std::string patientPosition{ "HFS" };
  /** At least 0. */
  int seriesNumber{ 1 };
  /** Series with equal patientID, studyDescription and seed belong to one study and one frame of reference. */
  unsigned int seed{ 0 };
};

/** Writes a volume in Hounsfield units as a CT Image Storage series (explicit VR little endian), one file per slice,
 * IM0001.dcm and so on, into an existing folder.
 *
 * The image axes may point anywhere, but they are a right-handed orthonormal frame: a header states two axes, and
 * readers take their cross product for the third. Values lie in [-1024, 31743]; at least two slices, at most 65535 rows
 * and columns.
 *
 * UIDs lie under 2.25. Those of study and frame of reference come from patientID, studyDescription and seed, those of
 * the series and its images from all of the description, the pixels and the geometry. Dates are fixed. So equal calls
 * write equal bytes, and different images never share a UID.
 *
 * Positions, directions and spacings are written with the 16 characters of a Decimal String, that is with 9 or more
 * significant digits.
 *
 * Throws InputError for an image or a description that no CT series can hold, OutputError when a file cannot be
 * written. \ingroup DicomSeries */
DicomSeries_EXPORT void
WriteDicomSeries(const itk::Image<short, 3> *   image,
                 const std::string &            folder,
                 const DicomSeriesDescription & description);

/** WriteDicomSeries to a folder that appears whole or not at all.
 *
 * The slices go to a hidden folder beside `folder`, which then takes its name in one step. `folder` may be absent,
 * empty, or hold a series that WriteDicomSeries wrote and nothing else: that one is exchanged for the new one and
 * removed last. A run that fails or is interrupted leaves the old series as it was; what a run that was killed outright
 * has left is removed by the next one.
 *
 * Throws like WriteDicomSeries, and OutputError when `folder` holds other things.
 * \ingroup DicomSeries */
DicomSeries_EXPORT void
WriteDicomSeriesFolder(const itk::Image<short, 3> *   image,
                       const std::string &            folder,
                       const DicomSeriesDescription & description);

/** Throws the OutputError of WriteDicomSeriesFolder, before there is an image to write.
 * \ingroup DicomSeries */
DicomSeries_EXPORT void
CheckDicomSeriesFolder(const std::string & folder);
} // namespace shapeton

#endif
