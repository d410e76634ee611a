// Shapeton diffusion of 65,536 shapetons in 256^3 voxels compared with the published scalar loop, alternating in one
// process. Prints nanoseconds per shapeton and step and the ratios of medians.
#include "BenchmarkVolume.h"
#include "MedianReporter.h"
#include "ShapetonPeer.h"

#include "shapetonKernelSets.h"
#include "shapetonParallelFor.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonParticleKernels.h"
#include "shapetonParticleRecords.h"

#include "itkMultiThreaderBase.h"

#include <algorithm>

namespace
{
using namespace shapeton;

constexpr std::size_t   usualSide = 256;
constexpr std::uint32_t shapetons = 65536;
constexpr unsigned int  stepsOfIteration = 16;
constexpr double        shapetonSteps = static_cast<double>(shapetons) * stepsOfIteration;
constexpr double        distance = 0.01;

/** The phantom scaled to [0, 1]. */
std::vector<float>
MakeIntensities(std::size_t side)
{
  auto        volume = MakeBenchmarkVolume({ side, side, side });
  const auto  ends = std::minmax_element(volume.begin(), volume.end());
  const float lower = *ends.first;
  const float scale = 1.0F / (*ends.second - lower);
  for (float & value : volume)
  {
    value = (value - lower) * scale;
  }
  return volume;
}

ParticleDiffusionOptions
Settings(DirectionSampling sampling, PathRule rule = PathRule::Endpoint)
{
  ParticleDiffusionOptions settings;
  settings.intensityWindow = { { 0.0, 1.0 } };
  settings.shapetons = shapetons;
  settings.distance = distance;
  settings.directionSampling = sampling;
  settings.pathRule = rule;
  return settings;
}

/** A run of the library, including the counting of visits. */
struct Product
{
  Product(const std::vector<float> & intensities, std::size_t side, const ParticleDiffusionOptions & settings)
    : visits(intensities.size())
    , diffusion(VolumeView(intensities.data(), { side, side, side }), settings, nullptr, visits.data())
  {}

  void
  TakeSteps(unsigned int steps, const std::optional<SteadyRule> & rule = {})
  {
    diffusion.Run(diffusion.GetMeasures().step + steps, rule);
  }

  std::array<std::vector<float>, 3>
  Places() const
  {
    std::array<std::vector<float>, 3> places;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      places[axis].assign(diffusion.GetPlaces(axis), diffusion.GetPlaces(axis) + shapetons);
    }
    return places;
  }

  std::vector<std::uint32_t> visits;
  ParticleDiffusion          diffusion;
};

const std::vector<float> &
UsualIntensities()
{
  static const std::vector<float> intensities = MakeIntensities(usualSide);
  return intensities;
}

Product &
Usual(DirectionSampling sampling, PathRule rule = PathRule::Endpoint)
{
  static std::map<std::pair<DirectionSampling, PathRule>, std::unique_ptr<Product>> products;
  auto & product = products[{ sampling, rule }];
  if (!product)
  {
    product = std::make_unique<Product>(UsualIntensities(), usualSide, Settings(sampling, rule));
  }
  return *product;
}

void
Peer(benchmark::State & state)
{
  static ShapetonPeer peer(UsualIntensities(),
                           { usualSide, usualSide, usualSide },
                           { 7.0F, static_cast<float>(distance * usualSide), 0.01F, 1 },
                           Product(UsualIntensities(), usualSide, Settings(DirectionSampling::SectorArea)).Places());
  for (auto _ : state)
  {
    peer.Run(stepsOfIteration, static_cast<unsigned int>(state.range(0)));
  }
}

void
Take(benchmark::State & state, Product & product, const std::optional<SteadyRule> & rule = {})
{
  const unsigned int all = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(static_cast<unsigned int>(state.range(0)));
  for (auto _ : state)
  {
    product.TakeSteps(stepsOfIteration, rule);
  }
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(all);
}

/** One thread; the same phantom and distance in volumes of several resolutions. */
void
Resolution(benchmark::State & state)
{
  static std::map<std::size_t, std::unique_ptr<Product>> products;
  const auto                                             side = static_cast<std::size_t>(state.range(1));
  auto &                                                 product = products[side];
  if (!product)
  {
    product = std::make_unique<Product>(MakeIntensities(side), side, Settings(DirectionSampling::SolidAngle));
  }
  Take(state, *product);
}

/** Input of the kernels, without the rest of the library. */
struct Bench
{
  Bench()
    : records(EdgeVolume(VolumeView(UsualIntensities().data(), { usualSide, usualSide, usualSide }),
                         Settings(DirectionSampling::SolidAngle)),
              nullptr,
              [] {})
    , visits(UsualIntensities().size())
    , voxels(shapetons)
  {
    places = Usual(DirectionSampling::SolidAngle).Places();
    constexpr auto side = static_cast<std::int32_t>(usualSide);
    constexpr auto step = static_cast<float>(distance * usualSide);
    surroundings = { records.GetData(), visits.data(), { side, side, side }, { step, step, step } };
    for (std::size_t i = 0; i < shapetons; ++i)
    {
      const auto index = [&](unsigned int axis) { return static_cast<std::uint32_t>(places[axis][i]); };
      voxels[i] = (index(2) * usualSide + index(1)) * usualSide + index(0);
    }
  }

  static Bench &
  Get()
  {
    static Bench bench;
    return bench;
  }

  /** Processes shapetons in groups, like the library. */
  void
  TakeSteps(unsigned int steps, const ParticleKernels::Set & kernels, ParticleKernels::Draw draw)
  {
    constexpr std::size_t             group = 256;
    alignas(64) float                 components[3][group];
    const ParticleKernels::Directions directions{ components[0], components[1], components[2] };
    for (std::size_t first = 0; first < shapetons; first += group)
    {
      const ParticleKernels::Shapetons some{ static_cast<std::uint32_t>(first), group,
                                             places[0].data() + first,          places[1].data() + first,
                                             places[2].data() + first,          voxels.data() + first };
      for (unsigned int i = 1; i <= steps; ++i)
      {
        draw(surroundings, some, { 1, step + i }, table, directions);
        kernels.move(surroundings, some, directions);
        for (std::size_t shapeton = first; shapeton < first + group; ++shapeton)
        {
          ++visits[voxels[shapeton]];
        }
      }
    }
    step += steps;
  }

  ParticleRecords                   records;
  std::vector<std::uint32_t>        visits;
  std::vector<std::uint32_t>        voxels;
  std::array<std::vector<float>, 3> places;
  ParticleKernels::ThetaTable       table;
  ParticleKernels::Surroundings     surroundings{};
  std::uint64_t                     step{ 0 };
};

void
Register()
{
  const auto inTurns = [](benchmark::internal::Benchmark * one, int iterations) {
    return one->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(iterations)->Repetitions(9);
  };
  const auto onThreads = [&](const char * name, int iterations, const auto & function) {
    inTurns(benchmark::RegisterBenchmark(name, function), iterations)->Arg(1)->Arg(2);
  };
  SteadyRule never; // evaluated at each step, but never ends the run
  never.epsilon = -1.0;
  onThreads("Peer", 1, Peer);
  onThreads("SolidAngle", 6, [](auto & state) { Take(state, Usual(DirectionSampling::SolidAngle)); });
  onThreads("SectorArea", 6, [](auto & state) { Take(state, Usual(DirectionSampling::SectorArea)); });
  onThreads("EachStepMeasured", 4, [=](auto & state) { Take(state, Usual(DirectionSampling::SolidAngle), never); });
  onThreads("Traversal", 1, [](auto & state) { Take(state, Usual(DirectionSampling::Uniform, PathRule::Traversal)); });
  inTurns(benchmark::RegisterBenchmark("Resolution", Resolution), 6)
    ->Args({ 1, 64 })
    ->Args({ 1, 256 })
    ->Args({ 1, 512 });
  for (const auto * const kernels : KernelsOfThisCpu<ParticleKernels::Set>())
  {
    const auto draw = [&](const std::string & sampling, ParticleKernels::Draw function) {
      const std::string name = std::string("Kernels ") + kernels->name + ' ' + sampling;
      const auto        take = [=](benchmark::State & state) {
        for (auto _ : state)
        {
          Bench::Get().TakeSteps(stepsOfIteration, *kernels, function);
        }
      };
      inTurns(benchmark::RegisterBenchmark(name.c_str(), take), 6);
    };
    draw("solidAngle", kernels->DrawOf(DirectionSampling::SolidAngle));
    draw("sectorArea", kernels->DrawOf(DirectionSampling::SectorArea));
  }
}

/** Quantities that compare a run of the peer with a run of the library. */
struct Summary
{
  static constexpr unsigned int numbers = 7;
  static const char *
  NameOf(unsigned int i)
  {
    static const char * const names[numbers] = {
      "visits of the first ball, share",     "visits of the second ball, share",
      "visits of the third ball, share",     "voxels reached, share",
      "mean squared step along x, voxels^2", "mean squared step along y, voxels^2",
      "mean squared step along z, voxels^2"
    };
    return names[i];
  }

  Summary(const std::vector<float> &                intensities,
          const std::vector<std::uint32_t> &        visits,
          const std::array<std::vector<float>, 3> & before,
          const std::array<std::vector<float>, 3> & after)
  {
    double whole = 0.0;
    for (std::size_t voxel = 0; voxel < visits.size(); ++voxel)
    {
      const float value = intensities[voxel];
      const int   ball = value > 0.9F ? 2 : value > 0.7F ? 1 : value > 0.35F ? 0 : -1;
      whole += visits[voxel];
      if (ball >= 0)
      {
        value_[ball] += visits[voxel];
      }
      value_[3] += visits[voxel] > 0 ? 1.0 / visits.size() : 0.0;
    }
    for (int ball = 0; ball < 3; ++ball)
    {
      value_[ball] /= whole;
    }
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (std::size_t i = 0; i < before[axis].size(); ++i)
      {
        const double step = after[axis][i] - before[axis][i];
        value_[4 + axis] += step * step / before[axis].size();
      }
    }
  }

  double value_[numbers]{};
};

/** Mean and standard error over runs with several seeds. */
std::string
MeanOf(const std::vector<Summary> & runs, unsigned int i)
{
  double sum = 0.0, squares = 0.0;
  for (const Summary & run : runs)
  {
    sum += run.value_[i];
  }
  const double mean = sum / runs.size();
  for (const Summary & run : runs)
  {
    squares += (run.value_[i] - mean) * (run.value_[i] - mean);
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%8.5f +- %.5f", mean, std::sqrt(squares / (runs.size() - 1) / runs.size()));
  return text;
}

/** Checks that the peer simulates the same process, except for the effect of its tolerance on the angles of small
 * weights. */
void
CompareResults(double p)
{
  constexpr std::size_t    side = 96;
  constexpr unsigned int   steps = 40;
  const auto               intensities = MakeIntensities(side);
  constexpr float          tolerances[2] = { 0.01F, 1e-7F };
  std::vector<Summary>     ours, peers[2];
  ParticleDiffusionOptions settings = Settings(DirectionSampling::SectorArea);
  settings.distance = 2.56 / side;
  settings.p = p;
  for (settings.seed = 1; settings.seed <= 5; ++settings.seed)
  {
    Product    product(intensities, side, settings);
    const auto start = product.Places();
    product.TakeSteps(steps - 1);
    const auto before = product.Places();
    product.TakeSteps(1);
    ours.emplace_back(intensities, product.visits, before, product.Places());
    for (int i = 0; i < 2; ++i)
    {
      ShapetonPeer peer(
        intensities, { side, side, side }, { static_cast<float>(p), 2.56F, tolerances[i], settings.seed }, start);
      const auto places = [&] {
        return std::array<std::vector<float>, 3>{ peer.GetPlaces(0), peer.GetPlaces(1), peer.GetPlaces(2) };
      };
      peer.Run(steps - 1, 1);
      const auto peerBefore = places();
      peer.Run(1, 1);
      peers[i].emplace_back(intensities, peer.GetVisits(), peerBefore, places());
    }
  }
  std::printf(
    "\n%zu^3 voxels, p = %g, steps of 2.56 voxels, %u steps, 5 seeds: mean +- standard error\n", side, p, steps);
  std::printf("%-38s %-22s %-22s %-22s\n", "", "ours, sectorArea", "peer, tolerance 0.01", "peer, tolerance 1e-7");
  for (unsigned int i = 0; i < Summary::numbers; ++i)
  {
    std::printf("%-38s %-22s %-22s %-22s\n",
                Summary::NameOf(i),
                MeanOf(ours, i).c_str(),
                MeanOf(peers[0], i).c_str(),
                MeanOf(peers[1], i).c_str());
  }
}

void
PrintResults(std::map<std::string, double> ns)
{
  std::printf("\n%u shapetons, %zu^3 voxels, p = 7, distance %g; ns per shapeton and step, medians\n",
              shapetons,
              usualSide,
              distance);
  for (auto & [name, value] : ns)
  {
    value *= 1e6 / shapetonSteps; // from milliseconds
    std::printf("%-30s %8.2f\n", name.c_str(), value);
  }
  std::printf("\n");
  PrintRatio("solidAngle against the scalar peer, one thread each", ns["Peer/1"] / ns["SolidAngle/1"], 10);
  PrintRatio("sectorArea against the scalar peer, one thread each", ns["Peer/1"] / ns["SectorArea/1"], 10);
  PrintRatio("solidAngle against the scalar peer, two threads each", ns["Peer/2"] / ns["SolidAngle/2"], 8);
  PrintRatio("sectorArea against the scalar peer, two threads each", ns["Peer/2"] / ns["SectorArea/2"], 8);
  PrintRatio("512^3 against 64^3, one thread", ns["Resolution/1/512"] / ns["Resolution/1/64"], 3, true);
  std::printf(
    "Working set of 65,536 shapetons: 1 MB, and one line each of records (16 bytes a voxel) and visits (4) for "
    "each,\n8 MB; all records and visits of 64^3 voxels: 5 MB, of 256^3: 336 MB, of 512^3: 2.7 GB\n");
}
} // namespace

int
main(int argc, char * argv[])
{
  InitializeBenchmarks(argc, argv);
  Register();
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  PrintResults(reporter.milliseconds);
  if (reporter.milliseconds.count("Peer/1") > 0)
  {
    CompareResults(7.0);
    CompareResults(25.0);
  }
  return 0;
}
