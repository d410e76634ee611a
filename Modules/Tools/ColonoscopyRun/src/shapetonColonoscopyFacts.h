#ifndef shapetonColonoscopyFacts_h
#define shapetonColonoscopyFacts_h

#include "shapetonColonoscopyReport.h"

namespace shapeton
{
using ColonoscopyFacts = ColonoscopyReportContent::Facts;

ColonoscopyFacts
SummaryOf(const ColonoscopyReportContent & content);

/** Length, area, distension and folds of each segment. */
CsvTable
SegmentTable(const ColonoscopyResults & results);

/** Place and confidence of each flexure; those that were not found, too. */
CsvTable
FlexureTable(const ColonoscopyResults & results);

CsvTable
TaeniaTable(const ColonoscopyResults & results);

/** Which stage ran what, how it ended, and where its files lie. */
CsvTable
StageTable(const ColonoscopyReportContent & content);
} // namespace shapeton

#endif
