// Table 2.1 of the dissertation with a column for Shapeton. Rows without available data use a phantom of equal size.
#include "BenchmarkVolume.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "itkMultiThreaderBase.h"
#include "shapetonVolumeReader.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
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
  { "Foot", { { 256, 256, 256 } }, 100000, 7.0, "80,531", 4.8, "" },
  { "Engine", { { 256, 256, 128 } }, 52000, 10.1, "11,744", 1.4, "volumes/engine.nii.gz" },
  { "Aneurysm", { { 256, 256, 256 } }, 100000, 7.5, "85,564", 5.1, "" },
  { "Abdominal stent", { { 512, 512, 174 } }, 100000, 8.0, "2,098,201", 46.1, "" },
  { "MRI head", { { 256, 256, 256 } }, 400000, 6.0, "352,322", 21.3, "" },
  { "Visible Female hand", { { 176, 187, 190 } }, 1000000, 10.0, "112,559", 18.2, "" },
  { "Bonsai", { { 256, 256, 256 } }, 1000000, 8.5, "845,572", 50.4, "volumes/bonsai.nii.gz" },
} };

/** Volume of a row; `real` is true if it is the published one. */
std::vector<float>
Load(const Row & row, bool & real)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  const std::string  path = folder && *row.file ? std::string(folder) + '/' + row.file : "";
  real = !path.empty() && std::filesystem::exists(path);
  if (!real)
  {
    return MakeBenchmarkVolume(row.size);
  }
  const shapeton::Volume volume = shapeton::ReadVolume(path);
  const auto             size = volume.image->GetBufferedRegion().GetSize();
  if (!std::equal(size.begin(), size.end(), row.size.begin()))
  {
    std::fprintf(stderr, "%s does not have the published size\n", path.c_str());
    std::exit(1);
  }
  const float * const first = volume.image->GetBufferPointer();
  return std::vector<float>(first, first + volume.image->GetBufferedRegion().GetNumberOfPixels());
}

double
Seconds(const Row & row, const std::vector<float> & volume, shapeton::Device device)
{
  shapeton::CumulativeHeatDiffusionSettings settings;
  settings.p = row.p;
  settings.timeSteps = row.steps;
  const auto start = std::chrono::steady_clock::now();
  settings.device = device;
  std::vector<float> heat(volume.size());
  shapeton::DiffuseCumulativeHeat(volume.data(), row.size, settings, heat.data());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
} // namespace

int
main()
{
  const shapeton::DeviceUse gpu = shapeton::ChooseDevice(shapeton::Device::Automatic, 0);
  std::printf("\nTable 2.1, %u threads, GPU: %s; * phantom of equal size, data set not available\n\n",
              itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads(),
              gpu.Describe().c_str());
  std::printf("| data set | resolution | steps | p | conventional, s per step (published) | cumulative, ms per step "
              "(published) | ours, ms per step | ours, all steps, s | times faster | on the GPU, all "
              "steps, s |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row & row : rows)
  {
    bool         real = false;
    const auto   volume = Load(row, real);
    const double seconds = Seconds(row, volume, shapeton::Device::Cpu);
    const double milliseconds = 1000.0 * seconds / row.steps;
    std::printf("| %s%s | %zu x %zu x %zu | %llu | %g | %s | %g | %.3f | %.1f | %.0f | ",
                row.name,
                real ? "" : "*",
                row.size[0],
                row.size[1],
                row.size[2],
                static_cast<unsigned long long>(row.steps),
                row.p,
                row.conventionalSeconds,
                row.publishedMilliseconds,
                milliseconds,
                seconds,
                row.publishedMilliseconds / milliseconds);
    gpu.gpu ? std::printf("%.2f |\n", Seconds(row, volume, shapeton::Device::Cuda)) : std::printf("- |\n");
    std::fflush(stdout);
  }
  return 0;
}
