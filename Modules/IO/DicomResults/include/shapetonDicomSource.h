#ifndef shapetonDicomSource_h
#define shapetonDicomSource_h

#include "ShapetonDicomResultsExport.h"
#include "shapetonDicomSourceOptions.h"
#include "shapetonVolumeReader.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** The source series of results. Results share its patient, study and frame of reference, and reference its slices.
 * \ingroup ShapetonDicomResults */
struct DicomSource
{
  DicomSeries series;
  /** The grid of its voxels: size, spacing, origin, direction. */
  itk::ImageBase<3>::Pointer grid;
  /** Attributes that results copy from the header of the first slice, as a data set in explicit VR little endian:
   * patient, study, character set, time zone, clinical trial, de-identification, dates. */
  std::string header;
};

/** Reads the headers of a series, which must be regular because results cannot reference the slices of a repaired
 * volume. With DicomSourceOptions::deshear, a tilted series is also accepted, but only for reading results; the grid is
 * then that of the repair `deshear`. Throws InputError as ReadVolume() does, and if slices have no SOP Instance UID.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomSource
ReadDicomSource(const std::string & path, const DicomSourceOptions & options = {});

/** Patient ID of the source as UTF-8; empty if it has none. Throws InputError if its character set is unknown.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT std::string
                            PatientIDOf(const DicomSource & source);

/** The creation dates of a result. \ingroup ShapetonDicomResults */
enum class DicomResultDates
{
  /** The dates of the source, so that identical input yields identical bytes. */
  Source,
  /** The current time, in the time zone of the source if specified, otherwise in local time. */
  Now
};

/** Description of a result for its header. \ingroup ShapetonDicomResults */
struct DicomResultHeader
{
  /** The program that created it. */
  std::string tool;
  std::string version;
  int         seriesNumber{ 0 };
  /** At most 64 characters. */
  std::string seriesDescription;
  /** Body Part Examined, a term of DICOM PS3.16 Annex L such as "COLON", for images; empty for none. */
  std::string      bodyPart{};
  DicomResultDates dates{ DicomResultDates::Source };
};

/** Reference to a result from other objects. \ingroup ShapetonDicomResults */
struct DicomInstance
{
  std::string sopClassUID;
  std::string sopInstanceUID;
  std::string seriesUID;
};

/** Statement in each result that it is for research use, not for diagnosis. \ingroup ShapetonDicomResults */
constexpr const char * DicomResearchNote = "For research use; not a diagnosis.";
} // namespace shapeton

#endif
