#include "itkFlatColonRows.h"

#include "itkToolError.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Scales of pixels, evenly spaced over the row: of all that have a face, or of those that are no bridge. */
std::vector<double>
ScalesOf(const FlatColonGrid & grid, const FlatColonRow & row, bool withBridges)
{
  constexpr int       perDirection = 150;
  const int           columnStep = std::max(1, row.columns / perDirection);
  const int           rowStep = std::max(1, grid.Rows() / perDirection);
  std::vector<double> scales;
  for (int column = row.firstColumn; column < row.firstColumn + row.columns; column += columnStep)
  {
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
  row.scale = quantile(0.5);
  row.lowScale = quantile(0.1);
  row.highScale = quantile(0.9);
}
} // namespace

std::vector<FlatColonRow>
BreakIntoRows(const FlatColonGrid & grid, int greatestColumns)
{
  RequireUsage(greatestColumns > 0, "a row of the flat picture needs a column at least");
  const int                 number = (grid.Columns() + greatestColumns - 1) / greatestColumns;
  std::vector<FlatColonRow> rows(number);
  for (int i = 0; i < number; ++i)
  {
    const auto border = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(grid.Columns()) * k / number); };
    rows[i].firstColumn = border(i);
    rows[i].columns = border(i + 1) - border(i);
    MeasureScale(grid, rows[i]);
  }
  return rows;
}

std::vector<FlatColonTick>
RulerTicks(const std::vector<double> & distanceOfColumns, double step)
{
  RequireUsage(step > 0.0, "the step of a ruler must be greater than 0");
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
} // namespace itk
