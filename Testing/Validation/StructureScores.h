#ifndef StructureScores_h
#define StructureScores_h

#include "BoundTable.h"
#include "LandmarkTrial.h"
#include "Reliability.h"

#include <optional>

/** What the caecal end of a column of exams must reach: shares of 0 to 1. */
struct StructureBounds
{
  double pole{ 0.95 };  ///< exams whose line ends within 15 mm of the caecal pole
  double valve{ 0.80 }; ///< exams whose ileocaecal valve is found within 15 mm
};

/** The caecal pole and the ileocaecal valve over the exams of a column. */
class StructureScores
{
public:
  /** Of an exam without a model both are missed. Returns what was missed in words. */
  std::vector<std::string>
  Add(const LandmarkExam & exam);

  /** Without bounds they are reported only. */
  void
  AddTo(BoundTable & table, const std::optional<StructureBounds> & bounds) const;

  /** Of the confidence of valves that were found. */
  void
  WriteReliability(ValidationReport & report) const;

private:
  std::vector<double> m_Pole;  ///< mm; infinite where there is none
  std::vector<double> m_Valve; ///< mm; infinite where none is found
  Reliability         m_ValveReliability;
};

#endif
