#ifndef StructureScores_h
#define StructureScores_h

#include "BoundTable.h"
#include "LandmarkTrial.h"
#include "Reliability.h"

#include <optional>

/** Bounds for the cecal end, as shares (0 to 1) of the exams of a column. */
struct StructureBounds
{
  double pole{ 0.95 };  ///< exams with a line end within 15 mm of the cecal pole
  double valve{ 0.80 }; ///< exams with the ileocecal valve found within 15 mm
};

/** Errors of the cecal pole and the ileocecal valve over the exams of a column. */
class StructureScores
{
public:
  /** Adds an exam and returns a description of missed structures. Without a model, both are missed. */
  std::vector<std::string>
  Add(const LandmarkExam & exam);

  /** Without bounds, the scores are only reported. */
  void
  AddTo(BoundTable & table, const std::optional<StructureBounds> & bounds) const;

  /** Reliability of the confidence of the valves found. */
  void
  WriteReliability(ValidationReport & report) const;

private:
  std::vector<double> m_Pole;  ///< mm; infinite if missing
  std::vector<double> m_Valve; ///< mm; infinite if not found
  Reliability         m_ValveReliability;
};

#endif
