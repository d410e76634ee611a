#ifndef shapetonColonoscopyFacts_h
#define shapetonColonoscopyFacts_h

#include "shapetonColonoscopyReport.h"

namespace shapeton
{
using ColonoscopyFacts = ColonoscopyReportContent::Facts;

/** Position, series, completeness and size, with reference ranges. */
ColonoscopyFacts
SummaryOf(const ColonoscopyReportContent & content);

/** Input, handles, flat map, folds and taeniae. */
ColonoscopyFacts
MethodFactsOf(const ColonoscopyReportContent & content);

/** "4992 ml of gas and 260.1 cm of colon", as far as these are outside the reference ranges; "" if none is. */
std::string
OutsideReferences(const Json & quality);

/** Whether segment `number` (1 rectum to 6 cecum) of a landmarks.json is evaluable: "yes, along 97 % of the length", or
 * the fraction and the reasons; empty if unknown. */
std::string
EvaluableInWords(const Json & landmarks, int number);

/** Position and confidence of each flexure, including those that were not found. */
CsvTable
FlexureTable(const ColonoscopyResults & results);

CsvTable
TaeniaTable(const ColonoscopyResults & results);

/** For each stage: its tool, how it ended, and the location of its files. */
CsvTable
StageTable(const ColonoscopyReportContent & content);
} // namespace shapeton

#endif
