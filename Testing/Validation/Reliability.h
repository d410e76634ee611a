#ifndef Reliability_h
#define Reliability_h

#include "ValidationReport.h"

#include <string>
#include <vector>

/** Stated probabilities beside what came true. */
class Reliability
{
public:
  /** `borders` of the classes of confidence, ascending from 0 to 1; five even ones by default. */
  explicit Reliability(std::vector<double> borders = { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 });

  void
  Add(double confidence, bool isRight);

  /** Expected calibration error: the mean, over all statements, of how far the mean confidence of their class lies from
   * the share that came true; 0 for none. */
  double
  CalibrationError() const;

  /** A row for each class: number, mean confidence, share that came true. */
  void
  Write(const std::string & what, ValidationReport & report) const;

private:
  struct Class
  {
    std::vector<double> confidences;
    int                 right{ 0 };

    int
    Number() const
    {
      return static_cast<int>(confidences.size());
    }
  };

  std::vector<double> m_Borders;
  std::vector<Class>  m_Classes;
};

#endif
