#include "shapetonFlatColonRows.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Scales at evenly spaced pixels of the row that are not bridged; with `withBridges`, at all of them. */
std::vector<double>
ScalesOf(const FlatColonGrid & grid, const FlatColonRow & row, bool withBridges)
{
  constexpr int       perDirection = 150; // pixels; chosen: 22,500 samples are enough for quantiles
  const int           shown = row.ShownColumns();
  const int           columnStep = std::max(1, shown / perDirection);
  const int           rowStep = std::max(1, grid.Rows() / perDirection);
  std::vector<double> scales;
  for (int place = 0; place < shown; place += columnStep)
  {
    const int column = row.ColumnAt(place);
    for (int line = 0; line < grid.Rows(); line += rowStep)
    {
      const FlatSample sample = grid.SampleOfPixel(column, line);
      if (sample.face >= 0 && (withBridges || !sample.isBridged))
      {
        scales.push_back(sample.scale);
      }
    }
  }
  return scales;
}

void
MeasureScale(const FlatColonGrid & grid, FlatColonRow & row)
{
  std::vector<double> scales = ScalesOf(grid, row, false);
  scales = scales.empty() ? ScalesOf(grid, row, true) : scales;
  if (scales.empty())
  {
    return;
  }
  std::sort(scales.begin(), scales.end());
  const auto quantile = [&](double share) { return scales[static_cast<std::size_t>(share * (scales.size() - 1))]; };
  constexpr double low = 0.1, high = 0.9; // quantiles; chosen: ignore single distorted pixels
  row.scale = quantile(0.5);
  row.lowScale = quantile(low);
  row.highScale = quantile(high);
}

/** Whether at least 90 % of the pixels of a column are bridged; the others may be the seam of a collapsed lumen. */
bool
IsBridgedAllAround(const FlatColonGrid & grid, int column)
{
  int bridged = 0;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    bridged += grid.IsBridged(column, row);
  }
  return 10 * bridged >= 9 * grid.Rows();
}

/** Columns in the middle of bridges longer than `longest` pixels. */
std::vector<FlatColonCut>
FindCuts(const FlatColonGrid & grid, int longest)
{
  std::vector<FlatColonCut> cuts;
  int                       begin = 0; // start of the bridge that contains the column
  for (int column = 0; longest > 0 && column <= grid.Columns(); ++column)
  {
    if (column < grid.Columns() && IsBridgedAllAround(grid, column))
    {
      continue;
    }
    const int length = column - begin;
    if (length > longest)
    {
      cuts.push_back({ begin + longest / 2, length - longest });
    }
    begin = column + 1;
  }
  return cuts;
}
} // namespace

int
FlatColonRow::ShownColumns() const
{
  int shown = columns;
  for (const FlatColonCut & cut : cuts)
  {
    shown -= cut.columns;
  }
  return shown;
}

double
FlatColonRow::PlaceOf(double column) const
{
  double place = column - firstColumn;
  for (const FlatColonCut & cut : cuts)
  {
    place -= std::clamp(column - cut.firstColumn, 0.0, static_cast<double>(cut.columns));
  }
  return place;
}

int
FlatColonRow::ColumnAt(int place) const
{
  int column = firstColumn + place;
  for (const FlatColonCut & cut : cuts)
  {
    column += column >= cut.firstColumn ? cut.columns : 0;
  }
  return column;
}

bool
FlatColonRow::Shows(double column) const
{
  bool shows = column >= firstColumn && column <= firstColumn + columns;
  for (const FlatColonCut & cut : cuts)
  {
    shows = shows && !(column > cut.firstColumn && column < cut.firstColumn + cut.columns);
  }
  return shows;
}

std::vector<FlatColonRow>
BreakIntoRows(const FlatColonGrid & grid, int greatestColumns, int longestBridge)
{
  RequireParameter(greatestColumns > 0, "a row of the flat picture needs at least one column");
  RequireParameter(longestBridge >= 0, "the longest bridge must not be negative");
  FlatColonRow whole;
  whole.columns = grid.Columns();
  whole.cuts = FindCuts(grid, longestBridge);
  const int                 shown = whole.ShownColumns();
  const int                 number = (shown + greatestColumns - 1) / greatestColumns;
  std::vector<FlatColonRow> rows(number);
  for (int i = 0; i < number; ++i)
  {
    const auto border = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(shown) * k / number); };
    rows[i].firstColumn = whole.ColumnAt(border(i));
    const int end = whole.ColumnAt(border(i + 1) - 1) + 1;
    rows[i].columns = end - rows[i].firstColumn;
    for (const FlatColonCut & cut : whole.cuts)
    {
      if (cut.firstColumn > rows[i].firstColumn && cut.firstColumn < end)
      {
        rows[i].cuts.push_back(cut);
      }
    }
    MeasureScale(grid, rows[i]);
  }
  return rows;
}

std::vector<FlatColonTick>
RulerTicks(const std::vector<double> & distanceOfColumns, double step)
{
  RequireParameter(step > 0.0, "the step of a ruler must be greater than 0");
  std::vector<FlatColonTick> ticks;
  if (distanceOfColumns.empty())
  {
    return ticks;
  }
  double next = step * std::ceil(distanceOfColumns.front() / step);
  for (std::size_t column = 0; column < distanceOfColumns.size(); ++column)
  {
    const double here = distanceOfColumns[column];
    const double before = column > 0 ? distanceOfColumns[column - 1] : here;
    for (; next <= here; next += step)
    {
      const double share = here > before ? (next - before) / (here - before) : 1.0;
      ticks.push_back({ column - 0.5 + share, next });
    }
  }
  return ticks;
}
} // namespace shapeton
