#include "itkColonoscopyReport.h"

#include "itkFileBytes.h"
#include "itkFlatTestTubes.h"
#include "itkReportFolder.h"

#include "gtest/gtest.h"

namespace
{
using reporttest::Folder;
namespace stages = itk::colonoscopystage;

/** A straight tube with three segments, borders at 50 and 120 mm of 10 to 160 mm of the centreline. */
itk::SurfaceMesh
LabelledTube()
{
  const flattubes::TubeForm form;
  itk::SurfaceMesh          tube = flattubes::MakeFlatTube(
    form, [](double u, double angle) { return Eigen::Vector3d(20.0 * std::cos(angle), 20.0 * std::sin(angle), u); });
  itk::SurfaceArray segment{ "segment", itk::SurfaceArray::ValueMatrix(tube.F.rows(), 1), true };
  for (Eigen::Index face = 0; face < tube.F.rows(); ++face)
  {
    const double u = tube.V.row(tube.F(face, 0)).z();
    segment.values(face, 0) = u < 40.0 ? 1 : u < 110.0 ? 2 : 3;
  }
  tube.cellArrays.push_back(segment);
  return tube;
}

itk::StageResult
StageNamed(const std::string & name, int status)
{
  itk::StageResult stage;
  stage.name = name;
  stage.program = "Tool";
  stage.version = "1";
  stage.status = status;
  stage.message = status == 0 ? "" : "no <colon> found";
  return stage;
}

std::string
ReportOf(const itk::ColonoscopyReportContent & content)
{
  const Folder folder;
  itk::WriteColonoscopyReport(content, folder / "report.html", folder / "scratch");
  EXPECT_FALSE(std::filesystem::exists(folder / "scratch"));
  return itk::ReadFileBytes(folder / "report.html");
}
} // namespace

TEST(ColonoscopyReport, SegmentsFollowOneAnother)
{
  const auto segments = itk::SegmentsOf(LabelledTube());
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].name, "rectum");
  EXPECT_EQ(segments[2].name, "descending");
  EXPECT_NEAR(segments[0].end, 50.0, 3.0);
  EXPECT_NEAR(segments[1].end, 120.0, 3.0);
  EXPECT_EQ(segments[0].end, segments[1].begin);
  EXPECT_EQ(segments[1].end, segments[2].begin);
  EXPECT_NEAR(segments[1].area, 2.0 * flattubes::pi * 20.0 * 70.0, 400.0);
  EXPECT_TRUE(itk::SegmentsOf(itk::SurfaceMesh()).empty());
}

TEST(ColonoscopyReport, OfARunThatFailedTellsWhatFailed)
{
  itk::ColonoscopyResults results;
  results.stages = { StageNamed(stages::inspection, 0), StageNamed(stages::segmentation, 3) };
  itk::ColonoscopyReportContent content;
  content.results = &results;
  content.failure = "the stage segmentation failed";
  content.warnings = { "look <here>" };
  content.provenance = { { "tool", "VirtualColonoscopy" } };
  const std::string html = ReportOf(content);
  for (const char * const text : { "For research use. This is not a diagnosis",
                                   "partial: the stage segmentation failed",
                                   "look &lt;here&gt;",
                                   "<td>failed: no &lt;colon&gt; found</td>",
                                   "None: the stage was not done." })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(html.find("<figure>"), std::string::npos);
  EXPECT_EQ(ReportOf(content), html);
}

TEST(ColonoscopyReport, FilesForSlicerAreThoseOfTheResults)
{
  const Folder            folder;
  const itk::OutputPath   inPlace = [](const std::string & path) { return path; };
  itk::ColonoscopyResults results;
  EXPECT_TRUE(itk::WriteColonoscopySlicerFiles(results, folder / ".", inPlace).empty());
  results.segments = itk::SegmentsOf(LabelledTube());
  results.folds = { { 3, 20.0, 0.5 } };
  results.features.V = Eigen::Matrix3d::Identity();
  results.features.curves = { { 0 }, { 1 }, { 2 } };
  results.features.cellArrays = { { "fold", Eigen::Vector3d(3, 3, 3), true },
                                  { "kind", Eigen::Vector3d(0, 1, 2), true } };
  const auto written = itk::WriteColonoscopySlicerFiles(results, folder / ".", inPlace);
  EXPECT_EQ(written, (std::vector<std::string>{ "segments.ctbl", "features.mrk.json", "folds.ctbl" }));
  EXPECT_NE(itk::ReadFileBytes(folder / "segments.ctbl").find("2 sigmoid "), std::string::npos);
  EXPECT_NE(itk::ReadFileBytes(folder / "folds.ctbl").find("3 fold_3 "), std::string::npos);
  EXPECT_NE(itk::ReadFileBytes(folder / "features.mrk.json").find("\"label\": \"fold 3\""), std::string::npos);
}
