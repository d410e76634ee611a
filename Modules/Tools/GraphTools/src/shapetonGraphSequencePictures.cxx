#include "shapetonGraphComparisonPictures.h"
#include "shapetonGraphReport.h"

#include <algorithm>
#include <map>

namespace shapeton
{
namespace
{
const char * const ChangedColor = "#43a047";
const char * const OtherColor = "#ef9a9a";

std::vector<std::string>
ColorsOfChange(const Graph & graph, const std::vector<int> & changed, const std::vector<std::string> & tracked)
{
  std::vector<std::string> colors(graph.nodes, OtherColor);
  for (const int node : changed)
  {
    colors[node] = ChangedColor;
  }
  for (int node = 0; node < graph.nodes && !tracked.empty(); ++node)
  {
    const auto found = std::find(tracked.begin(), tracked.end(), NameOfNode(graph, node));
    if (found != tracked.end())
    {
      colors[node] = TrackColors()[(found - tracked.begin()) % TrackColors().size()];
    }
  }
  return colors;
}

/** Evenly sampled steps from the first to the last, at most mostStepsOfPicture. */
std::vector<int>
ShownSteps(int steps)
{
  const int        shown = std::min(steps, mostStepsOfPicture);
  std::vector<int> list;
  for (int i = 0; i < shown; ++i)
  {
    list.push_back(shown > 1 ? static_cast<int>(static_cast<long long>(i) * (steps - 1) / (shown - 1)) : 0);
  }
  return list;
}

std::string
TitleOf(const DynamicSequence & sequence, int step)
{
  return "step " + std::to_string(step) + ": " + sequence.files[step];
}

/** Consistent color per name in all steps, in order of first appearance. */
class ColorsOfNames
{
public:
  explicit ColorsOfNames(const DynamicSequence & sequence)
  {
    for (const DynamicStep & step : sequence.steps)
    {
      for (int node = 0; node < step.certificate.graph.nodes; ++node)
      {
        m_Numbers.emplace(NameOfNode(step.certificate.graph, node), static_cast<int>(m_Numbers.size()));
      }
    }
    m_Colors = DistinctColors(static_cast<int>(m_Numbers.size()));
  }

  std::vector<std::string>
  Of(const Graph & graph) const
  {
    std::vector<std::string> colors;
    for (int node = 0; node < graph.nodes; ++node)
    {
      colors.push_back(m_Colors[m_Numbers.at(NameOfNode(graph, node))]);
    }
    return colors;
  }

private:
  std::map<std::string, int> m_Numbers;
  std::vector<std::string>   m_Colors;
};

/** Marks the changes between two steps: the ends of removed edges on the first step, all other changes on the second
 * step. */
void
WriteComparedSteps(const DynamicSequence &          sequence,
                   const std::vector<int> &         compared,
                   const std::vector<std::string> & tracked,
                   const GraphSideBySide &          sheet,
                   const std::string &              path)
{
  const EmbeddingCertificate & a = sequence.steps[compared[0]].certificate;
  const EmbeddingCertificate & b = sequence.steps[compared[1]].certificate;
  const GraphChanges           changes = ChangesBetween(a, b);
  std::vector<int>             gone = changes.removedNodes;
  for (const int edge : changes.removedEdges)
  {
    gone.insert(gone.end(), a.graph.edges[edge].begin(), a.graph.edges[edge].end());
  }
  WriteGraphSheetSvg(
    { { TitleOf(sequence, compared[0]), &a, ColorsOfChange(a.graph, gone, tracked), sheet.hasLabels },
      { TitleOf(sequence, compared[1]), &b, ColorsOfChange(b.graph, changes.changedNodes, tracked), sheet.hasLabels } },
    {},
    path);
}
} // namespace

void
WriteSequencePictures(const DynamicSequence &          sequence,
                      const std::vector<int> &         compared,
                      const std::vector<std::string> & tracked,
                      const GraphSideBySide &          sheet,
                      const OutputPath &               output)
{
  const ColorsOfNames    names(sequence);
  std::vector<GraphView> changes;
  std::vector<GraphView> correspondence;
  const auto             steps = static_cast<int>(sequence.steps.size());
  for (const int step : ShownSteps(steps))
  {
    const DynamicStep & shown = sequence.steps[step];
    const Graph &       graph = shown.certificate.graph;
    const std::string   title = TitleOf(sequence, step);
    const auto          colors = ColorsOfChange(graph, shown.changes.changedNodes, tracked);
    changes.push_back({ title, &shown.certificate, colors, sheet.hasLabels });
    correspondence.push_back({ title, &shown.certificate, names.Of(graph), sheet.hasLabels });
  }
  GraphPictureOptions options;
  constexpr int       panelSize = 400; // pixels
  constexpr int       mostColumns = 6;
  const int           shownSteps = static_cast<int>(changes.size());
  const int           rows = (shownSteps + mostColumns - 1) / mostColumns;
  options.panelSize = panelSize;
  options.columns = (shownSteps + rows - 1) / rows;
  options.enlarged = tracked;
  WriteGraphSheetSvg(changes, options, output(sheet.folder + "/steps.svg"));
  options.enlarged.clear();
  WriteGraphSheetSvg(correspondence, options, output(sheet.folder + "/correspondence.svg"));
  if (!compared.empty())
  {
    WriteComparedSteps(sequence, compared, tracked, sheet, output(sheet.folder + "/compare.svg"));
  }
  GraphReport report{ "Dynamic graph", changes, {}, sheet.warnings, sheet.provenance, {} };
  report.tracked = tracked;
  report.isSequence = true;
  report.paragraphs = { "Green: nodes that are new, or gained or lost an edge since the previous step; red: other "
                        "nodes. Tracked nodes have colors of their own. Choose two steps above to see their "
                        "differences." };
  if (steps > mostStepsOfPicture)
  {
    report.paragraphs.push_back(std::to_string(mostStepsOfPicture) + " of " + std::to_string(steps) +
                                " steps are shown; the tables list all of them.");
  }
  report.tables.emplace_back("All steps", TableOfSteps(sequence));
  WriteGraphReport(report, output(sheet.folder + "/index.html"));
}
} // namespace shapeton
