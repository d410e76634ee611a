#include "shapetonLiveExplorer.h"

#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
/** Visits of a volume of 4^3 voxels; the first voxel has the most. */
shapeton::ShapeAnalysis
VisitsAfter(std::uint64_t timeStep)
{
  auto visits = basetest::NewImage<itk::Image<std::uint32_t, 3>>({ { 4, 4, 4 } });
  visits->FillBuffer(1);
  visits->GetBufferPointer()[0] = static_cast<std::uint32_t>(timeStep);
  return shapeton::AnalyzeVisits(visits, timeStep);
}

shapeton::Json
StateIn(const std::string & script)
{
  const std::string head = "block(\"live\",null,";
  const std::size_t start = script.find(head) + head.size();
  return shapeton::Json::parse(script.substr(start, script.find(");\n", start) - start));
}
} // namespace

TEST(LiveExplorer, ItsDataLieBesideThePage)
{
  const shapeton::LiveExplorer explorer("/runs/now.html", nullptr);
  EXPECT_EQ(explorer.DataFolder(), "/runs/now-data");
  EXPECT_EQ(explorer.StateFile(), "/runs/now-data/live.js");
  EXPECT_EQ(explorer.PageFiles().front(), "/runs/now.html");
}

TEST(LiveExplorer, AStateIsOneFileWithTheLastStepAndAtMost64Rows)
{
  const std::string      path = testing::TempDir() + "/live.js";
  shapeton::LiveExplorer explorer("now.html", [&path](const std::string &) { return path; });
  for (std::uint64_t step = 1; step <= 100; ++step)
  {
    explorer.WriteState(VisitsAfter(step), { step, "step " + std::to_string(step), step == 100 });
  }
  const std::string    script = shapeton::ReadFileBytes(path);
  const shapeton::Json state = StateIn(script);
  for (const char * name : { "bins-live", "histogram", "axis" })
  {
    EXPECT_NE(script.find("block(\"" + std::string(name) + "\","), std::string::npos) << name;
  }
  EXPECT_EQ(state["stored"], shapeton::Json({ 100 }));
  EXPECT_EQ(state["progress"], "step 100");
  EXPECT_EQ(state["isFinished"], true);
  EXPECT_EQ(state["quantity"]["greatestVisits"], 100);
  const auto steps = state["timeSteps"].get<std::vector<std::uint64_t>>();
  EXPECT_GE(steps.size(), 32U);
  EXPECT_LE(steps.size(), 64U);
  EXPECT_EQ(steps.front(), 1U);
  EXPECT_EQ(steps.back(), 100U);
}
