#ifndef shapetonPdfFile_h
#define shapetonPdfFile_h

#include "ShapetonPagesExport.h"
#include "shapetonHtmlReport.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** Whether WeasyPrint, which WritePdf() runs, is found in the folders of PATH.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT bool
HasPdfWriter();

/** Prints a page, such as one written by HtmlReport, on paper of size A4 with the print rules of its style sheet. Pages
 * without scripts only. The same page gives the same bytes. Throws OutputError if WeasyPrint is missing or fails.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT void
WritePdf(const std::string & htmlPath, const std::string & pdfPath);

/** Prints a page to a file of a result. Without WeasyPrint, an older file, which would contradict the page, is removed,
 * and a remark says what to install. \ingroup ShapetonPages */
ShapetonPages_EXPORT Remarks
PrintPage(const std::string & htmlPath, const std::string & pdfPath, const OutputPath & outputPath);
} // namespace shapeton

#endif
