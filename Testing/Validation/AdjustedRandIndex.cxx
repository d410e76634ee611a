#include "AdjustedRandIndex.h"

namespace
{
double
Pairs(double members)
{
  return 0.5 * members * (members - 1.0);
}
} // namespace

double
AdjustedRandIndex(const std::map<int, std::map<int, double>> & members)
{
  std::map<int, double> columns;
  double                together = 0.0, inRows = 0.0, inColumns = 0.0, all = 0.0;
  for (const auto & [row, counts] : members)
  {
    double inRow = 0.0;
    for (const auto & [column, count] : counts)
    {
      together += Pairs(count);
      inRow += count;
      columns[column] += count;
    }
    inRows += Pairs(inRow);
    all += inRow;
  }
  for (const auto & [column, count] : columns)
  {
    inColumns += Pairs(count);
  }
  const double byChance = inRows * inColumns / Pairs(all);
  const double most = 0.5 * (inRows + inColumns);
  return most > byChance ? (together - byChance) / (most - byChance) : 0.0;
}
