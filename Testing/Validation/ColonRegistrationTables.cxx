#include "BoundTable.h"
#include "RegistrationTrial.h"

#include <algorithm>
#include <limits>
#include <set>

using namespace shapeton;

namespace
{
struct RegistrationBounds
{
  double precision;
  double recall;
  double mean; ///< mm
  double shareWithin10;
  double worst; ///< over unflagged patients (mm)
  double shareFlagged;
  double onMap;      ///< width 1
  double timesFrame; ///< factor by which the map is better than the frame
};

/** Patients of one preset. */
struct Column
{
  std::string               preset;
  RegistrationBounds        bounds;
  std::vector<unsigned int> seeds;
  bool                      isFromCt{ false };
  double                    spacing{ 0.8 };
};

/** Relaxes the bounds for models from CT; the comparison of map and frame is unchanged. */
void
Ease(RegistrationBounds & bounds)
{
  bounds.precision -= lossFromCt;
  bounds.recall -= lossFromCt;
  bounds.shareWithin10 -= lossFromCt;
  bounds.shareFlagged += lossFromCt;
  bounds.mean *= growthFromCt;
  bounds.worst *= growthFromCt;
  bounds.onMap *= growthFromCt;
}

Column
MakeColumn(const std::string & preset, bool isFromCt, const std::vector<unsigned int> & seeds)
{
  Column column;
  column.preset = preset;
  column.bounds = preset == "standard" ? RegistrationBounds{ 0.90, 0.88, 5.0, 0.92, 8.0, 0.20, 0.040, 2.0 }
                                       : RegistrationBounds{ 0.85, 0.80, 7.5, 0.85, 15.0, 0.30, 0.055, 1.7 };
  column.seeds = seeds;
  column.isFromCt = isFromCt;
  if (isFromCt)
  {
    Ease(column.bounds);
  }
  return column;
}

LandmarkExam
MakeExam(const Column & column, unsigned int seed, const std::string & position)
{
  const LandmarkCase one = ValidationCase(column.preset, seed, position, column.spacing, column.isFromCt);
  ValidationReport::Progress("colon-registration: " + column.preset + ", " + NameOfCase(one));
  return MakeLandmarkExam(one);
}

/** Scores of all patients with the same landmarks. */
struct PatientScores
{
  std::vector<std::string>       names;
  std::vector<RegistrationScore> scores;

  template <typename TMeasure>
  std::vector<double>
  Of(TMeasure measure) const
  {
    std::vector<double> values;
    for (const RegistrationScore & score : scores)
    {
      if (score.failure.empty())
      {
        values.push_back(measure(score));
      }
    }
    return values;
  }
  template <typename TMeasure>
  int
  Sum(TMeasure measure) const
  {
    int sum = 0;
    for (const RegistrationScore & score : scores)
    {
      sum += measure(score);
    }
    return sum;
  }
  bool
  AreComplete() const
  {
    return !scores.empty() && Sum([](const RegistrationScore & s) { return s.failure.empty() ? 0 : 1; }) == 0;
  }
};

/** Local confidence at the points of all patients. */
Reliability
ReliabilityOf(const PatientScores & patients)
{
  Reliability reliability(LocalClasses);
  for (const RegistrationScore & score : patients.scores)
  {
    reliability.Add(score.local);
  }
  return reliability;
}

double
WorstUnflagged(const PatientScores & patients)
{
  double worst = 0.0;
  for (const RegistrationScore & score : patients.scores)
  {
    worst = score.failure.empty() && !score.isFlagged ? std::max(worst, score.errors.Mean()) : worst;
  }
  return worst;
}

void
AddMatches(const RegistrationBounds & bounds, const PatientScores & patients, bool isWhole, BoundTable & table)
{
  const int  right = patients.Sum([](const RegistrationScore & s) { return s.right; });
  const int  pairs = patients.Sum([](const RegistrationScore & s) { return s.pairs; });
  const int  common = patients.Sum([](const RegistrationScore & s) { return s.common; });
  const auto add = [&](const std::string & what, double bound, int whole, int RegistrationScore::*wholeOf) {
    const auto shares = patients.Of([=](const RegistrationScore & s) { return ShareOf(s.right, s.*wholeOf); });
    table.AddShare("fold matches, " + what, AtLeast(bound), right, whole, shares, isWhole);
  };
  add("precision", bounds.precision, pairs, &RegistrationScore::pairs);
  add("recall", bounds.recall, common, &RegistrationScore::common);
}

/** Returns the patients with a measure outside the bound of the mean. */
template <typename TMeasure>
std::string
PatientsOutside(const PatientScores & patients, const TMeasure & measure, Bound bound)
{
  std::string names;
  for (std::size_t i = 0; i < patients.scores.size(); ++i)
  {
    const RegistrationScore & score = patients.scores[i];
    const double              value = score.failure.empty() ? measure(score) : bound.limit;
    if (!bound.IsReachedBy(value))
    {
      names += (names.empty() ? "" : ", ") + patients.names[i] + " (" + Rounded(value, 2) + ')';
    }
  }
  return names;
}

/** Returns the reason for each missed bound. */
std::vector<std::string>
AddErrors(const RegistrationBounds & bounds, const PatientScores & patients, bool isWhole, BoundTable & table)
{
  const auto               mean = [](const RegistrationScore & s) { return s.errors.Mean(); };
  const auto               within = [](const RegistrationScore & s) { return s.errors.ShareWithin10(); };
  const auto               onMap = [](const RegistrationScore & s) { return s.errors.MeanOnMap(); };
  const auto               times = [](const RegistrationScore & s) { return s.frame.Mean() / s.errors.Mean(); };
  const auto               frames = patients.Of([](const RegistrationScore & s) { return s.frame.Mean(); });
  const double             meanError = MeanOf(patients.Of(mean));
  std::vector<std::string> reasons;
  const auto               add = [&](const std::string & what, Bound bound, double value, const auto & measure) {
    table.AddValue(what, bound, value, patients.Of(measure), isWhole);
    const bool        isReached = isWhole && bound.IsReachedBy(value);
    const std::string outside = isReached ? "" : PatientsOutside(patients, measure, bound);
    if (!outside.empty())
    {
      reasons.push_back("Patients outside the bound of \"" + what + "\": " + outside + '.');
    }
  };
  add("error in space, mean, mm", AtMost(bounds.mean), meanError, mean);
  add("share below 10 mm", AtLeast(bounds.shareWithin10), MeanOf(patients.Of(within)), within);
  add("error on the flat map, mean", AtMost(bounds.onMap), MeanOf(patients.Of(onMap)), onMap);
  add(
    "frame error over map error", AtLeast(bounds.timesFrame), frames.empty() ? 0.0 : MeanOf(frames) / meanError, times);
  return reasons;
}

void
AddTrust(const RegistrationBounds & bounds, const PatientScores & patients, bool isWhole, BoundTable & table)
{
  const int    flips = patients.Sum([](const RegistrationScore & s) { return s.flips; });
  const int    flagged = patients.Sum([](const RegistrationScore & s) { return s.isFlagged ? 1 : 0; });
  const auto   all = static_cast<int>(patients.scores.size());
  const double worst = WorstUnflagged(patients);
  table.AddValue("worst unflagged patient, mean error, mm", AtMost(bounds.worst), worst, {}, isWhole);
  table.AddShare("flagged patients", AtMost(bounds.shareFlagged), flagged, all, {}, isWhole);
  table.AddBounded("inverted triangles", "0", std::to_string(flips), {}, isWhole && flips == 0);
}

/** Suffix of file names of results with true landmarks. */
constexpr const char * trueLandmarks = "-true-landmarks";

/** Bounds apply to results with found landmarks; results with true landmarks are only reported. */
void
WriteSummary(const Column & column, const PatientScores & patients, bool hasBounds, ValidationReport & report)
{
  BoundTable table(report, hasBounds);
  const bool isWhole = patients.AreComplete();
  AddMatches(column.bounds, patients, isWhole, table);
  const std::vector<std::string> reasons = AddErrors(column.bounds, patients, isWhole, table);
  AddTrust(column.bounds, patients, isWhole, table);
  const auto        seconds = patients.Of([](const RegistrationScore & s) { return s.seconds; });
  const Reliability local = ReliabilityOf(patients);
  table.AddFact("local confidence, Brier score", Rounded(local.BrierScore()));
  table.AddFact("local confidence, expected calibration error", Rounded(local.CalibrationError()));
  const auto median = patients.Of([](const RegistrationScore & s) { return s.errors.Median(); });
  table.AddMean("error in space, median, mm", median);
  table.AddFact("patients without a map",
                std::to_string(patients.Sum([](const RegistrationScore & s) { return s.failure.empty() ? 0 : 1; })));
  table.AddFact("longest run, s", seconds.empty() ? "" : Rounded(*std::max_element(seconds.begin(), seconds.end())));
  table.Write(std::string("measures") + (hasBounds ? "" : trueLandmarks));
  for (const std::string & reason : hasBounds ? reasons : std::vector<std::string>())
  {
    report.AddText(reason);
  }
}

std::string
InWords(const TaeniaScore & taeniae)
{
  return !taeniae.areKnown ? "unknown" : taeniae.areRight ? "right" : "wrong";
}

void
WritePatients(const std::string & name, const PatientScores & patients, ValidationReport & report)
{
  CsvTable table(Columns("patient | mean, mm | +- | 95 % | below 10 mm | on the map | frame, mm | precision | recall | "
                         "confidence | flagged | taeniae | probability | share of taeniae"));
  for (std::size_t i = 0; i < patients.scores.size(); ++i)
  {
    const RegistrationScore & s = patients.scores[i];
    if (!s.failure.empty())
    {
      table.AddRow({ patients.names[i], "FAILED: " + s.failure, "", "", "", "", "", "", "", "", "" });
      continue;
    }
    table.AddRow(Cells() << patients.names[i] << Rounded(s.errors.Mean()) << Rounded(s.errors.HalfInterval())
                         << Rounded(s.errors.Percentile95()) << Rounded(s.errors.ShareWithin10())
                         << Rounded(s.errors.MeanOnMap()) << Rounded(s.frame.Mean())
                         << Rounded(ShareOf(s.right, s.pairs)) << Rounded(ShareOf(s.right, s.common))
                         << Rounded(s.confidence) << (s.isFlagged ? "yes" : "") << InWords(s.taeniae)
                         << Rounded(s.taeniae.probability) << Rounded(s.taeniae.share));
  }
  report.AddRows(name, table);
}

/** Table 4.1 of the dissertation, which counts unmatched points as incorrect. */
void
WritePoints(const PatientScores & patients, ValidationReport & report)
{
  CsvTable table(
    Columns("segment | published: supine | prone | correct | wrong | ours: supine | prone | correct | wrong"));
  for (int segment = 0; segment <= 6; ++segment)
  {
    FeaturePointCounts published;
    FeaturePointCounts ours;
    for (const RegistrationScore & score : patients.scores)
    {
      published.Add(score.publishedPoints[segment]);
      ours.Add(score.points[segment]);
    }
    std::vector<std::string> row{ segment == 0 ? "whole" : ColonAnatomy::SegmentName(segment) };
    for (const FeaturePointCounts & counts : { published, ours })
    {
      for (const int number : { counts.source, counts.target, counts.correct, counts.wrong })
      {
        row.push_back(std::to_string(number));
      }
    }
    table.AddRow(row);
  }
  report.AddRows("points", table);
}

void
WriteSchemes(const PatientScores & patients, ValidationReport & report)
{
  CsvTable table(Columns("scheme | mean, mm [95 % interval] | 95th percentile, mm | below 10 mm | on the map | "
                         "inverted triangles per patient | patients with inverted triangles"));
  std::set<std::string> names;
  for (const RegistrationScore & score : patients.scores)
  {
    for (const auto & [name, scheme] : score.schemes)
    {
      names.insert(name);
    }
  }
  for (const std::string & name : names)
  {
    const auto of = [&](auto measure) {
      return patients.Of([&](const RegistrationScore & s) { return measure(s.schemes.at(name).errors); });
    };
    const auto flips = patients.Of([&](const RegistrationScore & s) { return s.schemes.at(name).flips; });
    table.AddRow(
      Cells() << name.substr(2) << MeanWithInterval(of([](const RegistrationErrors & e) { return e.Mean(); }))
              << Rounded(MeanOf(of([](const RegistrationErrors & e) { return e.Percentile95(); })))
              << Rounded(MeanOf(of([](const RegistrationErrors & e) { return e.ShareWithin10(); })))
              << Rounded(MeanOf(of([](const RegistrationErrors & e) { return e.MeanOnMap(); })))
              << Rounded(MeanOf(flips)) << std::count_if(flips.begin(), flips.end(), [](double n) { return n > 0.0; }));
  }
  report.AddRows("schemes", table);
}

/** Pairs each supine position with the prone position of the next patient. */
void
TellPatientsApart(const std::vector<LandmarkExam> & supine,
                  const std::vector<LandmarkExam> & prone,
                  ValidationReport &                report)
{
  int pairs = 0;
  int apart = 0;
  for (std::size_t i = 0; i < supine.size() && supine.size() > 1; ++i)
  {
    const LandmarkExam & other = prone[(i + 1) % prone.size()];
    if (supine[i].failure.empty() && other.failure.empty())
    {
      ++pairs;
      apart += AreToldApart(supine[i], other);
    }
  }
  if (pairs > 0)
  {
    report.AddText("Flagged or rejected pairs of different patients: " + RatioOf(apart, pairs) + ' ' +
                   report.Check(apart == pairs));
  }
}

void
TryColumn(const Column & column, ValidationReport & report)
{
  report.AddText("## " + TitleOfColumn(column.preset, column.isFromCt, column.spacing));
  std::vector<LandmarkExam> supine;
  std::vector<LandmarkExam> prone;
  PatientScores             found;
  PatientScores             known;
  for (const unsigned int seed : column.seeds)
  {
    supine.push_back(MakeExam(column, seed, "supine"));
    prone.push_back(MakeExam(column, seed, "prone"));
    for (PatientScores * const scores : { &found, &known })
    {
      scores->names.push_back("seed " + std::to_string(seed));
      RegistrationScore score;
      score.failure = supine.back().failure + prone.back().failure;
      scores->scores.push_back(score.failure.empty()
                                 ? TryRegistration(supine.back(), prone.back(), scores == &known, scores == &found)
                                 : score);
    }
    const RegistrationScore & last = found.scores.back();
    ValidationReport::Progress("  " + (last.failure.empty() ? Rounded(last.errors.Mean()) + " mm" : last.failure));
  }
  WriteSummary(column, found, true, report);
  WritePatients("patients", found, report);
  ReliabilityOf(found).Write("points", report);
  WritePoints(found, report);
  WriteSchemes(found, report);
  WriteSummary(column, known, false, report);
  WritePatients(std::string("patients") + trueLandmarks, known, report);
  TellPatientsApart(supine, prone, report);
}

void
Explain(const ValidationSettings & settings, ValidationReport & report)
{
  if (settings.firstSeed > 0)
  {
    report.AddText(settings.MethodOf("colon-registration"));
    return;
  }
  report.AddText("Synthetic patients (" + settings.SeedsInWords() +
                 "), supine registered to prone; folds slide 3 mm along the wall. Both colons are modeled from the "
                 "true lumen in voxels of 0.8 mm, flattened, and searched with default options.");
  report.AddText("Errors are measured at grid points of the wall that are not constraints, outside collapsed sections: "
                 "in space, and on the flat map with a circumference of 1. Means are over patients, including flagged "
                 "ones. The frame aligns flexures and taeniae only. A detected fold corresponds to the true fold with "
                 "the crest nearest to its center, within 6 mm. A match is correct if both folds correspond to the "
                 "same true fold; recall refers to true folds found in both positions.");
  report.AddText(
    "In `patients`, +- is half the 95 % interval of the mean over 20 blocks along the colon. `points` counts ends "
    "of folds (Table 4.1 of the dissertation, which counts unmatched points as incorrect): those near the main taenia, "
    "matched as published, and all, matched by ours. `schemes` compares simpler registrations. `reliability-points` "
    "compares the local confidence with the share of points whose error is at most 10 mm. Files named `true-landmarks` "
    "contain the results with the true flexures and taeniae.");
}

void
ExplainCt(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    settings.MethodOf("colon-registration") +
    " Both colons are modeled from CT: bounds of shares are relaxed by 0.03, bounds of errors by a factor of 1.3.");
}

/** The bounds are for finer voxels and many patients, so this only checks that the code runs. */
void
TryCoarsePair(const ValidationSettings & settings, ValidationReport & report)
{
  Column column = MakeColumn("standard", false, settings.Seeds(1));
  column.spacing = 2.0;
  const LandmarkExam      supine = MakeExam(column, column.seeds.front(), "supine");
  const LandmarkExam      prone = MakeExam(column, column.seeds.front(), "prone");
  const RegistrationScore score = TryRegistration(supine, prone, true, true);
  report.AddText("One coarse pair is registered: " + report.Check(score.failure.empty()) + ' ' + score.failure);
  if (score.failure.empty())
  {
    report.AddText("Mean error " + Rounded(score.errors.Mean()) + " mm, " + Rounded(score.frame.Mean()) +
                   " mm of the frame: " + report.Check(score.errors.Mean() < score.frame.Mean()));
    report.AddText("Triangles turned over: " + std::to_string(score.flips) + ' ' + report.Check(score.flips == 0));
  }
}

void
TryPresets(const ValidationSettings & settings, bool isFromCt, ValidationReport & report)
{
  for (const std::string & preset : settings.presets)
  {
    TryColumn(MakeColumn(preset, isFromCt, settings.Seeds(20, preset)), report);
  }
}
} // namespace

void
ValidateColonRegistration(const ValidationSettings & settings, ValidationReport & report)
{
  Explain(settings, report);
  if (settings.quick)
  {
    TryCoarsePair(settings, report);
    return;
  }
  TryPresets(settings, false, report);
}

void
ValidateColonRegistrationFromCt(const ValidationSettings & settings, ValidationReport & report)
{
  ExplainCt(settings, report);
  TryPresets(settings, true, report);
}
