#include "shapetonReaderReport.h"

#include "shapetonColonTerms.h"
#include "shapetonCsvFile.h"
#include "shapetonFileBytes.h"
#include "shapetonPdfFile.h"
#include "shapetonReaderLesions.h"
#include "shapetonReaderTestExam.h"
#include "shapetonTestErrors.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace
{
using namespace shapeton;

/** The run of readertest with the files that a report needs, and its verdicts. */
class ReaderReportFiles : public testing::Test
{
protected:
  ReaderReportFiles()
  {
    readertest::WriteCandidates(m_Exam);
    std::filesystem::create_directories(m_Exam + "/segmentation");
    const Json quality{ { "lumen", { { "position", "supine" } } },
                        { "provenance", { { "input.inputVolume", "seriesInstanceUID:1.2.3" } } } };
    WriteJson(quality, m_Exam + "/segmentation/quality.json");
    std::filesystem::create_directories(m_Out);
    m_Verdicts = readertest::Verdicts(m_Exam);
  }

  std::vector<ReaderLesion>
  Lesions()
  {
    WriteJson(m_Verdicts, m_Path);
    const ColonExamination exam(m_Exam);
    return LesionsOf(ReadReaderVerdicts(m_Path, exam), exam.ReadCandidates());
  }

  /** The page of the report. */
  std::string
  Write(bool isAnonymous = false)
  {
    WriteJson(m_Verdicts, m_Path);
    const Remarks remarks =
      WriteReaderReport({ m_Exam, "", m_Path, isAnonymous }, m_Out, [](const std::string & path) { return path; });
    EXPECT_EQ(remarks.empty(), HasPdfWriter());
    return ReadFileBytes(m_Out + "/reader-report.html");
  }

  basetest::Folder  m_Folder;
  const std::string m_Exam = m_Folder / "exam";
  const std::string m_Path = m_Folder / "verdicts.json";
  const std::string m_Out = m_Folder / "out";
  Json              m_Verdicts;
};

bool
Has(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** Candidate `number`, with a size of 8 mm, matched with candidate `other` of the other position. */
PolypCandidate
MatchedCandidate(int number, int other)
{
  PolypCandidate candidate;
  candidate.number = number;
  candidate.diameter = 8.0;
  candidate.other = PolypInOtherPosition();
  candidate.other->isSeen = other > 0;
  candidate.other->candidate = other;
  return candidate;
}
} // namespace

TEST_F(ReaderReportFiles, CountsAcceptedPolypsBySize)
{
  // Candidate 1 is measured as 12 mm, but the reader entered 9 mm; the finding measures 11 mm.
  EXPECT_EQ(SizesOfAccepted(this->Lesions()), "1 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm");
  m_Verdicts["candidates"][0]["size"] = nullptr;
  EXPECT_EQ(SizesOfAccepted(this->Lesions()), "2 of 10 mm and more, 0 of 6 to 9 mm, 0 below 6 mm");
  m_Verdicts["candidates"][2]["verdict"] = "polyp";
  m_Verdicts["findings"][0]["diameter"] = nullptr;
  EXPECT_EQ(SizesOfAccepted(this->Lesions()), "1 of 10 mm and more, 0 of 6 to 9 mm, 1 below 6 mm, 1 without a size");
}

TEST_F(ReaderReportFiles, IsPreliminaryUntilAllIsReadAndCategorized)
{
  const auto why = [&] {
    const auto lesions = this->Lesions();
    return WhyPreliminary(ReadReaderVerdicts(m_Path, ColonExamination(m_Exam)).assessment, lesions);
  };
  EXPECT_EQ(why(), "1 candidate is unread");
  m_Verdicts["assessment"]["colonic"] = "";
  EXPECT_EQ(why(), "1 candidate is unread; no category of the colon was entered");
  m_Verdicts["candidates"][2]["verdict"] = "not a polyp";
  EXPECT_EQ(why(), "no category of the colon was entered");
  m_Verdicts["assessment"]["colonic"] = "C1";
  EXPECT_EQ(why(), "");
  m_Verdicts["candidates"].clear(); // candidates that the verdicts do not contain are unread
  EXPECT_EQ(why(), "3 candidates are unread");
}

TEST_F(ReaderReportFiles, EveryCategoryHasItsCode)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> categories{
    { "colonic", { "C0", "C1", "C2", "C2a", "C2b", "C3", "C4" } },
    { "extracolonic", { "E0", "E1", "E2", "E1/E2", "E3", "E4" } }
  };
  std::set<std::string> values;
  for (const auto & [member, words] : categories)
  {
    for (const std::string & word : words)
    {
      m_Verdicts["assessment"][member] = word;
      EXPECT_NO_THROW(this->Lesions()) << word; // the file is accepted
      const DicomCode & code = colonterms::CodeOfCategory(word);
      EXPECT_EQ(code.meaning.rfind(word + " - ", 0), 0u) << word;
      values.insert(code.value);
    }
  }
  EXPECT_EQ(values.size(), categories[0].second.size() + categories[1].second.size());
  EXPECT_THROW(colonterms::CodeOfCategory("C5"), std::out_of_range);
}

TEST(ReaderLesions, OfBothPositionsCountOnce)
{
  const std::vector<std::vector<PolypCandidate>> candidates{ { MatchedCandidate(1, 2), MatchedCandidate(2, 0) },
                                                             { MatchedCandidate(1, 1), MatchedCandidate(2, 0) } };
  ReaderVerdicts                                 verdicts;
  for (const char * const id : { "1", "2", "second/2" })
  {
    verdicts.candidates.push_back({ id, ReaderVerdict::Polyp, {} });
  }
  verdicts.candidates[2].statement.size = 11.0;
  std::vector<ReaderLesion> lesions = LesionsOf(verdicts, candidates);
  EXPECT_EQ(lesions[3].sameAs, "1"); // second/2, as the first position matched it
  EXPECT_EQ(lesions[0].Size(), 11.0);
  EXPECT_EQ(SizesOfAccepted(lesions), "1 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm");
  // second/1 is also matched with 1, which is already joined, so it counts as another polyp.
  verdicts.candidates.push_back({ "second/1", ReaderVerdict::Polyp, {} });
  lesions = LesionsOf(verdicts, candidates);
  EXPECT_EQ(lesions[2].sameAs, "1");
  EXPECT_EQ(lesions[3].sameAs, "");
  verdicts.candidates[0].verdict = ReaderVerdict::Unsure;
  lesions = LesionsOf(verdicts, candidates);
  EXPECT_EQ(lesions[2].sameAs, "");
}

TEST_F(ReaderReportFiles, StatesWhatTheReaderEntered)
{
  const std::string page = this->Write();
  EXPECT_TRUE(Has(page, "This is not a diagnosis"));
  EXPECT_TRUE(Has(page, "Preliminary: 1 candidate is unread."));
  EXPECT_TRUE(Has(page, "C3, as entered by the reader"));
  EXPECT_TRUE(Has(page, "no category entered")); // extracolonic
  EXPECT_TRUE(Has(page, "1 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm"));
  EXPECT_TRUE(Has(page, "3: 1 accepted, 1 unsure, 0 rejected, 1 unread; shown as second reader"));
  EXPECT_TRUE(Has(page, "on a &lt;fold&gt;"));
  EXPECT_TRUE(Has(page, "supine, series 1.2.3"));
  EXPECT_TRUE(Has(page, "Bookmark B1: behind the valve"));
  EXPECT_TRUE(Has(page, Base64(readertest::OnePixelPng())));
  EXPECT_TRUE(Has(page, "The run contains no picture of this candidate."));
  EXPECT_FALSE(Has(this->Write(true), "1.2.3"));
}

TEST_F(ReaderReportFiles, ListsExtracolonicFindingsApart)
{
  const std::string counted = "1 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm";
  Json              outside = m_Verdicts["findings"][0];
  outside["id"] = "F2";
  outside["extracolonic"] = true;
  outside["note"] = "aneurysm of the aorta";
  outside["diameter"] = 41.0;
  m_Verdicts["findings"].push_back(outside);
  const std::string page = this->Write();
  EXPECT_TRUE(Has(page, counted));
  EXPECT_TRUE(Has(page, "1 in the colon, 1 extracolonic"));
  EXPECT_TRUE(Has(page, "aneurysm of the aorta"));
  const CsvFile table(m_Out + "/reader-report.csv", { "id", "kind", "verdict", "size", "sizeBy", "note" });
  ASSERT_EQ(table.Rows(), 5u);
  EXPECT_EQ(table.Text(4, "kind"), "extracolonic finding");
  EXPECT_EQ(table.Text(4, "verdict"), "");
  EXPECT_EQ(table.Number(4, "size"), 41.0);

  const ColonExamination exam(m_Exam);
  const ReaderVerdicts   verdicts = ReadReaderVerdicts(m_Path, exam);
  EXPECT_EQ(verdicts.findings.size(), 1u);
  ASSERT_EQ(verdicts.extracolonic.size(), 1u);
  const std::string again = m_Folder / "again.json";
  WriteReaderVerdicts(verdicts, exam, again);
  EXPECT_EQ(ReadReaderVerdicts(again, exam).extracolonic.at(0).statement.note, "aneurysm of the aorta");
  EXPECT_EQ(MarkupOfVerdicts(verdicts, exam.ReadCandidates()).labels.back(), "extracolonic finding F2");
}

TEST_F(ReaderReportFiles, HasNoWarningIfComplete)
{
  m_Verdicts["candidates"][2]["verdict"] = "not a polyp";
  EXPECT_FALSE(Has(this->Write(), "Preliminary"));
  m_Verdicts["assessment"].erase("colonic");
  EXPECT_TRUE(Has(this->Write(), "Preliminary: no category of the colon was entered."));
}

TEST_F(ReaderReportFiles, HasARowForEachLesion)
{
  this->Write();
  const CsvFile table(m_Out + "/reader-report.csv",
                      { "id",
                        "kind",
                        "verdict",
                        "position",
                        "x",
                        "segment",
                        "arcLength",
                        "size",
                        "sizeBy",
                        "morphology",
                        "morphologyBy",
                        "sameAs",
                        "score",
                        "note" });
  ASSERT_EQ(table.Rows(), 4u);
  EXPECT_EQ(table.Text(0, "verdict"), "polyp");
  EXPECT_EQ(table.Number(0, "size"), 9.0);
  EXPECT_EQ(table.Text(0, "sizeBy"), "reader");
  EXPECT_EQ(table.Text(0, "morphology"), "pedunculated");
  EXPECT_EQ(table.Text(0, "morphologyBy"), "reader");
  EXPECT_EQ(table.Text(0, "note"), "on a <fold>");
  EXPECT_EQ(table.Number(1, "size"), 7.0);
  EXPECT_EQ(table.Text(1, "sizeBy"), "program");
  EXPECT_EQ(table.Text(1, "morphologyBy"), "program");
  EXPECT_EQ(table.Number(1, "arcLength"), 200.0);
  EXPECT_EQ(table.Text(2, "verdict"), "unread");
  EXPECT_EQ(table.Text(3, "id"), "F1");
  EXPECT_EQ(table.Text(3, "kind"), "finding");
  EXPECT_EQ(table.Text(3, "segment"), "cecum");
  EXPECT_EQ(table.Text(3, "score"), "");
  EXPECT_EQ(table.Number(3, "x"), 4.0);
}

TEST_F(ReaderReportFiles, ArePrinted)
{
  if (!HasPdfWriter())
  {
    GTEST_SKIP() << "WeasyPrint is not installed";
  }
  this->Write();
  const std::string pdf = ReadFileBytes(m_Out + "/reader-report.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  this->Write();
  EXPECT_TRUE(ReadFileBytes(m_Out + "/reader-report.pdf") == pdf);
}
