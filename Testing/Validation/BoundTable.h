#ifndef BoundTable_h
#define BoundTable_h

#include "Tables.h"
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
  /** A value that must be at most, or at least, the bound; missed unless `isWhole`. */
  void
  AddAtMost(const std::string & what, double bound, double value, const std::vector<double> & exams, bool isWhole);
  void
  AddAtLeast(const std::string & what, double bound, double value, const std::vector<double> & exams, bool isWhole);
  /** The same for part / whole; missed if `whole` is 0. */
  void
  AddShareAtMost(const std::string & what, double bound, int part, int whole, bool isWhole = true);
  void
  AddShareAtLeast(const std::string &         what,
                  double                      bound,
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
