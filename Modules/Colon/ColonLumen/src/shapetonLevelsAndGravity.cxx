#include "shapetonLevelsAndGravity.h"

#include "shapetonColonGravity.h"

#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double ClearLevels = 500.0; // mm^2
constexpr double ClearRatio = 3.0;

/** What lies flat along one direction. */
struct LevelsOfDirection
{
  itk::Vector<double, 3> gravity;
  std::vector<Level>     levels;
  double                 area{ 0.0 }; ///< mm^2
};

LevelsOfDirection
LevelsAlong(const ColonEvidence & e, const itk::Vector<double, 3> & gravity)
{
  const Fall        fall(e.grid, Eigen::Vector3d(gravity[0], gravity[1], gravity[2]));
  const auto        floors = FloorsOfGas(e.grid, e.hu, e.gas.set, e.gas.labels, e.isCandidate, fall, e.thresholds);
  LevelsOfDirection found;
  found.gravity = gravity;
  found.levels = FindLevels(e.grid, e.hu, floors, fall, e.thresholds.tissue);
  found.area = std::accumulate(
    found.levels.begin(), found.levels.end(), 0.0, [](double sum, const Level & level) { return sum + level.area; });
  return found;
}

void
WarnOfGravity(const std::string & patientPosition, const LevelsOfDirection * contradiction, ColonLumen & lumen)
{
  if (contradiction)
  {
    lumen.warnings.push_back(
      "the patient position \"" + patientPosition +
      "\" contradicts the fluid levels in the data: " + std::to_string(std::lround(contradiction->area)) +
      " mm^2 of flat levels say " + NameOfGravity(contradiction->gravity) + "; the position given was used");
  }
  if (lumen.gravitySource == ColonGravitySource::Assumed)
  {
    lumen.warnings.push_back("no patient position is given and the data show no clear fluid levels; supine is assumed");
  }
}
} // namespace

void
FindGravity(const std::string & patientPosition, ColonEvidence & evidence, ColonLumen & lumen)
{
  const auto given = GravityOfPatientPosition(patientPosition);
  const auto assumed = *GravityOfPatientPosition("supine");
  // Of the direction that is given, or else assumed, and of the one with most levels.
  LevelsOfDirection usual;
  LevelsOfDirection clearest;
  for (const char * name : { "supine", "prone", "leftDecubitus", "rightDecubitus" })
  {
    const auto        gravity = *GravityOfPatientPosition(name);
    LevelsOfDirection found = LevelsAlong(evidence, gravity);
    if (gravity == (given ? *given : assumed))
    {
      usual = found;
    }
    if (found.area > clearest.area)
    {
      clearest = std::move(found);
    }
  }
  const bool isClear = clearest.area >= ClearLevels && clearest.area > ClearRatio * (given ? usual.area : 0.0);
  lumen.gravitySource = given     ? ColonGravitySource::PatientPosition
                        : isClear ? ColonGravitySource::Levels
                                  : ColonGravitySource::Assumed;
  WarnOfGravity(patientPosition, given && isClear && !(clearest.gravity == *given) ? &clearest : nullptr, lumen);
  const LevelsOfDirection & taken = !given && isClear ? clearest : usual;
  lumen.gravity = taken.gravity;
  evidence.levels = taken.levels;
  evidence.gravity = Eigen::Vector3d(taken.gravity[0], taken.gravity[1], taken.gravity[2]);
}
} // namespace shapeton
