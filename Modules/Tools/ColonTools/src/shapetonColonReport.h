#ifndef shapetonColonReport_h
#define shapetonColonReport_h

#include "ColonToolsExport.h"
#include "shapetonRemarks.h"
#include "shapetonColonPictures.h"
#include "shapetonHtmlReport.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** What a report on a colon tells. \ingroup ColonTools */
struct ColonReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  std::string title{ "Colon surface and centreline" };
  ColonParts  colon;
  /** From the anal verge on; may be empty. */
  std::vector<ColonSegment> segments;

  /** What was analysed: name, modality, position, geometry. */
  Facts input;
  /** Volumes of gas and fluid, length, pieces and gaps, distension, genus raw and repaired, faces. */
  Facts summary;
  /** Thresholds and other parameters, and where they come from. */
  Facts parameters;
  /** What is missing or doubtful. */
  Remarks warnings;
  Facts   provenance;
};

/** Writes a report into an existing folder: index.html, which holds its pictures, and these as files:
 * slices-axial.png, slices-coronal.png, slices-sagittal.png, projection-coronal.png and projection-sagittal.png; where
 * there is a centreline distension.png; where there is a wall wall-anterior.png; and with both inside-anterior.png and
 * inside-left.png. Equal content gives equal bytes. Throws OutputError, and std::invalid_argument for a colon without
 * lumen. \ingroup ColonTools */
ColonTools_EXPORT void
WriteColonReport(const ColonReportContent & content, const std::string & folder, const OutputPath & outputPath);
} // namespace shapeton

#endif
