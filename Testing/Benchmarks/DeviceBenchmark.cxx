// GPU timings compared with their bounds: wall time in seconds, the best of three runs after a warm-up. Run by
// Utilities/run-benchmarks --device cuda.
#include "BenchmarkVolume.h"
#include "Times.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonDeviceHeatEngine.h"
#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatHistogram.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonVolumeRendering.h"

#include <algorithm>
#include <memory>

namespace
{
using namespace shapeton;

/** The shortest of three calls after a warm-up call, which loads kernels and touches memory. */
double
WarmSecondsOf(const std::function<void()> & work)
{
  work();
  return SecondsOf(work, 3);
}

void
Print(const char * what, double value, const char * unit, double atMost)
{
  std::printf("| %s | %.4g %s | %.4g | %s |\n", what, value, unit, atMost, value <= atMost ? "met" : "NOT MET");
  std::fflush(stdout);
}

/** Test volume with p = 7. */
struct Setting
{
  explicit Setting(std::size_t edge)
    : side(edge)
    , intensities(MakeBenchmarkVolume({ side, side, side }))
    , volumeGradient(VolumeView(intensities.data(), { side, side, side }))
    , initial(volumeGradient.GetGrid())
  {
    volumeGradient.ComputeInitialHeat(initial);
  }

  double
  Voxels() const
  {
    return static_cast<double>(side) * static_cast<double>(side) * static_cast<double>(side);
  }

  std::size_t                  side;
  std::vector<float>           intensities;
  const VolumeGradientOperator volumeGradient;
  PaddedField                  initial;
};

/** Counts all rows of the histogram. */
class Counter : public HeatSnapshots
{
public:
  explicit Counter(std::size_t rows) : m_Counts(rows * HeatHistogram::NumberOfBins) {}
  bool
  IsCounted(std::size_t) const override
  {
    return true;
  }
  void
  AddCounts(std::size_t snapshot, const std::uint32_t * counts, std::uint32_t weight) override
  {
    for (unsigned int bin = 0; bin < HeatHistogram::NumberOfBins; ++bin)
    {
      m_Counts[snapshot * HeatHistogram::NumberOfBins + bin] += weight * counts[bin];
    }
  }
  bool
  IsShown(std::size_t) const override
  {
    return false;
  }
  void
  ShowRow(std::size_t, std::size_t, const float *, unsigned int) override
  {}

private:
  std::vector<std::uint32_t> m_Counts;
};

/** Bandwidth in bytes per second. */
double
MeasureTriad()
{
  constexpr std::size_t  number = std::size_t{ 1 } << 26;
  constexpr unsigned int triads = 50;
  const auto             run = reinterpret_cast<RunTriadsFunction *>(FindDeviceFunction("ShapetonRunTriads"));
  return 12.0 * number * triads / WarmSecondsOf([&] { run(number, triads); });
}

void
MeasureSteps(const Setting & s, double bandwidth)
{
  const auto   make = reinterpret_cast<MakeDeviceHeatEngineFunction *>(FindDeviceFunction("ShapetonMakeHeatEngine"));
  const auto & op = s.volumeGradient;
  const DeviceHeatVolume                  volume{ op.GetGrid(),
                                 { op.GetConductances(0), op.GetConductances(1), op.GetConductances(2) } };
  const std::unique_ptr<DeviceHeatEngine> engine(make(volume, nullptr, nullptr));
  engine->Upload(HeatEngine::Heat, s.initial.GetData());
  constexpr unsigned int steps = 640;
  const double           seconds = WarmSecondsOf([&] { engine->StepExplicitly(steps, 1.0F / 12.0F, false); });
  const double           asked = std::max(0.004, 1e9 * 20.0 / (0.6 * bandwidth));
  Print("256^3, an explicit step (0.004, or 60 % of the triad at 20 bytes)",
        1e9 * seconds / steps / s.Voxels(),
        "ns per voxel",
        asked);
}

/** 100,000 steps with this number of histogram rows. */
void
MeasureSolver(const char * what, const Setting & s, std::size_t rows, double asked)
{
  const auto steps = rows > 0 ? MakeSnapshotSteps(100000, rows, SnapshotSpacing::Linear) : std::vector<std::uint64_t>();
  const double seconds = WarmSecondsOf([&] {
    PaddedField heat(s.volumeGradient.GetGrid());
    std::copy_n(s.initial.GetData(), s.volumeGradient.GetGrid().GetLength(), heat.GetData());
    Counter             counter(steps.size());
    HeatDiffusionSolver solver(s.volumeGradient, HeatDiffusionSolver::Method::Chebyshev, 1.0 / 12.0, 1e-5);
    solver.SetDevice(Device::Cuda);
    solver.Run(heat, 100000, steps, counter);
  });
  Print(what, seconds, "s", asked);
}

/** Time (s) of additional steps after an earlier run. */
double
SecondsOfShapetons(const Setting & s, std::uint32_t shapetons, std::uint64_t steps)
{
  ParticleDiffusionOptions settings;
  settings.shapetons = shapetons;
  settings.distance = 0.01;
  settings.device = Device::Cuda;
  std::vector<std::uint32_t> visits(s.intensities.size());
  const VolumeView           volume(s.intensities.data(), { s.side, s.side, s.side });
  ParticleDiffusion          diffusion(volume, settings, nullptr, visits.data());
  return WarmSecondsOf([&] { diffusion.Run(diffusion.GetMeasures().step + steps); });
}

void
MeasureFrame(Setting & s)
{
  const auto heat = itk::Image<float, 3>::New();
  heat->SetRegions(itk::Image<float, 3>::SizeType::Filled(s.side));
  for (float & value : s.intensities)
  {
    value /= 255.0F;
  }
  heat->GetPixelContainer()->SetImportPointer(s.intensities.data(), s.intensities.size(), false);
  const auto             lines = ShapeTransferFunction::Parse("0.2-0.4:red:0.2,0.45-0.7:ivory:0.5,0.75-1:lime:1");
  VolumeRenderingOptions options;
  options.width = options.height = 1000;
  options.azimuth = 25.0;
  options.elevation = 15.0;
  options.annotations = false;
  std::unique_ptr<VolumeRenderer> renderer;
  const double                    classification =
    WarmSecondsOf([&] { renderer = std::make_unique<VolumeRenderer>(heat, lines, Device::Cuda); });
  const double frame = WarmSecondsOf([&] { renderer->Render(options); });
  Print("256^3, a frame of 1000 x 1000 pixels", 1e3 * frame, "ms", 20.0);
  std::printf("\nOne-time classification on the CPU, and upload: %.0f ms.\n", 1e3 * classification);
}
} // namespace

int
main()
{
  const DeviceUse use = ChooseDevice(Device::Cuda, 0);
  const double    bandwidth = MeasureTriad();
  std::printf(
    "\n%s; triad %.0f GB/s\n\n| what | measured | bound | |\n|---|---|---|---|\n", use.device.c_str(), bandwidth / 1e9);
  Setting s(256);
  MeasureSteps(s, bandwidth);
  MeasureSolver("256^3, t = 1e5, final state", s, 0, 0.3);
  MeasureSolver("256^3, t = 1e5, 512 rows of the histogram", s, 512, 0.8);
  Print("65,536 shapetons, 2,500 steps", SecondsOfShapetons(s, 65536, 2500), "s", 0.2);
  Print("10^7 shapetons", 1e9 * SecondsOfShapetons(s, 10000000, 20) / 20 / 1e7, "ns per shapeton and step", 0.5);
  MeasureSolver("512^3, t = 1e5, final state", Setting(512), 0, 3.0);
  MeasureFrame(s);
  return 0;
}
