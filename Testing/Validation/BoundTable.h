#ifndef BoundTable_h
#define BoundTable_h

#include "Tables.h"
#include "ValidationReport.h"

/** Upper or lower bound of a value. */
struct Bound
{
  bool   isAtMost;
  double limit;

  bool
  IsReachedBy(double value) const
  {
    return isAtMost ? value <= limit : value >= limit;
  }
  /** "<= 3" */
  std::string
  Text() const
  {
    return (isAtMost ? "<= " : ">= ") + Rounded(limit);
  }
};

inline Bound
AtMost(double limit)
{
  return { true, limit };
}

inline Bound
AtLeast(double limit)
{
  return { false, limit };
}

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
  /** Adds a value; missed unless `isWhole`. */
  void
  AddValue(const std::string & what, Bound bound, double value, const std::vector<double> & exams, bool isWhole);
  /** The same for part / whole; missed if `whole` is 0. */
  void
  AddShare(const std::string &         what,
           Bound                       bound,
           int                         part,
           int                         whole,
           const std::vector<double> & exams = {},
           bool                        isWhole = true);
  void
  AddFact(const std::string & what, const std::string & value, const std::vector<double> & exams = {});
  /** Reports the mean of the values. */
  void
  AddMean(const std::string & what, const std::vector<double> & exams);
  /** Adds the table to the report as the summary `name`. */
  void
  Write(const std::string & name);

private:
  ValidationReport & m_Report;
  bool               m_HasBounds;
  shapeton::CsvTable m_Table;
};

#endif
