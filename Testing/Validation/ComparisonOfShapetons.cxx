// CHD or shapetons? Both on the same volumes: times, agreement, pictures.
#include "ShapetonComparison.h"

#include <cmath>
#include <cstdio>

using namespace shapeton;

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
  const Cells start = Cells() << trial.method << trial.settings << Rounded(trial.seconds, 2);
  if (!trial.visits)
  {
    return Cells(start) << "" << std::string() << "";
  }
  return Cells(start) << Percent(trial.measures.GetCoverage())
                      << Percent(trial.measures.trappedShapetons / std::stod(trial.settings))
                      << Rounded(MeanVisitsOfObjects(volume, trial));
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
  CsvTable table(
    Columns(columnsOfTrials +
            " | rank correlation of object means with CHD | variance between objects | classes | adjusted Rand index"));
  std::vector<double> ranks, between;
  const auto          heat = Values(MeansOfObjects(volume, trials.front().field));
  for (const Trial & trial : trials)
  {
    const ClassAgreement agreement = CompareClasses(volume, trial);
    ranks.push_back(RankCorrelation(heat, Values(MeansOfObjects(volume, trial.field))));
    between.push_back(VarianceBetweenObjects(volume, trial.field));
    table.AddRow(Cells() << CellsOf(volume, trial) << Hundredths(ranks.back()) << Percent(between.back())
                         << agreement.classes << Hundredths(agreement.adjustedRand));
  }
  comparison.report.AddRows("phantoms", table);
  comparison.report.AddText("Controlled walk: rank correlation of object means with CHD " + Hundredths(ranks.back()) +
                            " (bound 0.9: " + comparison.report.Check(ranks.back() >= 0.9) +
                            "), variance between objects " + Percent(between.back()) +
                            " (bound 70 %: " + comparison.report.Check(between.back() >= 0.7) + ").");
}

/** Means of the objects relative to the first one. */
void
TabulateObjects(const Comparison &         comparison,
                const PhantomCase &        phantom,
                const TrialVolume &        volume,
                const std::vector<Trial> & trials)
{
  CsvTable table({ "method", "object", "mean relative to the first object" });
  for (const Trial & trial : trials)
  {
    const auto means = Values(MeansOfObjects(volume, trial.field));
    for (std::size_t i = 0; i < means.size(); ++i)
    {
      table.AddRow(Cells() << trial.method + (trial.visits ? ", " + trial.settings : "") << phantom.objects[i]
                           << Rounded(means[i] / means.front()));
    }
  }
  comparison.report.AddRows("objects", table);
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
    "CHD and the controlled walk order the objects by surface over volume. The published walk from everywhere finds "
    "one class: visits are similar inside all objects and lower in a layer at their walls. The walk from the objects "
    "measures how fast they leak, in the reverse order of heat. Cube and large cuboid are then similar and the sphere "
    "differs, as published, but the small cuboid differs most from the large one. No method assigns one value to both "
    "cuboids 'irrespective of their size' (3.3.1)." },
  { "figure3.5",
    "Figure 3.5: deformed shapes",
    { "cuboid", "deformed cuboid", "sphere", "deformed sphere" },
    1000,
    "The 1,000 shapetons of the dissertation result in about one visit per voxel of this volume, which is noise. The "
    "published walk from the objects finds one class of cuboids and one of spheres, as published: the deformations "
    "hardly change how fast they leak. CHD and the controlled walk show the deformations: a third more heat in the "
    "twisted and bent cuboid (partly because a rotated surface cuts more voxel faces), 7 % more in the sphere with "
    "bumps." },
  { "hydrogen",
    "Figure 3.11a: hydrogen",
    { "nucleus", "upper lobe", "lower lobe", "orbit" },
    65000,
    "CHD and the controlled walk assign one value to both lobes, different from nucleus and orbit, as 3.6 claims. The "
    "published walk from everywhere does not separate the four. From the objects, both lobes are similar, and within 7 "
    "% of the nucleus." },
};

} // namespace

void
ValidateComparisonOfShapetons(const ValidationSettings & settings, ValidationReport & report)
{
  const Comparison comparison{ settings, report };
  report.AddText(
    "Two walks: 'published' is the walk of chapter 3 (DirectionSampling::SectorArea, PathRule::Endpoint, "
    "ParticlePlacement::Uniform); 'controlled' samples CHD (Uniform, Traversal, InitialHeat). Seconds: processor time, "
    "summed over all cores. Trapped: shapetons in voxels whose six weights are 0. Variance between objects: share of "
    "the variance over all object voxels. Classes: from ClassifyHeat() and ClassifyVisits(). The adjusted Rand index "
    "compares classes and objects over the object voxels. All seeds are 1; visits are reproducible, times are not.");
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
