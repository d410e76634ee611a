#include "shapetonColonoscopyLimitations.h"
#include "shapetonColonoscopyReport.h"
#include "shapetonPolypCandidateReport.h"

#include "shapetonFileBytes.h"
#include "shapetonHtmlReport.h"
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

shapeton::SurfaceArray
Array(const std::string & name, const Eigen::VectorXd & values)
{
  return { name, values, false };
}

/** A colon along the third axis of an image with 2 mm slices, collapsed from 200 to 240 mm, narrow from 300 to 320 mm
 * and outside the scan up to 5 mm. */
shapeton::ColonoscopyResults
CollapsedColon()
{
  constexpr int   points = 1761; // one each mm
  Eigen::VectorXd arc = Eigen::VectorXd::LinSpaced(points, 0.0, points - 1.0);
  const auto      between = [&](double begin, double end, double value) {
    return ((arc.array() >= begin && arc.array() <= end).cast<double>() * value).matrix().eval();
  };
  shapeton::ColonoscopyResults results;
  results.centerline.V = shapeton::VertexMatrix::Zero(points, 3);
  results.centerline.V.col(2) = arc;
  results.centerline.curves.emplace_back();
  for (int i = 0; i < points; ++i)
  {
    results.centerline.curves[0].push_back(i);
  }
  results.centerline.pointArrays = {
    Array("arcLength", arc),
    Array("radius", Eigen::VectorXd::Constant(points, 15.0)),
    Array("gap", between(201.0, 239.0, 1.0)),
    Array("notAssessable", between(0.0, 4.0, 2.0) + between(201.0, 239.0, 1.0) + between(300.0, 320.0, 4.0))
  };
  results.segments = shapeton::SegmentsOf(Landmarks(), 1760.0);
  results.quality = shapeton::Json::parse(R"({"missing": ["the ileocecal valve: it is unknown"],
    "lumen": {"catheter": {"found": true, "outerDiameter": 9.8, "balloonDiameter": 25.2, "to": [0, 0, 60]}}, "centerline": {"merges":
    [{"place": [1, 2, 99], "clearance": 2, "loop": 100}, {"place": [1, 2, 9], "clearance": 1, "loop": 90}]}})");
  results.lumen = itk::Image<unsigned char, 3>::New();
  results.lumen->SetRegions(itk::Size<3>{ { 1, 1, 900 } });
  const double spacing[3] = { 1.0, 1.0, 2.0 };
  results.lumen->SetSpacing(spacing);
  return results;
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

TEST(ColonoscopyReport, RanksLimitationsByConsequence)
{
  shapeton::ColonoscopyResults results = CollapsedColon();
  shapeton::ColonoscopyQuality quality;
  shapeton::SegmentQuality     sigmoid;
  results.inspection = shapeton::Json::parse(R"({"series": [{"usable": false, "lossy": true, "description": "scout"},
    {"usable": true, "derived": true, "lossy": true}]})");
  sigmoid.extent = results.segments[1];
  sigmoid.submergedShare = 0.4;
  sigmoid.hiddenArea = 170.0;
  sigmoid.hiddenParts = 2;
  sigmoid.largestHidden = { { 0.0, 0.0, 300.0 }, 120.0 };
  quality.segments = { sigmoid };
  const std::vector<shapeton::Limitation> list = shapeton::LimitationsOf(results, quality);
  const std::vector<std::string>          expected{
    "Incomplete: the ileocecal valve: it is unknown.",
    "Incomplete: one position only; the other may show what is hidden here,",
    "The images are derived, not original (Image Type): HU, sizes, lengths and",
    "The images were compressed with loss",
    "Sigmoid: collapsed segment, its wall is interpolated (no CT data), 4.0 cm, at 20.0 to 24.0 cm from the anal "
             "verge, "
             "slices 101 to 121.",
    "Sigmoid: poorly distended (caliber below 10 mm), 2.1 cm, at 30.0 to 32.1 cm from the anal verge, slices 151 to "
             "161.",
    "Rectum: outside the field of view, 0.5 cm, at 0.0 to 0.5 cm from the anal verge, slices 1 to 3.",
    "Wall not shown on the flat map: 1.7 cm^2 in 2 places (sigmoid 1.7); see slices and endoluminal views. The "
             "largest "
             "has 1.2 cm^2, slice 151.",
    "Wall under tagged fluid, where unfolded and 3-D views show polyps only after electronic cleansing; look for "
             "filling "
             "defects in the CT: sigmoid 40 %.",
    "Rectum: a catheter of 10 mm with a balloon of 25 mm hides wall up to its tip, slice 31.",
    "Loops of the colon touch at 2 places; no wall between them is resolved there: check that the course does not "
             "jump. "
             "The widest is at (1, 2, 99) mm, slice 51."
  };
  ASSERT_EQ(list.size(), expected.size());
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    EXPECT_EQ(list[i].text.substr(0, expected[i].size()), expected[i]);
  }
  ASSERT_TRUE(list[4].place);
  EXPECT_EQ(list[4].place->z(), 220.0);

  EXPECT_EQ(list[2].text.find("contradict"), std::string::npos);
  results.quality["lumen"]["gasVolume"] = 4992.0; // ml, more than any reference
  EXPECT_NE(shapeton::LimitationsOf(results, quality)[2].text.find("4992 ml of gas contradict the reference"),
            std::string::npos);
}

TEST(ColonoscopyReport, NamesReasonsForAnInadequateExamination)
{
  shapeton::ColonoscopyResults results = CollapsedColon();
  shapeton::ColonoscopyQuality quality;
  shapeton::SegmentQuality     sigmoid;
  sigmoid.extent = results.segments[1];
  sigmoid.assessability.share = 0.4;
  quality.segments = { sigmoid };
  EXPECT_EQ(
    shapeton::ReasonForInadequate(results, quality),
    "one position only, unless another one is read elsewhere; the ileocecal valve: it is unknown; only 40 % of the "
    "sigmoid is evaluable");
  results.quality["missing"] = shapeton::Json::array();
  results.isSecond = true;
  shapeton::ColonAssessability either; // the other position shows the rest
  either.share = 0.95;
  quality.either = { either };
  EXPECT_EQ(shapeton::ReasonForInadequate(results, quality), "");
}

TEST(ColonoscopyReport, ShowsPolypsThatThisPositionLacksOrNamesDifferently)
{
  shapeton::PolypCandidate stool, same;
  stool.number = 9;
  stool.lookalike = shapeton::PolypLookalike::Tagged;
  same.number = 1;
  const std::vector<shapeton::PolypCandidate> here{ same, stool };
  const auto                                  partnerOf = [](int number, int partner) {
    shapeton::PolypCandidate one;
    one.number = number;
    one.other = shapeton::PolypInOtherPosition();
    one.other->isSeen = partner > 0;
    one.other->candidate = partner;
    return one;
  };
  const Folder         folder;
  shapeton::HtmlReport html("Candidates");
  shapeton::AddPolypsOfOtherPosition(html, { here, { partnerOf(1, 1), partnerOf(5, 9), partnerOf(6, 0) } });
  html.Write(folder / "page.html");
  const std::string page = shapeton::ReadFileBytes(folder / "page.html");
  EXPECT_NE(page.find("<td>candidate 9, recognized as tagged stool or residue: the positions disagree</td>"),
            std::string::npos);
  EXPECT_NE(page.find("<td>no candidate</td>"), std::string::npos);
  EXPECT_EQ(page.find("candidate 1"), std::string::npos); // a candidate in both positions

  shapeton::PolypCards cards; // those that only the other position lists have a card, too
  cards.polyps = { here, { partnerOf(1, 1), partnerOf(5, 9) } };
  cards.pictureOf = [](int) { return std::string(); };
  shapeton::HtmlReport withCards("Cards");
  shapeton::AddPolypCandidateCards(withCards, cards);
  withCards.Write(folder / "cards.html");
  const std::string cardPage = shapeton::ReadFileBytes(folder / "cards.html");
  EXPECT_NE(cardPage.find("Lesion A: candidate 1"), std::string::npos);
  EXPECT_NE(cardPage.find("Lesion B: candidate 9"), std::string::npos);
  EXPECT_NE(cardPage.find("The positions disagree"), std::string::npos);

  shapeton::HtmlReport none("Candidates");
  shapeton::AddPolypsOfOtherPosition(none, { here, { partnerOf(1, 1) } });
  none.Write(folder / "none.html");
  EXPECT_EQ(shapeton::ReadFileBytes(folder / "none.html").find("<table>"), std::string::npos);
}
