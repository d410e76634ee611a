#ifndef shapetonColonoscopyQuality_h
#define shapetonColonoscopyQuality_h

#include "shapetonColonoscopyResults.h"
#include "shapetonSegmentQuality.h"

namespace shapeton
{
/** A place in a document, a list of x, y and z. */
Eigen::Vector3d
PlaceInJson(const Json & lps);

/** What an examination shows of each segment. */
struct ColonoscopyQuality
{
  std::vector<SegmentQuality> segments;
  /** With a second position: wall that neither shows, and what at least one of them shows of the segments. */
  std::vector<HinderedStretch>    hiddenInBoth;
  std::vector<ColonAssessability> either;
};

/** Without segments if landmarks are missing. */
ColonoscopyQuality
MeasureColonoscopyQuality(const ColonoscopyResults & results);

/** A row for each segment; the quantities in its columns are those of SegmentQuality. */
CsvTable
QualityTable(const ColonoscopyQuality & quality);
} // namespace shapeton

#endif
