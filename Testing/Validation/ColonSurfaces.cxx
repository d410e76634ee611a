#include "Tables.h"
#include "ColonTrial.h"
#include "ValidationReport.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
/** Patients imaged by one scanner. */
struct Group
{
  std::string               title;
  std::vector<LandmarkCase> cases;
  double                    leastDice{ 0.98 };
  double                    mostMedian{ 0.4 };
  /** If false, results are only reported. */
  bool hasBounds{ true };
};

/** Both positions, fluid from 0 to 0.5; every third patient has a collapsed section. */
Group
MakeGroup(const std::string & title, const std::vector<unsigned int> & seeds, double spacing)
{
  Group group;
  group.title = title;
  group.mostMedian = spacing < 1.0 ? 0.2 : 0.4;
  for (unsigned int patient = 0; patient < seeds.size(); ++patient)
  {
    for (const bool isProne : { false, true })
    {
      const double fluid = 0.5 * ((2 * patient + (isProne ? 1 : 0)) % 6) / 5.0;
      group.cases.push_back(ValidationCase("standard", seeds[patient], isProne ? "prone" : "supine", spacing, true));
      group.cases.back().parameters.fluid = fluid;
      group.cases.back().parameters.collapsed = patient % 3 == 2 ? 1 : 0;
    }
  }
  return group;
}

/** Both positions of the unmodified `realistic` preset. */
Group
MakeRealisticGroup(const std::vector<unsigned int> & seeds, double spacing)
{
  Group group;
  group.title = "Preset realistic, " + Rounded(spacing, 2) + " mm voxels";
  group.hasBounds = false;
  group.cases = BothPositions("realistic", seeds, spacing, true);
  return group;
}

std::string
Ratio(int kept, int all)
{
  return std::to_string(kept) + " / " + std::to_string(all);
}

CsvTable
EmptyCaseTable()
{
  return CsvTable(Columns("patient | position | fluid | collapsed | Dice | leak, ml | surface median, mm | 95 % | 95 % "
                          "at levels | missed 95 % | submerged folds kept | polyps kept | length error, % | line "
                          "distance, mm | covered, % | short cuts | order | genus raw | repaired | changed, ml | tubes "
                          "| faces | smallest angle, 1 % | s | lumen distance, mm | lumen 95 % Hausdorff, mm"));
}

void
AddCase(const LandmarkCase & one, const ColonErrors & errors, CsvTable & table)
{
  const auto & parameters = one.parameters;
  if (!errors.failure.empty())
  {
    std::vector<std::string> cells(26, "");
    cells[0] = std::to_string(parameters.seed);
    cells[1] = parameters.position;
    cells[2] = Rounded(parameters.fluid, 2);
    cells[3] = std::to_string(parameters.collapsed);
    cells[4] = "FAILED: " + errors.failure;
    table.AddRow(cells);
    return;
  }
  table.AddRow(Cells() << parameters.seed << parameters.position << Rounded(parameters.fluid, 2) << parameters.collapsed
                       << Rounded(errors.dice, 4) << Rounded(errors.leakMl, 2) << Rounded(errors.surfaceMedian, 2)
                       << Rounded(errors.surface95, 2) << Rounded(errors.level95, 2) << Rounded(errors.missed95, 2)
                       << Ratio(errors.keptFolds, errors.folds) << Ratio(errors.keptPolyps, errors.polyps)
                       << Rounded(100.0 * errors.lengthError, 2) << Rounded(errors.meanLineDistance, 2)
                       << Rounded(100.0 * errors.covered, 4) << errors.shortCuts
                       << (errors.isOrderRight ? "right" : "wrong") << errors.genusRaw << errors.genusRepaired
                       << Rounded(errors.changedMl, 2) << (errors.areTubes ? "yes" : "no") << errors.faces
                       << Rounded(errors.smallestAngle) << Rounded(errors.seconds, 2) << Rounded(errors.lumen.average)
                       << Rounded(errors.lumen.hausdorff95));
}

/** Measurement of an exam with its bound. */
struct Measure
{
  std::string name;
  std::string bound;
  double      value;
  bool        isWithin;
};

std::vector<Measure>
MeasuresOf(const ColonErrors & e, const Group & group, int faces)
{
  const double share = e.faces / double(faces);
  return {
    { "Dice of the lumen", ">= " + Rounded(group.leastDice), e.dice, e.dice >= group.leastDice },
    { "leak, ml", "<= 3", e.leakMl, e.leakMl <= 3.0 },
    { "surface error, median, mm",
      "<= " + Rounded(group.mostMedian),
      e.surfaceMedian,
      e.surfaceMedian <= group.mostMedian },
    { "surface error, 95 %, mm", "<= 1.0", e.surface95, e.surface95 <= 1.0 },
    { "surface error within 3 mm of fluid levels, 95 %, mm", "<= 1.5", e.level95, e.level95 <= 1.5 },
    { "length error, %", "within 3", 100.0 * e.lengthError, std::abs(e.lengthError) <= 0.03 },
    { "centerline distance, mean, mm", "<= 3", e.meanLineDistance, e.meanLineDistance <= 3.0 },
    { "shortcuts", "0", double(e.shortCuts), e.shortCuts == 0 },
    { "true length covered, %", ">= 98", 100.0 * e.covered, e.covered >= 0.98 },
    { "pieces in the right order", "1", double(e.isOrderRight), e.isOrderRight },
    { "genus of the repaired wall", "0 to 2", double(e.genusRepaired), e.genusRepaired >= 0 && e.genusRepaired <= 2 },
    { "volume changed by repair, ml", "<= 1", e.changedMl, e.changedMl <= 1.0 },
    { "manifold tubes with two loops", "1", double(e.areTubes), e.areTubes },
    { "faces over requested faces", "0.98 to 1.02", share, std::abs(share - 1.0) <= 0.02 },
    { "smallest angle, first percentile, degrees", ">= 15", e.smallestAngle, e.smallestAngle >= 15.0 },
    { "genus kept by simplification", "1", double(e.isGenusKept), e.isGenusKept },
  };
}

/** Values of one measurement over all patients of a group. */
struct Row
{
  std::string         measure;
  std::string         bound;
  std::vector<double> values;
  /** Exams outside the bound, with their values. */
  std::string failures;
};

/** Collects the bounded measurements and reports whether all patients meet the bounds. */
class Bounds
{
public:
  Bounds(const Group & group, int faces) : m_Group(group), m_Faces(faces) {}

  void
  Add(const LandmarkCase & one, const ColonErrors & e)
  {
    const std::string exam = std::to_string(one.parameters.seed) + ' ' + one.parameters.position;
    const auto        measures = MeasuresOf(e, m_Group, m_Faces);
    m_Rows.resize(measures.size());
    for (std::size_t i = 0; i < measures.size(); ++i)
    {
      Row & row = m_Rows[i];
      row.measure = measures[i].name;
      row.bound = measures[i].bound;
      row.values.push_back(measures[i].value);
      if (!measures[i].isWithin || !e.failure.empty())
      {
        row.failures += (row.failures.empty() ? "" : ", ") + exam + " (" + Rounded(measures[i].value, 2) + ')';
      }
    }
    m_Dices.push_back(e.dice);                                           // figures of other authors, without bounds
    constexpr double infinite = std::numeric_limits<double>::infinity(); // an exam without a lumen
    m_Averages.push_back(e.dice > 0.0 ? e.lumen.average : infinite);
    m_Hausdorffs.push_back(e.dice > 0.0 ? e.lumen.hausdorff95 : infinite);
    const int lost = e.folds + e.polyps - e.keptFolds - e.keptPolyps;
    if (lost > 0)
    {
      m_Lost += (m_Lost.empty() ? "" : ", ") + exam + ' ' + Ratio(lost, e.folds + e.polyps);
    }
    m_Kept += e.keptFolds + e.keptPolyps;
    m_Shapes += e.folds + e.polyps;
  }

  void
  Report(ValidationReport & report)
  {
    CsvTable   table({ "measure", "bound", "mean [95 % interval]", "result" });
    const auto add = [&](const std::string & what, const std::string & bound, const std::string & value, bool passed) {
      table.AddRow({ what, m_Group.hasBounds ? bound : "", value, m_Group.hasBounds ? report.Check(passed) : "" });
    };
    for (const Row & row : m_Rows)
    {
      add(row.measure, row.bound, MeanWithInterval(row.values), row.failures.empty());
    }
    const double share = static_cast<double>(m_Kept) / std::max(1, m_Shapes);
    add("submerged folds >= 2.5 mm thick and polyps >= 6 mm kept, all exams",
        ">= 95 %",
        Ratio(m_Kept, m_Shapes) + ", " + Rounded(100.0 * share) + " %",
        share >= 0.95);
    this->ReportLumens(table);
    report.AddSummary("measures", table);
    if (m_Group.hasBounds)
    {
      this->ReportFailures(share, report);
    }
  }

private:
  void
  ReportLumens(CsvTable & table) const
  {
    table.AddRow({ "Dice of the lumen, median", "", Rounded(LowerQuantile(m_Dices, 0.5), 4), "" });
    table.AddRow({ "symmetric surface distance of the lumen, mm", "", MeanWithInterval(m_Averages), "" });
    table.AddRow(
      { "symmetric surface distance of the lumen, median, mm", "", Rounded(LowerQuantile(m_Averages, 0.5)), "" });
    table.AddRow({ "95 % Hausdorff distance of the lumen, mm", "", MeanWithInterval(m_Hausdorffs), "" });
    table.AddRow(
      { "95 % Hausdorff distance of the lumen, median, mm", "", Rounded(LowerQuantile(m_Hausdorffs, 0.5)), "" });
  }

  void
  ReportFailures(double share, ValidationReport & report) const
  {
    for (const Row & row : m_Rows)
    {
      if (!row.failures.empty())
      {
        report.AddText("Outside the bound of \"" + row.measure + "\": " + row.failures + '.');
      }
    }
    if (share < 0.95)
    {
      report.AddText("Folds and polyps not kept: " + m_Lost + '.');
    }
  }

  const Group &    m_Group;
  int              m_Faces;
  std::vector<Row> m_Rows;
  /** Exams with lost folds or polyps, with their numbers. */
  std::string m_Lost;
  int         m_Kept{ 0 };
  int         m_Shapes{ 0 };

  std::vector<double> m_Dices, m_Averages, m_Hausdorffs;
};

void
TryGroup(const Group & group, int faces, ValidationReport & report)
{
  report.AddText("## " + group.title);
  CsvTable table = EmptyCaseTable();
  Bounds   bounds(group, faces);
  for (const LandmarkCase & one : group.cases)
  {
    const ColonErrors errors = TryColon(one, faces);
    AddCase(one, errors, table);
    bounds.Add(one, errors);
  }
  bounds.Report(report);
  report.AddRows("patients", table);
}

constexpr int Faces = 55000;

/** Groups of the presets of the settings; hard has none. */
void
TryPresets(const ValidationSettings & settings, const std::string & title, double spacing, ValidationReport & report)
{
  for (const std::string & preset : settings.presets)
  {
    if (preset == "standard")
    {
      TryGroup(MakeGroup(title, settings.Seeds(10), spacing), Faces, report);
    }
    else if (preset == "realistic")
    {
      TryGroup(MakeRealisticGroup(settings.Seeds(10, preset), spacing), Faces, report);
    }
  }
}

void
Explain(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    "Synthetic patients of preset standard (" + settings.SeedsInWords() +
    "), supine and prone, with fluid from 0 to half of the lumen; every third patient has a collapsed section. "
    "Patients of preset realistic have no bounds. `ColonSegmentation` receives the CT and the patient position only.");
  report.AddText(
    "Each exam must meet each bound; the last bound applies to all exams together. Surface error is the distance from "
    "vertices of `wall.vtp`, without synthetic bridges, to the true wall; `missed` in `patients` is the reverse "
    "distance. True length is covered where the line is within the lumen radius. Folds and polyps are kept if at least "
    "90 % of their tissue volume remains in the cleansed CT; a fold extends to 0.8 of its height from the crest.");
  report.AddText("Distances of the lumen compare the surface voxels of the lumen with those of the true lumen in both "
                 "directions: the symmetric distance is the mean over both surfaces, the 95 % Hausdorff distance the "
                 "larger of the 95th percentiles of both directions.");
}
} // namespace

void
ValidateColonSurfaces(const ValidationSettings & settings, ValidationReport & report)
{
  Explain(settings, report);
  if (!settings.quick)
  {
    TryPresets(settings, "1.4 mm voxels", 1.4, report);
    return;
  }
  // Coarse voxels; the bounds are for finer voxels, so this only checks that the code runs.
  LandmarkCase one = ValidationCase("standard", settings.Seeds(1).front(), "supine", 2.8, true);
  one.parameters.fluid = 0.2;
  const ColonErrors errors = TryColon(one, 20000);
  CsvTable          table = EmptyCaseTable();
  AddCase(one, errors, table);
  report.AddTable(table);
  report.AddText("One coarse patient: " +
                 report.Check(errors.failure.empty() && errors.dice > 0.9 && errors.areTubes && errors.shortCuts == 0));
}

void
ValidateColonNoise(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(settings.MethodOf("colon-surfaces"));
  Group group = MakeGroup("1.4 mm voxels, noise of 100 HU", settings.Seeds(3), 1.4);
  group.leastDice = 0.97;
  for (LandmarkCase & one : group.cases)
  {
    one.parameters.noise = 100.0;
  }
  TryGroup(group, Faces, report);
}

void
ValidateColonSurfacesFine(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(settings.MethodOf("colon-surfaces"));
  TryPresets(settings, "0.7 mm voxels", 0.7, report);
}
