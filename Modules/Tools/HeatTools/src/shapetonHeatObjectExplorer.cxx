#include "shapetonHeatObjectExplorer.h"

#include "shapetonReportFolder.h"
#include "shapetonShapeAnalysis.h"

namespace shapeton
{
namespace
{
/** The values of a heat volume or of visits, for the page. */
ShapeAnalysis
Analyze(const HeatFile & heat)
{
  const std::uint64_t step = heat.file.timeStep.value_or(0);
  const auto          visits = VisitsOf(heat.image, heat.file);
  return visits ? AnalyzeVisits(visits, step, false) : AnalyzeHeat(heat.image, step, false);
}
} // namespace

HeatObjectExplorer::HeatObjectExplorer(CommandLine & commandLine)
{
  if (const std::string folder = commandLine.GetString("explorer"); !folder.empty())
  {
    m_Explorer = MakeExplorer(commandLine, folder);
  }
}

HeatObjectExplorer::~HeatObjectExplorer() = default;

void
HeatObjectExplorer::Write(const itk::Image<float, 3> *  gray,
                          const std::vector<HeatFile> & heats,
                          const HeatObjectList &        list)
{
  if (!m_Explorer)
  {
    return;
  }
  const bool                 hasWindows = heats.front().file.intensityWindow.has_value();
  std::vector<HeatHistogram> rows;
  std::vector<std::uint64_t> steps;
  ShapeAnalysis              shape;
  for (const HeatFile & heat : heats)
  {
    if (rows.empty() || !hasWindows)
    {
      shape = Analyze(heat);
      rows.push_back(shape.histogram);
      steps.push_back(shape.histogram.GetTimeSteps().front());
      m_Explorer->AddStep(shape.values, steps.back());
    }
  }
  HeatHistogram histogram(steps);
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    histogram.AddToRow(row, rows[row].GetRow(0));
  }
  HeatExplorerContent content;
  content.title = "Heat objects";
  content.quantity = shape.quantity;
  content.histogram = &histogram;
  content.axisHistogram = &shape.axisHistogram;
  content.gray = gray;
  content.objects = &list;
  m_Explorer->Write(content);
}
} // namespace shapeton
