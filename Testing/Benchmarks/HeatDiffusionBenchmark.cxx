// Cumulative heat diffusion of 256^3 voxels compared with its peers in one process: the memory roofline (a triad), a
// plain scalar loop, and ITK's gradient anisotropic diffusion. Prints absolute times, then ratios of medians.
#include "BenchmarkVolume.h"
#include "MedianReporter.h"
#include "ScalarPeer.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonDiffusionKernels.h"
#include "shapetonKernelSets.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatHistogram.h"
#include "shapetonTimeTiles.h"

#include "itkGradientAnisotropicDiffusionImageFilter.h"

namespace
{
using namespace shapeton;

constexpr std::size_t side = 256;
constexpr double      voxels = static_cast<double>(side) * side * side;
constexpr float       dt = 1.0F / 12.0F;

/** The volume, its operator with p = 7, and work buffers. */
struct Setting
{
  Setting()
    : intensities(MakeBenchmarkVolume({ side, side, side }))
    , volumeGradient(VolumeView(intensities.data(), { side, side, side }))
    , initial(volumeGradient.GetGrid())
    , even(volumeGradient.GetGrid())
    , odd(volumeGradient.GetGrid())
    , rest(volumeGradient.GetGrid())
  {
    volumeGradient.ComputeInitialHeat(initial);
    this->Reset();
  }

  static Setting &
  Get()
  {
    static Setting setting;
    return setting;
  }

  DiffusionKernels::Edges
  EdgesOf(std::size_t row) const
  {
    const auto & grid = volumeGradient.GetGrid();
    return { volumeGradient.GetConductances(0) + row,
             volumeGradient.GetConductances(1) + row,
             volumeGradient.GetConductances(2) + row,
             static_cast<std::ptrdiff_t>(grid.GetStride(1)),
             static_cast<std::ptrdiff_t>(grid.GetStride(2)) };
  }

  void
  Reset()
  {
    std::copy_n(initial.GetData(), volumeGradient.GetGrid().GetLength(), even.GetData());
  }

  std::vector<float>           intensities;
  const VolumeGradientOperator volumeGradient;
  PaddedField                  initial, even, odd, rest;
};

void
Triad(benchmark::State & state)
{
  auto &            s = Setting::Get();
  const std::size_t chunk = side * side;
  float * const     a = s.even.GetData();
  const float *     b = s.odd.GetData();
  const float *     c = s.initial.GetData();
  for (auto _ : state)
  {
    ParallelFor(side, [&](std::size_t z) {
      for (std::size_t i = z * chunk; i < (z + 1) * chunk; ++i)
      {
        a[i] = b[i] + 0.5F * c[i];
      }
    });
  }
  s.Reset();
}

void
Scalar(benchmark::State & state)
{
  auto & s = Setting::Get();
  for (auto _ : state)
  {
    ScalarStep(s.volumeGradient, s.even.GetData(), s.odd.GetData(), dt);
    std::swap(s.even, s.odd);
  }
  s.Reset();
}

void
Sweep(benchmark::State & state)
{
  auto & s = Setting::Get();
  for (auto _ : state)
  {
    ParallelFor(side, [&](std::size_t z) {
      for (std::size_t y = 0; y < side; ++y)
      {
        const std::size_t row = s.volumeGradient.GetGrid().GetRow(y, z);
        BestKernels<DiffusionKernels::Set>().ExplicitStep(
          s.EdgesOf(row), s.even.GetData() + row, s.odd.GetData() + row, side, dt);
      }
    });
    std::swap(s.even, s.odd);
  }
  s.Reset();
}

/** Sixteen steps with tiling in space and time. */
void
Tiled(benchmark::State & state)
{
  auto &  s = Setting::Get();
  float * buffers[2] = { s.even.GetData(), s.odd.GetData() };
  for (auto _ : state)
  {
    RunTimeTiles(s.volumeGradient.GetGrid(), 16, { 32, 32, 16 }, [&](unsigned int step, std::size_t row) {
      BestKernels<DiffusionKernels::Set>().ExplicitStep(
        s.EdgesOf(row), buffers[(step + 1) % 2] + row, buffers[step % 2] + row, side, dt);
    });
  }
  s.Reset();
}

void
TiledCompensated(benchmark::State & state)
{
  auto &  s = Setting::Get();
  float * buffers[2] = { s.even.GetData(), s.odd.GetData() };
  for (auto _ : state)
  {
    RunTimeTiles(s.volumeGradient.GetGrid(), 16, { 32, 32, 16 }, [&](unsigned int step, std::size_t row) {
      BestKernels<DiffusionKernels::Set>().CompensatedStep(
        s.EdgesOf(row), buffers[(step + 1) % 2] + row, buffers[step % 2] + row, s.rest.GetData() + row, side, dt);
    });
  }
  s.Reset();
}

/** Five iterations of the most similar ITK filter, which recomputes conductances from the evolving image in each
 * iteration. */
void
ItkGradientAnisotropicDiffusion(benchmark::State & state)
{
  auto & s = Setting::Get();
  using ImageType = itk::Image<float, 3>;
  auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType::Filled(side));
  image->GetPixelContainer()->SetImportPointer(s.intensities.data(), s.intensities.size(), false);
  for (auto _ : state)
  {
    auto filter = itk::GradientAnisotropicDiffusionImageFilter<ImageType, ImageType>::New();
    filter->SetInput(image);
    filter->SetNumberOfIterations(5);
    filter->SetTimeStep(0.0625);
    filter->SetConductanceParameter(1.0);
    filter->Update();
  }
}

void
FinalState(benchmark::State & state)
{
  auto & s = Setting::Get();
  for (auto _ : state)
  {
    HeatDiffusionSolver solver(s.volumeGradient, HeatDiffusionSolver::Method::Chebyshev, dt, 1e-5);
    solver.Run(s.even, state.range(0));
    state.counters["applications"] = static_cast<double>(solver.GetNumberOfApplications());
  }
  s.Reset();
}

void
Snapshots(benchmark::State & state)
{
  auto &                                  s = Setting::Get();
  const auto                              steps = MakeSnapshotSteps(state.range(0), 512, SnapshotSpacing::Linear);
  std::vector<std::vector<std::uint32_t>> counts(
    NumberOfThreads(), std::vector<std::uint32_t>(steps.size() * HeatHistogram::NumberOfBins));
  for (auto _ : state)
  {
    HeatDiffusionSolver solver(s.volumeGradient, HeatDiffusionSolver::Method::Chebyshev, dt, 1e-5);
    solver.Run(
      s.even, state.range(0), steps, [&](std::size_t snapshot, std::size_t, const float * heat, unsigned int worker) {
        HeatHistogram::CountHeats(heat, side, counts[worker].data() + snapshot * HeatHistogram::NumberOfBins);
      });
    state.counters["applications"] = static_cast<double>(solver.GetNumberOfApplications());
  }
  s.Reset();
}

constexpr int turns = 7;
BENCHMARK(Triad)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(40)->Repetitions(turns);
BENCHMARK(Scalar)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(4)->Repetitions(turns);
BENCHMARK(Sweep)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(20)->Repetitions(turns);
BENCHMARK(Tiled)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3)->Repetitions(turns);
BENCHMARK(TiledCompensated)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3)->Repetitions(turns);
BENCHMARK(ItkGradientAnisotropicDiffusion)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(3);
BENCHMARK(FinalState)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(Snapshots)->Arg(100000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
} // namespace

int
main(int argc, char * argv[])
{
  InitializeBenchmarks(argc, argv);
  Setting::Get();
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  auto &       ms = reporter.milliseconds;
  const double bandwidth = 12.0 * voxels / ms["Triad"]; // bytes per millisecond
  const auto   roofline = [&](double step) {
    return 20.0 * voxels / bandwidth / step;
  }; // read heat, 3 weights; write heat
  const double tiled = ms["Tiled"] / 16.0;
  std::printf(
    "\n256^3 voxels, p = 7, %u threads; triad %.1f GB/s; per voxel and step: scalar loop %.3f ns, sweep %.3f ns, "
    "tiled %.3f ns, tiled compensated %.3f ns\n",
    NumberOfThreads(),
    bandwidth * 1e-6,
    ms["Scalar"] * 1e6 / voxels,
    ms["Sweep"] * 1e6 / voxels,
    tiled * 1e6 / voxels,
    ms["TiledCompensated"] / 16.0 * 1e6 / voxels);
  PrintRatio("sweep / roofline at 20 bytes per voxel and step", roofline(ms["Sweep"]), 0.55);
  PrintRatio("time-tiled steps / roofline", roofline(tiled), 1.0);
  PrintRatio("time-tiled steps with compensated sums / roofline", roofline(ms["TiledCompensated"] / 16.0), 1.0);
  PrintRatio("time-tiled step vs. scalar loop, one thread", ms["Scalar"] / tiled, 3.5);
  PrintRatio(
    "time-tiled step against an iteration of ITK's filter", ms["ItkGradientAnisotropicDiffusion"] / 5.0 / tiled, 100.0);
  PrintRatio("heat after 100,000 steps against the scalar loop*", 1e5 * ms["Scalar"] / ms["FinalState/100000"], 150.0);
  PrintRatio(
    "heat after 1,000,000 steps against the scalar loop*", 1e6 * ms["Scalar"] / ms["FinalState/1000000"], 150.0);
  PrintRatio(
    "512 histogram rows to 100,000 against the scalar loop*", 1e5 * ms["Scalar"] / ms["Snapshots/100000"], 50.0);
  std::printf("* extrapolated from the time per step of the scalar loop\n");
  return 0;
}
