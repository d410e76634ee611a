#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** A row of a matrix of the case file. */
struct MatrixRow
{
  int                           line;
  std::vector<std::string_view> cells;
};

/** The columns of MATPOWER's case format, version 1 and 2. */
constexpr std::size_t BusNumber = 0;
constexpr std::size_t FromBus = 0;
constexpr std::size_t ToBus = 1;
constexpr std::size_t BranchStatus = 10;

std::string_view
WithoutComment(std::string_view line)
{
  return line.substr(0, line.find('%'));
}

/** The position after the bracket of "mpc.NAME = [" or "NAME = [", or npos. */
std::size_t
StartOfMatrix(std::string_view line, std::string_view name)
{
  const std::vector<std::string_view> words = Words(line.substr(0, line.find('[')), "=");
  const bool                          isAssignment =
    line.find('[') != std::string_view::npos && line.find('=') < line.find('[') && words.size() == 1;
  const std::string_view field = isAssignment ? words[0].substr(words[0].rfind('.') + 1) : std::string_view();
  return isAssignment && field == name ? line.find('[') + 1 : std::string_view::npos;
}

/** The rows of the matrix "mpc.NAME = [ ... ]". */
std::vector<MatrixRow>
RowsOf(const GraphText & text, std::string_view name)
{
  std::vector<MatrixRow> rows;
  LineReader             lines(text.bytes);
  int                    start = 0;
  bool                   isOpen = false;
  for (std::string_view line; lines.Next(line);)
  {
    line = WithoutComment(line);
    if (!isOpen)
    {
      const std::size_t bracket = StartOfMatrix(line, name);
      if (bracket == std::string_view::npos)
      {
        continue;
      }
      if (start != 0)
      {
        text.Refuse(lines.Number(), "a second matrix " + Quoted(name), "use one case per file");
      }
      isOpen = true;
      start = lines.Number();
      line.remove_prefix(bracket);
    }
    const std::size_t end = line.find(']');
    isOpen = end == std::string_view::npos;
    for (line = line.substr(0, end); !line.empty();)
    {
      const std::size_t row = std::min(line.find(';'), line.size());
      if (const auto cells = Words(line.substr(0, row), ","); !cells.empty())
      {
        rows.push_back({ lines.Number(), cells });
      }
      line.remove_prefix(std::min(row + 1, line.size()));
    }
  }
  if (start <= 0)
  {
    text.Refuse(0, "the matrix " + Quoted(name) + " is missing", "use a complete MATPOWER case");
  }
  if (isOpen)
  {
    text.Refuse(start, "the matrix " + Quoted(name) + " is not terminated", "use a complete copy of the file");
  }
  return rows;
}

double
CellOf(const GraphText & text, const MatrixRow & row, std::size_t column)
{
  double     value = 0.0;
  const bool isNumber = column < row.cells.size() && ParseDouble(row.cells[column], value);
  if (!isNumber)
  {
    text.Refuse(row.line, "column " + std::to_string(column + 1) + " of the matrix is missing or not a number");
  }
  return value;
}

/** Node name of a bus number: "7" also for 7.0. */
std::string
BusOf(const GraphText & text, const MatrixRow & row, std::size_t column)
{
  const double     number = CellOf(text, row, column);
  constexpr double greatest = 1e9; // fits into an int
  if (!(number >= 0.0 && number <= greatest && number == static_cast<int>(number)))
  {
    text.Refuse(row.line, Quoted(row.cells[column]) + " is not a bus number");
  }
  return std::to_string(static_cast<int>(number));
}
} // namespace

Graph
ReadMatpower(const GraphText & text, std::vector<std::string> & notes)
{
  GraphBuilder builder(text);
  for (const MatrixRow & row : RowsOf(text, "bus"))
  {
    builder.AddNode(BusOf(text, row, BusNumber), row.line);
  }
  int left = 0;
  for (const MatrixRow & row : RowsOf(text, "branch"))
  {
    const int  first = builder.DeclaredNode(BusOf(text, row, FromBus), row.line);
    const int  second = builder.DeclaredNode(BusOf(text, row, ToBus), row.line);
    const bool isInService = row.cells.size() <= BranchStatus || CellOf(text, row, BranchStatus) != 0.0;
    if (isInService)
    {
      builder.AddEdge(first, second, row.line);
    }
    left += isInService ? 0 : 1;
  }
  if (left > 0)
  {
    notes.push_back(std::to_string(left) + " branches that are out of service were skipped");
  }
  return builder.Take();
}
} // namespace shapeton
