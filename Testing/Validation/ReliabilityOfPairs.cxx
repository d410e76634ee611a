// Confidence of pairs of positions, of one patient and of two, against what is true of them.
#include "BoundTable.h"
#include "RegistrationTrial.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

using namespace shapeton;

namespace
{
/** A pair of positions as the registration judges it. */
struct JudgedPair
{
  std::string            name;
  bool                   isOnePatient{ false };
  bool                   isRefused{ false };
  RegistrationConfidence confidence;
  /** mm; 0 for two patients. */
  double error{ 0.0 };

  double
  Confidence() const
  {
    return isRefused ? 0.0 : confidence.whole;
  }
  /** What the confidence is the probability of: one patient, and a map that most folds can be found by. */
  bool
  IsRight() const
  {
    constexpr double greatest = 10.0; // mm, less than half of the distance of folds
    return isOnePatient && !isRefused && error <= greatest;
  }
};

/** All positions of a preset. */
struct Patients
{
  std::string                preset;
  std::vector<unsigned int>  seeds;
  std::vector<LandmarkExam>  supineExams, proneExams;
  std::vector<ColonPosition> supine, prone;
};

Patients
MakePatients(const std::string & preset, const std::vector<unsigned int> & seeds)
{
  Patients patients;
  patients.preset = preset;
  const auto make = [&](unsigned int seed, const std::string & position) {
    const LandmarkCase one = ValidationCase(preset, seed, position, 0.8, false);
    ValidationReport::Progress("colon-pairs: " + preset + ", " + NameOfCase(one));
    return MakeLandmarkExam(one);
  };
  for (const unsigned int seed : seeds)
  {
    LandmarkExam supine = make(seed, "supine");
    LandmarkExam prone = make(seed, "prone");
    if (supine.failure.empty() && prone.failure.empty())
    {
      patients.seeds.push_back(seed);
      patients.supine.push_back(MakeColonPosition(supine, "supine", false));
      patients.prone.push_back(MakeColonPosition(prone, "prone", false));
      patients.supineExams.push_back(std::move(supine));
      patients.proneExams.push_back(std::move(prone));
    }
  }
  return patients;
}

JudgedPair
Judge(const Patients & patients, std::size_t i, std::size_t j)
{
  JudgedPair pair;
  pair.name = patients.preset + ", " + std::to_string(patients.seeds[i]) + " to " + std::to_string(patients.seeds[j]);
  pair.isOnePatient = i == j;
  try
  {
    const SupineProneRegistration registration = RegisterColonPositions(patients.supine[i], patients.prone[j]);
    pair.confidence = registration.confidence;
    if (pair.isOnePatient)
    {
      const auto truth = TruePairs(*patients.supineExams[i].anatomy, *patients.proneExams[i].anatomy);
      pair.error = MeasureRegistrationErrors(registration, truth).Mean();
    }
  }
  catch (const Exception &)
  {
    pair.isRefused = true;
  }
  return pair;
}

/** Each patient with itself, and supine with the prone positions of the next ones. */
std::vector<JudgedPair>
JudgeAll(const Patients & patients)
{
  constexpr std::size_t   others = 2;
  const std::size_t       number = patients.seeds.size();
  std::vector<JudgedPair> pairs;
  for (std::size_t i = 0; i < number; ++i)
  {
    for (std::size_t next = 0; next < std::min(number, others + 1); ++next)
    {
      pairs.push_back(Judge(patients, i, (i + next) % number));
      ValidationReport::Progress("  " + pairs.back().name + ": " + Rounded(pairs.back().Confidence()));
    }
  }
  return pairs;
}

/** Expected calibration error: the mean over all pairs of how far the mean confidence of a class lies from the share
 * that is right. */
double
WriteReliability(const std::vector<JudgedPair> & pairs, ValidationReport & report)
{
  const std::vector<double> borders{ 0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 1.0 };
  CsvTable                  table({ "confidence", "pairs", "of one patient", "mean confidence", "right" });
  double                    away = 0.0;
  for (std::size_t k = 0; k + 1 < borders.size(); ++k)
  {
    std::vector<double> confidences;
    int                 ofOne = 0;
    int                 right = 0;
    for (const JudgedPair & pair : pairs)
    {
      const double confidence = pair.Confidence();
      if (confidence >= borders[k] && (confidence < borders[k + 1] || k + 2 == borders.size()))
      {
        confidences.push_back(confidence);
        ofOne += pair.isOnePatient;
        right += pair.IsRight();
      }
    }
    const auto number = static_cast<int>(confidences.size());
    table.AddRow({ Rounded(borders[k]) + " to " + Rounded(borders[k + 1]),
                   std::to_string(number),
                   std::to_string(ofOne),
                   number > 0 ? Rounded(MeanOf(confidences)) : "",
                   number > 0 ? RatioOf(right, number) : "" });
    away += number > 0 ? std::abs(MeanOf(confidences) * number - right) : 0.0;
  }
  report.AddTable(table);
  return pairs.empty() ? 0.0 : away / static_cast<double>(pairs.size());
}

void
WritePairs(const std::vector<JudgedPair> & pairs, ValidationReport & report)
{
  CsvTable table({ "pair",
                   "confidence",
                   "of one patient",
                   "matched",
                   "contradicted",
                   "energy",
                   "margin of thirds",
                   "margin of sense",
                   "mean error, mm" });
  for (const JudgedPair & pair : pairs)
  {
    const RegistrationConfidence & c = pair.confidence;
    if (pair.isRefused)
    {
      table.AddRow({ pair.name, "refused", "", "", "", "", "", "", "" });
      continue;
    }
    table.AddRow({ pair.name,
                   Rounded(c.whole),
                   Rounded(c.ProbabilityOfOnePatient()),
                   Rounded(c.matchedShare),
                   Rounded(c.contradictedShare),
                   Rounded(c.energy),
                   Rounded(c.margin),
                   Rounded(c.senseMargin),
                   pair.isOnePatient ? Rounded(pair.error) : "" });
  }
  report.AddTable(table);
}
} // namespace

void
ValidateReliabilityOfPairs(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    "Synthetic patients (" + settings.SeedsInWords() +
    "), from the true lumen in voxels of 0.8 mm: supine with prone of the same patient, and of the next two. "
    "A pair is right that is of one patient with a mean error of at most 10 mm; a refused one has the "
    "confidence 0. The expected calibration error is the mean distance of confidence and share of right pairs "
    "within the classes.");
  std::vector<JudgedPair> pairs;
  for (const std::string & preset : settings.presets)
  {
    const std::vector<JudgedPair> more = JudgeAll(MakePatients(preset, settings.Seeds(20)));
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  const double error = WriteReliability(pairs, report);
  report.AddText("Expected calibration error: " + Rounded(error));
  WritePairs(pairs, report);
}
