#include "shapetonHeatParameterChoice.h"

#include "shapetonHeatClassification.h"
#include "shapetonIntensityClasses.h"
#include "shapetonNumberText.h"
#include "shapetonExceptions.h"
#include "shapetonReducedVolume.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Window = std::array<double, 2>;
using Size = std::array<std::size_t, 3>;
using Spacing = std::array<double, 3>;

constexpr Window SoftTissue = { { -160.0, 240.0 } }; // HU, the usual window of the abdomen
/** 1/p in units of the median difference between neighbors; beyond 2, edges leak in all nine real volumes tested. */
constexpr std::array<double, 2> Cuts = { { 1.0, 2.0 } };
constexpr double                LeastP = 2.0;
constexpr double                GreatestP = 50.0;
/** Steps on the copy, about a factor of 3 apart: from local shape to large objects. */
constexpr std::array<std::uint64_t, 6> TrialSteps = { { 30, 100, 300, 1000, 3000, 10000 } };
/** Smoothing in units of the smallest spacing of the copy: slightly more than the smoothing caused by averaging over
 * its voxels. */
constexpr double Smoothing = 0.35;
/** Noise between neighbors of more than this many times 1/p insulates too many voxels unless the volume is smoothed. */
constexpr double GreatestNoise = 0.25;
/** The soft tissue window of CT is not used if it shows fewer regions than this, hardly more than one. */
constexpr double LeastRegions = 1.5;

/** Whether a sorted sample looks like HU: much air and much soft tissue. */
bool
LooksLikeCt(const std::vector<float> & sample)
{
  const auto share = [&](float lower, float upper) {
    const auto first = std::lower_bound(sample.begin(), sample.end(), lower);
    return static_cast<double>(std::upper_bound(first, sample.end(), upper) - first) /
           static_cast<double>(sample.size());
  };
  constexpr float  leastAir = -1100.0F; // HU
  constexpr float  mostAir = -800.0F;
  constexpr float  leastTissue = -150.0F;
  constexpr float  mostTissue = 150.0F;
  constexpr double leastShare = 0.03;
  return share(leastAir, mostAir) > leastShare && share(leastTissue, mostTissue) > leastShare;
}

/** One combination of parameters on the copy. */
struct Trial
{
  Window        window{};
  double        p{ 0.0 };
  std::uint64_t timeSteps{ 0 };
  double        median{ 0.0 }; ///< difference of neighbors, in units of the window
  double        cut{ 0.0 };    ///< 1/p in units of the median
  double        regions{ -1.0 };
};

/** Calls `body` with the value of each voxel scaled by the window and those of its next `number` - 1 neighbors along an
 * axis, if all are in the domain and strictly inside the window, and with the index of the voxel. */
template <unsigned int number, typename TBody>
void
VisitInside(const VolumeView & volume, const Window & window, unsigned int axis, const TBody & body)
{
  const Size &      size = volume.size;
  const Size        strides = { 1, size[0], size[0] * size[1] };
  constexpr auto    wanted = std::size_t{ 1 } << 19;
  const std::size_t voxels = volume.NumberOfVoxels();
  const std::size_t step = std::max<std::size_t>(1, voxels / wanted) | 1; // odd: no pattern on even grids
  for (std::size_t voxel = 0; voxel < voxels; voxel += step)
  {
    if (voxel / strides[axis] % size[axis] + number > size[axis])
    {
      continue;
    }
    std::array<double, number> scaled{};
    bool                       inside = true;
    for (unsigned int i = 0; i < number; ++i)
    {
      const std::size_t at = voxel + i * strides[axis];
      scaled[i] = (volume.values[at] - window[0]) / (window[1] - window[0]);
      inside &= scaled[i] > 0.0 && scaled[i] < 1.0 && volume.IsInDomain(at);
    }
    if (inside)
    {
      body(scaled, voxel);
    }
  }
}

double
Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  if (values.empty())
  {
    return 0.0;
  }
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Median nonzero half gradient inside the window; 0 if there is none. */
double
MedianDifference(const VolumeView & copy, const Window & window)
{
  std::vector<double> differences;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double resolution = copy.spacing[axis] / SmallestSpacing(copy.spacing);
    VisitInside<2>(copy, window, axis, [&](const std::array<double, 2> & v, std::size_t) {
      if (v[0] != v[1])
      {
        differences.push_back(VolumeGradientOperator::HalfGradient(v[0], v[1], resolution));
      }
    });
  }
  return Median(differences);
}

/** Whether a voxel has the value of all its neighbors, as in padding, a removed background or clipped intensities. */
bool
IsInConstant(const VolumeView & volume, std::size_t voxel)
{
  const Size & size = volume.size;
  const Size   strides = { 1, size[0], size[0] * size[1] };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = voxel / strides[axis] % size[axis];
    if ((place > 0 && volume.values[voxel - strides[axis]] != volume.values[voxel]) ||
        (place + 1 < size[axis] && volume.values[voxel + strides[axis]] != volume.values[voxel]))
    {
      return false;
    }
  }
  return true;
}

/** Standard deviation of the noise inside the window, from second differences, which vanish in linear slopes. Constant
 * parts of the volume tell nothing about the noise of the others. */
double
NoiseInside(const VolumeView & volume, const Window & window)
{
  constexpr double    perMedian = 1.4826; // standard deviation of a normal variable over its median absolute value
  const double        perDifference = std::sqrt(6.0);
  std::vector<double> differences;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? volume.size[0] : volume.size[0] * volume.size[1];
    VisitInside<3>(volume, window, axis, [&](const std::array<double, 3> & v, std::size_t first) {
      if (!IsInConstant(volume, first + stride))
      {
        differences.push_back(std::abs(v[0] - 2.0 * v[1] + v[2]));
      }
    });
  }
  return perMedian * Median(differences) / perDifference;
}

/** \class Trials
 * \brief Diffusions on the copy; keeps the best one. */
class Trials
{
public:
  Trials(ReducedVolume copy, const CumulativeHeatDiffusionOptions & options, const GivenHeatParameters & given)
    : m_ReducedVolume(std::move(copy)), m_Settings{ options }, m_Given(given)
  {
    m_Settings.smoothing = 0.0;
    m_Settings.untilSteady = false;
    m_Settings.snapshotSteps.assign(TrialSteps.begin(), TrialSteps.end());
    if (given.timeSteps)
    {
      const double onReducedVolume =
        static_cast<double>(*given.timeSteps) / (m_ReducedVolume.factor * m_ReducedVolume.factor);
      m_Settings.snapshotSteps = { std::max<std::uint64_t>(1,
                                                           static_cast<std::uint64_t>(std::llround(onReducedVolume))) };
    }
    m_Settings.timeSteps = m_Settings.snapshotSteps.back();
  }

  const ReducedVolume &
  GetCopy() const
  {
    return m_ReducedVolume;
  }

  /** Tries the given p, or several, with a window. */
  void
  TryWindow(const Window & window, const Progress & progress)
  {
    if (!(window[1] > window[0]))
    {
      return;
    }
    const double median = MedianDifference(m_ReducedVolume, window);
    if (m_Given.p)
    {
      this->Try({ window, *m_Given.p / m_ReducedVolume.factor, 0, median, 0.0 }, progress);
      return;
    }
    for (std::size_t i = 0; i < Cuts.size(); ++i)
    {
      const double p = median > 0.0 ? std::clamp(1.0 / (Cuts[i] * median), LeastP, GreatestP) : LeastP;
      const double share = 1.0 / Cuts.size();
      this->Try({ window, p, 0, median, Cuts[i] }, progress.Part("", i * share, (i + 1) * share));
    }
  }

  const Trial &
  GetBest() const
  {
    return m_Best;
  }

private:
  /** Tries all times with one window and one p. */
  void
  Try(const Trial & trial, const Progress & progress)
  {
    m_Settings.p = trial.p;
    m_Settings.intensityWindow = trial.window;
    const VolumeGradientOperator volumeGradient(m_ReducedVolume, m_Settings, m_Settings.conductance);
    std::vector<float>           heat(m_ReducedVolume.NumberOfVoxels());
    DiffuseCumulativeHeat(
      m_ReducedVolume,
      m_Settings,
      heat.data(),
      nullptr,
      [&](std::uint64_t step, const std::vector<float> & now) {
        HeatHistogram row({ step });
        row.AddToRow(0, now.data(), now.size());
        auto         classes = FindHeatClasses(row, 0);
        const double count = MeasureCoherence(volumeGradient, now.data(), classes);
        if (count > m_Best.regions)
        {
          m_Best = trial;
          m_Best.timeSteps = step;
          m_Best.regions = count;
        }
      },
      progress);
  }

  ReducedVolume                   m_ReducedVolume;
  CumulativeHeatDiffusionSettings m_Settings;
  GivenHeatParameters             m_Given;
  Trial                           m_Best;
};

std::string
Text(double value, int digits)
{
  return NumberText(value, digits);
}

/** Tries the given window, or all candidates; returns the reason for the best one. */
std::string
TryWindows(Trials & trials, const GivenHeatParameters & given, const std::string & modality, const Progress & progress)
{
  if (given.intensityWindow || given.p)
  {
    VolumeGradientOptions options;
    options.intensityWindow = given.intensityWindow;
    trials.TryWindow(WindowOf(options, trials.GetCopy()), progress);
    return given.intensityWindow ? "" : "the range of the volume, to which the given p refers";
  }
  const auto sample = SampleIntensities(trials.GetCopy());
  const bool isCt = modality == "CT" || (modality.empty() && LooksLikeCt(sample));
  if (isCt)
  {
    constexpr double share = 0.4;
    trials.TryWindow(SoftTissue, progress.Part("", 0.0, share));
    if (trials.GetBest().regions >= LeastRegions)
    {
      return std::string("soft tissue, ") +
             (modality.empty() ? "because the intensities look like HU" : "because the modality is CT");
    }
  }
  auto ends = FindIntensityClasses(sample);
  std::transform(ends.begin(), ends.end(), ends.begin(), [](double end) { return RoundedNumber(end, 3); });
  const std::array<Window, 4> windows = {
    { { { ends[0], ends[3] } }, { { ends[1], ends[3] } }, { { ends[0], ends[2] } }, { { ends[1], ends[2] } } }
  };
  const double begin = isCt ? 0.5 : 0.0;
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    const double share = (1.0 - begin) / windows.size();
    trials.TryWindow(windows[i], progress.Part("", begin + i * share, begin + (i + 1) * share));
  }
  return "of four windows between the dark (up to " + Text(ends[1], 3) + ") and the bright (from " + Text(ends[2], 3) +
         ") of three intensity classes, it shows most regions bounded by edges";
}

void
ChooseSmoothing(const VolumeView &          volume,
                const GivenHeatParameters & given,
                const ReducedVolume &       copy,
                HeatParameterChoice &       choice)
{
  if (given.smoothing || given.p)
  {
    choice.smoothing = given.smoothing.value_or(0.0);
    return;
  }
  const double noise = NoiseInside(volume, choice.intensityWindow) * std::sqrt(2.0);
  const bool   insulates = noise * choice.p > GreatestNoise;
  choice.smoothing = insulates ? RoundedNumber(Smoothing * SmallestSpacing(copy.spacing), 2) : 0.0;
  choice.smoothingReason = "noise between neighbors has a standard deviation of " + Text(noise, 2) +
                           " of the window, " + (insulates ? "more" : "not more") + " than a quarter of 1/p";
}
void
RequireValues(const VolumeView & volume)
{
  const std::size_t voxels = volume.NumberOfVoxels();
  if (volume.values == nullptr || voxels == 0)
  {
    throw InputError("the volume is empty; update the filter that makes it");
  }
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    if (!std::isfinite(volume.values[voxel]) && volume.IsInDomain(voxel))
    {
      throw InputError("voxel " + std::to_string(voxel) + " of the volume is not a finite number; replace it");
    }
  }
}
} // namespace

void
HeatParameterChoice::ApplyTo(VolumeDiffusionOptions & options) const
{
  if (intensityWindow[0] < intensityWindow[1])
  {
    options.intensityWindow = intensityWindow;
  }
  options.p = p;
  options.smoothing = smoothing;
  options.timeSteps = timeSteps;
}

GivenHeatParameters
GivenAmong(const std::vector<std::string> & names, const VolumeDiffusionOptions & options)
{
  const auto has = [&](const char * name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  GivenHeatParameters given;
  given.intensityWindow = options.intensityWindow;
  if (has("p"))
  {
    given.p = options.p;
  }
  if (has("smoothing"))
  {
    given.smoothing = options.smoothing;
  }
  if (has("timeSteps"))
  {
    given.timeSteps = options.timeSteps;
  }
  return given;
}

HeatParameterChoice
ChooseHeatParameters(const VolumeView &                     volume,
                     const CumulativeHeatDiffusionOptions & options,
                     const GivenHeatParameters &            given,
                     const Progress &                       progress)
{
  RequireWindow(options.intensityWindow);
  RequireWindow(given.intensityWindow);
  CumulativeHeatDiffusionOptions all = options;
  all.p = given.p.value_or(options.p);
  all.smoothing = given.smoothing.value_or(options.smoothing);
  all.timeSteps = given.timeSteps.value_or(options.timeSteps);
  CheckOptions(all);
  RequireValues(volume);
  HeatParameterChoice choice;
  choice.intensityWindow = WindowOf(options, volume);
  choice.p = given.p.value_or(options.p);
  choice.smoothing = given.smoothing.value_or(0.0);
  choice.timeSteps = given.timeSteps.value_or(1);
  if (given.p && given.timeSteps)
  {
    return choice;
  }
  VolumeView relative(volume);
  relative.spacing = options.ignoreSpacing ? Spacing{ { 1.0, 1.0, 1.0 } } : volume.spacing;
  Trials trials(ReduceVolume(relative), options, given);
  choice.windowReason = TryWindows(trials, given, volume.modality, progress);
  const ReducedVolume & copy = trials.GetCopy();
  const Trial &         best = trials.GetBest();
  const double          factor = copy.factor;
  if (best.regions < 0.0)
  {
    choice.windowReason = "the volume is constant: the heat is 0 for any parameters";
    return choice;
  }
  if (!given.p)
  {
    choice.intensityWindow = best.window;
  }
  choice.regions = best.regions;
  choice.p = given.p.value_or(RoundedNumber(best.p * factor, 3));
  if (!given.p)
  {
    choice.pReason = "1/p is " + Text(best.cut, 1) + " times the median difference of neighbors (" +
                     Text(best.median / factor, 2) + " of the window)";
  }
  choice.timeSteps =
    static_cast<std::uint64_t>(std::llround(RoundedNumber(static_cast<double>(best.timeSteps) * factor * factor, 2)));
  if (given.timeSteps)
  {
    choice.timeSteps = *given.timeSteps;
  }
  else
  {
    choice.timeReason = "of " + std::to_string(TrialSteps.size()) + " times from " +
                        Text(TrialSteps.front() * factor * factor, 3) + " to " +
                        Text(TrialSteps.back() * factor * factor, 3) + " steps, it shows most regions bounded by edges";
  }
  ChooseSmoothing(volume, given, copy, choice);
  return choice;
}
} // namespace shapeton
