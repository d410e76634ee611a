#include "ValidationReport.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numeric>
#include <stdexcept>

ValidationReport::ValidationReport(const std::string & title) : m_Page("# " + title + "\n\n") {}

void
ValidationReport::AddText(const std::string & text)
{
  m_Page += text + "\n\n";
}

void
ValidationReport::AddTable(const shapeton::CsvTable & table)
{
  const auto line = [this](const std::vector<std::string> & cells) {
    for (const auto & cell : cells)
    {
      m_Page += "| " + cell + ' ';
    }
    m_Page += "|\n";
  };
  line(table.GetColumns());
  line(std::vector<std::string>(table.GetColumns().size(), "---"));
  for (const auto & row : table.GetRows())
  {
    line(row);
  }
  m_Page += '\n';
}

std::string
ValidationReport::Check(bool passed)
{
  ++m_Checks;
  m_Failures += passed ? 0 : 1;
  return passed ? "pass" : "FAIL";
}

void
ValidationReport::Write(const std::string & path) const
{
  std::ofstream os(path);
  os << m_Page << m_Checks - m_Failures << " of " << m_Checks << " checks passed.\n";
  os.close();
  if (!os)
  {
    throw std::runtime_error("cannot write " + path);
  }
}

void
ValidationReport::Progress(const std::string & what)
{
  std::cerr << what << std::endl;
}

MeanInterval::MeanInterval(const std::vector<double> & values)
{
  const double n = static_cast<double>(values.size());
  mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  // 97.5 % quantiles of Student's t for 1 to 30 degrees of freedom.
  static const std::array<double, 30> t = { 12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                            2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                            2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042 };
  const double quantile = values.size() < 2 ? HUGE_VAL : values.size() <= t.size() + 1 ? t[values.size() - 2] : 1.96;
  const double half = values.size() < 2 ? HUGE_VAL : quantile * std::sqrt(squares / (n - 1.0) / n);
  lower = mean - half;
  upper = mean + half;
}

std::string
MeanWithInterval(const std::vector<double> & values)
{
  const MeanInterval interval(values);
  const std::string  text = shapeton::CsvTable::Rounded(interval.mean, 4);
  return values.size() < 2 ? text + " (one sample)"
                           : text + " [" + shapeton::CsvTable::Rounded(interval.lower, 4) + ", " +
                               shapeton::CsvTable::Rounded(interval.upper, 4) + "]";
}

std::vector<unsigned int>
ValidationSettings::Seeds(int asked, const std::string & preset) const
{
  const bool                isRealistic = preset == "realistic";
  std::vector<unsigned int> seeds(patients > 0 ? patients : isRealistic ? 20 : asked);
  std::iota(seeds.begin(), seeds.end(), firstSeed > 0 ? firstSeed : isRealistic ? 140 : 100);
  return seeds;
}

std::string
ValidationSettings::SeedsInWords() const
{
  return "`ColonPhantom`, seeds " +
         (firstSeed > 0 ? std::to_string(firstSeed) + " and above"
                        : std::string("100 and above, of the preset realistic 140 and above")) +
         "; parameters were fitted on seeds 1 to 99 (most on 1 to 40), and a few rules chosen with some of seeds 100 "
         "to "
         "119 in view, which the READMEs of the modules name";
}
