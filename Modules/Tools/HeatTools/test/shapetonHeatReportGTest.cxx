#include "shapetonHeatReport.h"
#include "shapetonParticleResultFiles.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonColorMap.h"
#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonExceptions.h"
#include "shapetonTestImages.h"
#include "shapetonTestReports.h"

#include <stdexcept>

namespace
{
using ImageType = itk::Image<float, 3>;

/** A small report with all sections. */
class HeatReport : public testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Gray = basetest::NewImage<ImageType>({ { 16, 14, 12 } }, { 0.5, 0.5, 2.0 });
    m_Heat = shapeton::NewImageOn<ImageType>(m_Gray, true);
    m_Heat->FillBuffer(0.0F);
    for (int i = 0; i < 16 * 14 * 12; ++i)
    {
      m_Gray->GetBufferPointer()[i] = static_cast<float>(i % 97);
      m_Heat->GetBufferPointer()[i] = i % 5 == 0 ? 0.25F : 0.0F;
    }
    m_Histogram = shapeton::HeatHistogram({ 0, 100 });
    m_Histogram.AddToRow(0, m_Heat->GetBufferPointer(), 16 * 14 * 12);
    m_Histogram.AddToRow(1, m_Heat->GetBufferPointer(), 16 * 14 * 12);
    shapeton::HeatClass background;
    background.upperHeat = 0.1;
    background.voxels = 2150;
    shapeton::HeatClass object;
    object.label = 1;
    object.lowerHeat = 0.1;
    object.upperHeat = 0.5;
    object.meanHeat = 0.25;
    object.voxels = 538;
    object.volume = 269.0;
    object.components = 3;
    object.normalizedHeat = 0.8;
    m_Content.classes = { background, object };
    m_Content.input = { { "Name", "<phantom> & more" } };
    m_Content.parameters = { { "p", "7" } };
    m_Content.provenance = { { "tool", "test" } };
    m_Content.warnings = { "mind the gap" };
    m_Content.histogram = &m_Histogram;
    m_Content.gray = m_Gray;
    m_Content.heat = m_Heat;
    m_Content.timeStep = 100;
    m_Content.markedTimeSteps = { 100 };
  }

  ImageType::Pointer          m_Gray;
  ImageType::Pointer          m_Heat;
  shapeton::HeatHistogram     m_Histogram;
  shapeton::HeatReportContent m_Content;
};

const shapeton::OutputPath inPlace = [](const std::string & path) { return path; };

const char * const files[] = { "index.html",    "histogram.png", "slices-heat.png", "slices-classes.png",
                               "rendering.png", "classes.csv",   "report.json" };
} // namespace

TEST_F(HeatReport, LinksToTheExplorerThatStandsBesideIt)
{
  const std::string folder = shapeton::TemporaryFolder("explored");
  std::filesystem::create_directory(folder + "/" + shapeton::HeatExplorer::DataFolder);
  const auto hasLink = [&] {
    shapeton::WriteHeatReport(m_Content, folder, inPlace);
    return shapeton::ReadFileBytes(folder + "/index.html").find("href=\"explorer.html\"") != std::string::npos;
  };
  EXPECT_FALSE(hasLink());
  shapeton::HeatExplorer explorer(folder, inPlace);
  shapeton::WriteExplorer(m_Content, explorer);
  EXPECT_TRUE(std::filesystem::exists(folder + "/explorer.html"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/explorer/bins-100.js"));
  m_Content.hasExplorer = true;
  EXPECT_TRUE(hasLink());
}

TEST_F(HeatReport, WritesAllFilesByTheGivenNames)
{
  const std::string        folder = shapeton::TemporaryFolder("report");
  std::vector<std::string> asked;
  shapeton::WriteHeatReport(m_Content, "/final", [&](const std::string & path) {
    asked.push_back(path);
    return folder + "/" + std::filesystem::path(path).filename().string();
  });
  for (const char * const file : files)
  {
    EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
    EXPECT_EQ(std::count(asked.begin(), asked.end(), std::string("/final/") + file), 1) << file;
  }
  EXPECT_EQ(asked.size(), std::size(files));
}

TEST_F(HeatReport, ThePageNeedsNoNetworkAndSaysWhatItIs)
{
  const std::string folder = shapeton::TemporaryFolder("report-page");
  shapeton::WriteHeatReport(m_Content, folder, inPlace);
  const std::string html = shapeton::ReadFileBytes(folder + "/index.html");
  for (const char * const wanted : { "research use",
                                     "not a diagnosis",
                                     "mind the gap",
                                     "&lt;phantom&gt; &amp; more",
                                     "16 x 14 x 12",
                                     "0.5, 0.5, 2",
                                     "data:image/png;base64," })
  {
    EXPECT_NE(html.find(wanted), std::string::npos) << wanted;
  }
  for (const char * const unwanted : { "http:", "https:", "src=\"file", "<script", "/tmp", "\"nan\"" })
  {
    EXPECT_EQ(html.find(unwanted), std::string::npos) << unwanted;
  }
  EXPECT_EQ(basetest::CountOf(html, "<img"), 4U);
}

TEST_F(HeatReport, TablesAndJsonHoldTheClasses)
{
  const std::string folder = shapeton::TemporaryFolder("report-data");
  shapeton::WriteHeatReport(m_Content, folder, inPlace);
  const shapeton::Json document = shapeton::ReadJson(folder + "/report.json");
  EXPECT_EQ(document["timeStep"], 100);
  EXPECT_EQ(document["classes"].size(), 2U);
  EXPECT_EQ(document["classes"][1]["meanHeat"], 0.25);
  EXPECT_EQ(document["warnings"][0], "mind the gap");
  EXPECT_EQ(document["provenance"]["tool"], "test");
  const auto table = shapeton::ClassTable(m_Content.classes);
  ASSERT_EQ(table.GetRows().size(), 2U);
  EXPECT_EQ(table.GetRows()[1][3], "0.25");
  EXPECT_EQ(table.GetRows()[1][4], "538");
  EXPECT_EQ(table.GetRows()[0].back(), "");
  EXPECT_EQ(table.GetRows()[1].back(), shapeton::HexOf(shapeton::ClassColor(1)));
  const std::string csv = shapeton::ReadFileBytes(folder + "/classes.csv");
  EXPECT_EQ(csv.substr(0, 15), "label,lowerHeat");
}

TEST_F(HeatReport, OpenedRangesHaveAHistogramARenderingAndTheirLines)
{
  m_Content.ranges = shapeton::HeatRangesOf({ 0.1, 0.5, 0.2, 0.3 });
  const std::string folder = shapeton::TemporaryFolder("report-range");
  shapeton::WriteHeatReport(m_Content, folder, inPlace);
  EXPECT_TRUE(std::filesystem::exists(folder + "/histogram-range.png"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/rendering-range.png"));
  const shapeton::Json opened = shapeton::ReadJson(folder + "/report.json")["histogramRange"];
  EXPECT_EQ(opened["ranges"], shapeton::Json({ { 0.1, 0.5 }, { 0.2, 0.3 } }));
  ASSERT_EQ(opened["lines"].size(), 1U);
  EXPECT_EQ(opened["lines"][0]["voxels"], 538);
  EXPECT_EQ(opened["lines"][0]["lowerHeat"], 0.2);
  EXPECT_NO_THROW(shapeton::ShapeTransferFunction::Parse(opened["transferFunction"].get<std::string>()));
  EXPECT_TRUE(shapeton::RangeRemarks(m_Content).empty());
}

TEST_F(HeatReport, AnOpenedRangeWithoutHeatIsReportedAndRemarkedUpon)
{
  m_Content.ranges = shapeton::HeatRangesOf({ 0.3, 0.4 });
  const auto remarks = shapeton::RangeRemarks(m_Content);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("the zoomed histogram is empty"), std::string::npos);
  EXPECT_NE(remarks[0].find("0.25"), std::string::npos);
  const std::string folder = shapeton::TemporaryFolder("report-empty-range");
  EXPECT_NO_THROW(shapeton::WriteHeatReport(m_Content, folder, inPlace));
  EXPECT_TRUE(shapeton::ReadJson(folder + "/report.json")["histogramRange"]["lines"].empty());
}

TEST_F(HeatReport, ClassesHaveTheirOwnColors)
{
  shapeton::HeatClass other = m_Content.classes[1];
  other.label = 2;
  other.lowerHeat = 0.5;
  other.upperHeat = 1.0;
  other.meanHeat = 0.9;
  m_Content.classes.push_back(other);
  const std::string folder = shapeton::TemporaryFolder("report-colors");
  shapeton::WriteHeatReport(m_Content, folder, inPlace);
  const std::string html = shapeton::ReadFileBytes(folder + "/index.html");
  for (const unsigned int label : { 1U, 2U })
  {
    EXPECT_NE(html.find("background:" + shapeton::HexOf(shapeton::ClassColor(label))), std::string::npos) << label;
  }
}

TEST_F(HeatReport, EqualContentGivesEqualBytes)
{
  const std::string first = shapeton::TemporaryFolder("report-first");
  const std::string second = shapeton::TemporaryFolder("report-second");
  shapeton::WriteHeatReport(m_Content, first, inPlace);
  shapeton::WriteHeatReport(m_Content, second, inPlace);
  for (const char * const file : files)
  {
    EXPECT_EQ(shapeton::ReadFileBytes(first + "/" + file), shapeton::ReadFileBytes(second + "/" + file)) << file;
  }
}

TEST_F(HeatReport, FailuresAreReported)
{
  EXPECT_THROW(shapeton::WriteHeatReport(m_Content, "/nonexistent-folder", inPlace), shapeton::OutputError);
  m_Content.heat = nullptr;
  EXPECT_THROW(shapeton::WriteHeatReport(m_Content, shapeton::TemporaryFolder("report-none"), inPlace),
               std::invalid_argument);
}

TEST_F(HeatReport, ABackgroundAloneIsReportedToo)
{
  m_Heat->FillBuffer(0.0F);
  m_Histogram = shapeton::HeatHistogram({ 100 });
  m_Histogram.AddToRow(0, m_Heat->GetBufferPointer(), 16 * 14 * 12);
  m_Content.classes.resize(1);
  const std::string folder = shapeton::TemporaryFolder("report-background");
  EXPECT_NO_THROW(shapeton::WriteHeatReport(m_Content, folder, inPlace));
}

TEST(HeatTables, TheHistogramTableHoldsEveryVoxelInItsRange)
{
  shapeton::HeatHistogram  histogram({ 0, 50 });
  const std::vector<float> heats{ 0.0F, 0.0F, 0.25F, 0.2501F, 1.0F };
  histogram.AddToRow(1, heats.data(), heats.size());
  const shapeton::CsvTable table = shapeton::HistogramTable(histogram);
  ASSERT_EQ(table.GetRows().size(), 3U);
  EXPECT_EQ(table.GetRows()[0], (std::vector<std::string>{ "50", "0", "1.52587890625e-05", "2" }));
  EXPECT_EQ(table.GetRows()[1][1], "0.25");
  EXPECT_EQ(table.GetRows()[1][3], "2");
  EXPECT_EQ(table.GetRows()[2][2], "1");
}

TEST(HeatTables, RemarksTellWhatIsNotAsExpected)
{
  shapeton::CumulativeHeatDiffusionResult result;
  result.timeStep = 500;
  result.windowUpper = 1.0;
  EXPECT_TRUE(shapeton::RunRemarks(result, false, 500).empty());
  EXPECT_EQ(shapeton::RunRemarks(result, true, 0).size(), 1U);
  result.steady = true;
  EXPECT_TRUE(shapeton::RunRemarks(result, true, 0).empty());
  EXPECT_EQ(shapeton::RunRemarks(result, true, 501).size(), 1U);
}

TEST(PartRemarks, SayThatHeatShowsMoreOfSpeckle)
{
  const auto remarksOf = [](const std::vector<double> & coherences) {
    std::vector<shapeton::HeatClass> classes;
    for (const double coherence : coherences)
    {
      classes.emplace_back();
      classes.back().label = static_cast<unsigned int>(classes.size() - 1);
      classes.back().coherence = coherence;
      classes.back().isSurroundings = classes.size() == 2;
    }
    const auto remarks = shapeton::PartRemarks(classes);
    return remarks.empty() ? std::string() : remarks.front();
  };
  EXPECT_EQ(remarksOf({ 0.5, 0.9, 0.8, 0.7, 0.1 }), "") << "two parts and some speckle";
  EXPECT_EQ(remarksOf({ 0.5, 0.9, 0.8 }), "") << "one object";
  EXPECT_NE(remarksOf({ 0.5, 0.9, 0.8, 0.1 }).find("one part"), std::string::npos);
  EXPECT_NE(remarksOf({ 0.5, 0.9, 0.1, 0.0 }).find("no parts"), std::string::npos);
  EXPECT_NE(remarksOf({ 0.5, 0.9 }).find("one class"), std::string::npos);
}
