#include "shapetonGraphComparisonPictures.h"
#include "shapetonGraphReport.h"

namespace shapeton
{
namespace
{
std::string
SentenceOf(const GraphComparison & comparison)
{
  int partners = 0;
  for (const int image : comparison.correspondence.image)
  {
    partners += image >= 0 ? 1 : 0;
  }
  const std::string by = comparison.correspondence.by;
  return std::string(comparison.isomorphic ? "The graphs are isomorphic. " : "The graphs are not isomorphic. ") +
         std::to_string(partners) + " nodes have a partner, found by " + by +
         "; its circle has the same colour. Circles without a partner are grey.";
}
} // namespace

void
WriteComparisonPictures(const GraphComparison & comparison, const GraphSideBySide & sheet, const OutputPath & output)
{
  const auto                   colors = ColoursOfNodes(comparison);
  const std::vector<GraphView> views{ { "first graph", &comparison.a, colors[0], sheet.hasLabels },
                                      { "second graph", &comparison.b, colors[1], sheet.hasLabels } };
  WriteGraphSheetSvg(views, {}, output(sheet.folder + "/comparison.svg"));
  GraphReport report{
    "Two graphs side by side", views, { SentenceOf(comparison) }, sheet.warnings, sheet.provenance, {}
  };
  report.paragraphs.insert(report.paragraphs.end(), comparison.differences.begin(), comparison.differences.end());
  WriteGraphReport(report, output(sheet.folder + "/index.html"));
}
} // namespace shapeton
