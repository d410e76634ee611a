#ifndef shapetonColonFhir_h
#define shapetonColonFhir_h

#include "ShapetonColonToolsExport.h"
#include "shapetonDicomMeasurements.h"
#include "shapetonJson.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** A DICOM object of an examination. */
struct WrittenDicom
{
  DicomInstance instance;
  std::string   modality;
  /** Series Description. */
  std::string description;
};

/** What a FHIR bundle states about an examination. */
struct ColonFhirContent
{
  /** Patient ID; empty if the series has none. */
  std::string patientID;
  /** The series that was read. */
  DicomSeries series;
  /** At least one object. */
  std::vector<WrittenDicom> objects;
  /** Name and version of the program. */
  std::string tool;
  std::string version;
  /** Measurements of candidates only, not of other structures. */
  DicomMeasurementReport candidates;
  /** The report of the reader, if there is one. */
  std::optional<DicomMeasurementReport> reader;
};

/** A FHIR R4 bundle (collection): Patient (identifier only), Device (the program), ImagingStudy (the series and the
 * objects), and a DiagnosticReport for the program and one for the reader, each with an Observation per group.
 *
 * Reports have the status "partial" and observations "preliminary", because neither is verified. The categories of the
 * reader are conclusion codes. Private DICOM codes are written as text, because their scheme has no URI. Identifiers
 * (urn:uuid) are derived from SHA-256 of the series and the first object, so identical input yields identical bytes. */
ShapetonColonTools_EXPORT Json
FhirBundleOf(const ColonFhirContent & content);
} // namespace shapeton

#endif
