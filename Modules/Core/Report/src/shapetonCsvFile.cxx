#include "shapetonCsvFile.h"

#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Parses text row by row. */
class Scanner
{
public:
  explicit Scanner(const std::string & text) : m_Text(text)
  {
    const std::string mark = "\xEF\xBB\xBF";
    m_At = text.compare(0, mark.size(), mark) == 0 ? mark.size() : 0;
  }

  bool
  IsAtEnd() const
  {
    return m_At >= m_Text.size();
  }

  int
  Line() const
  {
    return m_Line;
  }

  /** False if a quote is not closed. */
  bool
  ReadRow(std::vector<std::string> & cells)
  {
    cells.assign(1, "");
    bool isQuoted = false;
    for (; !this->IsAtEnd(); ++m_At)
    {
      const char c = m_Text[m_At];
      m_Line += c == '\n';
      if (c == '"' && isQuoted && m_At + 1 < m_Text.size() && m_Text[m_At + 1] == '"')
      {
        cells.back() += c;
        ++m_At;
      }
      else if (c == '"')
      {
        isQuoted = !isQuoted;
      }
      else if (c == ',' && !isQuoted)
      {
        cells.emplace_back();
      }
      else if (c == '\n' && !isQuoted)
      {
        ++m_At;
        break;
      }
      else if (c != '\r' || isQuoted)
      {
        cells.back() += c;
      }
    }
    return !isQuoted;
  }

private:
  const std::string & m_Text;
  std::size_t         m_At{ 0 };
  int                 m_Line{ 1 };
};

std::string
Trimmed(const std::string & text)
{
  const auto begin = text.find_first_not_of(" \t");
  const auto end = text.find_last_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}
} // namespace

CsvFile::CsvFile(const std::string & path, const std::vector<std::string> & columns) : m_Path(path)
{
  this->Parse(ReadFileBytes(path));
  this->RequireColumns(columns);
}

void
CsvFile::Parse(const std::string & text)
{
  Scanner                  scanner(text);
  std::vector<std::string> cells;
  while (!scanner.IsAtEnd())
  {
    const int line = scanner.Line();
    if (!scanner.ReadRow(cells))
    {
      this->Refuse(line, "a quote is not closed");
    }
    std::transform(cells.begin(), cells.end(), cells.begin(), Trimmed);
    if (cells.size() == 1 && cells.front().empty())
    {
      continue;
    }
    if (m_Columns.empty())
    {
      m_Columns = cells;
      continue;
    }
    if (cells.size() != m_Columns.size())
    {
      this->Refuse(line,
                   "there are " + std::to_string(cells.size()) + " cells, but " + std::to_string(m_Columns.size()) +
                     " columns");
    }
    m_Rows.push_back({ line, cells });
  }
}

void
CsvFile::RequireColumns(const std::vector<std::string> & columns) const
{
  constexpr std::size_t most = 12; // named columns; more hide the message
  std::string           header;
  for (std::size_t i = 0; i < std::min(most, columns.size()); ++i)
  {
    header += (header.empty() ? "" : ",") + columns[i];
  }
  header += columns.size() > most ? ",... (" + std::to_string(columns.size()) + " columns)" : "";
  for (const std::string & column : columns)
  {
    const auto number = std::count(m_Columns.begin(), m_Columns.end(), column);
    if (number != 1)
    {
      this->Refuse(1,
                   "the column \"" + column + (number == 0 ? "\" is missing" : "\" occurs more than once") +
                     "; the header must contain " + header);
    }
  }
}

std::size_t
CsvFile::ColumnOf(const std::string & name) const
{
  return static_cast<std::size_t>(std::find(m_Columns.begin(), m_Columns.end(), name) - m_Columns.begin());
}

const std::string &
CsvFile::Text(std::size_t row, const std::string & column) const
{
  return m_Rows.at(row).cells.at(this->ColumnOf(column));
}

double
CsvFile::Number(std::size_t row, const std::string & column) const
{
  const std::string & text = this->Text(row, column);
  double              value = 0.0;
  const auto          result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value))
  {
    this->Refuse(m_Rows[row].line, column + " is \"" + text + "\", which is not a number");
  }
  return value;
}

double
CsvFile::NumberOrNothing(std::size_t row, const std::string & column) const
{
  return this->Text(row, column).empty() ? std::numeric_limits<double>::quiet_NaN() : this->Number(row, column);
}

void
CsvFile::Refuse(int line, const std::string & fault) const
{
  throw InputError('"' + m_Path + "\", line " + std::to_string(line) + ": " + fault);
}
} // namespace shapeton
