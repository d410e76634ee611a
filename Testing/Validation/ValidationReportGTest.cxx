#include "ValidationReport.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{
const std::string firstLine = "<!-- part colon-polyps -->\n";
const std::string lastLine = "<!-- end colon-polyps -->\n";
const std::string handWritten = "# Polyps\n\nText with  two spaces \n\n";
const std::string notes = "\n## Notes\n<!-- part of a sentence -->\nno new line at the end";

std::string
Replace(const std::string & page)
{
  return ReplaceSection(page, "colon-polyps", "new\n");
}

std::string
ReadText(const std::string & path)
{
  std::ifstream      is(path, std::ios::binary);
  std::ostringstream text;
  text << is.rdbuf();
  return text.str();
}

/** An empty folder for each test. */
class ValidationReportFiles : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder = std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/ValidationReport" + test;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder + "/rows");
    section.page = folder + "/page.md";
    section.pageTitle = "Page";
    section.name = "part";
    section.rowsFolder = folder + "/rows";
    section.rowsPrefix = "part";
    section.pictureFolder = folder;
  }

  std::string       folder;
  ValidationSection section;
};

shapeton::CsvTable
TableOfBounds()
{
  shapeton::CsvTable table({ "what", "bound", "value", "" });
  table.AddRow({ "with bound", "<= 2", "1", "pass" });
  table.AddRow({ "without bound", "", "7", "" });
  table.AddRow({ "failed without bound", "", "9", "FAIL" });
  return table;
}
} // namespace

TEST(ReplaceSection, ReplacesOnlyTheLinesBetweenTheMarkers)
{
  const std::string other = "<!-- part colon-polyps-ct -->\nold\n<!-- end colon-polyps-ct -->\n";
  EXPECT_EQ(Replace(handWritten + other + firstLine + "old\n\nold\n" + lastLine + notes),
            handWritten + other + firstLine + "new\n" + lastLine + notes);
  EXPECT_EQ(Replace(firstLine + lastLine), firstLine + "new\n" + lastLine);
}

TEST(ReplaceSection, IsRepeatable)
{
  const std::string once = Replace(handWritten);
  EXPECT_EQ(Replace(once), once);
}

TEST(ReplaceSection, AppendsAMissingSection)
{
  EXPECT_EQ(Replace(handWritten), handWritten + "\n" + firstLine + "new\n" + lastLine);
  EXPECT_EQ(Replace(notes), notes + "\n\n" + firstLine + "new\n" + lastLine);
  EXPECT_EQ(Replace(""), firstLine + "new\n" + lastLine);
}

TEST(ReplaceSection, DistinguishesFirstSeeds)
{
  const std::string page = Replace("");
  EXPECT_EQ(ReplaceSection(page, "colon-polyps --firstSeed 200", "other\n"),
            page + "\n<!-- part colon-polyps --firstSeed 200 -->\nother\n<!-- end colon-polyps --firstSeed 200 -->\n");
}

TEST(ReplaceSection, RejectsIncompleteMarkers)
{
  EXPECT_THROW(Replace(firstLine), std::runtime_error);
  EXPECT_THROW(Replace(lastLine), std::runtime_error);
  EXPECT_THROW(Replace(lastLine + firstLine), std::runtime_error);
  EXPECT_THROW(Replace(firstLine + lastLine + firstLine + lastLine), std::runtime_error);
}

TEST_F(ValidationReportFiles, LowersHeadingsAndKeepsHandWrittenText)
{
  ValidationReport first("First title");
  first.AddText("## Heading\n\ntext # not a heading");
  first.AddText("```\n# code\n```");
  first.Check(true);
  first.Write(section);
  const std::string begin = "# Page\n\n<!-- part part -->\n## First title\n\n";
  EXPECT_EQ(
    ReadText(section.page),
    begin + "### Heading\n\ntext # not a heading\n\n```\n# code\n```\n\n1 of 1 checks passed.\n\n<!-- end part -->\n");

  std::ofstream(section.page, std::ios::binary | std::ios::app) << notes;
  ValidationReport second("Second title");
  second.Check(false);
  second.Write(section);
  EXPECT_EQ(ReadText(section.page),
            "# Page\n\n<!-- part part -->\n## Second title\n\n0 of 1 checks passed.\n\n<!-- end part -->\n" + notes);
  EXPECT_FALSE(std::filesystem::exists(section.page + ".tmp"));
}

TEST_F(ValidationReportFiles, LeavesAPageWithIncompleteMarkersUnchanged)
{
  std::ofstream(section.page) << "<!-- part part -->\n";
  EXPECT_THROW(ValidationReport("Title").Write(section), std::runtime_error);
  EXPECT_EQ(ReadText(section.page), "<!-- part part -->\n");
}

TEST_F(ValidationReportFiles, SummaryShowsRowsWithABoundAndFailures)
{
  ValidationReport report("Title");
  report.AddText("## Heading");
  report.AddSummary("values", TableOfBounds());
  report.Write(section);
  const std::string page = ReadText(section.page);
  EXPECT_NE(page.find("3 rows, 1 failed: [values](rows/part-values.csv).\n\n"
                      "| what | bound | value |  |\n"
                      "| --- | --- | --- | --- |\n"
                      "| with bound | <= 2 | 1 | pass |\n"
                      "| failed without bound |  | 9 | FAIL |\n\n"),
            std::string::npos)
    << page;
  EXPECT_EQ(ReadText(folder + "/rows/part-values.csv"),
            "section,what,bound,value,\n"
            "Heading,with bound,<= 2,1,pass\n"
            "Heading,without bound,,7,\n"
            "Heading,failed without bound,,9,FAIL\n");
}

TEST_F(ValidationReportFiles, SummaryWithoutBoundsShowsOnlyTheLink)
{
  shapeton::CsvTable table({ "what", "bound" });
  table.AddRow({ "value", "" });
  ValidationReport report("Title");
  report.AddSummary("values", table);
  report.Write(section);
  const std::string page = ReadText(section.page);
  EXPECT_NE(page.find("1 row: [values](rows/part-values.csv).\n\n0 of 0 checks passed."), std::string::npos) << page;
}

TEST_F(ValidationReportFiles, WritesTablesToFilesByTheirColumns)
{
  shapeton::CsvTable walks({ "walk", "share" });
  walks.AddRow({ "published", "0.5" });
  shapeton::CsvTable times({ "walk", "time, s" });
  times.AddRow({ "published", "3" });
  ValidationReport report("Title");
  report.AddTable(walks);
  report.AddTable(times);
  report.AddText("## Others");
  report.AddTable(walks);
  report.Write(section);
  EXPECT_EQ(ReadText(folder + "/rows/part-summary.csv"), "section,walk,share\n,published,0.5\nOthers,published,0.5\n");
  EXPECT_EQ(ReadText(folder + "/rows/part-summary-2.csv"), "section,walk,\"time, s\"\n,published,3\n");
  const std::string page = ReadText(section.page);
  EXPECT_NE(page.find("| walk | share |\n| --- | --- |\n| published | 0.5 |\n"), std::string::npos) << page;
}

TEST_F(ValidationReportFiles, RefersToPicturesInTheirFolder)
{
  section.pictureFolder = folder + "/pictures";
  ValidationReport report("Title");
  report.AddText("![A chart](chart.svg)");
  report.Write(section);
  const std::string page = ReadText(section.page);
  EXPECT_NE(page.find("![A chart](pictures/chart.svg)"), std::string::npos) << page;
}

TEST(ValidationReport, SummaryRequiresAColumnOfBounds)
{
  ValidationReport report("Title");
  EXPECT_THROW(report.AddSummary("values", shapeton::CsvTable({ "what" })), std::logic_error);
}
