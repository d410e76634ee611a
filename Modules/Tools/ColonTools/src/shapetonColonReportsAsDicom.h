#ifndef shapetonColonReportsAsDicom_h
#define shapetonColonReportsAsDicom_h

#include "shapetonColonSegmentsAsDicom.h"
#include "shapetonDicomMeasurements.h"

namespace shapeton
{
/** Note on each candidate in every report. */
constexpr const char * CandidateNote =
  "a candidate of a computer program, not a finding of a reader; its certainty is the program's score; for "
  "research use; not a diagnosis";

/** Measurements of lumen, candidates and segments of the colon, as groups of TID 1500. */
DicomMeasurementReport
MeasurementsOfColon(const ColonExamination & exam, const ColonSegmentsAsDicom & segments);

/** The candidates as findings of TID 4120. */
DicomContent
CadReportOfColon(const ColonExamination &     exam,
                 const ColonSegmentsAsDicom & segments,
                 const DicomSource &          source,
                 const DicomResultHeader &    header);
} // namespace shapeton

#endif
