#include "shapetonColonoscopyReport.h"

#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"
#include "shapetonJson.h"

namespace
{
using basetest::Folder;
namespace stages = shapeton::colonoscopystage;

/** Landmarks as written by ColonLandmarks if the hepatic flexure was not found. */
shapeton::Json
Landmarks()
{
  return shapeton::Json::parse(R"({"segments": [
    {"number": 0, "name": "unknown", "begin": null, "end": null, "area": 5},
    {"number": 1, "name": "rectum", "begin": null, "end": 150.5, "area": 300},
    {"number": 2, "name": "sigmoid", "begin": 150.5, "end": 600, "area": 400},
    {"number": 4, "name": "transverse", "begin": 900, "end": null, "area": 500},
    {"number": 6, "name": "cecum", "begin": 1700, "end": null, "area": 600}]})");
}

shapeton::StageResult
StageNamed(const std::string & name, int status)
{
  shapeton::StageResult stage;
  stage.name = name;
  stage.program = "Tool";
  stage.version = "1";
  stage.status = status;
  stage.message = status == 0 ? "" : "no <colon> found";
  return stage;
}

std::string
ReportOf(const shapeton::ColonoscopyReportContent & content)
{
  const Folder folder;
  shapeton::WriteColonoscopyReport(content, folder / "report.html", folder / "scratch");
  EXPECT_FALSE(std::filesystem::exists(folder / "scratch"));
  return shapeton::ReadFileBytes(folder / "report.html");
}
} // namespace

TEST(ColonoscopyReport, SegmentsAreThoseWithTwoEnds)
{
  const auto segments = shapeton::SegmentsOf(Landmarks(), 1760.0);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].name, "rectum");
  EXPECT_EQ(segments[0].begin, 0.0);
  EXPECT_EQ(segments[0].end, 150.5);
  EXPECT_EQ(segments[1].area, 400.0);
  EXPECT_EQ(segments[2].label, 6);
  EXPECT_EQ(segments[2].end, 1760.0);
  EXPECT_EQ(basetest::MessageOf([] { shapeton::SegmentsOf(shapeton::Json::parse("{}"), 1.0); }).substr(0, 12),
            "InputError: ");
}

TEST(ColonoscopyReport, OfARunThatFailedTellsWhatFailed)
{
  shapeton::ColonoscopyResults results;
  results.stages = { StageNamed(stages::inspection, 0), StageNamed(stages::segmentation, 3) };
  shapeton::ColonoscopyReportContent content;
  content.results = &results;
  content.failure = "the stage segmentation failed";
  content.warnings = { "look <here>" };
  content.provenance = { { "tool", "VirtualColonoscopy" } };
  const std::string html = ReportOf(content);
  for (const char * const text : { "For research use. This is not a diagnosis",
                                   "partial: the stage segmentation failed",
                                   "look &lt;here&gt;",
                                   "<td>failed: no &lt;colon&gt; found</td>",
                                   "None: the stage was not run." })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(html.find("<figure>"), std::string::npos);
  EXPECT_EQ(ReportOf(content), html);
}

TEST(ColonoscopyReport, FilesForSlicerAreThoseOfTheResults)
{
  const Folder                 folder;
  const shapeton::OutputPath   inPlace = [](const std::string & path) { return path; };
  shapeton::ColonoscopyResults results;
  EXPECT_TRUE(shapeton::WriteColonoscopySlicerFiles(results, folder / ".", inPlace).empty());
  results.segments = shapeton::SegmentsOf(Landmarks(), 1760.0);
  results.centerline.V = Eigen::Matrix3d::Identity();
  results.centerline.curves = { { 0, 1, 2 } };
  results.stages = { StageNamed(stages::segmentation, 0) };
  results.stages[0].files = { { "lumen.nrrd", "" } };
  const auto written = shapeton::WriteColonoscopySlicerFiles(results, folder / ".", inPlace);
  EXPECT_EQ(written, (std::vector<std::string>{ "lumen.ctbl", "centerline.mrk.json", "segments.ctbl" }));
  EXPECT_NE(shapeton::ReadFileBytes(folder / "segments.ctbl").find("2 sigmoid "), std::string::npos);
  EXPECT_NE(shapeton::ReadFileBytes(folder / "centerline.mrk.json").find("\"type\": \"Curve\""), std::string::npos);
}
