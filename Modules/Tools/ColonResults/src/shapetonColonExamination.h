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
/** What VirtualColonoscopy has found in one series. */
struct ColonExamination
{
  std::string folder;
  /** Of the series that it read, with "#part" for a part of a mixed series. */
  std::string seriesUID;
  /** Of what the folder of the series held, "sha256:...". */
  std::string digest;
  Json        quality;
  /** Whether candidates were looked for. */
  bool isSearched{ false };
  /** 1 gas, 2 fluid, 3 terminal ileum. */
  DicomLabelImage::Pointer        lumen;
  CurveSet                        centreline;
  std::vector<ColonSegmentExtent> segments;
  std::vector<PolypCandidate>     candidates;
  /** The numbers of candidates; null where there is none. */
  DicomLabelImage::Pointer heads;
  /** The flat wall, and the fold of each of its faces; empty where folds were not found. */
  SurfaceMesh                 flat;
  std::vector<unsigned short> folds;
  /** What the run remarked, each with its stage in front. */
  Remarks warnings;
  /** What is missing. */
  Remarks missing;

  /** Whether a file of a stage, "STAGE/FILE", is there; if not, `what` goes to the missing. Throws InputError where it
   * is there and does not belong to the rest. */
  bool
  Has(const std::string & name, const std::string & what);
  /** Throws InputError unless the file is there and belongs to the rest. */
  std::string
  Required(const std::string & name) const;
  std::string
  PathOf(const std::string & name) const
  {
    return folder + '/' + name;
  }
};

/** Reads the folder. Lumen and centreline must be there. Throws InputError. */
ColonExamination
ReadColonExamination(const std::string & folder);
} // namespace shapeton

#endif
