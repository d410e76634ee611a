#include "shapetonReaderVerdicts.h"

#include "shapetonReaderTestExam.h"
#include "shapetonTestErrors.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace shapeton;
using basetest::Folder;
using readertest::Verdicts;

/** A run whose verdicts a test may change before they are read. */
class ReaderVerdictsFile : public testing::Test
{
protected:
  ReaderVerdictsFile()
  {
    readertest::WriteCandidates(m_Exam);
    m_Verdicts = Verdicts(m_Exam);
  }

  ReaderVerdicts
  Read()
  {
    WriteJson(m_Verdicts, m_Path);
    return ReadReaderVerdicts(m_Path, ColonExamination(m_Exam));
  }

  /** Whether the verdicts are rejected with this message if `value` is at `pointer`. */
  testing::AssertionResult
  Refuses(const char * pointer, const Json & value, const std::string & message)
  {
    m_Verdicts = Verdicts(m_Exam);
    m_Verdicts[Json::json_pointer(pointer)] = value;
    return basetest::Refuses([&] { this->Read(); }, message);
  }

  Folder            m_Folder;
  const std::string m_Exam = m_Folder / "exam";
  const std::string m_Path = m_Folder / "verdicts.json";
  Json              m_Verdicts;
};
} // namespace

TEST_F(ReaderVerdictsFile, IsReadCompletely)
{
  const ReaderVerdicts verdicts = this->Read();
  EXPECT_EQ(verdicts.isSecondReader, true);
  EXPECT_EQ(verdicts.assessment.colonic, "C3");
  EXPECT_EQ(verdicts.assessment.extracolonic, "");
  ASSERT_EQ(verdicts.candidates.size(), 3u);
  EXPECT_EQ(verdicts.candidates[0].verdict, ReaderVerdict::Polyp);
  EXPECT_EQ(verdicts.candidates[0].statement.size, 9.0);
  EXPECT_EQ(verdicts.candidates[0].statement.morphology, PolypMorphology::Pedunculated);
  EXPECT_EQ(verdicts.candidates[0].statement.note, "on a <fold>");
  EXPECT_EQ(verdicts.candidates[1].verdict, ReaderVerdict::Unsure);
  EXPECT_TRUE(std::isnan(verdicts.candidates[1].statement.size));
  EXPECT_EQ(verdicts.candidates[2].verdict, ReaderVerdict::Unread);
  ASSERT_EQ(verdicts.findings.size(), 1u);
  EXPECT_EQ(verdicts.findings[0].statement.size, 11.0);
  EXPECT_EQ(verdicts.findings[0].segment, 6);
  EXPECT_EQ(verdicts.findings[0].arcLength, 1400.5);
  EXPECT_EQ(verdicts.findings[0].place, Eigen::Vector3d(4.0, 5.0, 6.0));
  ASSERT_EQ(verdicts.bookmarks.size(), 1u);
  EXPECT_EQ(verdicts.bookmarks[0].png, readertest::OnePixelPng());
}

TEST_F(ReaderVerdictsFile, OfVersion1HasNoAssessment)
{
  m_Verdicts["version"] = 1;
  for (const char * const key : { "secondReader", "assessment", "bookmarks" })
  {
    m_Verdicts.erase(key);
  }
  for (const char * const key : { "segment", "arcLength", "morphology", "position" })
  {
    m_Verdicts["findings"][0].erase(key);
  }
  const ReaderVerdicts verdicts = this->Read();
  EXPECT_FALSE(verdicts.isSecondReader);
  EXPECT_EQ(verdicts.assessment.colonic, "");
  EXPECT_EQ(verdicts.findings[0].position, 0u);
  EXPECT_EQ(verdicts.findings[0].segment, 0);
  EXPECT_EQ(verdicts.findings[0].statement.morphology, PolypMorphology::Unknown);
  EXPECT_TRUE(std::isnan(verdicts.findings[0].arcLength));
  EXPECT_TRUE(verdicts.bookmarks.empty());
}

TEST_F(ReaderVerdictsFile, BecomesMarkups)
{
  const Markup markup = MarkupOfVerdicts(this->Read(), ColonExamination(m_Exam).ReadCandidates());
  EXPECT_EQ(
    markup.labels,
    (std::vector<std::string>{ "candidate 1: polyp", "candidate 2: unsure", "candidate 3: unread", "finding F1" }));
  EXPECT_EQ(markup.points[1], Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(markup.descriptions[0], "on a <fold>");
}

TEST_F(ReaderVerdictsFile, OfAnotherExaminationOrVersionIsRefused)
{
  EXPECT_TRUE(this->Refuses("/exam/sha256", std::string(64, '0'), "belong to another examination"));
  EXPECT_TRUE(this->Refuses("/exam", 3, "the examination is not an object"));
  EXPECT_TRUE(this->Refuses("/version", 3, "unsupported version"));
  EXPECT_TRUE(this->Refuses("/version", "2", "unsupported version"));
  EXPECT_TRUE(this->Refuses("/candidates", nullptr, "the file has no list of candidates"));
  m_Verdicts = Json::array();
  EXPECT_TRUE(basetest::Refuses([&] { this->Read(); }, "the file is not an object"));
}

TEST_F(ReaderVerdictsFile, WithUnknownWordsIsRefused)
{
  EXPECT_TRUE(
    this->Refuses("/candidates/0/verdict", "cancer", "the candidate \"1\" has an unknown verdict \"cancer\""));
  EXPECT_TRUE(this->Refuses("/candidates/0/verdict", nullptr, "unknown verdict \"\""));
  EXPECT_TRUE(this->Refuses("/candidates/0/morphology", "round", "unknown morphology \"round\""));
  EXPECT_TRUE(this->Refuses("/findings/0/segment", "colon", "the finding \"F1\" has an unknown segment \"colon\""));
  EXPECT_TRUE(this->Refuses("/assessment/colonic", "C5", "the assessment has an unknown colonic \"C5\""));
  EXPECT_TRUE(this->Refuses("/assessment/extracolonic", "C1", "unknown extracolonic \"C1\""));
}

TEST_F(ReaderVerdictsFile, WithImpossibleSizesIsRefused)
{
  for (const double size : { 0.0, -3.0, 200.5 })
  {
    EXPECT_TRUE(this->Refuses("/candidates/0/size", size, "the candidate \"1\" has the size")) << size;
    EXPECT_TRUE(this->Refuses("/findings/0/diameter", size, "the finding \"F1\" has the diameter")) << size;
  }
  EXPECT_FALSE(this->Refuses("/candidates/0/size", 200.0, ""));
  EXPECT_TRUE(this->Refuses("/candidates/0/size", "9", "a size that is not a number"));
}

TEST_F(ReaderVerdictsFile, WithWrongTypesIsRefused)
{
  EXPECT_TRUE(this->Refuses("/candidates/0", 7, "an entry of the candidates is not an object"));
  EXPECT_TRUE(this->Refuses("/candidates/0/note", 7, "a note that is not a text"));
  EXPECT_TRUE(this->Refuses("/secondReader", "yes", "neither true nor false"));
  EXPECT_TRUE(this->Refuses("/findings/0/lps", Json::array({ 1, 2 }), "needs 3 numbers as lps"));
  EXPECT_TRUE(this->Refuses("/findings/0/lps", nullptr, "needs 3 numbers as lps"));
  EXPECT_TRUE(this->Refuses("/findings/0/uv", Json::array({ 1, "2" }), "needs 2 numbers as uv"));
  EXPECT_TRUE(this->Refuses("/findings/0/position", 1, "a position that the examination does not have"));
  EXPECT_TRUE(this->Refuses("/findings/0/position", -1, "a position that the examination does not have"));
}

TEST_F(ReaderVerdictsFile, WithRepeatedOrUnknownIdsIsRefused)
{
  EXPECT_TRUE(this->Refuses("/candidates/1/id", "1", "the candidate \"1\" is repeated"));
  EXPECT_TRUE(this->Refuses("/candidates/1/id", "4", "the candidate \"4\" is not a candidate of the examination"));
  EXPECT_TRUE(this->Refuses("/candidates/1/id", "second/1", "is not a candidate of the examination"));
  EXPECT_TRUE(this->Refuses("/candidates/1/id", "", "has no id"));
}

TEST_F(ReaderVerdictsFile, WithPicturesThatAreNotPngIsRefused)
{
  const std::string png = readertest::OnePixelPng();
  for (const std::string & picture : { "data:image/jpeg;base64," + Base64(png),
                                       "data:image/png;base64," + Base64("GIF89a" + png),
                                       "data:image/png;base64," + Base64(png.substr(0, png.size() - 1)),
                                       "data:image/png;base64,?" + Base64(png),
                                       std::string("javascript:alert(1)") })
  {
    EXPECT_TRUE(this->Refuses("/bookmarks/0/picture", picture, "the bookmark \"B1\" has a picture that is not a PNG"))
      << picture;
  }
  EXPECT_TRUE(this->Refuses("/bookmarks/0/picture", nullptr, "the bookmark \"B1\" has no picture"));
}

TEST_F(ReaderVerdictsFile, ComesBackAsItWasWritten)
{
  const ReaderVerdicts   verdicts = this->Read();
  const ColonExamination exam(m_Exam);
  const std::string      copy = m_Folder / "copy.json";
  WriteReaderVerdicts(verdicts, exam, copy);
  const ReaderVerdicts again = ReadReaderVerdicts(copy, exam);
  WriteReaderVerdicts(again, exam, m_Path);
  EXPECT_EQ(ReadJson(copy), ReadJson(m_Path));
  EXPECT_EQ(again.candidates[0].statement.size, 9.0);
  EXPECT_EQ(again.bookmarks[0].png, verdicts.bookmarks[0].png);
}
