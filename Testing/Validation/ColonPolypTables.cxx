#include "BoundTable.h"
#include "PolypPair.h"
#include "PolypTrial.h"

#include <algorithm>
#include <cmath>

using namespace shapeton;

namespace
{
/** Bounds to be reached. */
struct PolypBounds
{
  double large{ 0.95 };
  double largeLower{ 0.90 };
  double medium{ 0.90 };
  double falses{ 4.0 };
  double size{ 1.0 };
};

struct Column
{
  std::string               title;
  std::vector<LandmarkCase> cases;
  PolypBounds               bounds;
};

constexpr double defaultScore = 1.0 - defaultPolypSensitivity;

/** Relaxes the bounds for models from CT instead of the true lumen. */
void
Ease(PolypBounds & bounds)
{
  bounds.large -= lossFromCt;
  bounds.largeLower = std::max(0.0, bounds.largeLower - lossFromCt);
  bounds.medium -= lossFromCt;
  bounds.size *= growthFromCt;
}

Column
MakeColumn(const std::string & preset, bool isFromCt, double spacing, const std::vector<unsigned int> & seeds)
{
  Column column;
  column.title = TitleOfColumn(preset, isFromCt, spacing);
  if (preset != "standard")
  {
    column.bounds = { 0.90, 0.0, 0.85, 6.0, 1.5 };
  }
  if (isFromCt)
  {
    Ease(column.bounds);
  }
  column.cases = BothPositions(preset, seeds, spacing, isFromCt);
  return column;
}

constexpr PolypGroup large{ false, 10.0, 1000.0 };
constexpr PolypGroup medium{ false, 6.0, 10.0 };
constexpr PolypGroup small{ false, 0.0, 6.0 };
constexpr PolypGroup flatLarge{ true, 10.0, 1000.0 };
constexpr PolypGroup flatMedium{ true, 6.0, 10.0 };

/** Combines both positions of each patient. */
std::vector<double>
FalsePerPatient(const std::vector<PolypExam> & exams, double score, bool withValve = true)
{
  std::vector<double> patients;
  for (std::size_t i = 0; i + 1 < exams.size(); i += 2)
  {
    double number = 0.0;
    for (const std::size_t exam : { i, i + 1 })
    {
      number += CountFrom(exams[exam].falseScores, score);
      number -= withValve ? 0 : CountFrom(exams[exam].valveScores, score);
    }
    patients.push_back(number);
  }
  return patients;
}

/** |measured - true| of the polyps found (mm). */
std::vector<double>
SizeErrors(const std::vector<PolypExam> & exams, const std::vector<PolypGroup> & groups, double score)
{
  std::vector<double> errors;
  for (const PolypExam & exam : exams)
  {
    for (const PolypTruth & truth : exam.truths)
    {
      const bool isIn =
        std::any_of(groups.begin(), groups.end(), [&](const PolypGroup & group) { return group.Holds(truth.polyp); });
      if (isIn && truth.score >= score)
      {
        errors.push_back(std::abs(truth.diameter - truth.polyp.diameter));
      }
    }
  }
  return errors;
}

void
AddBounded(const PolypBounds & bounds, const std::vector<PolypExam> & exams, BoundTable & table)
{
  const PolypCount big = CountFound(exams, large, defaultScore);
  const double     bigLower = big.LowerBound();
  table.AddBounded("sessile or pedunculated polyps >= 10 mm found",
                   ">= " + Rounded(bounds.large) +
                     (bounds.largeLower > 0.0 ? ", lower bound >= " + Rounded(bounds.largeLower) : ""),
                   ShareWithBound(big),
                   {},
                   big.present > 0 && ShareOf(big.found, big.present) >= bounds.large && bigLower >= bounds.largeLower);
  const PolypCount middle = CountFound(exams, medium, defaultScore);
  table.AddBounded("sessile or pedunculated polyps of 6 to 9 mm found",
                   ">= " + Rounded(bounds.medium),
                   ShareWithBound(middle),
                   {},
                   middle.present > 0 && ShareOf(middle.found, middle.present) >= bounds.medium);
  const std::vector<double> falses = FalsePerPatient(exams, defaultScore);
  table.AddValue("false candidates per patient, both positions", AtMost(bounds.falses), MeanOf(falses), falses, true);
  const std::vector<double> errors = SizeErrors(exams, { large, medium }, defaultScore);
  table.AddValue(
    "largest diameter of these polyps, mean error, mm", AtMost(bounds.size), MeanOf(errors), errors, !errors.empty());
}

/** Explains a missed lower bound by the number of large polyps. */
void
WriteLargeNeeded(double lowerBound, const PolypCount & big, ValidationReport & report)
{
  if (big.LowerBound() >= lowerBound)
  {
    return;
  }
  int needed = big.found;
  while (needed <= big.present && WilsonLowerBound(needed, big.present) < lowerBound)
  {
    ++needed;
  }
  const std::string need = "A lower bound of " + Rounded(lowerBound) + " requires ";
  report.AddText(needed <= big.present
                   ? need + std::to_string(needed) + " of " + std::to_string(big.present) + " polyps >= 10 mm."
                   : need + "more than " + std::to_string(big.present) + " polyps >= 10 mm.");
}

void
AddReported(const std::vector<PolypExam> & exams, BoundTable & table)
{
  table.AddFact("flat polyps >= 10 mm found (goal 0.70)", ShareWithBound(CountFound(exams, flatLarge, defaultScore)));
  table.AddFact("flat polyps of 6 to 9 mm found", ShareWithBound(CountFound(exams, flatMedium, defaultScore)));
  table.AddFact("sessile polyps below 6 mm found", ShareWithBound(CountFound(exams, small, defaultScore)));
  const std::vector<double> withoutValve = FalsePerPatient(exams, defaultScore, false);
  table.AddMean("false candidates per patient, without the ileocecal valve", withoutValve);
  const std::vector<double> flat = SizeErrors(exams, { flatLarge, flatMedium }, defaultScore);
  table.AddMean("largest diameter of flat polyps, mean error, mm", flat);
}

void
AddCurve(const std::vector<PolypExam> & exams, ValidationReport & report)
{
  CsvTable table({ "sensitivity", ">= 10 mm", "6-9 mm", "below 6 mm", "flat >= 10 mm", "false per patient" });
  for (const double sensitivity : { 0.01, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998 })
  {
    const double             score = 1.0 - sensitivity;
    std::vector<std::string> cells{ Rounded(sensitivity) };
    for (const PolypGroup & group : { large, medium, small, flatLarge })
    {
      const PolypCount count = CountFound(exams, group, score);
      cells.push_back(Rounded(ShareOf(count.found, count.present)));
    }
    cells.push_back(MeanWithInterval(FalsePerPatient(exams, score)));
    table.AddRow(std::move(cells));
  }
  report.AddRows("curve", table);
}

CsvTable
TableOfMissed(const std::vector<PolypExam> & exams)
{
  CsvTable table({ "exam", "kind", "diameter, mm", "height, mm", "on a fold", "score" });
  for (const PolypExam & exam : exams)
  {
    for (const PolypTruth & truth : exam.truths)
    {
      if (truth.polyp.diameter >= 6.0 && truth.score < defaultScore)
      {
        table.AddRow(Cells() << exam.name << truth.polyp.kind << Rounded(truth.polyp.diameter)
                             << Rounded(truth.polyp.height) << (truth.polyp.onFold ? "yes" : "")
                             << (truth.score > 0.0 ? Rounded(truth.score) : ""));
      }
    }
  }
  return table;
}

/** Results of the exams of a column. */
struct Results
{
  /** Candidates as in a run of both positions with default options. */
  std::vector<PolypExam> delivered;
  /** Candidates of each single position, at any sensitivity. */
  std::vector<PolypExam> alone;
  int                    pairs{ 0 };
};

/** Both positions of a patient. */
void
TryPatient(const LandmarkCase * cases, const std::string & title, ValidationReport & report, Results & results)
{
  ColonExam                   exams[2];
  std::vector<PolypCandidate> candidates[2];
  for (int i = 0; i < 2; ++i)
  {
    ValidationReport::Progress(title + ": " + NameOfCase(cases[i]));
    exams[i] = MakeColonExam(cases[i]);
    if (!exams[i].failure.empty())
    {
      report.AddText(NameOfCase(cases[i]) + " FAILED: " + exams[i].failure + ' ' + report.Check(false));
      results.alone.push_back(ComparePolyps(cases[i], *exams[i].anatomy, {})); // all polyps are missed
      continue;
    }
    candidates[i] = FindJudgedCandidates(exams[i], defaultPolypSensitivity);
    results.alone.push_back(ComparePolyps(cases[i], *exams[i].anatomy, FindJudgedCandidates(exams[i], 0.999)));
  }
  const bool areThere = exams[0].failure.empty() && exams[1].failure.empty();
  results.pairs += areThere && WeighPair(exams[0], exams[1], candidates[0], candidates[1]);
  for (int i = 0; i < 2; ++i)
  {
    results.delivered.push_back(ComparePolyps(cases[i], *exams[i].anatomy, candidates[i]));
  }
}

/** Returns the sessile and pedunculated polyps of 10 mm and more. */
PolypCount
TryColumn(const Column & column, ValidationReport & report)
{
  report.AddText("## " + column.title);
  Results results;
  for (std::size_t i = 0; i + 1 < column.cases.size(); i += 2)
  {
    TryPatient(&column.cases[i], column.title, report, results);
  }
  BoundTable table(report, true);
  AddBounded(column.bounds, results.delivered, table);
  AddReported(results.delivered, table);
  const std::vector<double> alone = FalsePerPatient(results.alone, defaultScore);
  table.AddFact("patients with candidates compared between positions",
                RatioOf(results.pairs, static_cast<int>(alone.size())));
  table.AddMean("single positions: false candidates per patient", alone);
  for (const auto & [name, group] : { std::pair<const char *, PolypGroup>{ "polyps >= 10 mm", large },
                                      { "polyps of 6 to 9 mm", medium },
                                      { "flat polyps >= 10 mm", flatLarge } })
  {
    table.AddFact(std::string("single positions: ") + name,
                  ShareWithBound(CountFound(results.alone, group, defaultScore)));
  }
  table.Write("measures");
  WriteLargeNeeded(column.bounds.largeLower, CountFound(results.delivered, large, defaultScore), report);
  AddCurve(results.alone, report);
  report.AddRows("missed", TableOfMissed(results.delivered));
  return CountFound(results.delivered, large, defaultScore);
}

void
TryPresets(const ValidationSettings & settings, bool isFromCt, ValidationReport & report)
{
  PolypCount all;
  for (const std::string & preset : settings.presets)
  {
    const PolypCount count = TryColumn(MakeColumn(preset, isFromCt, 0.8, settings.Seeds(20, preset)), report);
    all.found += count.found;
    all.present += count.present;
  }
  report.AddText("## All presets");
  report.AddText("Sessile or pedunculated polyps >= 10 mm: " + ShareWithBound(all) +
                 "; at least 100 are required: " + report.Check(all.present >= 100));
}

void
Explain(const ValidationSettings & settings, ValidationReport & report)
{
  if (settings.firstSeed > 0)
  {
    report.AddText(settings.MethodOf("colon-polyps"));
    return;
  }
  report.AddText("Synthetic patients (" + settings.SeedsInWords() +
                 "), supine and prone. The wall is computed from the true lumen in voxels of 0.8 mm and searched with "
                 "default options. True polyps in collapsed sections are excluded.");
  report.AddText("A polyp is found if a candidate is within its radius plus 3 mm of the center of its head or base. "
                 "Other candidates are false, including candidates at the ileocecal valve; false candidates of both "
                 "positions of a patient are added. Scores are final: they account for content, valve, catheter and, "
                 "where both positions can be registered, the other position. Shares have Wilson's two-sided 95 % "
                 "bound, assuming independent polyps. Other intervals are over patients or polyps.");
  report.AddText(
    "`curve` is the free-response ROC curve of single positions. `missed` lists the missed polyps >= 6 mm.");
}

void
ExplainCt(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    settings.MethodOf("colon-polyps") +
    " The wall is computed from CT: bounds of shares are 0.03 lower, the bound of sizes is 1.3 times larger.");
}

/** Coarse voxels of one patient; only checks that the code runs. */
void
TryCoarsePatient(const ValidationSettings & settings, ValidationReport & report)
{
  const Column    column = MakeColumn("standard", false, 1.4, settings.Seeds(1));
  const ColonExam exam = MakeColonExam(column.cases[0]);
  report.AddText("One coarse patient is modeled: " + report.Check(exam.failure.empty()));
  if (exam.failure.empty())
  {
    const std::vector<PolypExam> exams{ ComparePolyps(
      column.cases[0], *exam.anatomy, FindJudgedCandidates(exam, defaultPolypSensitivity)) };
    const PolypCount             big = CountFound(exams, large, defaultScore);
    const int                    falses = CountFrom(exams[0].falseScores, defaultScore);
    report.AddText("Polyps >= 10 mm found " + RatioOf(big.found, big.present) + ", false candidates " +
                   std::to_string(falses) + ": " +
                   report.Check(ShareOf(big.found, big.present) >= 0.7 && falses <= 15));
  }
}
} // namespace

void
ValidateColonPolyps(const ValidationSettings & settings, ValidationReport & report)
{
  Explain(settings, report);
  if (settings.quick)
  {
    TryCoarsePatient(settings, report);
    return;
  }
  TryPresets(settings, false, report);
}

void
ValidateColonPolypsFromCt(const ValidationSettings & settings, ValidationReport & report)
{
  ExplainCt(settings, report);
  TryPresets(settings, true, report);
}
