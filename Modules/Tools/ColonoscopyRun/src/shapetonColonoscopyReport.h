#ifndef shapetonColonoscopyReport_h
#define shapetonColonoscopyReport_h

#include "ColonoscopyRunExport.h"

#include "shapetonRemarks.h"
#include "shapetonColonoscopyResults.h"
#include "shapetonHtmlReport.h"

namespace shapeton
{
/** What the report tells beside the results. \ingroup ColonoscopyRun */
struct ColonoscopyReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;
  /** Not owned. */
  const ColonoscopyResults * results{ nullptr };
  /** "" where all stages have come to their end. */
  std::string failure;
  Remarks     warnings;
  Facts       provenance;
};

/** Writes one HTML file that holds its pictures: summary, distension, views in space, the flat colon in rows, tables,
 * what is doubtful, provenance; of a run that has failed as far as it goes. Equal content gives equal bytes.
 * `scratchFolder` is made and removed again with all it holds. Throws OutputError. \ingroup ColonoscopyRun */
ColonoscopyRun_EXPORT void
WriteColonoscopyReport(const ColonoscopyReportContent & content,
                       const std::string &              path,
                       const std::string &              scratchFolder);

/** Writes files for 3D Slicer that no stage writes into a folder, as far as there are results: centreline.mrk.json and
 * the colour tables lumen.ctbl and segments.ctbl. Returns their names. Throws OutputError.
 * \ingroup ColonoscopyRun */
ColonoscopyRun_EXPORT std::vector<std::string>
                      WriteColonoscopySlicerFiles(const ColonoscopyResults & results,
                                                  const std::string &        folder,
                                                  const OutputPath &         outputPath);
} // namespace shapeton

#endif
