#ifndef shapetonColonoscopyReport_h
#define shapetonColonoscopyReport_h

#include "ShapetonColonToolsExport.h"

#include "shapetonRemarks.h"
#include "shapetonColonoscopyQuality.h"
#include "shapetonOutputPath.h"

namespace shapeton
{
/** Content of the report in addition to the results. \ingroup ShapetonColonTools */
struct ColonoscopyReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;
  /** Not owned. */
  const ColonoscopyResults * results{ nullptr };
  ColonoscopyQuality         quality;
  /** Error message of the failed stage; "" if all stages completed. */
  std::string failure;
  Remarks     warnings;
  Facts       provenance;
};

/** Writes one self-contained HTML file: a first page with the examination, quality by segment, candidates and
 * limitations; then cards of the candidates, distension, landmarks, the unfolded wall and views in space; technical
 * details are collapsed at the end. For a failed run, it contains the results so far. Equal content gives equal bytes.
 * `scratchFolder` is created and removed with its contents. Throws OutputError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonoscopyReport(const ColonoscopyReportContent & content,
                       const std::string &              path,
                       const std::string &              scratchFolder);

/** Writes additional files for 3D Slicer, if their results exist: centerline.mrk.json and the color
 * tables lumen.ctbl and segments.ctbl. Returns their names. Throws OutputError.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::vector<std::string>
                          WriteColonoscopySlicerFiles(const ColonoscopyResults & results,
                                                      const std::string &        folder,
                                                      const OutputPath &         outputPath);
} // namespace shapeton

#endif
