// Builds the partition tree of a heat-like volume of float numbers, on 1 and 2 threads, and one level of ITK's
// morphological watershed, alternately in one run; then selects an object as a click does. Arguments: side of the
// volume in voxels, default 256; number of rounds, default 3.
#include "Times.h"

#include "shapetonHeatObjects.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"
#include "shapetonPartitionTree.h"
#include "shapetonQuantiles.h"

#include "itkGradientMagnitudeImageFilter.h"
#include "itkMorphologicalWatershedImageFilter.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using namespace shapeton;
using HeatImage = itk::Image<float, 3>;

constexpr double mostSeconds = 6.0; // 2 threads
constexpr double leastSpeedup = 1.4;
constexpr double mostClickSeconds = 0.05;

void
PrintTimes(const char * text, const Times & times)
{
  std::printf("  %-42s elapsed: median %7.3f s, best %7.3f s   processor: median %7.3f s\n",
              text,
              UpperMedian(times.elapsed),
              *std::min_element(times.elapsed.begin(), times.elapsed.end()),
              UpperMedian(times.processor));
}

/** Smooth blobs of different size and heat, with noise of up to one percent of the value. */
HeatImage::Pointer
MakeHeat(int side)
{
  struct Blob
  {
    double x, y, z, perRadius, heat;
  };
  constexpr int                          blobs = 40;
  constexpr double                       noise = 0.01;
  constexpr double                       surroundings = 0.002;
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> place(0.0, side), radius(0.04 * side, 0.12 * side), share(0.1, 0.9);
  std::vector<Blob>                      scene;
  for (int i = 0; i < blobs; ++i)
  {
    scene.push_back({ place(random), place(random), place(random), 1.0 / radius(random), share(random) });
  }
  const auto image = HeatImage::New();
  image->SetRegions(HeatImage::SizeType::Filled(static_cast<itk::SizeValueType>(side)));
  image->Allocate();
  const VoxelGrid grid(side, side, side);
  ParallelFor(static_cast<std::size_t>(side), [&](std::size_t k) {
    std::minstd_rand                      ofSlice(static_cast<unsigned int>(k) + 1);
    std::uniform_real_distribution<float> weak(1.0F - noise, 1.0F + noise);
    for (std::size_t voxel = k * grid.stride[2]; voxel < (k + 1) * grid.stride[2]; ++voxel)
    {
      const auto at = grid.Voxel(voxel);
      double     heat = surroundings;
      for (const Blob & blob : scene)
      {
        const double distance = blob.perRadius * std::hypot(at[0] - blob.x, at[1] - blob.y, at[2] - blob.z);
        heat += distance < 3.0 ? blob.heat * std::exp(-distance * distance) : 0.0;
      }
      image->GetBufferPointer()[voxel] = static_cast<float>(heat) * weak(ofSlice);
    }
  });
  return image;
}

/** The peer: a watershed of the gradient magnitude, which is a single partition. */
void
Watershed(const HeatImage * logarithm)
{
  const auto gradient = itk::GradientMagnitudeImageFilter<HeatImage, HeatImage>::New();
  gradient->SetInput(logarithm);
  const auto watershed = itk::MorphologicalWatershedImageFilter<HeatImage, itk::Image<unsigned int, 3>>::New();
  watershed->SetInput(gradient->GetOutput());
  watershed->SetLevel(0.1);
  watershed->MarkWatershedLineOff();
  watershed->Update();
}

void
Run(int side, int rounds)
{
  const auto      image = MakeHeat(side);
  const auto      logarithm = MapVoxels<float>(image.GetPointer(), [](float heat) { return std::log(heat); });
  const VoxelGrid grid(side, side, side);
  const std::array<double, 3> spacing{ { 1.0, 1.0, 1.0 } };
  Times                       one, two, peer, click;
  std::printf("%d^3 voxels, %d rounds; machine of %u threads\n", side, rounds, NumberOfThreads());
  for (int round = 0; round < rounds; ++round)
  {
    const auto build = [&] { BuildPartitionTree(logarithm->GetBufferPointer(), grid, spacing); };
    SetNumberOfThreads(1);
    one.Measure(build);
    SetNumberOfThreads(2);
    two.Measure(build);
    peer.Measure([&] { Watershed(logarithm); });
  }
  HeatObjectOptions options;
  options.leastProbability = 0.0; // clicks are timed, not judged
  const auto list = FindHeatObjects(image, options);
  for (int object = 1; object <= static_cast<int>(list.objects.size()) && object <= rounds; ++object)
  {
    click.Measure([&] { MaskOfObject(list, object); });
  }
  PrintTimes("partition tree, 1 thread", one);
  PrintTimes("partition tree, 2 threads", two);
  PrintTimes("watershed of ITK", peer);
  PrintBound("seconds of the tree, 2 threads", UpperMedian(two.elapsed), mostSeconds);
  PrintBound("times faster with 2 threads", UpperMedian(one.elapsed) / UpperMedian(two.elapsed), leastSpeedup, true);
  std::printf(
    "  %-42s %8.3f\n", "times faster than the watershed", UpperMedian(peer.elapsed) / UpperMedian(two.elapsed));
  const double slowest = *std::max_element(click.elapsed.begin(), click.elapsed.end());
  PrintBound("seconds of a click, the largest objects", slowest, mostClickSeconds);
  std::printf("  peak memory, with the peer: %.2f GB\n", PeakMegabytes() / 1024.0);
}
} // namespace

int
main(int argc, char * argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 256;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 3;
  if (side < 2 || rounds < 1)
  {
    std::fprintf(stderr, "usage: PartitionTreeBenchmark [side of the volume] [rounds]\n");
    return EXIT_FAILURE;
  }
  try
  {
    Run(side, rounds);
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
