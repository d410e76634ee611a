#ifndef shapetonColonReportsAsDicom_h
#define shapetonColonReportsAsDicom_h

#include "shapetonColonSegmentsAsDicom.h"
#include "shapetonDicomMeasurements.h"
#include "shapetonReaderLesions.h"

namespace shapeton
{
/** Note on each candidate in every report. */
constexpr const char * CandidateNote =
  "a candidate of a computer program, not a finding of a reader; its certainty is the program's score; for "
  "research use; not a diagnosis";

/** Measurements of lumen, candidates and segments of the colon, as groups of TID 1500. */
DicomMeasurementReport
MeasurementsOfColon(const DicomExamination & exam, const ColonSegmentsAsDicom & segments);

/** Prefix of the code (99SHAPETON) of a candidate used as second finding site; viewers keep the code in their own
 * reports. */
constexpr const char * CandidateCodePrefix = "candidate-";

/** The candidates as lengths that OHIF treats as its own measurements, so that a reader can change and label them: the
 * tracking identifier is the name of OHIF's tool, and the candidate is the label and the second finding site. */
DicomMeasurementReport
CandidatesForOhif(const DicomExamination & exam, const ColonSegmentsAsDicom & segments);

/** The reading of an examination. */
struct ColonReading
{
  ReaderVerdicts            verdicts;
  std::vector<ReaderLesion> lesions;
  /** Person name of the reader. */
  std::string observer;
};

/** The polyps that the reader accepted in the position of this run (0 or 1), as groups of TID 1500 with the reader as
 * observer, and the categories that the reader entered. The report is complete unless WhyPreliminary() states a
 * reason. */
DicomMeasurementReport
MeasurementsOfReader(const ColonReading & reading, std::size_t position, const ColonSegmentsAsDicom & segments);

/** The candidates as findings of TID 4120. */
DicomContent
CadReportOfColon(const DicomExamination &     exam,
                 const ColonSegmentsAsDicom & segments,
                 const DicomSource &          source,
                 const DicomResultHeader &    header);
} // namespace shapeton

#endif
