#include "FoldErrors.h"
#include "LandmarkScores.h"

#include <algorithm>
#include <optional>

using namespace shapeton;

namespace
{
constexpr int patientsAsked = 10;

/** Bounds to be reached. */
struct FoldBounds
{
  double recall;
  double precision;
  double ends; ///< mm
};

/** Patients of one preset with equally computed models. */
struct Column
{
  std::string               title;
  std::vector<LandmarkCase> cases;
  /** If false, results are only reported. */
  bool           hasBounds{ true };
  FoldBounds     folds{ 0.95, 0.95, 2.5 };
  LandmarkBounds landmarks{ 3.5, 0.95, 1.0, 0.8, 0.95 };
  /** Set only for the `realistic` preset. */
  std::optional<StructureBounds> structures;
};

/** Errors of all exams of a column, together and per exam. */
struct FoldScores
{
  FoldErrors          all;
  std::vector<double> recalls;
  std::vector<double> precisions;
  std::vector<double> ends;
  std::vector<double> areas;
};

/** Relaxes the bounds for models from CT instead of the true lumen. */
void
Ease(Column & column)
{
  for (double * const share : { &column.folds.recall,
                                &column.folds.precision,
                                &column.landmarks.taeniaWithin10,
                                &column.landmarks.markedWithin10,
                                &column.landmarks.flexures,
                                &column.landmarks.labeled })
  {
    *share -= lossFromCt;
  }
  column.folds.ends *= growthFromCt;
  column.landmarks.taeniaMean *= growthFromCt;
}

Column
MakeColumn(const std::string & preset, bool isFromCt, double spacing, const std::vector<unsigned int> & seeds)
{
  Column column;
  column.title = TitleOfColumn(preset, isFromCt, spacing);
  column.hasBounds = spacing <= 0.8;
  if (preset != "standard")
  {
    column.folds = { 0.92, 0.92, 4.0 };
    column.landmarks = { 5.0, 0.90, 1.0, 0.7, 0.90 };
  }
  if (isFromCt)
  {
    Ease(column);
  }
  if (preset == "realistic") // both have bounds
  {
    column.landmarks.flexures = 0.8;
    column.landmarks.calibration = 0.1;
    column.structures = StructureBounds();
  }
  column.cases = BothPositions(preset, seeds, spacing, isFromCt);
  return column;
}

FoldErrors
TryFolds(const FlatColon & flat, const LandmarkExam & exam, HaustralFoldScheme scheme)
{
  HaustralFoldSettings options;
  options.scheme = scheme;
  return MeasureFoldErrors(
    flat.Grid(), FindHaustralFolds(flat, options), exam.anatomy->Folds(), exam.anatomy->Correspondence());
}

void
AddExam(const FoldErrors & errors, FoldScores & scores)
{
  scores.all.Add(errors);
  scores.recalls.push_back(ShareOf(errors.found, errors.present));
  scores.precisions.push_back(ShareOf(errors.right, errors.labels));
  scores.ends.push_back(MeanOf(errors.ends));
  scores.areas.push_back(ShareOf(errors.areaOfBoth, errors.areaOfEither));
}

void
AddBounded(const FoldBounds & bounds, const FoldScores & ours, BoundTable & table)
{
  const FoldErrors & all = ours.all;
  const double       ends = MeanOf(all.ends);
  table.AddShare("folds >= 3.5 mm high found", AtLeast(bounds.recall), all.found, all.present, ours.recalls);
  table.AddShare("correct fold labels", AtLeast(bounds.precision), all.right, all.labels, ours.precisions);
  table.AddValue("fold end points, mean error, mm", AtMost(bounds.ends), ends, ours.ends, !all.ends.empty());
}

void
AddReported(const FoldScores & ours, const FoldScores & published, BoundTable & table)
{
  const FoldErrors & all = ours.all;
  table.AddFact("folds found if labels may be shared", RatioOf(all.covered, all.present));
  table.AddFact("folds 2 to 3.5 mm high found", RatioOf(all.lowFound, all.lowPresent));
  table.AddFact("area ratio of folds", RatioOf(all.areaOfBoth, all.areaOfEither), ours.areas);
  table.AddFact("hidden folds", std::to_string(all.hidden));
  table.AddFact("labels that cover several folds", std::to_string(all.merged));
  table.AddFact("fold length over true length, mean", Rounded(MeanOf(all.lengthRatios)));
  table.AddFact("fold height minus true height, mean, mm", Rounded(MeanOf(all.heightErrors)));
  table.AddFact("published scheme: folds found", RatioOf(published.all.found, published.all.present));
  table.AddFact("published scheme: correct fold labels", RatioOf(published.all.right, published.all.labels));
  table.AddFact("published scheme: end points, mean error, mm", Rounded(MeanOf(published.all.ends)));
}

void
TryColumn(const Column & column, ValidationReport & report)
{
  report.AddText("## " + column.title);
  FoldScores      ours;
  FoldScores      published;
  LandmarkScores  landmarks;
  StructureScores structures;
  CsvTable        faults({ "exam", "fault" });
  CsvTable        exams({ "exam", "folds found", "labels right", "ends, mm", "published: found", "right" });
  for (const LandmarkCase & one : column.cases)
  {
    ValidationReport::Progress(column.title + ": " + NameOfCase(one));
    const LandmarkExam             exam = MakeLandmarkExam(one);
    const std::vector<std::string> missed = structures.Add(exam);
    if (!exam.failure.empty())
    {
      exams.AddRow({ NameOfCase(one), "FAILED: " + exam.failure + ' ' + report.Check(false), "", "", "", "" });
      continue;
    }
    const FlatColon  flat(exam.flat);
    const FoldErrors mine = TryFolds(flat, exam, HaustralFoldScheme::GraphCut);
    const FoldErrors theirs = TryFolds(flat, exam, HaustralFoldScheme::Published);
    AddExam(mine, ours);
    AddExam(theirs, published);
    exams.AddRow(Cells() << NameOfCase(one) << RatioOf(mine.found, mine.present) << RatioOf(mine.right, mine.labels)
                         << Rounded(MeanOf(mine.ends)) << RatioOf(theirs.found, theirs.present)
                         << RatioOf(theirs.right, theirs.labels));
    for (const auto & some : { missed, landmarks.Add(exam), mine.faults })
    {
      for (const std::string & fault : some)
      {
        faults.AddRow({ NameOfCase(one), fault });
      }
    }
  }
  BoundTable table(report, column.hasBounds);
  AddBounded(column.folds, ours, table);
  landmarks.AddBounded(column.landmarks, table);
  structures.AddTo(table, column.structures);
  AddReported(ours, published, table);
  landmarks.AddReported(table);
  table.Write("measures");
  landmarks.WriteMissedFlexures(report);
  landmarks.WriteReliability(report);
  structures.WriteReliability(report);
  report.AddRows("exams", exams);
  report.AddRows("faults", faults);
}

void
Explain(const ValidationSettings & settings, ValidationReport & report)
{
  if (settings.firstSeed > 0)
  {
    report.AddText(settings.MethodOf("colon-landmarks"));
    return;
  }
  report.AddText("Synthetic patients (" + settings.SeedsInWords() +
                 "), supine and prone. The colon is modeled from the true lumen, flattened, and searched with default "
                 "options. `value` pools all exams; the mean is over exams. `faults` lists exam and reason of each "
                 "miss. An exam without landmarks counts as wrong.");
  report.AddText(
    "The true crest of a fold is sampled where it is at least 1 mm above the wall. A sample is visible if the surface "
    "is within 3 mm and not a bridge. Folds with less than half of their samples visible are hidden and excluded. A "
    "fold is found if at least half of its visible samples are within 2 mm of one label. Each label is assigned to the "
    "fold >= 2 mm high whose samples it covers most. It is correct if at least half of its pixels are within 4 mm of "
    "the crest of a fold >= 1.5 mm high. End points are compared with the ends of the true crest. The area ratio of "
    "folds is the area on true folds and labels over the area on true folds or labels, at points every 5 mm of the "
    "wall; a point is on a fold that rises by more than 1 mm there.");
  report.AddText(
    "Taenia errors are distances from true points to the found taeniae, outside collapsed sections; taeniae are "
    "assigned separately in each open section. With three markers, one point per true taenia is given; the bound of 1 "
    "fails for any point beyond 10 mm. Flexure errors are measured along the centerline from the border between true "
    "segments. As share of the circumference, the error is the root mean square over the points of an exam, each "
    "distance over the circumference of the wall without folds. The cecal pole is the point of the cecal wall farthest "
    "from the mouth of the cecum. The reliability files compare confidence with the share of flexures within 30 mm and "
    "of valves within 15 mm.");
}

void
ExplainCt(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(settings.MethodOf("colon-landmarks") +
                 " The colon is modeled from CT: bounds of shares are 0.03 lower, bounds of distances 1.3 times "
                 "larger. Bounds of flexures, cecal pole and valve of the preset realistic are unchanged. Voxels of "
                 "1.4 mm (first four patients) have no bounds.");
}

/** The bounds are for finer voxels and many patients, so this only checks that the code runs. */
void
TryCoarsePatient(const ValidationSettings & settings, ValidationReport & report)
{
  const LandmarkExam exam = MakeLandmarkExam(MakeColumn("standard", false, 2.0, settings.Seeds(1)).cases[0]);
  report.AddText("One coarse patient is flattened: " + report.Check(exam.failure.empty()));
  if (exam.failure.empty())
  {
    const FoldErrors errors = TryFolds(FlatColon(exam.flat), exam, HaustralFoldScheme::GraphCut);
    report.AddText(
      "Folds found " + RatioOf(errors.found, errors.present) + ", labels that are folds " +
      RatioOf(errors.right, errors.labels) + ": " +
      report.Check(ShareOf(errors.found, errors.present) > 0.7 && ShareOf(errors.right, errors.labels) > 0.7));
  }
}
} // namespace

void
ValidateColonLandmarks(const ValidationSettings & settings, ValidationReport & report)
{
  Explain(settings, report);
  if (settings.quick)
  {
    TryCoarsePatient(settings, report);
    return;
  }
  for (const std::string & preset : settings.presets)
  {
    TryColumn(MakeColumn(preset, false, 0.8, settings.Seeds(patientsAsked, preset)), report);
  }
}

void
ValidateColonLandmarksFromCt(const ValidationSettings & settings, ValidationReport & report)
{
  ExplainCt(settings, report);
  for (const double spacing : { 0.8, 1.4 })
  {
    for (const std::string & preset : settings.presets)
    {
      std::vector<unsigned int> seeds = settings.Seeds(patientsAsked, preset);
      seeds.resize(spacing > 0.8 ? std::min<std::size_t>(seeds.size(), 4) : seeds.size());
      TryColumn(MakeColumn(preset, true, spacing, seeds), report);
    }
  }
}
