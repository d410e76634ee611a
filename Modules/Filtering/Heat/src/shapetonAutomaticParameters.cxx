#include "shapetonAutomaticParameters.h"
#include "shapetonParallelFor.h"
#include "shapetonReducedVolume.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace shapeton
{
namespace
{
constexpr std::size_t bins = 8192; // for half gradients in [0, 1]
using Histogram = std::vector<std::uint64_t>;

std::uint64_t
Sum(const Histogram & histogram, std::size_t first = 0)
{
  std::uint64_t sum = 0;
  for (std::size_t bin = first; bin < bins; ++bin)
  {
    sum += histogram[bin];
  }
  return sum;
}

/** The given quantile of the half gradients, counting only bins from `first`. */
double
Quantile(const Histogram & histogram, double share, std::size_t first)
{
  const double wanted = share * static_cast<double>(Sum(histogram, first));
  double       below = 0.0;
  for (std::size_t bin = first; bin < bins; ++bin)
  {
    below += static_cast<double>(histogram[bin]);
    if (below >= wanted)
    {
      return (bin + 0.5) / bins;
    }
  }
  return 1.0;
}

/** Counts the half gradients along all lines of the volume; with `peaksOnly` only those that exceed both of their
 * neighbors. */
Histogram
CountHalfGradients(const VolumeView & volume, const std::array<double, 2> & window, bool peaksOnly)
{
  const auto &          size = volume.size;
  const double          smallest = SmallestSpacing(volume.spacing);
  std::array<double, 3> resolution{};
  std::transform(
    volume.spacing.begin(), volume.spacing.end(), resolution.begin(), [smallest](double h) { return h / smallest; });
  const std::array<std::size_t, 3> strides = { 1, size[0], size[0] * size[1] };
  std::vector<Histogram>           histograms(NumberOfThreads(), Histogram(bins, 0));
  const auto                       scaled = [&](std::size_t i) {
    return std::clamp((volume.values[i] - window[0]) / (window[1] - window[0]), 0.0, 1.0);
  };
  ParallelForWorkers(size[2], [&](std::size_t z, unsigned int worker) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::array<std::size_t, 3> index = { x, y, z };
        const std::size_t                voxel = x + y * strides[1] + z * strides[2];
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const auto isIn = [&](std::size_t i) { return volume.IsInDomain(i) && volume.IsInDomain(i + strides[axis]); };
          if (index[axis] + 2 >= size[axis] || index[axis] == 0 || !isIn(voxel))
          {
            continue;
          }
          const auto half = [&](std::size_t i) {
            return isIn(i) ? std::abs(scaled(i + strides[axis]) - scaled(i)) / resolution[axis] : 0.0;
          };
          const double value = half(voxel);
          if (!peaksOnly || (value > half(voxel - strides[axis]) && value >= half(voxel + strides[axis])))
          {
            ++histograms[worker]
                        [value < 1.0 ? static_cast<std::size_t>(value * bins) : bins - 1]; // NaN is rejected later
          }
        }
      }
    }
  });
  for (std::size_t worker = 1; worker < histograms.size(); ++worker)
  {
    std::transform(
      histograms[0].begin(), histograms[0].end(), histograms[worker].begin(), histograms[0].begin(), std::plus<>());
  }
  return histograms[0];
}
} // namespace

AutomaticP
ChooseP(const VolumeView & volume, const VolumeGradientOptions & options)
{
  const auto window = WindowOf(options, volume);
  AutomaticP choice;
  if (!(window[1] > window[0]))
  {
    choice.reason = "the volume is constant: the heat is 0 for any p";
    return choice;
  }
  const Histogram  all = CountHalfGradients(volume, window, false);
  const bool       noisy = 10 * Sum(all, 1) > Sum(all);
  constexpr double perQuartile = 3.138; // the lower quartile of |normal| is sd / 3.138
  choice.noise = noisy ? perQuartile * Quantile(all, 0.25, 1) : 0.0;

  const Histogram peaks = CountHalfGradients(volume, window, true);
  const auto      firstEdge = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(4.0 * choice.noise * bins)));
  if (firstEdge >= bins || Sum(peaks, firstEdge) == 0)
  {
    choice.reason = "no edge exceeds the noise; the default is used";
    return choice;
  }
  choice.edgeContrast = Quantile(peaks, 0.25, firstEdge);
  // Between the noise bound and the edge contrast, with a margin on both sides.
  const double     reach = std::max(4.0 * choice.noise, 0.25 * choice.edgeContrast);
  const double     cut = std::sqrt(reach * std::max(choice.edgeContrast, reach));
  constexpr double greatestP = 50.0;
  choice.p = std::clamp(1.0 / cut, 1.0, greatestP);
  char text[240];
  std::snprintf(
    text,
    sizeof(text),
    "noise between neighbors has a standard deviation of %.4f of the intensity window, and three in four edges "
    "exceed %.4f: edges insulate from 1/p = %.4f on",
    choice.noise,
    choice.edgeContrast,
    1.0 / choice.p);
  choice.reason = text;
  return choice;
}

std::vector<std::uint64_t>
MakeSnapshotSteps(std::uint64_t last, std::size_t number, SnapshotSpacing spacing)
{
  std::vector<std::uint64_t> steps{ 0 };
  const auto                 intervals = static_cast<double>(std::max<std::size_t>(number, 2) - 1);
  for (std::size_t i = 1; i <= intervals; ++i)
  {
    const double share = i / intervals;
    const double step = spacing == SnapshotSpacing::Linear ? share * last : std::pow(static_cast<double>(last), share);
    steps.push_back(std::min(last, static_cast<std::uint64_t>(std::llround(step))));
  }
  steps.back() = last;
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}
} // namespace shapeton
