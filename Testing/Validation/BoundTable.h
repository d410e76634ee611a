#ifndef BoundTable_h
#define BoundTable_h

#include "ValidationReport.h"

/** A table of measures, some of which have a bound to reach. */
class BoundTable
{
public:
  /** Without bounds all is reported only. */
  BoundTable(ValidationReport & report, bool hasBounds);

  /** `all` is of all exams together, `exams` the measure of each; `isReached` decides. */
  void
  AddBounded(const std::string &         what,
             const std::string &         bound,
             const std::string &         all,
             const std::vector<double> & exams,
             bool                        isReached);
  void
  AddFact(const std::string & what, const std::string & value, const std::vector<double> & exams = {});
  void
  Write();

private:
  ValidationReport & m_Report;
  bool               m_HasBounds;
  shapeton::CsvTable m_Table;
};

/** 0 for none. */
double
MeanOf(const std::vector<double> & values);
/** The value that this share of them does not exceed; 0 for none. */
double
Percentile(std::vector<double> values, double share);
/** 1 where there is nothing. */
double
ShareOf(int part, int whole);
std::string
Rounded(double value, int digits = 3);
/** "part / whole = share". */
std::string
RatioOf(int part, int whole);

#endif
