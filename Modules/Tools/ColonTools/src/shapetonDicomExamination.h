#ifndef shapetonDicomExamination_h
#define shapetonDicomExamination_h

#include "shapetonDicomSegmentation.h"
#include "shapetonExaminationFolder.h"
#include "shapetonRemarks.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Results of VirtualColonoscopy for one DICOM series. According to the records of the stages, all results are from the
 * same run. */
struct DicomExamination
{
  /** Nothing else is read yet. */
  explicit DicomExamination(ExaminationFolder itsFolder);

  ExaminationFolder folder;
  /** UID of the series that was read; "#part" is appended for a part of a mixed series. */
  std::string seriesUID;
  /** Digest of the series folder's contents, "sha256:...". */
  std::string digest;
  Json        quality;
  /** Whether the run searched for candidates. */
  bool isSearched{ false };
  /** Labels: 1 gas, 2 fluid, 3 terminal ileum. */
  DicomLabelImage::Pointer        lumen;
  CurveSet                        centerline;
  std::vector<ColonSegmentExtent> segments;
  std::vector<PolypCandidate>     candidates;
  /** Candidate numbers; null without candidates. */
  DicomLabelImage::Pointer heads;
  /** The flat wall, and the fold index of each of its faces; empty if folds were not found. */
  SurfaceMesh                 flat;
  std::vector<unsigned short> folds;
  /** Warnings of the run, each prefixed with its stage. */
  Remarks warnings;
  /** Missing results. */
  Remarks missing;

  /** Whether a file exists; if not, adds `what` to the missing results. Throws InputError if the file exists but does
   * not match the rest. */
  bool
  Has(const ExaminationFile & file, const std::string & what);
  /** Throws InputError unless the file exists and matches the rest. */
  std::string
  Required(const ExaminationFile & file) const;
};

/** Reads the folder. Lumen and centerline are required. Throws InputError. */
DicomExamination
ReadDicomExamination(const std::string & folder);
} // namespace shapeton

#endif
