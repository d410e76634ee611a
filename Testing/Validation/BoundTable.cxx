#include "BoundTable.h"

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
  m_Table.AddRow(Cells() << what << (m_HasBounds ? bound : "") << all << (exams.empty() ? "" : MeanWithInterval(exams))
                         << (m_HasBounds ? m_Report.Check(isReached) : ""));
}

void
BoundTable::AddValue(const std::string &         what,
                     Bound                       bound,
                     double                      value,
                     const std::vector<double> & exams,
                     bool                        isWhole)
{
  this->AddBounded(what, bound.Text(), Rounded(value), exams, isWhole && bound.IsReachedBy(value));
}

void
BoundTable::AddShare(const std::string &         what,
                     Bound                       bound,
                     int                         part,
                     int                         whole,
                     const std::vector<double> & exams,
                     bool                        isWhole)
{
  const bool isReached = isWhole && whole > 0 && bound.IsReachedBy(ShareOf(part, whole));
  this->AddBounded(what, bound.Text(), RatioOf(part, whole), exams, isReached);
}

void
BoundTable::AddFact(const std::string & what, const std::string & value, const std::vector<double> & exams)
{
  m_Table.AddRow({ what, "", value, exams.empty() ? "" : MeanWithInterval(exams), "" });
}

void
BoundTable::AddMean(const std::string & what, const std::vector<double> & exams)
{
  this->AddFact(what, Rounded(MeanOf(exams)), exams);
}

void
BoundTable::Write(const std::string & name)
{
  m_Report.AddSummary(name, m_Table);
}
