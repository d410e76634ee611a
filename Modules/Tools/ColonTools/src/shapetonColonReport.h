#ifndef shapetonColonReport_h
#define shapetonColonReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonRemarks.h"
#include "shapetonColonPictures.h"
#include "shapetonOutputPath.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Content of a report on a colon. \ingroup ShapetonColonTools */
struct ColonReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  std::string title{ "Colon surface and centerline" };
  ColonParts  colon;

  /** Input: name, modality, position, geometry. */
  Facts input;
  /** Volumes of gas and fluid, length, pieces and gaps, distension, genus raw and repaired, faces. */
  Facts summary;
  /** Thresholds and other parameters, with their sources. */
  Facts parameters;
  /** Missing or doubtful results. */
  Remarks warnings;
  Facts   provenance;
};

/** Writes a report into an existing folder: a self-contained index.html, and its pictures as files: slices-axial.png,
 * slices-coronal.png, slices-sagittal.png, projection-coronal.png and projection-sagittal.png; with a centerline,
 * distension.png; with a wall, wall-anterior.png; with both, inside-anterior.png and inside-left.png. Equal content
 * gives equal bytes. Throws OutputError, or std::invalid_argument for a colon without a lumen.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonReport(const ColonReportContent & content, const std::string & folder, const OutputPath & outputPath);
} // namespace shapeton

#endif
