#include "shapetonCsvTable.h"
#include "shapetonFileBytes.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace shapeton
{
namespace
{
std::string
Quoted(const std::string & cell)
{
  if (cell.find_first_of(",\"\r\n") == std::string::npos)
  {
    return cell;
  }
  std::string quoted = "\"";
  for (const char c : cell)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::string
LineOf(const std::vector<std::string> & cells)
{
  if (cells.size() == 1 && cells[0].empty())
  {
    return "\"\"\n"; // readers skip empty lines
  }
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    line += (i ? "," : "") + Quoted(cells[i]);
  }
  return line + '\n';
}
} // namespace

CsvTable::CsvTable(std::vector<std::string> columns) : m_Columns(std::move(columns)) {}

CsvTable::~CsvTable() = default;

void
CsvTable::AddRow(std::vector<std::string> cells)
{
  if (cells.size() != m_Columns.size())
  {
    throw std::invalid_argument("a row of " + std::to_string(cells.size()) + " cells in a table of " +
                                std::to_string(m_Columns.size()) + " columns");
  }
  m_Rows.push_back(std::move(cells));
}

CsvTable
CsvTable::WithoutEmptyColumns() const
{
  std::vector<std::size_t> kept;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < m_Columns.size(); ++column)
  {
    if (std::any_of(m_Rows.begin(), m_Rows.end(), [=](const auto & row) { return !row[column].empty(); }))
    {
      kept.push_back(column);
      names.push_back(m_Columns[column]);
    }
  }
  CsvTable table(names);
  for (const auto & row : m_Rows)
  {
    std::vector<std::string> cells;
    for (const std::size_t column : kept)
    {
      cells.push_back(row[column]);
    }
    table.AddRow(std::move(cells));
  }
  return table;
}

void
CsvTable::Write(const std::string & path) const
{
  std::string text = LineOf(m_Columns);
  for (const auto & row : m_Rows)
  {
    text += LineOf(row);
  }
  WriteFileBytes(path, text);
}

std::string
CsvTable::Number(double value)
{
  char       text[32];
  const auto result = std::to_chars(text, text + sizeof(text), value);
  return std::string(text, result.ptr);
}

std::string
CsvTable::Rounded(double value, int digits)
{
  char       text[32];
  const int  kept = std::clamp(digits, 1, 17); // precision of a double
  const auto result = std::to_chars(text, text + sizeof(text), value, std::chars_format::general, kept);
  return std::string(text, result.ptr);
}
} // namespace shapeton
