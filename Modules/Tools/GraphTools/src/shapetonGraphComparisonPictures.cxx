#include "shapetonGraphComparisonPictures.h"
#include "shapetonGraphReport.h"

#include <array>
#include <numeric>

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
         "; their circles share a color. Circles of other nodes are gray.";
}

/** Keys shared by corresponding nodes. */
std::array<std::vector<int>, 2>
KeysOfNodes(const GraphComparison & comparison)
{
  const int                       nodes = comparison.a.graph.nodes;
  std::array<std::vector<int>, 2> keys{ std::vector<int>(nodes), std::vector<int>(comparison.b.graph.nodes) };
  std::iota(keys[0].begin(), keys[0].end(), 0);
  std::iota(keys[1].begin(), keys[1].end(), nodes);
  for (int node = 0; node < nodes; ++node)
  {
    const int image = comparison.correspondence.image[node];
    if (image >= 0)
    {
      keys[1][image] = node;
    }
  }
  return keys;
}
} // namespace

void
WriteComparisonPictures(const GraphComparison & comparison, const GraphSideBySide & sheet, const OutputPath & output)
{
  const auto                   colors = ColorsOfNodes(comparison);
  const auto                   keys = KeysOfNodes(comparison);
  const std::vector<GraphView> views{ { "first graph", &comparison.a, colors[0], sheet.hasLabels, keys[0] },
                                      { "second graph", &comparison.b, colors[1], sheet.hasLabels, keys[1] } };
  WriteGraphSheetSvg(views, {}, output(sheet.folder + "/comparison.svg"));
  GraphReport report{
    "Two graphs side by side", views, { SentenceOf(comparison) }, sheet.warnings, sheet.provenance, {}
  };
  report.paragraphs.insert(report.paragraphs.end(), comparison.differences.begin(), comparison.differences.end());
  WriteGraphReport(report, output(sheet.folder + "/index.html"));
}
} // namespace shapeton
