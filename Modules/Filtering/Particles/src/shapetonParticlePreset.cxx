#include "shapetonParticlePreset.h"

#include "shapetonParticleDiffusion.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace shapeton
{
namespace
{
constexpr double wantedVisits = 200.0; // per voxel; fewer merge similar objects in the histogram
constexpr double mostVisits = 1e8;     // of all voxels; about 25 seconds of one core
/** Fewer shapetons do not sample the initial heat of small objects; those of large volumes need steps, too. */
constexpr double leastShapetons = 2e4;
constexpr double usualShapetons = 2e5;
constexpr double mostShapetons = 1e7;
constexpr double voxelsPerShapeton = 10.0;
/** Visits accumulate from the first step, so their mean time is half of the duration. */
constexpr double durationPerTime = 2.0;
constexpr double mostHeatSteps = 1e6;  // of a trial; more are not quick, and show nothing else
constexpr double leastSteps = 100.0;   // fewer show the initial heat
constexpr double objectStep = 2.0;     // voxels; three times as fast as 1, at 1.4 times the cost per step
constexpr double surfaceStep = 1.0;    // voxels
constexpr double surfaceSteps = 100.0; // standard deviation along each axis: 7 voxels

using Names = std::vector<std::string>;

bool
IsAmong(const Names & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

double
LongestSide(const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing)
{
  double side = 0.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    side = std::max(side, static_cast<double>(size[axis]) * spacing[axis]);
  }
  return side;
}

double
VoxelsOf(const std::array<std::size_t, 3> & size)
{
  return static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(size[2]);
}

/** Total number of visits. */
double
VisitsOf(const std::array<std::size_t, 3> & size)
{
  return std::min(wantedVisits * VoxelsOf(size), mostVisits);
}

/** Copies the options that are not given. */
void
TakeOthers(const ParticleDiffusionOptions & values, const Names & given, ParticleDiffusionOptions & options)
{
  ParticleDiffusionOptions merged = values;
  ParticleDiffusionOptions::VisitOptions(options, [&](const OptionInfo & info, const auto & kept) {
    ParticleDiffusionOptions::VisitOptions(merged, [&](const OptionInfo & other, auto & option) {
      if constexpr (std::is_same_v<std::decay_t<decltype(kept)>, std::decay_t<decltype(option)>>)
      {
        if (std::string(info.GetName()) == other.GetName() && IsAmong(given, info.GetName()))
        {
          option = kept;
        }
      }
    });
  });
  options = merged;
}

GivenHeatParameters
GivenOfHeat(const Names & given, const ParticleDiffusionOptions & options, double heatStepsPerStep)
{
  GivenHeatParameters parameters;
  parameters.intensityWindow = options.intensityWindow;
  if (IsAmong(given, "p"))
  {
    parameters.p = options.p;
  }
  if (IsAmong(given, "smoothing"))
  {
    parameters.smoothing = options.smoothing;
  }
  if (IsAmong(given, "timeSteps"))
  {
    const double steps = static_cast<double>(options.timeSteps) * heatStepsPerStep / durationPerTime;
    parameters.timeSteps = static_cast<std::uint64_t>(std::clamp(std::round(steps), 1.0, mostHeatSteps));
  }
  return parameters;
}
} // namespace

ParticleDiffusionOptions
OptionsOfPreset(ShapetonPreset preset, const std::array<std::size_t, 3> & size, const std::array<double, 3> & spacing)
{
  ParticleDiffusionOptions options;
  if (preset == ShapetonPreset::Published)
  {
    options.directionSampling = DirectionSampling::SectorArea;
    return options;
  }
  options.directionSampling = DirectionSampling::Uniform;
  options.pathRule = PathRule::Traversal;
  options.placement = ParticlePlacement::InitialHeat;
  const double step = preset == ShapetonPreset::Surface ? surfaceStep : objectStep;
  options.distance =
    std::min(1.0, step * *std::min_element(spacing.begin(), spacing.end()) / LongestSide(size, spacing));
  options.timeSteps = static_cast<std::uint64_t>(surfaceSteps);
  return options;
}

HeatParameterChoice
ChooseShapetonParameters(const float *                      intensities,
                         const std::array<std::size_t, 3> & size,
                         const std::array<double, 3> &      spacing,
                         ShapetonPreset                     preset,
                         const std::vector<std::string> &   given,
                         const std::string &                modality,
                         ParticleDiffusionOptions &         options,
                         const Progress &                   progress)
{
  CheckOptions(options);
  TakeOthers(OptionsOfPreset(preset, size, spacing), given, options);
  HeatParameterChoice choice;
  if (preset == ShapetonPreset::Published)
  {
    return choice;
  }
  CumulativeHeatDiffusionSettings settings;
  static_cast<VolumeDiffusionOptions &>(settings) = options;
  settings.spacing = spacing;
  const double smallest = *std::min_element(spacing.begin(), spacing.end());
  const double perStep =
    EquivalentHeatTimeSteps(1.0, options.distance * LongestSide(size, spacing) / smallest, settings.timeStepLength);
  choice = ChooseHeatParameters(intensities, size, settings, GivenOfHeat(given, options, perStep), modality, progress);
  ParticleDiffusionOptions chosen = options;
  if (choice.intensityWindow[0] < choice.intensityWindow[1]) // not a constant volume
  {
    chosen.intensityWindow = choice.intensityWindow;
  }
  chosen.p = choice.p;
  chosen.smoothing = choice.smoothing;
  const double visits = VisitsOf(size);
  if (preset == ShapetonPreset::Objects)
  {
    const double most = visits / std::clamp(VoxelsOf(size) / voxelsPerShapeton, leastShapetons, usualShapetons);
    const double wanted = durationPerTime * static_cast<double>(choice.timeSteps) / perStep;
    chosen.timeSteps = static_cast<std::uint64_t>(std::max(leastSteps, std::round(std::min(wanted, most))));
  }
  TakeOthers(chosen, given, options);
  chosen = options;
  chosen.shapetons = static_cast<std::uint32_t>(
    std::clamp(std::ceil(visits / static_cast<double>(options.timeSteps)), leastShapetons, mostShapetons));
  TakeOthers(chosen, given, options);
  return choice;
}
} // namespace shapeton
