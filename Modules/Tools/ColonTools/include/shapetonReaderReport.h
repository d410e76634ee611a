#ifndef shapetonReaderReport_h
#define shapetonReaderReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonOutputPath.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** Inputs of the reader's report. \ingroup ShapetonColonTools */
struct ReaderReportInput
{
  /** Folder of a run of VirtualColonoscopy. */
  std::string exam;
  /** Run of the patient's other position; if empty, the folder `second` of the run, if it exists. */
  std::string second;
  /** Path of a verdicts.json saved by the viewer page of these positions. */
  std::string verdicts;
  /** Omits the series UIDs. */
  bool isAnonymous{ false };
};

/** Writes the report of a reader into an existing folder: reader-report.html, its PDF version reader-report.pdf, and
 * reader-report.csv with one row for each candidate and finding.
 *
 * The categories are those that the reader entered; the report does not compute any. It is marked as preliminary while
 * candidates are unread or the category of the colon is missing. Without WeasyPrint, it writes no PDF file, removes an
 * older one, and returns a remark. Equal input gives equal bytes. Throws the InputError of ReadReaderVerdicts(), and
 * InputError for a run that lacks files; OutputError.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT Remarks
WriteReaderReport(const ReaderReportInput & input, const std::string & folder, const OutputPath & outputPath);
} // namespace shapeton

#endif
