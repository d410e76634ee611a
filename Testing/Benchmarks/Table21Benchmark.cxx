// Table 2.1 of the dissertation with columns for Shapeton, and conventional diffusion of small volumes. Rows without
// available data use a phantom of equal size.
#include "BenchmarkVolume.h"
#include "ConventionalHeat.h"
#include "Times.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "itkMultiThreaderBase.h"
#include "shapetonVolumeReader.h"

#include <filesystem>

namespace
{
struct Row
{
  const char *               name;
  std::array<std::size_t, 3> size;
  std::uint64_t              steps;
  double                     p;
  const char *               conventionalSeconds;   // published, per iteration
  double                     publishedMilliseconds; // per iteration
  const char *               file;                  // below SHAPETON_TEST_DATA_DIR
};

const std::array<Row, 7> rows = { {
  { "Foot", { { 256, 256, 256 } }, 100000, 7.0, "80,531", 4.8, "scivis/foot.nii.gz" },
  { "Engine", { { 256, 256, 128 } }, 52000, 10.1, "11,744", 1.4, "volumes/engine.nii.gz" },
  { "Aneurysm", { { 256, 256, 256 } }, 100000, 7.5, "85,564", 5.1, "scivis/aneurism.nii.gz" },
  { "Abdominal stent", { { 512, 512, 174 } }, 100000, 8.0, "2,098,201", 46.1, "scivis/stent.nii.gz" },
  { "MRI head", { { 256, 256, 256 } }, 400000, 6.0, "352,322", 21.3, "scivis/mri_ventricles.nii.gz" },
  { "Visible Female hand", { { 176, 187, 190 } }, 1000000, 10.0, "112,559", 18.2, "" },
  { "Bonsai", { { 256, 256, 256 } }, 1000000, 8.5, "845,572", 50.4, "volumes/bonsai.nii.gz" },
} };

struct LoadedVolume
{
  std::array<std::size_t, 3> size{};
  std::vector<float>         values;
  bool                       isReal{ false };
};

/** Volume of a row; its size may be smaller than the published one. */
LoadedVolume
Load(const Row & row)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  const std::string  path = folder && *row.file ? std::string(folder) + '/' + row.file : "";
  if (path.empty() || !std::filesystem::exists(path))
  {
    return { row.size, MakeBenchmarkVolume(row.size), false };
  }
  const shapeton::Volume volume = shapeton::ReadVolume(path);
  const auto             size = volume.image->GetBufferedRegion().GetSize();
  const float * const    first = volume.image->GetBufferPointer();
  return { { { size[0], size[1], size[2] } },
           { first, first + volume.image->GetBufferedRegion().GetNumberOfPixels() },
           true };
}

/** Time of cumulative diffusion in seconds: processor time on the CPU, elapsed time on a GPU. */
double
Seconds(const Row & row, const LoadedVolume & volume, shapeton::Device device)
{
  shapeton::CumulativeHeatDiffusionSettings settings;
  settings.p = row.p;
  settings.timeSteps = row.steps;
  settings.device = device;
  const Stopwatch    watch;
  std::vector<float> heat(volume.values.size());
  shapeton::DiffuseCumulativeHeat(shapeton::VolumeView(volume.values.data(), volume.size), settings, heat.data());
  return device == shapeton::Device::Cpu ? watch.ProcessorSeconds() : watch.Seconds();
}

void
PrintRow(const Row & row, bool hasGpu)
{
  const LoadedVolume volume = Load(row);
  const double       seconds = Seconds(row, volume, shapeton::Device::Cpu);
  constexpr double   millisecondsPerSecond = 1000.0;
  const double       milliseconds = millisecondsPerSecond * seconds / static_cast<double>(row.steps);
  std::printf("| %s%s | %zu x %zu x %zu | %zu x %zu x %zu | %llu | %g | %s | %g | %.3f | %.1f | %.0f | ",
              row.name,
              volume.isReal ? "" : "*",
              row.size[0],
              row.size[1],
              row.size[2],
              volume.size[0],
              volume.size[1],
              volume.size[2],
              static_cast<unsigned long long>(row.steps),
              row.p,
              row.conventionalSeconds,
              row.publishedMilliseconds,
              milliseconds,
              seconds,
              row.publishedMilliseconds / milliseconds);
  hasGpu ? std::printf("%.2f |\n", Seconds(row, volume, shapeton::Device::Cuda)) : std::printf("- |\n");
  std::fflush(stdout);
}

/** Conventional diffusion is started once per voxel, so its time per voxel grows with the number of voxels. */
void
PrintConventional()
{
  constexpr std::uint64_t steps = 100;
  std::printf("\n| voxels | steps | conventional, processor seconds | cumulative | ratio |\n|---|---|---|---|---|\n");
  for (const std::size_t side : { 16, 24, 32 })
  {
    const LoadedVolume volume{ { { side, side, side } }, MakeBenchmarkVolume({ { side, side, side } }), false };
    const shapeton::VolumeGradientOperator volumeGradient(shapeton::VolumeView(volume.values.data(), volume.size));
    const double conventional = ProcessorSecondsOf([&] { ConventionalHeat(volumeGradient, steps); });
    Row          row = rows[0];
    row.steps = steps;
    const double cumulative = Seconds(row, volume, shapeton::Device::Cpu);
    std::printf("| %zu^3 | %llu | %.2f | %.4f | %.0f |\n",
                side,
                static_cast<unsigned long long>(steps),
                conventional,
                cumulative,
                conventional / cumulative);
    std::fflush(stdout);
  }
}
} // namespace

int
main()
{
  const shapeton::DeviceUse gpu = shapeton::ChooseDevice(shapeton::Device::Automatic, 0);
  std::printf("\nTable 2.1, %u threads, GPU: %s; * phantom of equal size, data set not available\n\n",
              itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads(),
              gpu.Describe().c_str());
  std::printf(
    "| data set | resolution (published) | ours | steps | p | conventional, s per step (published) | cumulative, "
    "ms per step (published) | ours, ms of processor time per step | ours, all steps, s of processor time | "
    "times less | on the GPU, all steps, s |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row & row : rows)
  {
    PrintRow(row, gpu.gpu);
  }
  PrintConventional();
  return 0;
}
