#include "shapetonHeatExplorer.h"

#include "shapetonExplorerData.h"

#include <stdexcept>

namespace shapeton
{
const char * const HeatExplorer::DataFolder = "explorer";

HeatExplorer::HeatExplorer(const std::string & folder, const OutputPath & outputPath)
  : m_Folder(folder), m_OutputPath(outputPath), m_Blocks(folder + "/" + DataFolder, false, outputPath)
{}

void
HeatExplorer::AddStep(const itk::Image<float, 3> * values, std::uint64_t timeStep)
{
  if (m_TimeSteps.empty() || m_TimeSteps.back() != timeStep)
  {
    m_TimeSteps.push_back(timeStep);
    PutBins(m_Blocks, "bins-" + std::to_string(timeStep), values);
  }
}

void
HeatExplorer::Write(const HeatExplorerContent & content)
{
  if (m_TimeSteps.empty())
  {
    throw std::logic_error("a heat explorer requires the heat of at least one time step");
  }
  PutGray(m_Blocks, content.gray, WindowOf(content.gray, content.window));
  PutCounts(m_Blocks, "histogram", *content.histogram);
  if (content.axisHistogram)
  {
    PutCounts(m_Blocks, "axis", *content.axisHistogram);
  }
  Json info = InfoOf(content);
  info["quantity"] = JsonOf(content.quantity);
  info["timeSteps"] = content.histogram->GetTimeSteps();
  info["stored"] = m_TimeSteps;
  info["hasAxis"] = content.axisHistogram != nullptr;
  info["lines"] = JsonOf(content.lines);
  if (content.objects)
  {
    PutLabels(m_Blocks, content.objects->labels);
    info["objects"] = JsonOf(*content.objects);
  }
  m_Blocks.PutJson("info", info);
  WriteExplorerPage(m_OutputPath(m_Folder + "/explorer.html"), DataFolder);
}
} // namespace shapeton
