#include "LandmarkScores.h"

#include "shapetonExceptions.h"
#include "shapetonIleocecalValve.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/** Also valid without any detections. */
LandmarkErrors
TryLandmarks(const LandmarkExam & exam, const ColonLandmarkSettings & options, std::string & failure)
{
  try
  {
    return MeasureLandmarks(
      FindColonLandmarks(FlatColon(exam.flat), exam.centerline, options), exam.centerline, *exam.anatomy);
  }
  catch (const Exception & error)
  {
    failure = error.what();
  }
  LandmarkErrors errors;
  errors.flexures.fill(infinite);
  errors.taeniaMean = errors.taeniaOfTurn = infinite;
  return errors;
}

constexpr const char * flexureNames[] = { "rectosigmoid", "descending-sigmoid", "splenic", "hepatic" };

std::string
InWords(const LandmarkErrors & errors)
{
  std::string text;
  for (int k = 0; k < 4; ++k)
  {
    if (!(errors.flexures[k] <= 30.0))
    {
      text += std::string(text.empty() ? "" : ", ") + flexureNames[k] + " flexure " +
              (std::isfinite(errors.flexures[k]) ? Rounded(errors.flexures[k]) + " mm off" : "not found");
    }
  }
  if (!(errors.taeniaWithin10 >= 0.95))
  {
    text += (text.empty() ? "" : ", ") + std::string("taeniae within 10 mm ") + Rounded(errors.taeniaWithin10);
  }
  return text;
}

int
ExamsWithin(const std::vector<double> & values, double least)
{
  int number = 0;
  for (const double value : values)
  {
    number += value >= least;
  }
  return number;
}
} // namespace

void
LandmarkScores::Rule::Add(const LandmarkErrors & errors)
{
  ++exams;
  taeniaMeans.push_back(errors.taeniaMean);
  taeniaWithin10.push_back(errors.taeniaWithin10);
  taeniaOfTurn.push_back(errors.taeniaOfTurn);
  taeniaIdentified10.push_back(errors.taeniaIdentified10);
  labeled.push_back(errors.labeledShare);
  flexuresRight += errors.areFlexuresWithin30;
}

std::vector<std::string>
LandmarkScores::Add(const LandmarkExam & exam)
{
  std::string           failure;
  ColonLandmarkSettings options;
  const LandmarkErrors  ours = TryLandmarks(exam, options, failure);
  m_Ours.Add(ours);
  for (std::size_t k = 0; k < ours.flexures.size(); ++k)
  {
    const bool isClose = ours.flexures[k] <= 30.0;
    ++m_Flexures;
    m_FlexuresClose += isClose;
    m_FlexuresMissed[k] += !isClose;
    if (std::isfinite(ours.flexures[k]))
    {
      m_FlexureReliability.Add(ours.flexureConfidence[k], isClose);
    }
  }
  options.markers = MarkersOfTruth(*exam.anatomy, exam.flat);
  const LandmarkErrors marked = TryLandmarks(exam, options, failure);
  m_Marked.Add(marked);
  options.markers.clear();
  options.flexureRule = FlexureRule::Published;
  options.taeniaRule = TaeniaRule::Published;
  m_Published.Add(TryLandmarks(exam, options, failure));
  std::vector<std::string> faults;
  const std::string        misled = marked.taeniaWithin10 >= std::min(0.95, ours.taeniaWithin10)
                                      ? ""
                                      : "with three markers, taeniae within 10 mm " + Rounded(marked.taeniaWithin10);
  for (const std::string & fault : { failure, InWords(ours), misled })
  {
    if (!fault.empty())
    {
      faults.push_back(fault);
    }
  }
  return faults;
}

void
LandmarkScores::AddBounded(const LandmarkBounds & bounds, BoundTable & table) const
{
  const bool   hasExams = m_Ours.exams > 0;
  const double mean = MeanOf(m_Ours.taeniaMeans);
  const double within = MeanOf(m_Ours.taeniaWithin10);
  const double marked = MeanOf(m_Marked.taeniaWithin10);
  const double labeled = MeanOf(m_Ours.labeled);
  table.AddValue("taeniae, mean error, mm", AtMost(bounds.taeniaMean), mean, m_Ours.taeniaMeans, hasExams);
  table.AddValue(
    "taeniae, share within 10 mm", AtLeast(bounds.taeniaWithin10), within, m_Ours.taeniaWithin10, hasExams);
  table.AddBounded("taeniae with three markers, share within 10 mm",
                   AtLeast(bounds.markedWithin10).Text(),
                   Rounded(marked, 4),
                   m_Marked.taeniaWithin10,
                   hasExams && marked >= bounds.markedWithin10);
  table.AddShare(
    "exams with all four flexures within 30 mm", AtLeast(bounds.flexures), m_Ours.flexuresRight, m_Ours.exams);
  if (bounds.calibration)
  {
    const double error = m_FlexureReliability.CalibrationError();
    table.AddValue("flexure confidence, expected calibration error", AtMost(*bounds.calibration), error, {}, hasExams);
  }
  table.AddValue("area with the correct segment", AtLeast(bounds.labeled), labeled, m_Ours.labeled, hasExams);
}

void
LandmarkScores::AddReported(BoundTable & table) const
{
  table.AddFact("exams with 95 % of the taeniae within 10 mm",
                RatioOf(ExamsWithin(m_Ours.taeniaWithin10, 0.95), m_Ours.exams));
  table.AddFact("flexures within 30 mm", RatioOf(m_FlexuresClose, m_Flexures));
  table.AddMean("taeniae, share within 10 mm, one assignment for the whole colon", m_Ours.taeniaIdentified10);
  table.AddMean("taeniae, root mean square error, share of the circumference", m_Ours.taeniaOfTurn);
  table.AddFact("published rule: taeniae, mean error, mm", Rounded(MeanOf(m_Published.taeniaMeans)));
  table.AddMean("published rule: taeniae, share within 10 mm", m_Published.taeniaWithin10);
  table.AddFact("published rule: exams with all four flexures within 30 mm",
                RatioOf(m_Published.flexuresRight, m_Published.exams));
  table.AddMean("published rule: area with the correct segment", m_Published.labeled);
}

void
LandmarkScores::WriteMissedFlexures(ValidationReport & report) const
{
  std::string missed;
  for (std::size_t k = 0; k < m_FlexuresMissed.size(); ++k)
  {
    if (m_FlexuresMissed[k] > 0)
    {
      missed += std::string(missed.empty() ? "" : ", ") + flexureNames[k] + ' ' + std::to_string(m_FlexuresMissed[k]);
    }
  }
  if (!missed.empty())
  {
    report.AddText("Flexures not within 30 mm: " + missed + '.');
  }
}

void
LandmarkScores::WriteReliability(ValidationReport & report) const
{
  m_FlexureReliability.Write("flexures", report);
}

namespace
{
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
    table.AddShare(what + " within 15 mm", AtLeast(*bound), right, all);
  }
  else
  {
    table.AddFact(what + " within 15 mm", RatioOf(right, all));
  }
  const std::vector<double> found = Finite(errors);
  table.AddMean(what + ", mean error when found, mm", found);
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
