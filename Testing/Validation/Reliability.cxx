#include "Reliability.h"

#include "Tables.h"

#include <algorithm>
#include <cmath>

Reliability::Reliability(std::vector<double> borders) : m_Borders(std::move(borders)), m_Classes(m_Borders.size() - 1)
{}

void
Reliability::Add(double confidence, bool isRight)
{
  const auto upper = std::upper_bound(m_Borders.begin() + 1, m_Borders.end() - 1, confidence);
  Class &    own = m_Classes[upper - m_Borders.begin() - 1];
  own.confidences.push_back(confidence);
  own.right += isRight;
  const double away = confidence - (isRight ? 1.0 : 0.0);
  own.squares += away * away;
}

void
Reliability::Add(const Reliability & other)
{
  for (std::size_t k = 0; k < m_Classes.size(); ++k)
  {
    const Class & one = other.m_Classes[k];
    Append(one.confidences, m_Classes[k].confidences);
    m_Classes[k].right += one.right;
    m_Classes[k].squares += one.squares;
  }
}

double
Reliability::CalibrationError() const
{
  double away = 0.0;
  int    all = 0;
  for (const Class & one : m_Classes)
  {
    away += std::abs(MeanOf(one.confidences) * one.Number() - one.right);
    all += one.Number();
  }
  return all > 0 ? away / all : 0.0;
}

double
Reliability::BrierScore() const
{
  double squares = 0.0;
  int    all = 0;
  for (const Class & one : m_Classes)
  {
    squares += one.squares;
    all += one.Number();
  }
  return all > 0 ? squares / all : 0.0;
}

void
Reliability::Write(const std::string & what, ValidationReport & report) const
{
  shapeton::CsvTable table({ "confidence", what, "mean confidence", "right" });
  for (std::size_t k = 0; k < m_Classes.size(); ++k)
  {
    const Class & one = m_Classes[k];
    table.AddRow(Cells() << Rounded(m_Borders[k]) + " to " + Rounded(m_Borders[k + 1]) << one.Number()
                         << (one.Number() > 0 ? Rounded(MeanOf(one.confidences)) : "")
                         << (one.Number() > 0 ? RatioOf(one.right, one.Number()) : ""));
  }
  report.AddRows("reliability-" + what, table);
}
