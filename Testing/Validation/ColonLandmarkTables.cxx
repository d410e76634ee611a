#include "FoldErrors.h"
#include "LandmarkTrial.h"
#include "ValidationReport.h"

#include <cmath>
#include <numeric>

using namespace itk;

namespace
{
/** What must be reached. */
struct FoldBounds
{
  double recall;
  double precision;
  double ends; ///< mm
};

/** Patients of one preset, their models made in one way. */
struct Column
{
  std::string               title;
  std::vector<LandmarkCase> cases;
  /** Without them nothing is asked. */
  bool       hasBounds{ true };
  FoldBounds bounds{ 0.95, 0.95, 2.5 };
};

/** Errors of all exams of a column, and of each. */
struct FoldScores
{
  FoldErrors          all;
  std::vector<double> recalls;
  std::vector<double> precisions;
  std::vector<double> ends;
};

double
Mean(const std::vector<double> & values)
{
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double
Share(int part, int whole)
{
  return whole > 0 ? static_cast<double>(part) / whole : 1.0;
}

std::string
Number(double value, int digits = 3)
{
  return CsvTable::Rounded(value, digits);
}

std::string
Ratio(int part, int whole)
{
  return std::to_string(part) + " / " + std::to_string(whole) + " = " + Number(Share(part, whole), 4);
}

Column
MakeColumn(const std::string & preset, bool isFromCt, double spacing, int patients)
{
  Column column;
  column.title = "Preset " + preset + ", " + (isFromCt ? "from CT of " : "from the true lumen in voxels of ") +
                 Number(spacing) + " mm";
  column.bounds = preset == "hard" ? FoldBounds{ 0.92, 0.92, 4.0 } : FoldBounds{ 0.95, 0.95, 2.5 };
  column.hasBounds = spacing <= 0.8;
  if (isFromCt)
  {
    column.bounds.recall -= 0.03;
    column.bounds.precision -= 0.03;
    column.bounds.ends *= 1.3;
  }
  for (int patient = 0; patient < patients; ++patient)
  {
    for (const char * const position : { "supine", "prone" })
    {
      LandmarkCase one;
      one.parameters = ColonPhantomPreset(preset);
      one.parameters.seed = 100 + static_cast<unsigned int>(patient);
      one.parameters.position = position;
      one.spacing = spacing;
      one.isFromCt = isFromCt;
      column.cases.push_back(one);
    }
  }
  return column;
}

FoldErrors
TryFolds(const FlatColonGrid & grid, const LandmarkExam & exam, HaustralFoldScheme scheme)
{
  HaustralFoldOptions options;
  options.scheme = scheme;
  return MeasureFoldErrors(grid, FindHaustralFolds(grid, options), exam.anatomy->Folds());
}

void
AddExam(const FoldErrors & errors, FoldScores & scores)
{
  scores.all.Add(errors);
  scores.recalls.push_back(Share(errors.found, errors.present));
  scores.precisions.push_back(Share(errors.right, errors.labels));
  scores.ends.push_back(Mean(errors.ends));
}

/** The table of one column. */
class FoldTable
{
public:
  FoldTable(const Column & column, ValidationReport & report)
    : m_Column(column), m_Report(report), m_Table({ "what", "bound", "all exams", "mean of exams, 95 % interval", "" })
  {}

  void
  AddBounded(const FoldScores & ours)
  {
    const FoldErrors & all = ours.all;
    const FoldBounds & bounds = m_Column.bounds;
    const double       ends = Mean(all.ends);
    this->AddRow("folds >= 3.5 mm high that are found",
                 ">= " + Number(bounds.recall),
                 Ratio(all.found, all.present),
                 ours.recalls,
                 all.present > 0 && Share(all.found, all.present) >= bounds.recall);
    this->AddRow("labels that are folds",
                 ">= " + Number(bounds.precision),
                 Ratio(all.right, all.labels),
                 ours.precisions,
                 all.labels > 0 && Share(all.right, all.labels) >= bounds.precision);
    this->AddRow("end points, mean error, mm",
                 "<= " + Number(bounds.ends),
                 Number(ends),
                 ours.ends,
                 !all.ends.empty() && ends <= bounds.ends);
  }

  void
  AddReported(const FoldScores & ours, const FoldScores & published)
  {
    const FoldErrors & all = ours.all;
    this->AddFact("the same, one label may be that of several folds", Ratio(all.covered, all.present));
    this->AddFact("folds 2 to 3.5 mm high that are found", Ratio(all.lowFound, all.lowPresent));
    this->AddFact("folds hidden from the surface", std::to_string(all.hidden));
    this->AddFact("labels of several folds", std::to_string(all.merged));
    this->AddFact("length over true length, mean", Number(Mean(all.lengthRatios)));
    this->AddFact("height less true height, mm, mean", Number(Mean(all.heightErrors)));
    this->AddFact("published scheme: folds found", Ratio(published.all.found, published.all.present));
    this->AddFact("published scheme: labels that are folds", Ratio(published.all.right, published.all.labels));
    this->AddFact("published scheme: end points, mean error, mm", Number(Mean(published.all.ends)));
  }

  void
  Write()
  {
    m_Report.AddTable(m_Table);
  }

private:
  void
  AddRow(const std::string &         what,
         const std::string &         bound,
         const std::string &         all,
         const std::vector<double> & exams,
         bool                        isReached)
  {
    m_Table.AddRow({ what,
                     m_Column.hasBounds ? bound : "",
                     all,
                     exams.empty() ? "" : MeanWithInterval(exams),
                     m_Column.hasBounds ? m_Report.Check(isReached) : "" });
  }

  void
  AddFact(const std::string & what, const std::string & value)
  {
    m_Table.AddRow({ what, "", value, "", "" });
  }

  const Column &     m_Column;
  ValidationReport & m_Report;
  CsvTable           m_Table;
};

std::string
ListOf(const std::vector<std::string> & lines)
{
  std::string text;
  for (const std::string & line : lines)
  {
    text += "- " + line + '\n';
  }
  return text.empty() ? "None." : text;
}

void
TryColumn(const Column & column, ValidationReport & report)
{
  report.AddText("## " + column.title);
  FoldScores               ours;
  FoldScores               published;
  std::vector<std::string> faults;
  CsvTable                 exams({ "exam", "folds found", "labels right", "ends, mm", "published: found", "right" });
  for (const LandmarkCase & one : column.cases)
  {
    const LandmarkExam exam = MakeLandmarkExam(one);
    if (!exam.failure.empty())
    {
      exams.AddRow({ NameOfCase(one), "FAILED: " + exam.failure + ' ' + report.Check(false), "", "", "", "" });
      continue;
    }
    const FlatColonGrid grid(exam.flat);
    const FoldErrors    mine = TryFolds(grid, exam, HaustralFoldScheme::GraphCut);
    const FoldErrors    theirs = TryFolds(grid, exam, HaustralFoldScheme::Published);
    AddExam(mine, ours);
    AddExam(theirs, published);
    exams.AddRow({ NameOfCase(one),
                   Ratio(mine.found, mine.present),
                   Ratio(mine.right, mine.labels),
                   Number(Mean(mine.ends)),
                   Ratio(theirs.found, theirs.present),
                   Ratio(theirs.right, theirs.labels) });
    for (const std::string & fault : mine.faults)
    {
      faults.push_back(NameOfCase(one) + ": " + fault);
    }
  }
  FoldTable table(column, report);
  table.AddBounded(ours);
  table.AddReported(ours, published);
  table.Write();
  report.AddText("Each exam:");
  report.AddTable(exams);
  report.AddText("What was not found, or is none:");
  report.AddText(ListOf(faults));
}

void
Explain(ValidationReport & report)
{
  report.AddText(
    "Synthetic patients (`ColonPhantom`, seeds 100 and above, which nothing was tuned on), supine and prone, both "
    "presets. The colon is modelled from the true lumen or from the CT, flattened, and searched with default options. "
    "CT columns are allowed 0.03 less of shares and 1.3 times the distances; voxels of 1.4 mm are reported only.");
  report.AddText(
    "Folds: the true crest is sampled where it stands at least 1 mm above the wall; each sample goes to the nearest "
    "point of the surface, and is seen where that lies within 3 mm and is not on a bridge. A fold of which less than "
    "half is seen is hidden and counts for nothing. A fold is found when at least half of its seen samples lie within "
    "2 "
    "mm of one label that is its own: a label belongs to the one fold of 2 mm and more that it covers most samples of. "
    "A label is a fold when at least half of its pixels lie within 4 mm in space of the crest of a fold of 1.5 mm and "
    "more. End points: distance in space from the ends of the true crest, where it has come down to the wall, of folds "
    "that are found.");
}
} // namespace

void
ValidateColonLandmarks(const ValidationSettings & settings, ValidationReport & report)
{
  Explain(report);
  if (settings.quick)
  {
    // Coarse: the bounds are those of finer voxels and many patients, so only that it works is checked.
    Column column = MakeColumn("standard", false, 2.0, 1);
    column.cases.resize(1);
    const LandmarkExam exam = MakeLandmarkExam(column.cases[0]);
    report.AddText("One coarse patient is flattened: " + report.Check(exam.failure.empty()));
    if (exam.failure.empty())
    {
      const FoldErrors errors = TryFolds(FlatColonGrid(exam.flat), exam, HaustralFoldScheme::GraphCut);
      report.AddText(
        "Folds found " + Ratio(errors.found, errors.present) + ", labels that are folds " +
        Ratio(errors.right, errors.labels) + ": " +
        report.Check(Share(errors.found, errors.present) > 0.7 && Share(errors.right, errors.labels) > 0.7));
    }
    return;
  }
  for (const char * const preset : { "standard", "hard" })
  {
    TryColumn(MakeColumn(preset, false, 0.8, 10), report);
    TryColumn(MakeColumn(preset, true, 0.8, 10), report);
    TryColumn(MakeColumn(preset, true, 1.4, 10), report);
  }
}
