#include "shapetonLiveExplorer.h"

#include "shapetonExplorerData.h"
#include "shapetonFileBytes.h"

#include <filesystem>

namespace shapeton
{
namespace
{
constexpr std::size_t greatestNumberOfRows = 64; // of the histogram; more are thinned out

HeatHistogram
Joined(const std::vector<HeatHistogram> & rows)
{
  std::vector<std::uint64_t> steps;
  for (const HeatHistogram & row : rows)
  {
    steps.push_back(row.GetTimeSteps()[0]);
  }
  HeatHistogram joined(steps);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    joined.AddToRow(i, rows[i].GetRow(0));
  }
  return joined;
}
} // namespace

LiveExplorer::LiveExplorer(const std::string & page, const OutputPath & outputPath)
  : m_Page(page), m_OutputPath(outputPath)
{}

std::string
LiveExplorer::DataFolder() const
{
  std::filesystem::path folder(m_Page);
  return folder.replace_filename(folder.stem().string() + "-data").string();
}

std::vector<std::string>
LiveExplorer::PageFiles() const
{
  return { m_Page, this->DataFolder() + "/gray.js", this->DataFolder() + "/info.js" };
}

std::string
LiveExplorer::StateFile() const
{
  return this->DataFolder() + "/live.js";
}

void
LiveExplorer::WritePage(const HeatExplorerContent & content, double secondsBetweenStates) const
{
  PageBlocks blocks(this->DataFolder(), false, m_OutputPath);
  PutGray(blocks, content.gray, WindowOf(content.gray, content.window));
  Json info = InfoOf(content);
  info["secondsBetweenStates"] = secondsBetweenStates;
  blocks.PutJson("info", info);
  WriteExplorerPage(m_OutputPath(m_Page), std::filesystem::path(this->DataFolder()).filename().string());
}

void
LiveExplorer::WriteState(const ShapeAnalysis & shape, const LiveState & state)
{
  this->Remember(shape.histogram);
  const HeatHistogram histogram = Joined(m_Rows);
  const auto          lines = ShapeTransferFunction::FromClasses(shape.classes);
  PageBlocks          blocks("", true, m_OutputPath);
  PutBins(blocks, "bins-live", shape.values);
  PutCounts(blocks, "histogram", histogram);
  PutCounts(blocks, "axis", shape.axisHistogram);
  blocks.PutJson("live",
                 { { "quantity", JsonOf(shape.quantity) },
                   { "timeSteps", histogram.GetTimeSteps() },
                   { "stored", { state.timeStep } },
                   { "lines", JsonOf(lines) },
                   { "progress", state.progress },
                   { "isFinished", state.isFinished } });
  WriteFileBytes(m_OutputPath(this->StateFile()), blocks.Script());
}

/** Beyond the maximum number, every second row is dropped. */
void
LiveExplorer::Remember(const HeatHistogram & row)
{
  if (!m_Rows.empty() && m_Rows.back().GetTimeSteps() == row.GetTimeSteps())
  {
    return;
  }
  m_Rows.push_back(row);
  if (m_Rows.size() > greatestNumberOfRows)
  {
    std::vector<HeatHistogram> kept;
    for (std::size_t i = 0; i < m_Rows.size(); i += 2)
    {
      kept.push_back(m_Rows[i]);
    }
    m_Rows = std::move(kept);
  }
}
} // namespace shapeton
