// Figures 7.1 and 3.7: scale, time and distance.
#include "ShapetonComparison.h"

#include <array>
#include <functional>

using namespace shapeton;

namespace
{
/** Values of a field at the corners, edges, faces and center of the cube, averaged over all places of each kind. */
std::array<double, 4>
CubeFeatures(const TrialVolume & volume, const itk::Image<float, 3> * field)
{
  const auto            side = static_cast<std::size_t>(volume.image->GetLargestPossibleRegion().GetSize(0));
  const std::size_t     first = side / 4, last = side - side / 4 - 1, inner = side / 8;
  std::array<double, 4> sums{};
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (volume.IsObject(i))
    {
      const std::array<std::size_t, 3> at{ i % side, i / side % side, i / side / side };
      const auto                       outer = static_cast<std::size_t>(std::count_if(
        at.begin(), at.end(), [&](std::size_t x) { return x < first + inner / 4 || x > last - inner / 4; }));
      const auto                       deep =
        std::count_if(at.begin(), at.end(), [&](std::size_t x) { return x >= first + inner && x <= last - inner; });
      if (outer + deep == 3)
      {
        sums[3 - outer] += field->GetBufferPointer()[i];
        numbers[3 - outer] += 1.0;
      }
    }
  }
  std::transform(sums.begin(), sums.end(), numbers.begin(), sums.begin(), std::divides<>());
  return sums;
}

/** For the thin vessels, the large vessel and the aneurysm: the mean visits relative to all voxels, and the fraction of
 * visited voxels. The last value is the fraction of all visits that are in any of the three. */
std::vector<std::string>
CellsOfVessels(const TrialVolume & volume, const Trial & trial)
{
  std::array<std::array<double, 3>, 5> sums{}; // voxels, visits and visited voxels of each label; last, of all
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    const std::uint32_t visits = trial.visits->GetBufferPointer()[i];
    for (const unsigned int group : { static_cast<unsigned int>(volume.labels->GetBufferPointer()[i]), 4U })
    {
      sums[group][0] += 1.0;
      sums[group][1] += visits;
      sums[group][2] += visits > 0 ? 1.0 : 0.0;
    }
  }
  const double             mean = sums[4][1] / sums[4][0];
  std::vector<std::string> cells, shares;
  for (std::size_t label = 1; label <= 3; ++label)
  {
    cells.push_back(Rounded(sums[label][1] / sums[label][0] / mean));
    shares.push_back(Percent(sums[label][2] / sums[label][0]));
  }
  shares.push_back(Percent(1.0 - sums[0][1] / sums[4][1]));
  return Cells() << cells << shares;
}

const std::string columnsOfVessels =
  "start | distance | in voxels | seconds | thin vessels | large vessel | aneurysm | thin vessels visited | large "
  "vessel visited | aneurysm visited | visits in vessels";

std::vector<std::string>
RowOfVessels(const std::string & start, const TrialVolume & volume, double distance, const Trial & trial)
{
  return Cells() << start << distance << Rounded(StepInVoxels(volume, distance)) << Rounded(trial.seconds, 2)
                 << CellsOfVessels(volume, trial);
}
} // namespace

void
CompareScales(const Comparison & comparison)
{
  const TrialVolume          volume = MakeTrialPhantom("figure2.4", comparison.Cube(64));
  std::vector<std::uint64_t> steps{ 5, 15, 50, 150, 500 };
  steps.resize(comparison.settings.quick ? 2 : steps.size());
  const double distance = 1.0 / volume.image->GetLargestPossibleRegion().GetSize(0);
  comparison.report.AddText("## Figure 7.1: scale and time\n\nThe cube of figure2.4 in 64^3 voxels, p = 7, one voxel "
                            "per step, 400,000 shapetons, seed 1. Mean over the outer layers of the cube at corners, "
                            "edges and faces, and over its inside, relative to the mean of the four. CHD is evaluated "
                            "at the step from EquivalentHeatTimeSteps(); shapetons show all visits so far.");
  CsvTable     table({ "shapeton steps", "method", "corner", "edge", "face", "inside" });
  PictureSheet sheet("Figure 7.1: a cube, 64^3, p = 7, 400,000 shapetons, one voxel a step, seed 1",
                     { 3, steps.size(), 140, 128 });
  bool         ordered = true;
  for (std::size_t column = 0; column < steps.size(); ++column)
  {
    const WalkSettings               walk = { comparison.settings.quick ? 20000U : 400000U, distance, steps[column] };
    const std::array<Trial, 3>       trials{ RunHeat(volume, 7.0, MatchedHeatSteps(volume, walk)),
                                       RunShapetons(volume, 7.0, publishedWalk, walk),
                                       RunShapetons(volume, 7.0, controlledWalk, walk) };
    const std::array<std::string, 3> captions{ "CHD, " + std::to_string(trials[0].steps) + " steps",
                                               "published, " + std::to_string(walk.steps),
                                               "controlled, " + std::to_string(walk.steps) };
    for (std::size_t row = 0; row < trials.size(); ++row)
    {
      const auto               features = CubeFeatures(volume, trials[row].field);
      const double             mean = 0.25 * (features[0] + features[1] + features[2] + features[3]);
      std::vector<std::string> cells{ std::to_string(walk.steps), captions[row] };
      for (const double feature : features)
      {
        cells.push_back(Rounded(feature / mean));
      }
      ordered = ordered && (row != 2 || column > 0 || std::is_sorted(features.rbegin(), features.rend()));
      table.AddRow(cells);
      sheet.Put(row, column, captions[row], RenderLevels(LevelsOf(volume, trials[row]), 140, 128));
    }
  }
  comparison.report.AddRows("scales", table);
  comparison.Show(sheet, "figure7.1");
  comparison.report.AddText("The published walk shows no corners and edges at any time, as stated in 7.2.1; finally, "
                            "it has fewer visits there than inside. The controlled walk passes through the scales of "
                            "CHD, with corner > edge > face > inside at the first number of steps: " +
                            comparison.report.Check(ordered) +
                            ". Its visits are accumulated over all steps, so they lag behind the heat.");
}

void
CompareDistances(const Comparison & comparison)
{
  const bool        quick = comparison.settings.quick;
  const TrialVolume volume = MakeTrialPhantom("vessels", comparison.Cube(256));
  const Trial       heat = RunHeat(volume, 7.5, quick ? 1000 : 100000);
  const auto        walk = [&](const WalkRule & rule, double distance, bool inObjects) {
    return RunShapetons(volume, 7.5, rule, { quick ? 20000U : 65000U, distance, quick ? 40U : 400U, inObjects });
  };
  comparison.report.AddText(
    "## Figure 3.7: the distance\n\nThe vessels phantom (thin vessels: radius 5 to 6 voxels) in 256^3 voxels, p = 7.5, "
    "400 steps, 65,000 shapetons, published rule, seed 1. Shapetons start anywhere or in the vessels; the source does "
    "not state which. Mean visits are relative to all voxels. CHD took " +
    Rounded(heat.seconds, 2) + " s for 100,000 steps.");
  CsvTable     table(Columns(columnsOfVessels));
  PictureSheet sheet("Figure 3.7: vessels, 256^3, p = 7.5, 65,000 shapetons from the vessels, 400 steps, seed 1",
                     { 1, 5, 185, 200 });
  sheet.Put(0, 0, "CHD, 100,000 steps", RenderLevels(LevelsOf(volume, heat), 185, 200));
  std::size_t column = 1;
  for (const bool inObjects : { false, true })
  {
    for (const double distance : { 0.001, 0.005, 0.01, 0.05 })
    {
      const Trial trial = walk(publishedWalk, distance, inObjects);
      table.AddRow(RowOfVessels(inObjects ? "in the vessels" : "anywhere", volume, distance, trial));
      if (inObjects)
      {
        const auto picture = RenderLevels(LevelsOf(volume, trial), 185, 200);
        sheet.Put(0, column++, "distance " + CsvTable::Number(distance), picture);
      }
    }
  }
  const WalkRule walled{ "", publishedWalk.sampling, PathRule::Traversal, publishedWalk.placement };
  const Trial    trial = walk(walled, 0.05, true);
  table.AddRow(RowOfVessels("in the vessels, PathRule::Traversal", volume, 0.05, trial));
  comparison.report.AddRows("distances", table);
  comparison.Show(sheet, "vessels");
  comparison.report.AddText(
    "Shapetons that start anywhere visit thin vessels as often as the background, at every distance. Shapetons that "
    "start in the vessels jump through the walls, more with longer steps, and leave thin vessels first. Figure 3.7 "
    "shows this leakage, not scale. With PathRule::Traversal, all shapetons stay inside: " +
    comparison.report.Check(CellsOfVessels(volume, trial).back() == Percent(1.0)) + ".");
}
