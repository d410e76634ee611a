// Reliability of the confidence of a registration, for pairs of positions of the same patient and of two patients.
#include "BoundTable.h"
#include "RegistrationTrial.h"
#include "Reliability.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

using namespace shapeton;

namespace
{
/** Pair of positions with its confidence from the registration. */
struct JudgedPair
{
  std::string            name;
  bool                   isOnePatient{ false };
  bool                   isRefused{ false };
  RegistrationConfidence confidence;
  /** Error (mm); 0 for two patients. */
  double error{ 0.0 };

  double
  Confidence() const
  {
    return isRefused ? 0.0 : confidence.whole;
  }
  /** Event predicted by the confidence: the same patient, and a map that is accurate enough to match most folds. */
  bool
  IsRight() const
  {
    constexpr double greatest = 10.0; // mm, less than half of the distance between folds
    return isOnePatient && !isRefused && error <= greatest;
  }
};

/** All exams of a preset. */
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

/** Pairs each patient with itself, and supine positions with prone positions of the next patients. */
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

/** Fractions of pairs that are flagged or rejected: of one patient (wrongly), and of two patients. */
void
WriteFlagged(const std::string &             preset,
             const std::vector<JudgedPair> & pairs,
             double                          calibrationError,
             ValidationReport &              report)
{
  constexpr double mostWrongly = 0.10, leastOfTwo = 0.95;
  int              ofOne = 0, ofOneFlagged = 0, ofTwo = 0, ofTwoFlagged = 0;
  for (const JudgedPair & pair : pairs)
  {
    const bool isFlagged = pair.isRefused || pair.confidence.isFlagged;
    ofOne += pair.isOnePatient;
    ofTwo += !pair.isOnePatient;
    ofOneFlagged += pair.isOnePatient && isFlagged;
    ofTwoFlagged += !pair.isOnePatient && isFlagged;
  }
  BoundTable table(report, preset == "realistic");
  table.AddShare("flagged or rejected pairs of one patient", AtMost(mostWrongly), ofOneFlagged, ofOne);
  table.AddShare("flagged or rejected pairs of two patients", AtLeast(leastOfTwo), ofTwoFlagged, ofTwo);
  table.AddFact("expected calibration error", Rounded(calibrationError));
  table.Write("measures");
}

Reliability
ReliabilityOf(const std::vector<JudgedPair> & pairs)
{
  Reliability reliability({ 0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 1.0 });
  for (const JudgedPair & pair : pairs)
  {
    reliability.Add(pair.Confidence(), pair.IsRight());
  }
  return reliability;
}

void
WritePairs(const std::vector<JudgedPair> & pairs, ValidationReport & report)
{
  CsvTable table(Columns("pair | confidence | of one patient | matched | contradicted | energy | margin of thirds | "
                         "margin of sense | mean error, mm"));
  for (const JudgedPair & pair : pairs)
  {
    const RegistrationConfidence & c = pair.confidence;
    if (pair.isRefused)
    {
      table.AddRow({ pair.name, "refused", "", "", "", "", "", "", "" });
      continue;
    }
    table.AddRow(Cells() << pair.name << Rounded(c.whole) << Rounded(c.ProbabilityOfOnePatient())
                         << Rounded(c.matchedShare) << Rounded(c.contradictedShare) << Rounded(c.energy)
                         << Rounded(c.margin) << Rounded(c.senseMargin)
                         << (pair.isOnePatient ? Rounded(pair.error) : ""));
  }
  report.AddRows("pairs", table);
}
} // namespace

void
ValidateReliabilityOfPairs(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Synthetic patients (" + settings.SeedsInWords() +
                 "), from the true lumen in voxels of 0.8 mm. The supine position of each patient is registered to the "
                 "prone positions of the same patient and of the next two. A pair is correct if both positions are of "
                 "one patient and the mean error is at most 10 mm. A rejected pair has confidence 0. The expected "
                 "calibration error is the mean difference between confidence and share of correct pairs within "
                 "classes of confidence. Only the preset realistic has bounds.");
  for (const std::string & preset : settings.presets)
  {
    report.AddText("## Preset " + preset);
    const std::vector<JudgedPair> pairs = JudgeAll(MakePatients(preset, settings.Seeds(20, preset)));
    const Reliability             reliability = ReliabilityOf(pairs);
    WriteFlagged(preset, pairs, reliability.CalibrationError(), report);
    reliability.Write("pairs", report);
    WritePairs(pairs, report);
  }
}
