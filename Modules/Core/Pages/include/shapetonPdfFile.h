#ifndef shapetonPdfFile_h
#define shapetonPdfFile_h

#include "ShapetonPagesExport.h"
#include "shapetonHtmlReport.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** Whether WeasyPrint, which WritePdf() runs, is found in PATH.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT bool
HasPdfWriter();

/** Prints a page, such as one written by HtmlReport, on A4 paper with the print rules of its style sheet. The page must
 * not contain scripts. The same page always yields the same bytes. Throws OutputError if WeasyPrint is missing or
 * fails.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT void
WritePdf(const std::string & htmlPath, const std::string & pdfPath);

/** Prints a page to a result file. If WeasyPrint is missing, an older file is removed, because it would contradict the
 * page, and a remark states what to install. \ingroup ShapetonPages */
ShapetonPages_EXPORT Remarks
PrintPage(const std::string & htmlPath, const std::string & pdfPath, const OutputPath & outputPath);
} // namespace shapeton

#endif
