#ifndef shapetonGraphComparisonPictures_h
#define shapetonGraphComparisonPictures_h

#include "GraphToolsExport.h"
#include "shapetonDynamicTables.h"
#include "shapetonGraphComparison.h"
#include "shapetonHtmlReport.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** What pictures of graphs side by side need besides the graphs.
 * \ingroup GraphTools */
struct GraphSideBySide
{
  /** Where the files go. */
  std::string folder;
  /** Names of nodes beside them. */
  bool hasLabels{ false };
  /** For the report. */
  std::vector<std::pair<std::string, std::string>> provenance{};
  std::vector<std::string>                         warnings{};
};

/** Writes comparison.svg and index.html: both graphs, corresponding circles in one colour, those without a partner
 * grey; what differs, in words and figures. Throws OutputError. \ingroup GraphTools */
GraphTools_EXPORT void
WriteComparisonPictures(const GraphComparison & comparison, const GraphSideBySide & sheet, const OutputPath & output);

/** The number of steps that a picture of a sequence shows at most; of longer ones that many, from the first to the
 * last, as evenly as can be. \ingroup GraphTools */
constexpr int mostStepsOfPicture = 12;

/** Writes steps.svg (small multiples: nodes that changed since the step before green, others red, tracked ones blue),
 * correspondence.svg (a colour for each name through all steps), index.html with the first of them, and compare.svg
 * where two steps are compared: what changed between them green. Throws OutputError. \ingroup GraphTools */
GraphTools_EXPORT void
WriteSequencePictures(const DynamicSequence &          sequence,
                      const std::vector<int> &         compared,
                      const std::vector<std::string> & tracked,
                      const GraphSideBySide &          sheet,
                      const OutputPath &               output);
} // namespace shapeton

#endif
