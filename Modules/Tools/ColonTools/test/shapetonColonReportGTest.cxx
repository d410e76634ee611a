#include "shapetonColonReport.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonTestFolder.h"
#include "shapetonTestReports.h"
#include "shapetonTestColon.h"

#include <filesystem>
#include <set>
#include <stdexcept>

using basetest::CountOf;
using basetest::FilesIn;

namespace
{
const shapeton::OutputPath inPlace = [](const std::string & path) { return path; };

shapeton::ColonReportContent
ContentOf(const shapeton::TestColon & colon)
{
  shapeton::ColonReportContent content;
  content.colon = colon.Parts();
  content.input = { { "File", "a<b>.nrrd" } };
  content.summary = { { "Volume of gas", "12 ml" }, { "Genus, raw & repaired", "3, 0" } };
  content.parameters = { { "Gas below", "-800 HU" } };
  content.warnings = { "no lumen over 11 mm at <56 mm>" };
  content.provenance = { { "Version", "1 & 2" } };
  return content;
}
} // namespace

TEST(ColonReport, HoldsEveryPictureAndEscapesText)
{
  const basetest::Folder    folder;
  const shapeton::TestColon colon;
  shapeton::WriteColonReport(ContentOf(colon), folder / ".", inPlace);
  const std::set<std::string> pictures = { "inside-anterior.png",     "inside-left.png",    "wall-anterior.png",
                                           "distension.png",          "slices-axial.png",   "projection-coronal.png",
                                           "projection-sagittal.png", "slices-coronal.png", "slices-sagittal.png" };
  std::set<std::string>       expected = pictures;
  expected.insert("index.html");
  EXPECT_EQ(FilesIn(folder / "."), expected);
  const std::string html = shapeton::ReadFileBytes(folder / "index.html");
  EXPECT_EQ(CountOf(html, "data:image/png;base64,"), pictures.size());
  for (const char * text : { "For research use. This is not a diagnosis",
                             "Missing or doubtful results",
                             "no lumen over 11 mm at &lt;56 mm&gt;",
                             "Genus, raw &amp; repaired",
                             "a&lt;b&gt;.nrrd",
                             "1 &amp; 2",
                             "-800 HU" })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(html.find("<56"), std::string::npos);
}

TEST(ColonReport, TheLumenAloneIsEnough)
{
  const basetest::Folder       folder;
  const shapeton::TestColon    colon;
  shapeton::ColonReportContent content = ContentOf(colon);
  content.colon = {};
  content.colon.lumen = colon.lumen;
  content.warnings.clear();
  shapeton::WriteColonReport(content, folder / ".", inPlace);
  EXPECT_EQ(FilesIn(folder / ".").size(), 6U); // three slices, two projections, the page
  const std::string html = shapeton::ReadFileBytes(folder / "index.html");
  EXPECT_NE(html.find("the outlines are shown without a CT"), std::string::npos);
  EXPECT_NE(html.find("No warnings of this step"), std::string::npos);
}

TEST(ColonReport, EqualContentGivesEqualBytes)
{
  const basetest::Folder    folder;
  const shapeton::TestColon colon;
  std::string               pages[2];
  for (const int run : { 0, 1 })
  {
    const basetest::ThreadNumber number(run == 0 ? 1 : 3);
    shapeton::WriteColonReport(ContentOf(colon), folder / ".", inPlace);
    pages[run] = shapeton::ReadFileBytes(folder / "index.html");
  }
  EXPECT_FALSE(pages[0].empty());
  EXPECT_TRUE(pages[0] == pages[1]);
}

TEST(ColonReport, WritesWhereItIsToldTo)
{
  const basetest::Folder    folder;
  const shapeton::TestColon colon;
  std::set<std::string>     asked;
  shapeton::WriteColonReport(ContentOf(colon), folder / ".", [&](const std::string & path) {
    asked.insert(std::filesystem::path(path).filename().string());
    return path + ".part";
  });
  std::set<std::string> parts;
  for (const std::string & name : asked)
  {
    parts.insert(name + ".part");
  }
  EXPECT_EQ(FilesIn(folder / "."), parts);
}

TEST(ColonReport, NeedsALumen)
{
  const basetest::Folder folder;
  EXPECT_THROW(shapeton::WriteColonReport({}, folder / ".", inPlace), std::invalid_argument);
  EXPECT_TRUE(FilesIn(folder / ".").empty());
}
