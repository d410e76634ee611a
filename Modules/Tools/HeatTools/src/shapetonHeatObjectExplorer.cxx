#include "shapetonHeatObjectExplorer.h"

#include "shapetonReportFolder.h"
#include "shapetonShapeAnalysis.h"
#include "shapetonSliceChoice.h"

namespace shapeton
{
HeatObjectExplorer::HeatObjectExplorer(CommandLine & commandLine)
{
  if (const std::string folder = commandLine.GetString("explorer"); !folder.empty())
  {
    m_Explorer = MakeExplorer(commandLine, folder);
  }
}

HeatObjectExplorer::~HeatObjectExplorer() = default;

void
HeatObjectExplorer::Write(const itk::Image<float, 3> * gray,
                          const itk::Image<float, 3> * heat,
                          const HeatSnapshot &         file,
                          const HeatObjectTree &       tree,
                          const HeatObjectList &       objects)
{
  if (!m_Explorer)
  {
    return;
  }
  const std::uint64_t step = file.timeStep.value_or(0);
  const auto          visits = VisitsOf(heat, file);
  const ShapeAnalysis shape = visits ? AnalyzeVisits(visits, step, false) : AnalyzeHeat(heat, step, false);
  m_Explorer->AddStep(shape.values, step);
  const auto          list = tree.List(true);
  HeatExplorerContent content;
  content.title = "Heat objects";
  content.quantity = shape.quantity;
  content.histogram = &shape.histogram;
  content.axisHistogram = &shape.axisHistogram;
  content.gray = gray;
  content.objects = &list;
  content.place = CutThroughParts(objects.labels);
  m_Explorer->Write(content);
}
} // namespace shapeton
