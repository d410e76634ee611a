// CHD or shapetons? Both on the same volumes: times, agreement, pictures.
#include "ShapetonComparison.h"

#include <cmath>
#include <cstdio>

using namespace shapeton;

std::string
Percent(double share)
{
  return CsvTable::Rounded(100.0 * share, 3) + " %";
}

std::string
Hundredths(double value)
{
  return CsvTable::Number(std::round(100.0 * value) / 100.0 + 0.0); // no -0
}

std::string
CaptionOf(const Trial & trial)
{
  const std::string shapetons = "shapetons, ";
  const bool        isWalk = trial.method.rfind(shapetons, 0) == 0;
  return (isWalk ? trial.method.substr(shapetons.size()) : trial.method) + ", " + trial.settings;
}

std::vector<std::string>
CellsOf(const TrialVolume & volume, const Trial & trial)
{
  std::vector<std::string> cells{ trial.method, trial.settings, CsvTable::Rounded(trial.seconds, 2) };
  if (trial.visits)
  {
    const double shapetons = std::stod(trial.settings);
    cells.push_back(Percent(trial.measures.GetCoverage()));
    cells.push_back(Percent(trial.measures.trappedShapetons / shapetons));
    cells.push_back(CsvTable::Rounded(MeanVisitsOfObjects(volume, trial), 3));
  }
  else
  {
    cells.insert(cells.end(), 3, "");
  }
  return cells;
}

const std::vector<std::string> columnsOfTrials{ "method",   "shapetons x steps", "seconds",
                                                "coverage", "trapped",           "visits per object voxel" };

std::vector<std::string>
Joined(std::vector<std::string> cells, const std::vector<std::string> & more)
{
  cells.insert(cells.end(), more.begin(), more.end());
  return cells;
}

std::vector<double>
Values(const std::map<int, double> & map)
{
  std::vector<double> values;
  for (const auto & entry : map)
  {
    values.push_back(entry.second);
  }
  return values;
}

namespace
{
struct PhantomCase
{
  std::string              preset;
  std::string              title;
  std::vector<std::string> objects; ///< indexed by label
  std::uint32_t            printedShapetons;
  std::string              sees;
};

void
TabulateTrials(const Comparison & comparison, const TrialVolume & volume, const std::vector<Trial> & trials)
{
  CsvTable            table(Joined(
    columnsOfTrials,
    { "rank correlation of object means with CHD", "variance between objects", "classes", "adjusted Rand index" }));
  std::vector<double> ranks, between;
  const auto          heat = Values(MeansOfObjects(volume, trials.front().field));
  for (const Trial & trial : trials)
  {
    const ClassAgreement agreement = CompareClasses(volume, trial);
    ranks.push_back(RankCorrelation(heat, Values(MeansOfObjects(volume, trial.field))));
    between.push_back(VarianceBetweenObjects(volume, trial.field));
    table.AddRow(Joined(CellsOf(volume, trial),
                        { Hundredths(ranks.back()),
                          Percent(between.back()),
                          std::to_string(agreement.classes),
                          Hundredths(agreement.adjustedRand) }));
  }
  comparison.report.AddTable(table);
  comparison.report.AddText("The controlled walk orders the objects as CHD does (rank correlation at least 0.9: " +
                            comparison.report.Check(ranks.back() >= 0.9) +
                            "), and at least 70 % of its variance lies between them (" +
                            comparison.report.Check(between.back() >= 0.7) + ").");
}

/** Means of the objects relative to the first one. */
void
TabulateObjects(const Comparison &         comparison,
                const PhantomCase &        phantom,
                const TrialVolume &        volume,
                const std::vector<Trial> & trials)
{
  CsvTable table(Joined({ "mean over the object / over the " + phantom.objects.front() }, phantom.objects));
  for (const Trial & trial : trials)
  {
    const auto               means = Values(MeansOfObjects(volume, trial.field));
    std::vector<std::string> cells{ trial.method + (trial.visits ? ", " + trial.settings : "") };
    for (const double mean : means)
    {
      cells.push_back(CsvTable::Rounded(mean / means.front(), 3));
    }
    table.AddRow(cells);
  }
  comparison.report.AddTable(table);
}

void
ComparePhantom(const Comparison & comparison, const PhantomCase & phantom)
{
  const TrialVolume  volume = MakeTrialPhantom(phantom.preset, comparison.Cube(128));
  const auto         printed = comparison.Walk(phantom.printedShapetons, 0.01, 2500);
  const auto         many = comparison.Walk(200000, 0.01, 1500);
  std::vector<Trial> trials;
  trials.push_back(RunHeat(volume, 7.0, comparison.settings.quick ? 10000 : 100000));
  trials.push_back(RunShapetons(volume, 7.0, publishedWalk, printed));
  trials.push_back(RunShapetons(volume, 7.0, publishedWalk, many));
  auto fromObjects = many;
  fromObjects.startInObjects = true;
  trials.push_back(RunShapetons(volume, 7.0, publishedWalk, fromObjects));
  trials.push_back(RunShapetons(volume, 7.0, controlledWalk, many));
  comparison.report.AddText("## " + phantom.title + "\n\n" +
                            std::to_string(volume.image->GetLargestPossibleRegion().GetSize(0)) +
                            "^3 voxels, p = 7, distance " + CsvTable::Number(many.distance) + ", seed 1.");
  TabulateTrials(comparison, volume, trials);
  TabulateObjects(comparison, phantom, volume, trials);
  PictureSheet sheet(phantom.title + ", 128^3, p = 7, distance 0.01, seed 1", { 2, 4, 235, 190 });
  std::size_t  column = 0;
  for (const std::size_t i : { 0, 2, 3, 4 })
  {
    const auto levels = LevelsOf(volume, trials[i]);
    const auto middle = volume.image->GetLargestPossibleRegion().GetSize(1) / 2;
    sheet.Put(0, column, CaptionOf(trials[i]), RenderLevels(levels, 235, 190));
    sheet.Put(1,
              column++,
              "slice through the middle",
              DrawPlane(volume, levels, phantom.preset == "hydrogen" ? 1 : 2, middle, 235, 190));
  }
  comparison.Show(sheet, phantom.preset);
  comparison.report.AddText(phantom.sees);
}

const std::vector<PhantomCase> phantoms = {
  { "figure3.4",
    "Figure 3.4: cube, cuboids, sphere",
    { "cube", "large cuboid", "small cuboid", "sphere" },
    65000,
    "CHD sees four objects by their surface over their volume; so does the controlled walk. The published walk that "
    "starts anywhere sees one class: visits are alike inside all objects and fewer in a layer at their walls. When it "
    "starts in the objects it sees how fast they leak, in the reverse order of heat: cube and large cuboid are alike "
    "and the sphere differs, as published, but the small cuboid is farthest from the large one. No method gives the "
    "two cuboids one value 'irrespective of their size' (3.3.1)." },
  { "figure3.5",
    "Figure 3.5: deformed shapes",
    { "cuboid", "deformed cuboid", "sphere", "deformed sphere" },
    1000,
    "With the printed 1,000 shapetons a voxel of this volume has about one visit: the result is noise. The published "
    "walk that starts in the objects gives cuboids and spheres a class each, whatever their deformation, as published: "
    "it sees how fast they leak, and the deformations change their surface little. CHD and the controlled walk see the "
    "change: a third more heat in the twisted and bent cuboid (partly because a turned surface cuts more faces of "
    "voxels), 7 % more in the sphere with bumps." },
  { "hydrogen",
    "Figure 3.11a: hydrogen",
    { "nucleus", "upper lobe", "lower lobe", "orbit" },
    65000,
    "CHD and the controlled walk give both lobes one value and tell them from nucleus and orbit, as 3.6 claims. The "
    "published walk does not tell the four apart when it starts anywhere; when it starts in the objects, both lobes "
    "are alike, and within 7 % of the nucleus." },
};

} // namespace

void
ValidateComparisonOfShapetons(const ValidationSettings & settings, ValidationReport & report)
{
  const Comparison comparison{ settings, report };
  report.AddText(
    "Two walks: 'published' is that of chapter 3 (DirectionSampling::SectorArea, PathRule::Endpoint, "
    "ParticlePlacement::Uniform), 'controlled' samples CHD (Uniform, Traversal, InitialHeat). Seconds are processor "
    "time, "
    "summed over all cores: two idle cores need about half of it. Trapped are shapetons in voxels whose six weights "
    "are 0. "
    "The variance between objects is its share of the variance over all voxels of objects; classes are those of "
    "ClassifyHeat() and ClassifyVisits(); the adjusted Rand index compares them with the objects, over the objects' "
    "voxels. Seeds are 1 throughout; visits are exact for a seed, times are not.");
  RunShapetons(
    MakeTrialPhantom("figure2.4", itk::Size<3>::Filled(8)), 7.0, publishedWalk, { 100, 0.1, 1 }); // fills tables
  for (std::size_t i = 0; i < (settings.quick ? 1 : phantoms.size()); ++i)
  {
    ComparePhantom(comparison, phantoms[i]);
  }
  CompareScales(comparison);
  CompareDistances(comparison);
  if (settings.dataFolder.empty() || settings.quick)
  {
    std::printf("%-16s real volumes left out\n", "");
  }
  else
  {
    CompareRealVolumes(comparison);
    CompareEngineByP(comparison);
  }
  TabulateCubeByShapetons(comparison);
  TabulatePublishedVolumes(comparison);
}
