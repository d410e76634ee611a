#ifndef Reliability_h
#define Reliability_h

#include "ValidationReport.h"

#include <string>
#include <vector>

/** Comparison of stated probabilities with outcomes. */
class Reliability
{
public:
  /** `borders` are the ascending limits of the confidence classes, from 0 to 1. */
  explicit Reliability(std::vector<double> borders = { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 });

  void
  Add(double confidence, bool isRight);

  /** Expected calibration error: the difference between the mean confidence of a class and its fraction of correct
   * statements, averaged over all statements; 0 without statements. */
  double
  CalibrationError() const;

  /** Mean squared difference between confidence and outcome, 1 or 0 (Brier 1950); 0 without statements. */
  double
  BrierScore() const;

  /** Adds the statements of another instance with the same classes. */
  void
  Add(const Reliability & other);

  /** Writes one row per class: number, mean confidence, fraction of correct statements. */
  void
  Write(const std::string & what, ValidationReport & report) const;

private:
  struct Class
  {
    std::vector<double> confidences;
    int                 right{ 0 };
    double              squares{ 0.0 }; ///< of confidence minus outcome

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
