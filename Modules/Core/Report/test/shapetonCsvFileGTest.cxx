#include "shapetonCsvFile.h"
#include "shapetonFileBytes.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace
{
std::string
FileOf(const std::string & text)
{
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = ::testing::TempDir() + "CsvFile-" + test + ".csv"; // tests run concurrently
  shapeton::WriteFileBytes(path, text);
  return path;
}

std::string
FaultOf(const std::string & text, const std::vector<std::string> & columns)
{
  return basetest::ErrorOf([&] {
    const shapeton::CsvFile file(FileOf(text), columns);
    for (std::size_t row = 0; row < file.Rows(); ++row)
    {
      file.Number(row, columns.front());
    }
  });
}
} // namespace

TEST(CsvFile, ReadsWhatCsvTableWrites)
{
  shapeton::CsvTable table({ "a", "name", "b" });
  table.AddRow({ shapeton::CsvTable::Number(0.1), "x, \"y\"\nz", "" });
  table.AddRow({ shapeton::CsvTable::Number(-1e300), "", "2" });
  const std::string path = ::testing::TempDir() + "CsvFile.csv";
  table.Write(path);
  const shapeton::CsvFile file(path, { "name", "b", "a" });
  ASSERT_EQ(file.Rows(), 2U);
  EXPECT_EQ(file.Number(0, "a"), 0.1);
  EXPECT_EQ(file.Text(0, "name"), "x, \"y\"\nz");
  EXPECT_TRUE(std::isnan(file.NumberOrNothing(0, "b")));
  EXPECT_EQ(file.Number(1, "a"), -1e300);
  EXPECT_EQ(file.NumberOrNothing(1, "b"), 2.0);
  EXPECT_EQ(file.LineOf(0), 2);
  EXPECT_EQ(file.LineOf(1), 4); // the row above has two lines
}

TEST(CsvFile, TakesOtherLineEndsColumnsAndBlanks)
{
  const shapeton::CsvFile file(FileOf("\xEF\xBB\xBFx, more ,y\r\n\r\n 1 ,a, 2.5\r\n3,b,4"), { "y", "x" });
  ASSERT_EQ(file.Rows(), 2U);
  EXPECT_EQ(file.Number(0, "y"), 2.5);
  EXPECT_EQ(file.Number(1, "x"), 3.0);
  EXPECT_EQ(file.LineOf(0), 3);
}

TEST(CsvFile, NamesFaultsWithTheirLine)
{
  EXPECT_NE(FaultOf("x,y\n1,2\n3\n", { "x" }).find("line 3: there are 1 cells, but 2 columns"), std::string::npos);
  EXPECT_NE(FaultOf("x,y\n1,2\n\nwide,4\n", { "x" }).find("line 4: x is \"wide\""), std::string::npos);
  EXPECT_NE(FaultOf("x,y\nnan,2\n", { "x" }).find("line 2: x is \"nan\""), std::string::npos);
  EXPECT_NE(FaultOf("x,y\n,2\n", { "x" }).find("line 2: x is \"\""), std::string::npos);
  EXPECT_NE(FaultOf("x,y\n1 2,2\n", { "x" }).find("not a number"), std::string::npos);
  EXPECT_NE(FaultOf("x,y\n\"1,2\n", { "x" }).find("line 2: a quote is not closed"), std::string::npos);
  EXPECT_NE(FaultOf("x,y\n", { "x", "z" }).find("the column \"z\" is missing; the header must contain x,z"),
            std::string::npos);
  EXPECT_NE(FaultOf("x,x\n", { "x" }).find("the column \"x\" occurs more than once"), std::string::npos);
  EXPECT_NE(FaultOf("", { "x" }).find("the column \"x\" is missing"), std::string::npos);
  EXPECT_THROW(shapeton::CsvFile(::testing::TempDir() + "absent.csv", { "x" }), shapeton::InputError);
}
