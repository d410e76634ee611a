#include "StructureScores.h"

#include "shapetonIleocecalValve.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double close = 15.0; // mm

int
NumberClose(const std::vector<double> & errors)
{
  return static_cast<int>(std::count_if(errors.begin(), errors.end(), [](double error) { return error <= close; }));
}

/** Statistics of the finite values. */
std::vector<double>
Finite(std::vector<double> errors)
{
  errors.erase(std::remove_if(errors.begin(), errors.end(), [](double error) { return !std::isfinite(error); }),
               errors.end());
  return errors;
}

void
AddShare(const std::string &           what,
         const std::optional<double> & bound,
         const std::vector<double> &   errors,
         BoundTable &                  table)
{
  const int  right = NumberClose(errors);
  const auto all = static_cast<int>(errors.size());
  if (bound)
  {
    table.AddBounded(what + " within 15 mm",
                     ">= " + Rounded(*bound),
                     RatioOf(right, all),
                     {},
                     all > 0 && ShareOf(right, all) >= *bound);
  }
  else
  {
    table.AddFact(what + " within 15 mm", RatioOf(right, all));
  }
  const std::vector<double> found = Finite(errors);
  table.AddFact(what + ", mean error when found, mm", Rounded(MeanOf(found)), found);
}
} // namespace

std::vector<std::string>
StructureScores::Add(const LandmarkExam & exam)
{
  if (!exam.failure.empty())
  {
    m_Pole.push_back(infinite);
    m_Valve.push_back(infinite);
    return {};
  }
  std::vector<std::string> faults;
  const Eigen::Vector3d    end = exam.centerline.V.row(exam.centerline.V.rows() - 1);
  m_Pole.push_back((end - exam.anatomy->CecalPole()).norm());
  if (m_Pole.back() > close)
  {
    faults.push_back("the line ends " + Rounded(m_Pole.back()) + " mm from the cecal pole");
  }
  const auto valve = IleocecalValveOf(exam.centerline);
  m_Valve.push_back(valve ? (valve->position - exam.anatomy->Valve().position).norm() : infinite);
  if (valve)
  {
    m_ValveReliability.Add(valve->confidence, m_Valve.back() <= close);
  }
  if (m_Valve.back() > close)
  {
    faults.push_back(
      std::string("ileocecal valve ") +
      (valve ? Rounded(m_Valve.back()) + " mm off, confidence " + Rounded(valve->confidence) : "not found"));
  }
  return faults;
}

void
StructureScores::AddTo(BoundTable & table, const std::optional<StructureBounds> & bounds) const
{
  AddShare("cecal pole", bounds ? std::make_optional(bounds->pole) : std::nullopt, m_Pole, table);
  AddShare("ileocecal valve", bounds ? std::make_optional(bounds->valve) : std::nullopt, m_Valve, table);
  table.AddFact("valve confidence, expected calibration error", Rounded(m_ValveReliability.CalibrationError()));
}

void
StructureScores::WriteReliability(ValidationReport & report) const
{
  m_ValveReliability.Write("valves", report);
}
