#include "shapetonIntensityClasses.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
std::vector<float>
SampleIntensities(const VolumeView & volume)
{
  constexpr std::size_t wanted = 500'000;
  const std::size_t     step = std::max<std::size_t>(1, volume.NumberOfVoxels() / wanted);
  std::vector<float>    sample;
  for (std::size_t i = 0; i < volume.NumberOfVoxels(); i += step)
  {
    if (volume.IsInDomain(i))
    {
      sample.push_back(volume.values[i]);
    }
  }
  std::sort(sample.begin(), sample.end());
  return sample;
}

std::array<double, 4>
FindIntensityClasses(const std::vector<float> & sample)
{
  constexpr int       bins = 256;
  constexpr double    extreme = 0.001;
  const auto          cut = static_cast<std::size_t>(extreme * static_cast<double>(sample.size()));
  const double        lower = sample[cut];
  const double        upper = sample[sample.size() - 1 - cut];
  std::vector<double> count(bins + 1, 0.0);
  std::vector<double> sum(bins + 1, 0.0);
  for (const float value : sample)
  {
    const double clamped = std::clamp<double>(value, lower, upper);
    const double place = upper > lower ? (clamped - lower) / (upper - lower) : 0.0;
    const int    bin = std::min(bins - 1, static_cast<int>(place * bins));
    count[bin + 1] += 1.0;
    sum[bin + 1] += clamped;
  }
  std::partial_sum(count.begin(), count.end(), count.begin());
  std::partial_sum(sum.begin(), sum.end(), sum.begin());
  const auto mean = [&](int first, int end) {
    return (sum[end] - sum[first]) / std::max(1.0, count[end] - count[first]);
  };
  const auto between = [&](int first, int end) { return (sum[end] - sum[first]) * mean(first, end); };
  double     most = -1.0;
  int        one = 0;
  int        two = 0;
  for (int i = 1; i < bins; ++i)
  {
    for (int j = i + 1; j < bins; ++j)
    {
      const double variance = between(0, i) + between(i, j) + between(j, bins);
      if (variance > most)
      {
        most = variance;
        one = i;
        two = j;
      }
    }
  }
  const double width = (upper - lower) / bins;
  return { mean(0, one), lower + one * width, lower + two * width, mean(two, bins) };
}
} // namespace shapeton
