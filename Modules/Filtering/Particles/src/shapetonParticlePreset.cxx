#include "shapetonParticlePreset.h"

#include "shapetonExceptions.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonReducedVolume.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace shapeton
{
namespace
{
constexpr double wantedVisits = 200.0; // per voxel; fewer merge similar objects in the histogram
constexpr double mostVisits = 1e8;     // of all voxels; about 25 seconds of one core
/** Fewer shapetons do not sample the initial heat of small objects; more would leave too few steps in large volumes. */
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

/** Throws ParameterError for a name that no option has. */
void
RequireNames(const Names & given, const ShapetonPresetOptions & options)
{
  Names known;
  ShapetonPresetOptions::VisitOptions(
    options, [&known](const OptionInfo & info, const auto &) { known.push_back(info.GetName()); });
  for (const std::string & name : given)
  {
    RequireParameter(IsAmong(known, name), "\"" + name + "\" is not the name of a parameter of shapeton diffusion");
  }
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
VoxelsOf(const VolumeView & volume)
{
  return static_cast<double>(volume.NumberOfVoxels());
}

/** Total number of visits. */
double
VisitsOf(const VolumeView & volume)
{
  return std::min(wantedVisits * VoxelsOf(volume), mostVisits);
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

/** The given parameters of a heat diffusion that lasts as long as the walk. */
GivenHeatParameters
GivenOfHeat(const Names & given, const ParticleDiffusionOptions & options, double heatStepsPerStep)
{
  GivenHeatParameters parameters = GivenAmong(given, options);
  if (parameters.timeSteps)
  {
    const double steps = static_cast<double>(options.timeSteps) * heatStepsPerStep / durationPerTime;
    parameters.timeSteps = static_cast<std::uint64_t>(std::clamp(std::round(steps), 1.0, mostHeatSteps));
  }
  return parameters;
}

/** Window, p, smoothing, time steps and number of shapetons from the intensities; returns the reasons. */
HeatParameterChoice
ChooseByHeat(const VolumeView &         volume,
             ShapetonPreset             preset,
             const Names &              given,
             ParticleDiffusionOptions & options,
             const Progress &           progress)
{
  CumulativeHeatDiffusionOptions heat;
  static_cast<VolumeDiffusionOptions &>(heat) = options;
  const double smallest = SmallestSpacing(volume.spacing);
  const double perStep = EquivalentHeatTimeSteps(
    1.0, options.distance * LongestSide(volume.size, volume.spacing) / smallest, heat.timeStepLength);
  const auto               choice = ChooseHeatParameters(volume, heat, GivenOfHeat(given, options, perStep), progress);
  ParticleDiffusionOptions chosen = options;
  choice.ApplyTo(chosen);
  chosen.timeSteps = options.timeSteps;
  const double visits = VisitsOf(volume);
  if (preset == ShapetonPreset::Objects)
  {
    const double most = visits / std::clamp(VoxelsOf(volume) / voxelsPerShapeton, leastShapetons, usualShapetons);
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

ShapetonParameterChoice
ChooseShapetonParameters(const VolumeView &               volume,
                         const ShapetonPresetOptions &    options,
                         const std::vector<std::string> & given,
                         const Progress &                 progress)
{
  CheckOptions(options);
  RequireNames(given, options);
  ShapetonParameterChoice choice;
  choice.options = options;
  Names kept = given;
  kept.insert(kept.end(), { "seed", "untilSteady", "epsilon", "device" }); // no preset determines them
  TakeOthers(OptionsOfPreset(options.preset, volume.size, volume.spacing), kept, choice.options);
  if (options.preset != ShapetonPreset::Published)
  {
    choice.heat = ChooseByHeat(volume, options.preset, given, choice.options, progress);
  }
  if (options.featureSize > 0.0)
  {
    choice.feature = ChooseShapetons(volume.size, volume.spacing, options.featureSize, choice.options.timeSteps);
    choice.options.distance = choice.feature.distance;
    if (IsAmong(given, "shapetons"))
    {
      choice.feature.shapetonsReason.clear();
    }
    else
    {
      choice.options.shapetons = choice.feature.shapetons;
    }
  }
  return choice;
}
} // namespace shapeton
