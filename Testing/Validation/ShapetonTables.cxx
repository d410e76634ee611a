// Tables 3.1 and 3.2 and Figure 3.6 of the dissertation with results of Shapeton.
#include "ShapetonComparison.h"

#include "shapetonVolumeReader.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

using namespace shapeton;

namespace
{
struct CubeRow
{
  std::uint32_t shapetons;
  const char *  milliseconds; // published: per step, steps, total seconds
  const char *  steps;
  const char *  seconds;
};

const std::array<CubeRow, 6> cubeRows = { {
  { 4000, "0.057", "7,100", "0.40" },
  { 8000, "0.087", "4,400", "0.38" },
  { 15000, "0.129", "2,800", "0.35" },
  { 30000, "0.215", "1,600", "0.34" },
  { 65000, "0.236", "1,500", "0.35" },
  { 150000, "0.310", "1,200", "0.37" },
} };

std::unique_ptr<ParticleDiffusion>
PlaceShapetons(const TrialVolume & volume, std::uint32_t shapetons, std::vector<std::uint32_t> & visits)
{
  const auto               size = volume.image->GetLargestPossibleRegion().GetSize();
  ParticleDiffusionOptions settings;
  settings.p = 7.0;
  settings.intensityWindow = { { volume.lower, volume.upper } };
  settings.shapetons = shapetons;
  settings.directionSampling = publishedWalk.sampling;
  visits.assign(volume.GetNumberOfVoxels(), 0);
  return std::make_unique<ParticleDiffusion>(
    VolumeView(volume.image->GetBufferPointer(), { size[0], size[1], size[2] }), settings, nullptr, visits.data());
}

/** Steps until the cube is covered, accurate to 2 %, and the coverage after 1,600 steps. */
struct CubeRun
{
  std::uint64_t stepsToNearly{ 0 }; ///< 99 %
  std::uint64_t stepsToAll{ 0 };
  double        coverageAt1600{ 0.0 };
  double        millisecondsPerStep{ 0.0 };
};

CubeRun
CoverCube(const TrialVolume & volume, std::uint32_t shapetons)
{
  constexpr std::uint64_t    figureSteps = 1600;
  CubeRun                    run;
  std::vector<std::uint32_t> visits;
  const auto                 diffusion = PlaceShapetons(volume, shapetons, visits);
  double                     seconds = 0.0;
  std::uint64_t              step = 0;
  while (run.stepsToAll == 0 || step < figureSteps)
  {
    std::uint64_t next = step + std::max<std::uint64_t>(1, step / 50);
    next = step < figureSteps ? std::min(next, figureSteps) : next;
    const Stopwatch watch;
    diffusion->Run(next);
    seconds += watch.ProcessorSeconds();
    step = next;
    const double coverage = diffusion->GetMeasures().GetCoverage();
    run.stepsToNearly = run.stepsToNearly == 0 && coverage >= 0.99 ? step : run.stepsToNearly;
    run.stepsToAll = run.stepsToAll == 0 && coverage >= 1.0 ? step : run.stepsToAll;
    run.coverageAt1600 = step == figureSteps ? coverage : run.coverageAt1600;
  }
  run.millisecondsPerStep = 1000.0 * seconds / static_cast<double>(step);
  return run;
}

struct VolumeRow
{
  const char *  name;
  itk::Size<3>  size;
  double        p;
  std::uint64_t heatSteps;
  std::uint64_t walkSteps;
  double        heatMilliseconds; // published, per step
  double        walkMilliseconds;
  const char *  file; // below SHAPETON_TEST_DATA_DIR
};

const std::array<VolumeRow, 8> volumeRows = { {
  { "Foot", { { 256, 256, 256 } }, 7.0, 100000, 2800, 4.8, 0.69, "" },
  { "Engine", { { 256, 256, 128 } }, 10.0, 52000, 1100, 1.4, 0.74, "volumes/engine.nii.gz" },
  { "Aneurysm", { { 256, 256, 256 } }, 7.5, 100000, 3100, 5.1, 0.69, "" },
  { "MRI head", { { 256, 256, 256 } }, 6.0, 400000, 4160, 21.0, 0.68, "" },
  { "CT abdomen", { { 512, 512, 174 } }, 8.0, 100000, 2600, 46.0, 0.82, "" },
  { "CT chest", { { 384, 384, 240 } }, 6.0, 100000, 1600, 32.0, 1.93, "" },
  { "Visible Female hand", { { 176, 187, 190 } }, 10.0, 1000000, 4600, 18.0, 0.73, "" },
  { "Visible Female foot", { { 176, 187, 190 } }, 9.0, 500000, 4200, 13.0, 0.63, "" },
} };

TrialVolume
LoadRow(const ValidationSettings & settings, const VolumeRow & row, bool & real)
{
  real = *row.file != '\0' && !settings.dataFolder.empty() && !settings.quick;
  if (!real)
  {
    return MakeTrialPhantom("vessels", settings.quick ? itk::Size<3>::Filled(32) : row.size);
  }
  return { row.name, ReadVolume(settings.dataFolder + '/' + row.file).image, nullptr, 0.0, 255.0 };
}
} // namespace

void
TabulateCubeByShapetons(const Comparison & comparison)
{
  const ValidationSettings & settings = comparison.settings;
  ValidationReport &         report = comparison.report;
  const unsigned int         side = settings.quick ? 32 : 128;
  const TrialVolume          volume = MakeTrialPhantom("figure2.4", itk::Size<3>::Filled(side));
  const std::string          size = std::to_string(side);
  report.AddText("## Table 3.1 and Figure 3.6: the number of shapetons\n\nThe cube of figure2.4 (side " +
                 std::to_string(side / 2) + ") in " + size +
                 "^3 voxels, p = 7, distance 0.01, published rule, seed 1. Steps (to 2 %) until 99 % and 100 % of the "
                 "voxels of the cube were visited. The last column is Figure 3.6.");
  CsvTable table(
    Columns("shapetons | ms per step, published | ms per step | steps, published | steps to 99 % | steps to 100 % | "
            "seconds, published | seconds to 99 % | seconds to 100 % | covered after 1,600 steps"));
  for (const CubeRow & row : cubeRows)
  {
    if (settings.quick && row.shapetons < 30000)
    {
      continue;
    }
    const CubeRun run = CoverCube(volume, row.shapetons);
    table.AddRow(Cells() << row.shapetons << row.milliseconds << Rounded(run.millisecondsPerStep, 2) << row.steps
                         << run.stepsToNearly << run.stepsToAll << row.seconds
                         << Rounded(1e-3 * run.millisecondsPerStep * run.stepsToNearly, 2)
                         << Rounded(1e-3 * run.millisecondsPerStep * run.stepsToAll, 2)
                         << Rounded(100.0 * run.coverageAt1600, 4) + " %");
  }
  report.AddRows("cube", table);
  report.AddText(
    "Shapetons do not interact: the total number of required visits is independent of their number, and the number of "
    "steps is inversely proportional to it. On a CPU the total time has no optimum; it increases slowly when positions "
    "and visits exceed the caches. The published optimum near 30,000 is due to a graphics card with equal costs per "
    "step for 30,000 and 65,000 shapetons, where the number of steps stops decreasing.");
}

void
TabulatePublishedVolumes(const Comparison & comparison)
{
  const ValidationSettings & settings = comparison.settings;
  ValidationReport &         report = comparison.report;
  CsvTable table(Columns("data | size | p | steps of CHD | steps of shapetons | CHD, ms per step, published | CHD, ms "
                         "per step | shapetons, ms per step, published | shapetons, ms per step | CHD, seconds, "
                         "published | CHD, seconds | shapetons, seconds, published | shapetons, seconds"));
  std::array<std::vector<double>, 4> seconds; // CHD, published, shapetons, published
  for (const VolumeRow & row : volumeRows)
  {
    if (settings.quick && &row != &volumeRows.front())
    {
      continue;
    }
    bool                real = false;
    const TrialVolume   volume = LoadRow(settings, row, real);
    const std::uint64_t shorter = settings.quick ? 100 : 1;
    const Trial         heat = RunHeat(volume, row.p, row.heatSteps / shorter);
    const Trial         walk = RunShapetons(volume, row.p, publishedWalk, { 65000, 0.01, row.walkSteps / shorter });
    const double        publishedHeatSeconds = 1e-3 * row.heatMilliseconds * static_cast<double>(row.heatSteps);
    const double        publishedWalkSeconds = 1e-3 * row.walkMilliseconds * static_cast<double>(row.walkSteps);
    seconds[0].push_back(heat.seconds);
    seconds[1].push_back(publishedHeatSeconds);
    seconds[2].push_back(walk.seconds);
    seconds[3].push_back(publishedWalkSeconds);
    table.AddRow(
      Cells() << row.name + std::string(real ? "" : " (phantom of this size)")
              << std::to_string(row.size[0]) + " x " + std::to_string(row.size[1]) + " x " + std::to_string(row.size[2])
              << row.p << row.heatSteps << row.walkSteps << row.heatMilliseconds
              << Rounded(1000.0 * heat.seconds / static_cast<double>(heat.steps), 2) << row.walkMilliseconds
              << Rounded(1000.0 * walk.seconds / static_cast<double>(walk.steps), 2) << Rounded(publishedHeatSeconds)
              << Rounded(heat.seconds) << Rounded(publishedWalkSeconds) << Rounded(walk.seconds));
  }
  report.AddText("## Table 3.2: published and measured times\n\n65,000 shapetons, distance 0.01, published rule, seed "
                 "1. Published times are from a GeForce GTX 480, ours from a CPU. Our CHD evaluates all steps by one "
                 "Chebyshev expansion; its time per step is the total divided by the steps.");
  report.AddRows("published", table);
  const auto range = [&](int i) {
    const auto [least, most] = std::minmax_element(seconds[i].begin(), seconds[i].end());
    return Rounded(*least) + " to " + Rounded(*most);
  };
  report.AddText("Seconds, ours and published: CHD " + range(0) + " and " + range(1) + "; shapetons " + range(2) +
                 " and " + range(3) + ".");
}
