#include "BoundTable.h"

#include <algorithm>
#include <numeric>

BoundTable::BoundTable(ValidationReport & report, bool hasBounds)
  : m_Report(report), m_HasBounds(hasBounds), m_Table({ "measure", "bound", "value", "mean [95 % interval]", "result" })
{}

void
BoundTable::AddBounded(const std::string &         what,
                       const std::string &         bound,
                       const std::string &         all,
                       const std::vector<double> & exams,
                       bool                        isReached)
{
  m_Table.AddRow({ what,
                   m_HasBounds ? bound : "",
                   all,
                   exams.empty() ? "" : MeanWithInterval(exams),
                   m_HasBounds ? m_Report.Check(isReached) : "" });
}

void
BoundTable::AddFact(const std::string & what, const std::string & value, const std::vector<double> & exams)
{
  m_Table.AddRow({ what, "", value, exams.empty() ? "" : MeanWithInterval(exams), "" });
}

void
BoundTable::Write(const std::string & name)
{
  m_Report.AddSummary(name, m_Table);
}

double
MeanOf(const std::vector<double> & values)
{
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double
Percentile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
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
