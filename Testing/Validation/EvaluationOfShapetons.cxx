// Do shapetons separate objects? Walks and presets on phantoms with known labels, at seeds that were not used to choose
// defaults.
#include "Tables.h"
#include "ShapetonComparison.h"

#include "shapetonParallelFor.h"
#include "shapetonPhiloxStream.h"
#include "shapetonPi.h"
#include "shapetonTestImages.h"
#include "shapetonVisitDensity.h"

#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <mutex>

using namespace shapeton;

namespace
{
constexpr double       steepness = 7.0;
constexpr unsigned int sideOfPhantoms = 48;
constexpr double       wantedVisits = 200.0; // per voxel; those of the presets that are not published

/** Scenes that were not used to choose defaults. Lengths as in the presets of ShapePhantom. */
const std::vector<std::pair<std::string, const char *>> heldOutScenes = {
  { "ring, rod, disk", R"({ "units": "relative", "background": 0, "objects": [
    { "name": "ring", "kind": "torus", "ringRadius": 0.16, "tubeRadius": 0.06, "center": [-0.18, 0, 0],
      "intensity": 1000, "label": 1 },
    { "name": "rod", "kind": "capsule", "radius": 0.05, "length": 0.4, "center": [0.14, -0.2, 0],
      "intensity": 1000, "label": 2 },
    { "name": "disk", "kind": "cylinder", "radius": 0.16, "length": 0.14, "center": [0.22, 0.16, 0],
      "intensity": 1000, "label": 3 } ] })" },
  { "ellipsoids", R"({ "units": "relative", "background": 0, "objects": [
    { "name": "cigar", "kind": "ellipsoid", "radii": [0.07, 0.07, 0.26], "center": [-0.3, 0, 0],
      "intensity": 1000, "label": 1 },
    { "name": "egg", "kind": "ellipsoid", "radii": [0.14, 0.14, 0.2], "center": [-0.04, 0, 0],
      "intensity": 1000, "label": 2 },
    { "name": "pancake", "kind": "ellipsoid", "radii": [0.07, 0.26, 0.26], "center": [0.25, 0, 0],
      "intensity": 1000, "label": 3 } ] })" }
};

// ---- the interpolated walk ----

constexpr std::uint32_t purposeOfWalk = 0x496E7470U;

/** The scaled intensities of a volume between the centers of its voxels. */
class Interpolator
{
public:
  Interpolator(const TrialVolume & volume, double p)
    : m_Values(volume.image->GetBufferPointer())
    , m_Size(volume.image->GetLargestPossibleRegion().GetSize())
    , m_Steepness(p / (volume.upper - volume.lower))
  {}

  double
  operator()(const Eigen::Array3d & place) const
  {
    std::size_t low[3], high[3];
    double      share[3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double at = std::clamp(place[axis] - 0.5, 0.0, static_cast<double>(m_Size[axis] - 1));
      low[axis] = static_cast<std::size_t>(at);
      high[axis] = std::min<std::size_t>(low[axis] + 1, m_Size[axis] - 1);
      share[axis] = at - static_cast<double>(low[axis]);
    }
    const auto row = [&](std::size_t y, std::size_t z) {
      const float * const values = m_Values + (z * m_Size[1] + y) * m_Size[0];
      return values[low[0]] + share[0] * (values[high[0]] - values[low[0]]);
    };
    const auto plane = [&](std::size_t z) { return row(low[1], z) + share[1] * (row(high[1], z) - row(low[1], z)); };
    return plane(low[2]) + share[2] * (plane(high[2]) - plane(low[2]));
  }

  /** Edge weight between two intensities, see VolumeGradientOperator. */
  double
  Weight(double a, double b) const
  {
    return std::max(0.0, 1.0 - m_Steepness * std::abs(a - b));
  }

  std::size_t
  VoxelAt(const Eigen::Array3d & place) const
  {
    const auto index = [&](unsigned int axis) { return static_cast<std::size_t>(place[axis]); };
    return (index(2) * m_Size[1] + index(1)) * m_Size[0] + index(0);
  }

  /** Reflects a position at the border of the volume. */
  void
  Reflect(Eigen::Array3d & place) const
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto       side = static_cast<double>(m_Size[axis]);
      constexpr double margin = 1e-9; // keeps it inside
      place[axis] = place[axis] < 0.0 ? -place[axis] : place[axis] > side ? 2.0 * side - place[axis] : place[axis];
      place[axis] = std::clamp(place[axis], 0.0, side - margin);
    }
  }

private:
  const float * m_Values;
  itk::Size<3>  m_Size;
  double        m_Steepness;
};

Eigen::Array3d
AnyDirection(PhiloxStream & random)
{
  const double z = 2.0 * random.Unit() - 1.0, angle = shapeton::TwoPi * random.Unit();
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/** (8.3) and (8.4) for the octant of a direction. */
double
RadiusOf(const Eigen::Array3d & weights, const Eigen::Array3d & direction)
{
  const Eigen::Array3d d = direction.abs();
  const double         u = 2.0 / shapeton::Pi * std::acos(std::min(1.0, d[0]));
  const double         s = 2.0 / shapeton::Pi * std::atan2(d[2], d[1]);
  return weights[0] * (1.0 - u) + (weights[1] * (1.0 - s) + weights[2] * s) * u;
}

/** Moves by solid angle: rejection sampling with the cube of the radius. Does not move if all weights are 0. */
void
MoveByWeights(const Interpolator & volume, double step, PhiloxStream & random, Eigen::Array3d & place)
{
  const double   here = volume(place);
  Eigen::Array3d weights[2]; // backwards, forwards
  double         greatest = 0.0;
  for (unsigned int edge = 0; edge < 6; ++edge)
  {
    Eigen::Array3d there = place;
    there[edge / 2] += edge % 2 == 0 ? -1.0 : 1.0;
    weights[edge % 2][edge / 2] = volume.Weight(here, volume(there));
    greatest = std::max(greatest, weights[edge % 2][edge / 2]);
  }
  while (greatest > 0.0)
  {
    const Eigen::Array3d direction = AnyDirection(random);
    const Eigen::Array3d octant = (direction < 0.0).select(weights[0], weights[1]);
    if (random.Unit() < std::pow(RadiusOf(octant, direction) / greatest, 3.0))
    {
      place += step * direction;
      return;
    }
  }
}

/** Moves by a uniform direction with the weight of the step. */
void
MoveByStep(const Interpolator & volume, double step, PhiloxStream & random, Eigen::Array3d & place)
{
  Eigen::Array3d there = place + step * AnyDirection(random);
  volume.Reflect(there);
  if (random.Unit() < volume.Weight(volume(place), volume(there)))
  {
    place = there;
  }
}
/** Trial of shapetons whose edge weights are interpolated at their position, an interpretation of 3.2 that Shapeton
 * does not offer: the six weights follow from the trilinear intensities at the shapeton and one voxel away from it
 * along each axis. Directions are drawn by solid angle, and steps jump over walls. With ParticlePlacement::InitialHeat,
 * directions are uniform instead, and a step is taken with a probability equal to the weight between the intensities at
 * its ends; otherwise the shapeton stays. Voxels must be cubes. */
Trial
RunInterpolatedShapetons(const TrialVolume &  volume,
                         double               p,
                         const WalkSettings & settings,
                         ParticlePlacement    placement,
                         std::uint64_t        seed)
{
  ParticleDiffusionOptions start; // only to place the shapetons
  start.p = p;
  start.intensityWindow = { { volume.lower, volume.upper } };
  start.shapetons = settings.shapetons;
  start.placement = placement;
  start.seed = seed;
  const auto      size = volume.image->GetLargestPossibleRegion().GetSize();
  const Stopwatch watch;
  Trial           trial;
  trial.visits = NewImageOn<itk::Image<std::uint32_t, 3>>(volume.image, true);
  std::uint32_t * const   visits = trial.visits->GetBufferPointer();
  const ParticleDiffusion places(
    VolumeView(volume.image->GetBufferPointer(), { { size[0], size[1], size[2] } }), start, nullptr, visits);
  const Interpolator interpolator(volume, p);
  const double       step = StepInVoxels(volume, settings.distance);
  const unsigned int workers = NumberOfThreads();
  std::mutex         mutex;
  ParallelWorkers(workers, [&](unsigned int worker) {
    std::vector<std::uint32_t> own(volume.GetNumberOfVoxels());
    for (std::uint32_t shapeton = worker; shapeton < settings.shapetons; shapeton += workers)
    {
      PhiloxStream   random(seed, shapeton, purposeOfWalk);
      Eigen::Array3d place(places.GetPlaces(0)[shapeton], places.GetPlaces(1)[shapeton], places.GetPlaces(2)[shapeton]);
      for (std::uint64_t i = 0; i < settings.steps; ++i)
      {
        (placement == ParticlePlacement::InitialHeat ? MoveByStep : MoveByWeights)(interpolator, step, random, place);
        interpolator.Reflect(place);
        ++own[interpolator.VoxelAt(place)];
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    std::transform(own.begin(), own.end(), visits, visits, std::plus<>());
  });
  trial.field = NormalizeVisits(trial.visits);
  trial.seconds = watch.ProcessorSeconds();
  return trial;
}

// ---- phantoms and methods ----

struct Phantom
{
  std::string name; ///< of the column
  TrialVolume volume;
};

std::vector<Phantom>
TunedPhantoms(const itk::Size<3> & size)
{
  std::vector<Phantom> phantoms;
  for (const auto & [name, preset] : std::vector<std::pair<std::string, std::string>>{ { "2.7a", "figure2.7a" },
                                                                                       { "2.7b", "figure2.7b" },
                                                                                       { "3.4", "figure3.4" },
                                                                                       { "3.5", "figure3.5" },
                                                                                       { "hydrogen", "hydrogen" },
                                                                                       { "vessels", "vessels" } })
  {
    phantoms.push_back({ name, MakeTrialPhantom(preset, size) });
  }
  return phantoms;
}

std::vector<Phantom>
HeldOutPhantoms(const itk::Size<3> & size)
{
  std::vector<Phantom> phantoms;
  for (const auto & [name, scene] : heldOutScenes)
  {
    phantoms.push_back(
      { name, MakeTrialScene(name, ShapeScene::FromJson(nlohmann::ordered_json::parse(scene), name), size) });
  }
  return phantoms;
}

enum class Variant
{
  None,
  SolidAngle,
  ShortSolidAngle, ///< with 200 visits per voxel, as the other presets have
  FromObjects
};

/** ShapetonDiffusion with a preset and otherwise its defaults, except for the variant. */
Trial
RunPreset(const TrialVolume & volume, ShapetonPreset preset, Variant variant, std::uint64_t seed)
{
  auto filter = ParticleDiffusionImageFilter<itk::Image<float, 3>>::New();
  filter->SetInput(volume.image);
  filter->SetSeed(seed);
  std::vector<std::string> given{ "seed" };
  if (variant == Variant::SolidAngle || variant == Variant::ShortSolidAngle)
  {
    filter->SetDirectionSampling(DirectionSampling::SolidAngle);
    given.push_back("directionSampling");
  }
  if (variant == Variant::ShortSolidAngle)
  {
    filter->SetTimeSteps(static_cast<std::uint64_t>(wantedVisits * static_cast<double>(volume.GetNumberOfVoxels()) /
                                                    filter->GetShapetons()));
    given.push_back("timeSteps");
  }
  if (variant == Variant::FromObjects)
  {
    filter->SetMaskImage(volume.labels);
  }
  ShapetonPresetOptions options;
  static_cast<ParticleDiffusionOptions &>(options) = filter->GetOptions();
  options.preset = preset;
  filter->SetOptions(ChooseShapetonParameters(VolumeView(volume.image.GetPointer()), options, given).options);
  const Stopwatch watch;
  filter->Update();
  Trial trial;
  trial.visits = filter->GetOutput();
  trial.field = NormalizeVisits(trial.visits);
  trial.seconds = watch.ProcessorSeconds();
  return trial;
}

Trial
RunInterpolated(const TrialVolume & volume, ParticlePlacement placement, double stepInVoxels, std::uint64_t seed)
{
  WalkSettings settings;
  settings.distance = stepInVoxels / sideOfPhantoms;
  settings.shapetons = 20000;
  settings.steps =
    static_cast<std::uint64_t>(wantedVisits * static_cast<double>(volume.GetNumberOfVoxels()) / settings.shapetons);
  return RunInterpolatedShapetons(volume, steepness, settings, placement, seed);
}

/** One row of the tables. */
struct Method
{
  std::string                                              name;
  std::function<Trial(const TrialVolume &, std::uint64_t)> run; ///< the second argument is the seed
  bool                                                     isRandom{ true };
};

Method
MethodOf(const std::string & name, ShapetonPreset preset, Variant variant = Variant::None)
{
  return { name,
           [=](const TrialVolume & volume, std::uint64_t seed) { return RunPreset(volume, preset, variant, seed); } };
}

const std::string formerDefaults = "published by solid angle (the former defaults)";
const std::string presentDefaults = "`objects` (the defaults)";

std::vector<Method>
Methods()
{
  return { MethodOf(formerDefaults, ShapetonPreset::Published, Variant::SolidAngle),
           MethodOf("the same, 200 visits per voxel", ShapetonPreset::Published, Variant::ShortSolidAngle),
           MethodOf("`published`", ShapetonPreset::Published),
           MethodOf("`published` from the objects", ShapetonPreset::Published, Variant::FromObjects),
           { "weights at the shapeton, started anywhere",
             [](const TrialVolume & volume, std::uint64_t seed) {
               return RunInterpolated(volume, ParticlePlacement::Uniform, 0.48, seed);
             } },
           { "weights at the shapeton, initial heat",
             [](const TrialVolume & volume, std::uint64_t seed) {
               return RunInterpolated(volume, ParticlePlacement::InitialHeat, 2.0, seed);
             } },
           MethodOf("`surface`", ShapetonPreset::Surface),
           MethodOf(presentDefaults, ShapetonPreset::Objects),
           { "CHD, p = 7, 100,000 steps",
             [](const TrialVolume & volume, std::uint64_t) { return RunHeat(volume, steepness, 100000); },
             false } };
}

/** Adjusted Rand indices of a method on a phantom at all seeds. */
using Indices = std::vector<double>;

double
LeastOf(const Indices & indices)
{
  return *std::min_element(indices.begin(), indices.end());
}

double
GreatestOf(const Indices & indices)
{
  return *std::max_element(indices.begin(), indices.end());
}

std::string
MeanAndRange(const Indices & indices)
{
  const std::string least = Hundredths(LeastOf(indices)), greatest = Hundredths(GreatestOf(indices));
  return Hundredths(MeanOf(indices)) + (least == greatest ? "" : " (" + least + " to " + greatest + ")");
}

/** Runs all methods on all phantoms. */
class Evaluation
{
public:
  Evaluation(const std::vector<Phantom> & phantoms, const std::vector<std::uint64_t> & seeds) : m_Phantoms(phantoms)
  {
    for (const Method & method : Methods())
    {
      this->Try(method, method.isRandom ? seeds : std::vector<std::uint64_t>{ seeds.front() });
    }
  }

  void
  Tabulate(const std::string & name, ValidationReport & report) const
  {
    std::vector<std::string> columns{ "walk" };
    for (const Phantom & phantom : m_Phantoms)
    {
      columns.push_back(phantom.name);
    }
    columns.push_back("CPU seconds");
    CsvTable table(columns);
    for (const Method & method : Methods())
    {
      std::vector<std::string> cells{ method.name };
      for (const Phantom & phantom : m_Phantoms)
      {
        cells.push_back(MeanAndRange(m_Indices.at({ method.name, phantom.name })));
      }
      cells.push_back(Rounded(m_Seconds.at(method.name), 2));
      table.AddRow(std::move(cells));
    }
    report.AddTable(table);
    report.AddRows(name, m_Rows);
  }

  /** Number of phantoms on which `present`, for the indices of the defaults, is greater than `former`, for those of the
   * former defaults. */
  std::size_t
  CountBetter(double (*present)(const Indices &), double (*former)(const Indices &)) const
  {
    return static_cast<std::size_t>(std::count_if(m_Phantoms.begin(), m_Phantoms.end(), [&](const Phantom & phantom) {
      return present(m_Indices.at({ presentDefaults, phantom.name })) >
             former(m_Indices.at({ formerDefaults, phantom.name }));
    }));
  }

private:
  void
  Try(const Method & method, const std::vector<std::uint64_t> & seeds)
  {
    double seconds = 0.0;
    for (const Phantom & phantom : m_Phantoms)
    {
      ValidationReport::Progress(method.name + ": " + phantom.name);
      for (const std::uint64_t seed : seeds)
      {
        const Trial          trial = method.run(phantom.volume, seed);
        const ClassAgreement agreement = CompareClasses(phantom.volume, trial);
        m_Indices[{ method.name, phantom.name }].push_back(agreement.adjustedRand);
        seconds += trial.seconds;
        m_Rows.AddRow(Cells() << method.name << phantom.name << (method.isRandom ? std::to_string(seed) : "")
                              << agreement.classes << Rounded(agreement.adjustedRand, 4));
      }
    }
    m_Seconds[method.name] = seconds / static_cast<double>(m_Phantoms.size() * seeds.size());
  }

  const std::vector<Phantom> &                           m_Phantoms;
  std::map<std::pair<std::string, std::string>, Indices> m_Indices;
  std::map<std::string, double>                          m_Seconds;
  CsvTable m_Rows{ { "walk", "phantom", "seed", "classes", "adjusted Rand index" } };
};

void
Evaluate(const std::string &                name,
         const std::vector<Phantom> &       phantoms,
         const std::vector<std::uint64_t> & seeds,
         ValidationReport &                 report)
{
  const Evaluation evaluation(phantoms, seeds);
  evaluation.Tabulate(name, report);
  const std::string of = " of " + std::to_string(phantoms.size()) + " phantoms";
  const std::size_t better = evaluation.CountBetter(MeanOf, MeanOf);
  report.AddText("By the mean, the defaults are better than the former ones on " + std::to_string(better) + of +
                 " (bound: all): " + report.Check(better == phantoms.size()) + ". At their worst seed, they are " +
                 "better than the former ones at their best on " +
                 std::to_string(evaluation.CountBetter(LeastOf, GreatestOf)) + of + ".");
}
} // namespace

void
ValidateObjectsByShapetons(const ValidationSettings & settings, ValidationReport & report)
{
  const std::vector<std::uint64_t> seeds =
    settings.quick ? std::vector<std::uint64_t>{ 11 } : std::vector<std::uint64_t>{ 11, 12, 13 };
  const auto size = itk::Size<3>::Filled(sideOfPhantoms);
  report.AddText(
    "Adjusted Rand index of classes and objects over the voxels of the objects: mean and range over seeds 11 to 13, "
    "which chose no default. Phantoms of 48^3 voxels. Presets are those of ShapetonDiffusion with its defaults. CPU "
    "seconds are those of a volume, summed over all cores, and not those of a GPU. 'Weights at the shapeton' is the "
    "reading of 3.2 with weights from trilinear intensities at the position of the shapeton, p = 7, 200 visits per "
    "voxel: started anywhere, with directions by solid angle and steps of 0.48 voxels as in the former defaults; or "
    "started by initial heat, with uniform directions and steps of two voxels taken with the weight between their "
    "ends. It is a part of the validation only, and not optimized.");
  report.AddText("## Phantoms that the defaults were chosen on");
  if (settings.quick)
  {
    Evaluate("phantoms", { { "3.4", MakeTrialPhantom("figure3.4", size) } }, seeds, report);
    return;
  }
  Evaluate("phantoms", TunedPhantoms(size), seeds, report);
  report.AddText("## Other phantoms\n\nA ring, a rod and a disk; three ellipsoids. No setting was chosen on them.");
  Evaluate("held-out", HeldOutPhantoms(size), seeds, report);
}
