#ifndef LandmarkScores_h
#define LandmarkScores_h

#include "BoundTable.h"
#include "LandmarkErrors.h"
#include "LandmarkTrial.h"
#include "Reliability.h"

#include <array>
#include <optional>

/** Bounds for taeniae, flexures and segments. Fractions are from 0 to 1. */
struct LandmarkBounds
{
  double taeniaMean; ///< mm
  double taeniaWithin10;
  double markedWithin10; ///< with three markers
  double flexures;       ///< exams with all four within 30 mm
  double labeled;
  /** Expected calibration error of the confidence of flexures. */
  std::optional<double> calibration{};
};

/** Landmark errors over the exams of a column, with Shapeton's rules, the published rules, and a marker on each
 * taenia. */
class LandmarkScores
{
public:
  /** Finds the landmarks of an exam and returns a description of the missed landmarks. If landmarks cannot be computed,
   * the exam counts as entirely wrong. */
  std::vector<std::string>
  Add(const LandmarkExam & exam);

  void
  AddBounded(const LandmarkBounds & bounds, BoundTable & table) const;
  void
  AddReported(BoundTable & table) const;

  /** Lists the missed flexures, if any. */
  void
  WriteMissedFlexures(ValidationReport & report) const;

  /** Reliability of the confidence of flexures. */
  void
  WriteReliability(ValidationReport & report) const;

private:
  struct Rule
  {
    std::vector<double> taeniaMeans;
    std::vector<double> taeniaWithin10;
    std::vector<double> taeniaIdentified10;
    std::vector<double> taeniaOfTurn;
    std::vector<double> labeled;
    int                 flexuresRight{ 0 };
    int                 exams{ 0 };

    void
    Add(const LandmarkErrors & errors);
  };

  Rule m_Ours;
  Rule m_Published;
  Rule m_Marked;
  /** One value per flexure found. */
  Reliability m_FlexureReliability;
  int         m_FlexuresClose{ 0 };
  int         m_Flexures{ 0 };
  /** Number of missed flexures by type. */
  std::array<int, 4> m_FlexuresMissed{};
};

/** Bounds for the cecal end, as fractions (0 to 1) of the exams of a column. */
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
