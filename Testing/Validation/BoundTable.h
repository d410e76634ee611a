#ifndef BoundTable_h
#define BoundTable_h

#include "ValidationReport.h"

/** Table of measurements, some of which have a bound. */
class BoundTable
{
public:
  /** Without bounds, measurements are only reported. */
  BoundTable(ValidationReport & report, bool hasBounds);

  /** Adds a measurement with a bound: `all` for all exams together, `exams` for each exam; `isReached`: whether
   * the bound holds. */
  void
  AddBounded(const std::string &         what,
             const std::string &         bound,
             const std::string &         all,
             const std::vector<double> & exams,
             bool                        isReached);
  void
  AddFact(const std::string & what, const std::string & value, const std::vector<double> & exams = {});
  /** Adds the table to the report as the summary `name`. */
  void
  Write(const std::string & name);

private:
  ValidationReport & m_Report;
  bool               m_HasBounds;
  shapeton::CsvTable m_Table;
};

/** Mean; 0 without values. */
double
MeanOf(const std::vector<double> & values);
/** Quantile of the values for this share; 0 without values. */
double
Percentile(std::vector<double> values, double share);
/** Returns part / whole; 1 if `whole` is 0. */
double
ShareOf(int part, int whole);
std::string
Rounded(double value, int digits = 3);
/** Formats "part / whole = share". */
std::string
RatioOf(int part, int whole);

#endif
