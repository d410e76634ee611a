#ifndef shapetonColonoscopyQuality_h
#define shapetonColonoscopyQuality_h

#include "shapetonColonoscopyResults.h"
#include "shapetonSegmentQuality.h"

namespace shapeton
{
/** A point, which is stored in a document as a list of x, y and z. */
Eigen::Vector3d
PlaceInJson(const Json & lps);

/** What an examination shows of each segment. */
struct ColonoscopyQuality
{
  std::vector<SegmentQuality> segments;
  /** With a second position: wall that neither position shows, and how much of each segment at least one of them shows.
   */
  std::vector<HinderedStretch>    hiddenInBoth;
  std::vector<ColonAssessability> either;
  bool                            isOfMask{ false };
};

/** Whether a quality report is of a lumen mask without a CT. */
bool
IsOfMask(const Json & quality);

/** The result has no segments if landmarks are missing. */
ColonoscopyQuality
MeasureColonoscopyQuality(const ColonoscopyResults & results);

/** A row for each segment; the quantities in its columns are those of SegmentQuality. */
CsvTable
QualityTable(const ColonoscopyQuality & quality);
} // namespace shapeton

#endif
