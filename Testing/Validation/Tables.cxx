#include "Tables.h"

#include <algorithm>
#include <numeric>

double
MeanOf(const std::vector<double> & values)
{
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double
ShareOf(int part, int whole)
{
  return whole > 0 ? static_cast<double>(part) / whole : 1.0;
}

std::string
Rounded(double value, int digits)
{
  return shapeton::CsvTable::Rounded(value, digits);
}

std::string
RatioOf(int part, int whole)
{
  return std::to_string(part) + " / " + std::to_string(whole) + " = " + Rounded(ShareOf(part, whole), 4);
}

std::string
Percent(double share)
{
  return Rounded(100.0 * share) + " %";
}

std::vector<std::string>
Columns(const std::string & headings)
{
  const std::string        separator = " | ";
  std::vector<std::string> columns;
  for (std::size_t begin = 0; begin <= headings.size();)
  {
    const std::size_t end = std::min(headings.find(separator, begin), headings.size());
    columns.push_back(headings.substr(begin, end - begin));
    begin = end + separator.size();
  }
  return columns;
}
