// Open question 7.2.1 of the dissertation: the relation between the number of shapeton steps and scale.
#include "ShapetonTrial.h"
#include "Tables.h"
#include "ValidationChart.h"
#include "ValidationReport.h"
#include "ValidationVolumes.h"

#include "shapetonHeatDiffusionSolver.h"
#include "itkMultiThreaderBase.h"
#include "shapetonParticleDiffusion.h"

using namespace shapeton;

namespace
{
using Density = std::vector<double>; // relative to its mean over a domain, for the voxels of the domain
using Mask = std::vector<unsigned char>;

const WalkRule likeHeat = { "traversal, uniform directions, by initial heat",
                            DirectionSampling::Uniform,
                            PathRule::Traversal,
                            ParticlePlacement::InitialHeat };
const WalkRule solidAngle = { "traversal, by solid angle, by initial heat",
                              DirectionSampling::SolidAngle,
                              PathRule::Traversal,
                              ParticlePlacement::InitialHeat };
const WalkRule published = { "as published: endpoint, by sector area, uniform placement",
                             DirectionSampling::SectorArea,
                             PathRule::Endpoint,
                             ParticlePlacement::Uniform };
const WalkRule repaired = { "endpoint, by solid angle, uniform placement",
                            DirectionSampling::SolidAngle,
                            PathRule::Endpoint,
                            ParticlePlacement::Uniform };

ParticleDiffusionOptions
SettingsOf(const WalkRule & walk, const test::Volume & volume, double p, double stepInVoxels, std::uint32_t shapetons)
{
  ParticleDiffusionOptions settings;
  settings.p = p;
  settings.shapetons = shapetons;
  settings.distance = stepInVoxels / static_cast<double>(*std::max_element(volume.size.begin(), volume.size.end()));
  settings.pathRule = walk.path;
  settings.directionSampling = walk.sampling;
  settings.placement = walk.placement;
  return settings;
}

Mask
MaskOf(const test::Volume & volume)
{
  Mask mask(volume.values.size());
  std::transform(volume.values.begin(), volume.values.end(), mask.begin(), [](float value) { return value > 0.0F; });
  return mask;
}

template <typename TValue>
Density
Relative(const std::vector<TValue> & values, const Mask & domain)
{
  Density density;
  double  sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (domain[i])
    {
      density.push_back(static_cast<double>(values[i]));
      sum += density.back();
    }
  }
  for (double & value : density)
  {
    value *= static_cast<double>(density.size()) / sum;
  }
  return density;
}

/** Visits of the domain after each of `steps`, for several seeds; shapetons start in the domain if `masked`. */
std::vector<std::vector<Density>>
VisitsOf(const test::Volume &               volume,
         ParticleDiffusionOptions           settings,
         unsigned int                       seeds,
         const std::vector<std::uint64_t> & steps,
         const Mask &                       domain,
         bool                               masked)
{
  std::vector<std::vector<Density>> densities(steps.size());
  for (settings.seed = 1; settings.seed <= seeds; ++settings.seed)
  {
    std::vector<std::uint32_t> visits(volume.values.size());
    ParticleDiffusion          diffusion(volume, settings, masked ? domain.data() : nullptr, visits.data());
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      diffusion.Run(steps[i]);
      densities[i].push_back(Relative(visits, domain));
    }
  }
  return densities;
}

/** Mean squared deviation of the expected density from a reference, one value per pair of seeds. Products of
 * deviations of different seeds have independent sampling errors, which cancel on average. */
std::vector<double>
SquaredDeviations(const std::vector<Density> & densities, const Density & reference)
{
  std::vector<double> values;
  for (std::size_t pair = 0; pair + 1 < densities.size(); pair += 2)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i)
    {
      sum += (densities[pair][i] - reference[i]) * (densities[pair + 1][i] - reference[i]);
    }
    values.push_back(sum / static_cast<double>(reference.size()));
  }
  return values;
}

double
Spread(const Density & density)
{
  double squares = 0.0;
  for (const double value : density)
  {
    squares += (value - 1.0) * (value - 1.0);
  }
  return std::sqrt(squares / static_cast<double>(density.size()));
}

/** Root mean square with its interval, in percent of a reference value. */
struct Percent
{
  Percent(const std::vector<double> & squares, double whole)
  {
    const MeanInterval interval(squares);
    const auto         root = [&](double value) { return 100.0 * std::sqrt(std::max(0.0, value)) / whole; };
    value = root(interval.mean);
    text = Rounded(value) + " [" + Rounded(root(interval.lower)) + ", " + Rounded(root(interval.upper)) + "]";
  }
  double      value;
  std::string text;
};

/** Variance of the voxel displacement along an axis per step of a walk without walls. */
double
VarianceOfStep(double stepInVoxels)
{
  return 2.0 * EquivalentHeatTimeSteps(1.0, stepInVoxels, 1.0);
}

void
SpreadOfTheWalk(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("## Variance of a step\n\nTraversal with uniform directions and without walls: variance of the "
                 "displacement along an axis per step, compared with the closed form of EquivalentHeatTimeSteps(). "
                 "Four steps from one voxel of 64^3; bound of each deviation: five standard errors.");
  CsvTable            table({ "step a, voxels", "closed form", "measured per step", "standard error", "" });
  const std::uint32_t shapetons = settings.quick ? 20000 : 500000;
  constexpr double    steps = 4;
  test::Volume        volume({ 64, 64, 64 });
  Mask                start(volume.values.size());
  start[(std::size_t{ 32 } * 64 + 32) * 64 + 32] = 1;
  WalkRule walk = likeHeat;
  walk.placement = ParticlePlacement::Uniform;
  for (const double a : { 0.1, 0.5, 1.0, 1.3, 1.5, 2.0, 2.56, 4.0 })
  {
    std::vector<std::uint32_t> visits(volume.values.size());
    ParticleDiffusion diffusion(volume, SettingsOf(walk, volume, 7.0, a, shapetons), start.data(), visits.data());
    diffusion.Run(static_cast<std::uint64_t>(steps));
    double squares = 0.0, fourths = 0.0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (std::uint32_t i = 0; i < shapetons; ++i)
      {
        const double square = std::pow(std::floor(diffusion.GetPlaces(axis)[i]) - 32.0, 2);
        squares += square / (3.0 * shapetons);
        fourths += square * square / (3.0 * shapetons);
      }
    }
    const double error = std::sqrt((fourths - squares * squares) / (3.0 * shapetons)) / steps;
    table.AddRow(Cells() << a << Rounded(VarianceOfStep(a), 5) << Rounded(squares / steps, 5) << Rounded(error, 2)
                         << report.Check(std::abs(squares / steps - VarianceOfStep(a)) < 5.0 * error));
  }
  report.AddRows("steps", table);
}

/** Closed object of side 12 in 16^3 voxels, surrounded by 0, with two mixed intensity levels. It has either soft edges
 * (all weights strictly between 0 and 1, small between the levels) or only hard walls (all weights 0 or 1). */
test::Volume
ClosedObject(bool hard)
{
  test::Volume volume({ 16, 16, 16 });
  volume.Fill([hard](std::size_t x, std::size_t y, std::size_t z) {
    const bool   inside = std::min({ x, y, z }) >= 2 && std::max({ x, y, z }) < 14;
    const bool   low = test::Noise(x, y, z) < -0.3;
    const double grain = 0.02 * test::Noise(z, x, y);
    return !inside ? 0.0 : hard ? (low ? 0.5 : 1.0) : (low ? 0.56 : 0.99) + grain;
  });
  return volume;
}

/** Mean heat at the times of a walk's steps, by explicit steps of at most 1/96 in double precision. */
Density
MeanHeat(const test::Volume & volume, double p, double stepInVoxels, std::uint64_t steps, const Mask & domain)
{
  const double     duration = 0.5 * VarianceOfStep(stepInVoxels);
  const int        parts = static_cast<int>(std::ceil(96.0 * duration));
  test::BruteForce brute(volume, p, duration / parts);
  Density          sum(volume.values.size());
  for (std::uint64_t step = 1; step <= steps; ++step)
  {
    for (int part = 0; part < parts; ++part)
    {
      brute.Step();
    }
    std::transform(sum.begin(), sum.end(), brute.heat.begin(), sum.begin(), std::plus<double>());
  }
  return Relative(sum, domain);
}

/** Deviation from heat of walks with several step lengths, over the same time. */
Percent
DeviationFromHeat(const ValidationSettings & settings, const WalkRule & walk, bool hard, double a, std::uint64_t steps)
{
  const test::Volume  volume = ClosedObject(hard);
  const double        p = hard ? 7.0 : 2.0;
  const Mask          domain = MaskOf(volume);
  const Density       heat = MeanHeat(volume, p, a, steps, domain);
  const std::uint32_t shapetons = settings.quick ? 30000 : 260000;
  const unsigned int  seeds = settings.quick ? 4 : 8;
  const auto densities = VisitsOf(volume, SettingsOf(walk, volume, p, a, shapetons), seeds, { steps }, domain, true);
  return Percent(SquaredDeviations(densities[0], heat), Spread(heat));
}

void
BiasOfTheWalk(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("## Deviation from heat\n\nClosed objects of 12^3 voxels: 'soft', with weights strictly between 0 and "
                 "1 (about .1 and .98, p = 2), and 'walls', with weights 0 and 1 only. Shapetons placed by initial "
                 "heat walk by traversal. Deviation: root mean square of expected visits minus the mean heat at the "
                 "same times, both relative to their means, in percent of the standard deviation of the heat. Products "
                 "of the deviations of two seeds cancel sampling errors. Duration: about 33 time steps of 1/12.");
  const std::vector<double> lengths =
    settings.quick ? std::vector<double>{ 2.0, 0.5 } : std::vector<double>{ 4.0, 2.0, 1.5, 1.0, 0.7, 0.5, 0.25, 0.1 };
  const double duration = 2.75;
  CsvTable     table(Columns("step a, voxels | steps | uniform directions, soft, % | uniform directions, walls, % | by "
                             "solid angle, soft, % | by solid angle, walls, %"));
  std::vector<ChartSeries> series = {
    { "uniform, soft", {} }, { "uniform, walls", {} }, { "solid angle, soft", {} }, { "solid angle, walls", {} }
  };
  std::array<double, 4> shortest;
  shortest.fill(HUGE_VAL);
  int rises = 0;
  for (const double a : lengths)
  {
    const auto steps = static_cast<std::uint64_t>(std::max(1.0, std::round(2.0 * duration / VarianceOfStep(a))));
    std::vector<std::string> row = { CsvTable::Number(a), std::to_string(steps) };
    for (std::size_t i = 0; i < series.size(); ++i)
    {
      const Percent deviation = DeviationFromHeat(settings, i < 2 ? likeHeat : solidAngle, i % 2 == 1, a, steps);
      if (deviation.value > 0.0)
      {
        series[i].points.emplace_back(a, deviation.value);
      }
      rises += i == 0 && deviation.value > shortest[0] ? 1 : 0;
      shortest[i] = deviation.value;
      row.push_back(deviation.text);
    }
    table.AddRow(row);
  }
  report.AddRows("deviations", table);
  WriteLogarithmicChart(settings.outputFolder + "/shapeton-walk.svg",
                        "step, voxels",
                        "deviation from heat, % of its standard deviation",
                        series);
  report.AddText("![Deviation from heat by step](shapeton-walk.svg)");
  const double bound = settings.quick ? 15.0 : 5.0; // fewer samples
  report.AddText(
    "With uniform directions the deviation falls with the step (times it grows for a shorter step: " +
    std::to_string(rises) + ", bound 1: " + report.Check(rises <= 1) + "), to less than " + CsvTable::Number(bound) +
    " % for the shortest step: " + report.Check(shortest[0] < bound && shortest[1] < bound) +
    ". With directions by solid angle it stays above 30 %: " + report.Check(shortest[2] > 30.0 && shortest[3] > 30.0) +
    ". A weight then counts twice, in the direction and at the face, and more shapetons leave a wall than reach it.");
}

constexpr std::size_t cubeSide = 40;
/** Steps equivalent to two time steps of 1/12. */
constexpr double stepOfFigure = 2.0 / 3.0;

/** Mean visits near the corners, edges and faces of the cube of figure 2.4 (less than 2 voxels from three, two or one
 * sides, at least 10 from the others) and around its center. */
std::array<double, 4>
MeansOfRegions(const Density & density)
{
  std::array<double, 4> sums{}, numbers{};
  for (std::size_t i = 0; i < density.size(); ++i)
  {
    int near = 0, far = 0;
    for (const std::size_t index : { i % cubeSide, i / cubeSide % cubeSide, i / cubeSide / cubeSide })
    {
      const std::size_t depth = std::min(index, cubeSide - 1 - index);
      near += depth < 2;
      far += depth >= 10;
    }
    if (near + far == 3)
    {
      sums[3 - near] += density[i];
      numbers[3 - near] += 1.0;
    }
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    sums[i] /= numbers[i];
  }
  return sums;
}

/** Mean heat of the cube over every second time step up to each of `times`. */
std::vector<Density>
MeanHeatOfCube(const test::Volume & volume, const Mask & domain, const std::vector<std::uint64_t> & times)
{
  const VolumeGradientOperator volumeGradient(volume);
  PaddedField                  heat(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(heat);
  std::vector<std::uint64_t> steps;
  for (std::uint64_t step = 2; step <= times.back(); step += 2)
  {
    steps.push_back(step);
  }
  // One field per worker and time interval.
  std::vector<std::vector<Density>> sums(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads(),
                                         std::vector<Density>(times.size(), Density(volume.values.size())));
  HeatDiffusionSolver               solver(volumeGradient, HeatDiffusionSolver::Method::Chebyshev, 1.0 / 12.0, 1e-5);
  solver.Run(heat, times.back(), steps, [&](std::size_t i, std::size_t row, const float * values, unsigned int worker) {
    const auto     piece = std::lower_bound(times.begin(), times.end(), steps[i]) - times.begin();
    double * const sum = sums[worker][piece].data() + row * volume.size[0];
    std::transform(sum, sum + volume.size[0], values, sum, std::plus<double>());
  });
  std::vector<Density> means;
  Density              whole(volume.values.size());
  for (std::size_t piece = 0; piece < times.size(); ++piece)
  {
    for (const auto & one : sums)
    {
      std::transform(whole.begin(), whole.end(), one[piece].begin(), whole.begin(), std::plus<double>());
    }
    means.push_back(Relative(whole, domain));
  }
  return means;
}

/** Correlation of the expected visits with heat over the voxels; sampling errors would reduce the correlation of the
 * visits. */
double
CorrelationOfExpectation(const std::vector<Density> & densities, const Density & heat)
{
  double products = 0.0;
  for (const Density & density : densities)
  {
    for (std::size_t i = 0; i < heat.size(); ++i)
    {
      products += (density[i] - 1.0) * (heat[i] - 1.0) / static_cast<double>(heat.size() * densities.size());
    }
  }
  const double variance = MeanInterval(SquaredDeviations(densities, Density(heat.size(), 1.0))).mean;
  return variance > 0.0 ? products / (Spread(heat) * std::sqrt(variance)) : 0.0;
}

/** Means of the regions with their intervals over seeds, and the correlation. */
struct StateOfCube
{
  StateOfCube(const std::vector<Density> & densities, const Density & heat)
    : correlation(CorrelationOfExpectation(densities, heat))
  {
    std::array<std::vector<double>, 4> values;
    for (const Density & density : densities)
    {
      const auto regions = MeansOfRegions(density);
      for (unsigned int i = 0; i < 4; ++i)
      {
        values[i].push_back(regions[i]);
      }
    }
    for (unsigned int i = 0; i < 4; ++i)
    {
      means[i] = MeanInterval(values[i]).mean;
      cells.push_back(MeanWithInterval(values[i]));
    }
    cells.push_back(Rounded(correlation));
  }

  double                   correlation;
  std::array<double, 4>    means{};
  std::vector<std::string> cells;
};

/** "FAIL" if one of the checks has failed; "" without checks. */
std::string
ResultOf(const std::vector<std::string> & checks)
{
  return std::find(checks.begin(), checks.end(), "FAIL") != checks.end() ? "FAIL" : checks.front();
}

void
ScaleOfStates(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    "## Scale by time: figure 7.1\n\nThe cube of figure 2.4, side 40 in 64^3 voxels, p = 7, steps of 2/3 voxel. Visits "
    "near corners, edges and faces (2 voxels deep) and around the center, and their correlation over the cube with the "
    "mean heat of the steps up to t. The numbers of steps of the walks correspond to the spread of t time steps of "
    "heat: t / 2 by traversal, 1.125 t by endpoints, where a step has the variance a^2 / 3.");
  const test::Volume               volume = Cube(64, cubeSide);
  const Mask                       domain = MaskOf(volume);
  const std::vector<std::uint64_t> times =
    settings.quick ? std::vector<std::uint64_t>{ 10, 100 } : std::vector<std::uint64_t>{ 10, 100, 1000, 10000 };
  const auto         heats = MeanHeatOfCube(volume, domain, times);
  const unsigned int seeds = settings.quick ? 2 : 4;
  CsvTable           table({ "t", "process", "corners", "edges", "faces", "center", "correlation with heat", "" });
  const std::array<WalkRule, 4>           walks{ likeHeat, solidAngle, published, repaired };
  std::array<std::vector<std::string>, 4> correlations, checks;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double             t = static_cast<double>(times[i]);
    const auto               heat = MeansOfRegions(heats[i]);
    std::vector<std::string> row = { std::to_string(times[i]), "heat" };
    for (const double value : heat)
    {
      row.push_back(Rounded(value, 4));
    }
    row.insert(row.end(), { "1", "" });
    table.AddRow(row);
    for (std::size_t w = 0; w < walks.size(); ++w)
    {
      const WalkRule & walk = walks[w];
      const bool       masked = walk.placement == ParticlePlacement::InitialHeat;
      const auto       steps = static_cast<std::uint64_t>(std::round(masked ? t / 2.0 : 1.125 * t));
      const auto       shapetons =
        static_cast<std::uint32_t>(std::clamp((settings.quick ? 2e6 : 5e7) / static_cast<double>(steps), 20000.0, 1e6));
      const auto densities =
        VisitsOf(volume, SettingsOf(walk, volume, 7.0, stepOfFigure, shapetons), seeds, { steps }, domain, masked);
      const StateOfCube state(densities[0], heats[i]);
      row = { std::to_string(times[i]), walk.name };
      row.insert(row.end(), state.cells.begin(), state.cells.end());
      const auto & means = state.means;
      const bool   like = means[0] > means[1] && means[1] > means[2] && means[2] > means[3] && state.correlation > 0.98;
      row.push_back(walk.sampling == DirectionSampling::Uniform ? report.Check(like)
                    : masked                                    ? ""
                                                                : report.Check(state.correlation < 0.0));
      table.AddRow(row);
      correlations[w].push_back(state.cells.back());
      checks[w].push_back(row.back());
    }
  }
  std::vector<std::string> columns{ "correlation with heat" };
  for (const std::uint64_t time : times)
  {
    columns.push_back("t = " + std::to_string(time));
  }
  columns.insert(columns.end(), { "bound", "" });
  CsvTable summary(columns);
  for (std::size_t w = 0; w < walks.size(); ++w)
  {
    const std::string        bound = walks[w].sampling == DirectionSampling::Uniform
                                       ? "above 0.98, corners > edges > faces > center"
                                     : walks[w].placement == ParticlePlacement::InitialHeat ? ""
                                                                                            : "below 0";
    std::vector<std::string> row{ walks[w].name };
    row.insert(row.end(), correlations[w].begin(), correlations[w].end());
    row.insert(row.end(), { bound, ResultOf(checks[w]) });
    summary.AddRow(row);
  }
  report.AddTable(summary);
  report.AddRows("states", table);
  report.AddText("Figure 7.1 is correct: the published process shows no local shape. It starts without local shape and "
                 "builds up a depletion along the walls, deepest at the corners, the opposite of heat.");
}

void
UniformPlacement(const ValidationSettings & settings, ValidationReport & report)
{
  constexpr std::size_t side = 32, object = 16;
  const test::Volume    volume = Cube(side, object);
  const Mask            domain(volume.values.size(), 1);
  const std::uint32_t   shapetons = settings.quick ? 32768 : 131072;
  const std::uint64_t   steps = settings.quick ? 30 : 100;
  report.AddText(
    "## Uniform placement\n\nA cube of side 16 in 32^3 voxels, p = 7, shapetons placed uniformly, " +
    std::to_string(steps) +
    " steps of one voxel. Standard deviation of the expected visits over the voxels, in percent of their mean.");
  double   largestOfUniform = 0.0, smallestOfOthers = HUGE_VAL;
  CsvTable table({ "path", "directions", "standard deviation, %", "layer inside", "layer outside", "" });
  for (const PathRule path : { PathRule::Traversal, PathRule::Endpoint })
  {
    for (const DirectionSampling sampling :
         { DirectionSampling::Uniform, DirectionSampling::SolidAngle, DirectionSampling::SectorArea })
    {
      const WalkRule walk = { "", sampling, path, ParticlePlacement::Uniform };
      const auto     densities = VisitsOf(
        volume, SettingsOf(walk, volume, 7.0, 1.0, shapetons), settings.quick ? 4 : 8, { steps }, domain, false)[0];
      const Percent                      deviation(SquaredDeviations(densities, Density(domain.size(), 1.0)), 1.0);
      std::array<std::vector<double>, 2> layers;
      for (const Density & density : densities)
      {
        // The center of the cube's first face along x, where neighbors are on the same sides.
        std::array<double, 2> sums{};
        for (std::size_t z = 10; z < 22; ++z)
        {
          for (std::size_t y = 10; y < 22; ++y)
          {
            sums[0] += density[(z * side + y) * side + 8] / 144.0;
            sums[1] += density[(z * side + y) * side + 7] / 144.0;
          }
        }
        layers[0].push_back(sums[0]);
        layers[1].push_back(sums[1]);
      }
      const bool uniform = sampling == DirectionSampling::Uniform;
      (uniform ? largestOfUniform : smallestOfOthers) =
        uniform ? std::max(largestOfUniform, deviation.value) : std::min(smallestOfOthers, deviation.value);
      table.AddRow(Cells() << (path == PathRule::Traversal ? "traversal" : "endpoint") << NameOf(sampling)
                           << deviation.text << MeanWithInterval(layers[0]) << MeanWithInterval(layers[1])
                           << report.Check(uniform ? deviation.value < 2.0 : deviation.value > 4.0));
    }
  }
  report.AddRows("uniform", table);
  report.AddText("Largest with uniform directions: " + Rounded(largestOfUniform) +
                 " % (bound 2 %). Smallest with other directions: " + Rounded(smallestOfOthers) +
                 " % (bound 4 %). A walk with a symmetric transition matrix keeps a uniform density, so uniform "
                 "placement shows nothing. All contrast of the published process is caused by its directions, which "
                 "point away from walls: both sides of a wall are visited less, regardless of the object's shape.");
}

/** Replaces each voxel by `factor`^3 voxels. */
test::Volume
Upsampled(const test::Volume & volume, std::size_t factor)
{
  test::Volume fine({ volume.size[0] * factor, volume.size[1] * factor, volume.size[2] * factor });
  fine.Fill([&](std::size_t x, std::size_t y, std::size_t z) {
    return volume.values[(z / factor * volume.size[1] + y / factor) * volume.size[0] + x / factor];
  });
  return fine;
}

/** Sums over blocks of `factor`^3 voxels, relative to their mean. */
Density
Blocks(const Density & fine, const test::Size & size, std::size_t factor)
{
  std::vector<double> sums(size[0] * size[1] * size[2]);
  for (std::size_t i = 0; i < fine.size(); ++i)
  {
    const std::size_t x = i % (size[0] * factor) / factor;
    const std::size_t y = i / (size[0] * factor) % (size[1] * factor) / factor;
    const std::size_t z = i / (size[0] * factor) / (size[1] * factor) / factor;
    sums[(z * size[1] + y) * size[0] + x] += fine[i];
  }
  return Relative(sums, Mask(sums.size(), 1));
}

/** A ball, a box and a plate two voxels thick, each with a different intensity. */
test::Volume
Objects()
{
  test::Volume volume({ 32, 32, 32 });
  volume.Fill([](double x, double y, double z) {
    const bool ball = std::hypot(x - 9.0, y - 9.0, z - 10.0) < 6.2;
    const bool box = x >= 19 && x < 28 && y >= 6 && y < 14 && z >= 8 && z < 24;
    const bool plate = x >= 6 && x < 26 && y >= 22 && y < 24 && z >= 6 && z < 26;
    return ball ? 0.4 : box ? 0.7 : plate ? 1.0 : 0.0;
  });
  return volume;
}

/** Mean visits of the object with an intensity, for each seed. */
std::vector<double>
MeansOfObject(const test::Volume & volume, float intensity, const std::vector<Density> & densities)
{
  std::vector<double> means;
  const double        number = static_cast<double>(std::count(volume.values.begin(), volume.values.end(), intensity));
  for (const Density & density : densities)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < density.size(); ++i)
    {
      sum += volume.values[i] == intensity ? density[i] : 0.0;
    }
    means.push_back(sum / number);
  }
  return means;
}

std::vector<double>
Differences(const std::vector<double> & a, const std::vector<double> & b)
{
  std::vector<double> differences(a.size());
  std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<double>());
  return differences;
}

constexpr std::size_t cuts = 4; // subdivisions of a voxel along each axis

/** Rows of a walk: its objects in the coarse and in the fine volume, with the fine visits summed over coarse voxels. */
void
AddObjects(const test::Volume &         volume,
           const WalkRule &             walk,
           double                       shapetons,
           const std::vector<Density> & coarse,
           const std::vector<Density> & fine,
           CsvTable &                   table,
           CsvTable &                   summary,
           ValidationReport &           report)
{
  const Density        ones(volume.values.size(), 1.0);
  std::vector<Density> deviations;
  for (std::size_t seed = 0; seed < coarse.size(); ++seed)
  {
    deviations.push_back(Differences(fine[seed], coarse[seed]));
  }
  const double             whole = std::sqrt(std::max(1e-12, MeanInterval(SquaredDeviations(coarse, ones)).mean));
  const Percent            between(SquaredDeviations(deviations, Density(ones.size(), 0.0)), whole);
  double                   largest = 0.0;
  std::vector<std::string> checks;
  for (const auto & [name, intensity] : { std::make_pair("ball", 0.4F), { "box", 0.7F }, { "plate", 1.0F } })
  {
    const auto a = MeansOfObject(volume, intensity, coarse);
    const auto b = MeansOfObject(volume, intensity, fine);
    // Hard walls: shapetons cannot leave their object, so the numbers per object are binomial.
    const double voxels = static_cast<double>(std::count(volume.values.begin(), volume.values.end(), intensity));
    const double mean = MeanInterval(a).mean;
    const double share = mean * voxels / static_cast<double>(ones.size());
    const double error = mean * std::sqrt(2.0 * (1.0 - share) / (share * shapetons * static_cast<double>(a.size())));
    const double difference = MeanInterval(b).mean - mean;
    checks.push_back(walk.path == PathRule::Traversal ? report.Check(std::abs(difference) < 5.0 * error) : "");
    largest = std::max(largest, std::abs(difference));
    table.AddRow(Cells() << walk.name << name << MeanWithInterval(a) << MeanWithInterval(b)
                         << MeanWithInterval(Differences(b, a)) << checks.back() << between.text);
  }
  summary.AddRow(Cells() << walk.name << Rounded(largest, 4) << (checks.front().empty() ? "" : "five standard errors")
                         << ResultOf(checks) << between.text);
}

void
ResolutionOfTheResult(const ValidationSettings & settings, ValidationReport & report)
{
  const test::Volume  coarse = Objects();
  const test::Volume  fine = Upsampled(coarse, cuts);
  const Mask          all(coarse.values.size(), 1);
  const Mask          allFine(fine.values.size(), 1);
  const std::uint64_t steps = settings.quick ? 20 : 200;
  const std::uint32_t shapetons = settings.quick ? 10000 : 65536;
  const unsigned int  seeds = settings.quick ? 2 : 6;
  report.AddText("## Resolution of the volume\n\nA ball, a box and a thin plate in 32^3 voxels, and the same with each "
                 "voxel cut into 4^3; distance .05 (1.6 and 6.4 voxels), " +
                 std::to_string(steps) +
                 " steps, p = 7. Difference: change of the visits per mm^3 of an object, relative to the mean of the "
                 "volume. Standard deviation: of the change of the expected visits of coarse voxels, in percent of "
                 "that of the coarse visits.");
  CsvTable table({ "walk", "object", "32^3", "128^3", "difference", "", "standard deviation between them, %" });
  CsvTable summary({ "walk", "largest difference of an object", "bound", "", "standard deviation between them, %" });
  for (const WalkRule & walk : { likeHeat, solidAngle, published, repaired })
  {
    const auto visits =
      VisitsOf(coarse, SettingsOf(walk, coarse, 7.0, 1.6, shapetons), seeds, { steps }, all, false)[0];
    auto fineVisits = VisitsOf(fine, SettingsOf(walk, fine, 7.0, 6.4, shapetons), seeds, { steps }, allFine, false)[0];
    for (Density & density : fineVisits)
    {
      density = Blocks(density, coarse.size, cuts);
    }
    AddObjects(coarse, walk, shapetons, visits, fineVisits, table, summary, report);
  }
  report.AddTable(summary);
  report.AddRows("resolution", table);
  report.AddText("The published result depends on the resolution. Its directions differ from uniform ones only in the "
                 "voxel layer next to a wall, which a longer step leaves immediately, so the contrast vanishes with "
                 "finer voxels. By traversal from initial heat, the share of each object is unchanged, and with "
                 "uniform directions also the density inside the objects.");
}
} // namespace

void
ValidateWalkOfShapetons(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Section 7.2.1 of the dissertation asks how the scale of the shape information depends on the step of "
                 "the stochastic method. Answer: shapetons placed by initial heat that walk by traversal with uniform "
                 "directions are a sample of the heat at the time of EquivalentHeatTimeSteps(), for steps up to about "
                 "a voxel. For the published rules no such time exists. Seeds: 1, 2, ....");
  SpreadOfTheWalk(settings, report);
  BiasOfTheWalk(settings, report);
  ScaleOfStates(settings, report);
  UniformPlacement(settings, report);
  ResolutionOfTheResult(settings, report);
}
