#ifndef shapetonColonExamination_h
#define shapetonColonExamination_h

#include "shapetonColonLandmarkDocument.h"
#include "shapetonCurveSet.h"
#include "shapetonDicomSegmentation.h"
#include "shapetonJson.h"
#include "shapetonPolypCandidates.h"
#include "shapetonRemarks.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Results of VirtualColonoscopy for one series. */
struct ColonExamination
{
  std::string folder;
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

  /** Whether a stage file, "STAGE/FILE", exists; if not, adds `what` to the missing results. Throws InputError if the
   * file exists but does not match the rest. */
  bool
  Has(const std::string & name, const std::string & what);
  /** Throws InputError unless the file exists and matches the rest. */
  std::string
  Required(const std::string & name) const;
  std::string
  PathOf(const std::string & name) const
  {
    return folder + '/' + name;
  }
};

/** Reads the folder. Lumen and centerline are required. Throws InputError. */
ColonExamination
ReadColonExamination(const std::string & folder);
} // namespace shapeton

#endif
