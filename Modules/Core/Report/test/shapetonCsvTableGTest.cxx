#include "shapetonCsvTable.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

namespace
{
using Cells = std::vector<std::string>;
using Rows = std::vector<Cells>;

/** Reads CSV according to the grammar of RFC 4180, section 2, with LF. */
Rows
ParseCsv(const std::string & text)
{
  Rows        rows;
  Cells       row;
  std::string cell;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] == '"')
    {
      EXPECT_TRUE(cell.empty()) << "a quote inside an unquoted cell";
      for (++i; text.at(i) != '"' || (i + 1 < text.size() && text[i + 1] == '"'); ++i)
      {
        i += text[i] == '"' ? 1 : 0;
        cell += text[i];
      }
    }
    else if (text[i] == ',' || text[i] == '\n')
    {
      row.push_back(cell);
      cell.clear();
      if (text[i] == '\n')
      {
        rows.push_back(row);
        row.clear();
      }
    }
    else
    {
      cell += text[i];
    }
  }
  EXPECT_TRUE(row.empty() && cell.empty()) << "the last line lacks its end";
  return rows;
}

std::string
Written(const shapeton::CsvTable & table)
{
  const basetest::Folder folder;
  table.Write(folder / "table.csv");
  return shapeton::ReadFileBytes(folder / "table.csv");
}

TEST(CsvTable, IsWrittenAsPlainLines)
{
  shapeton::CsvTable table({ "class", "heat" });
  table.AddRow({ "sphere", "0.75" });
  table.AddRow({ " spaced ", "" });
  EXPECT_EQ(Written(table), "class,heat\nsphere,0.75\n spaced ,\n");
  EXPECT_EQ(table.GetColumns(), Cells({ "class", "heat" }));
  EXPECT_EQ(table.GetRows(), Rows({ { "sphere", "0.75" }, { " spaced ", "" } }));
}

TEST(CsvTable, QuotesOnlyWhatNeedsIt)
{
  shapeton::CsvTable table({ "a,b", "c\"d" });
  table.AddRow({ "two\nlines", "return\r" });
  table.AddRow({ "semi;colon", "\"" });
  EXPECT_EQ(Written(table), "\"a,b\",\"c\"\"d\"\n\"two\nlines\",\"return\r\"\nsemi;colon,\"\"\"\"\n");
}

TEST(CsvTable, AnyTextComesBack)
{
  std::mt19937      random(7);
  const std::string alphabet = std::string("\",\n\r ;ab\xC3\xA4\0", 11);
  for (std::size_t columns = 1; columns < 5; ++columns)
  {
    Rows       expected;
    const auto randomCells = [&] {
      Cells cells(columns);
      for (auto & cell : cells)
      {
        for (auto length = random() % 6; length > 0; --length)
        {
          cell += alphabet[random() % alphabet.size()];
        }
      }
      return cells;
    };
    expected.push_back(randomCells());
    shapeton::CsvTable table(expected[0]);
    for (int i = 0; i < 200; ++i)
    {
      expected.push_back(randomCells());
      table.AddRow(expected.back());
    }
    EXPECT_EQ(ParseCsv(Written(table)), expected);
  }
}

TEST(CsvTable, ASingleEmptyCellIsNoEmptyLine)
{
  shapeton::CsvTable table({ "name" });
  table.AddRow({ "" });
  EXPECT_EQ(Written(table), "name\n\"\"\n");
}

TEST(CsvTable, RowsOfAnotherLengthAreRefused)
{
  shapeton::CsvTable table({ "a", "b" });
  EXPECT_THROW(table.AddRow({ "1" }), std::invalid_argument);
  EXPECT_THROW(table.AddRow({ "1", "2", "3" }), std::invalid_argument);
  EXPECT_TRUE(table.GetRows().empty());
}

TEST(CsvTable, CannotBeWrittenEverywhere)
{
  const basetest::Folder folder;
  const std::string      path = folder / "no/table.csv";
  EXPECT_EQ(basetest::MessageOf([&] { shapeton::CsvTable({ "a" }).Write(path); }),
            "OutputError: cannot write \"" + path + "\": No such file or directory; use an existing, writable folder");
  EXPECT_EQ(
    basetest::MessageOf([] { shapeton::CsvTable({ "a" }).Write("/dev/full"); }),
    "OutputError: cannot write \"/dev/full\": No space left on device; free some space or choose another folder");
}

// ---- numbers ----

std::uint64_t
BitsOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

void
ExpectShortestRoundTrip(double value)
{
  const std::string text = shapeton::CsvTable::Number(value);
  EXPECT_EQ(BitsOf(std::strtod(text.c_str(), nullptr)), BitsOf(value)) << text;
  for (int digits = 1; digits <= 17; ++digits)
  {
    char other[64];
    std::snprintf(other, sizeof(other), "%.*g", digits, value);
    if (BitsOf(std::strtod(other, nullptr)) == BitsOf(value))
    {
      EXPECT_LE(text.size(), std::strlen(other)) << text << " or " << other;
    }
  }
}

TEST(CsvNumber, OfKnownValues)
{
  EXPECT_EQ(shapeton::CsvTable::Number(0.0), "0");
  EXPECT_EQ(shapeton::CsvTable::Number(-0.0), "-0");
  EXPECT_EQ(shapeton::CsvTable::Number(0.1), "0.1");
  EXPECT_EQ(shapeton::CsvTable::Number(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(shapeton::CsvTable::Number(-1024.5), "-1024.5");
  EXPECT_EQ(shapeton::CsvTable::Number(5e-324), "5e-324");
  EXPECT_EQ(shapeton::CsvTable::Number(std::nan("")), "nan");
  EXPECT_EQ(shapeton::CsvTable::Number(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(shapeton::CsvTable::Number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(CsvNumber, ReadsBackAsTheSameDoubleAndIsShort)
{
  using Limits = std::numeric_limits<double>;
  for (const double value :
       { 0.0, -0.0, 1.0, 0.1, 1e22, 1e23, Limits::max(), Limits::min(), Limits::denorm_min(), Limits::epsilon() })
  {
    ExpectShortestRoundTrip(value);
    ExpectShortestRoundTrip(-value);
  }
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i)
  {
    const std::uint64_t bits = random();
    double              value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      ExpectShortestRoundTrip(value);
    }
    ExpectShortestRoundTrip(static_cast<double>(bits % 2000000) / 1000.0 - 1000.0);
  }
}

TEST(CsvNumber, RoundedForPeople)
{
  EXPECT_EQ(shapeton::CsvTable::Rounded(3.14159265, 3), "3.14");
  EXPECT_EQ(shapeton::CsvTable::Rounded(-0.00012345, 2), "-0.00012");
  EXPECT_EQ(shapeton::CsvTable::Rounded(1000.0, 4), "1000");
  EXPECT_EQ(shapeton::CsvTable::Rounded(99.96, 3), "100");
  EXPECT_EQ(shapeton::CsvTable::Rounded(0.0, 3), "0");
  EXPECT_EQ(shapeton::CsvTable::Rounded(std::nan(""), 3), "nan");
  EXPECT_EQ(shapeton::CsvTable::Rounded(2.5, 0), shapeton::CsvTable::Rounded(2.5, 1));
  EXPECT_EQ(shapeton::CsvTable::Rounded(0.1, 1000), "0.10000000000000001");
  EXPECT_EQ(shapeton::CsvTable::Rounded(-1.2345678901234567e-300, 17).size(), 24u);
}

TEST(CsvNumber, DoesNotDependOnTheLocale)
{
  struct Comma : std::numpunct<char>
  {
    char
    do_decimal_point() const override
    {
      return ',';
    }
  };
  const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new Comma));
  EXPECT_EQ(shapeton::CsvTable::Number(1234.5), "1234.5");
  EXPECT_EQ(shapeton::CsvTable::Rounded(1234.5, 5), "1234.5");
  shapeton::CsvTable table({ "a" });
  table.AddRow({ shapeton::CsvTable::Number(0.5) });
  EXPECT_EQ(Written(table), "a\n0.5\n");
  std::locale::global(previous);
}
} // namespace

TEST(CsvTable, LeavesOutEmptyColumns)
{
  shapeton::CsvTable table({ "a", "b", "c" });
  table.AddRow({ "1", "", "" });
  table.AddRow({ "2", "", "x" });
  const shapeton::CsvTable kept = table.WithoutEmptyColumns();
  EXPECT_EQ(kept.GetColumns(), (std::vector<std::string>{ "a", "c" }));
  EXPECT_EQ(kept.GetRows().at(0), (std::vector<std::string>{ "1", "" }));
}
