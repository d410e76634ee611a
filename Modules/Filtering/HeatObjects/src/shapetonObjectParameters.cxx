#include "shapetonObjectParameters.h"

#include "shapetonHeatObjects.h"
#include "shapetonIntensityClasses.h"
#include "shapetonNumberText.h"
#include "shapetonReducedVolume.h"
#include "shapetonWindowMerge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace shapeton
{
namespace
{
/** Half width of the window in units of the contrast: a wider window (5 %) leaves half of the foot's bones connected.
 */
constexpr double HalfWindow = 0.0125;
/** Any p above 2 insulates edges that span half of the window. */
constexpr double Steepness = 10.0;
/** Standard deviation in units of the smallest spacing: on the foot, the mean Dice was 0.68 with 0.6 and 0.74 with 0.8,
 * all other parameters being equal. */
constexpr double SmoothingPerSpacing = 0.8;
/** Separates all bones of the foot; 30,000 steps separate 11 of 12. */
constexpr std::uint64_t EvenSteps = 100'000;
/** Times to try, about a factor of 3 apart. Later, small objects in contact reach the same heat. */
constexpr std::array<std::uint64_t, 5> Times = { { 3000, 10'000, 30'000, 100'000, 300'000 } };

/** A later time, or a threshold with weaker edges, must show this many times as many objects. */
constexpr double ClearlyMore = 1.05;

/** Smallest mean difference between neighbors across the edge of an object, as a fraction of the contrast: an edge
 * blurred over eight voxels still reaches it, noise of a thirtieth of the contrast does not. */
constexpr double LeastStep = 0.05;

/** Another window is worth its time if it adds an object that is more probable than not. */
constexpr double LeastAdded = 0.5;

HeatParameterChoice
Apply(const GivenHeatParameters & given, HeatParameterChoice choice)
{
  choice.intensityWindow = given.intensityWindow.value_or(choice.intensityWindow);
  choice.p = given.p.value_or(choice.p);
  choice.smoothing = given.smoothing.value_or(choice.smoothing);
  choice.timeSteps = given.timeSteps.value_or(choice.timeSteps);
  choice.windowReason = given.intensityWindow ? "" : choice.windowReason;
  choice.pReason = given.p ? "" : choice.pReason;
  choice.smoothingReason = given.smoothing ? "" : choice.smoothingReason;
  choice.timeReason = given.timeSteps ? "" : choice.timeReason;
  return choice;
}

/** The volume itself if it is small, otherwise a reduced one. */
ReducedVolume
CopyOf(const VolumeView & volume)
{
  constexpr std::size_t small = 128 * 128 * 128; // as reduced volumes
  return volume.NumberOfVoxels() <= small ? ReducedVolume{ volume, 1.0 } : ReduceVolume(volume);
}

/** Mean difference between neighbors on opposite sides of a threshold; 0 if there are none. */
double
MeanStepAcross(const VolumeView & copy, double threshold)
{
  const std::array<std::size_t, 3> strides = { { 1, copy.size[0], copy.size[0] * copy.size[1] } };
  double                           sum = 0.0;
  double                           pairs = 0.0;
  for (std::size_t axis = 0; axis < strides.size(); ++axis)
  {
    for (std::size_t voxel = 0; voxel < copy.NumberOfVoxels(); ++voxel)
    {
      if (voxel / strides[axis] % copy.size[axis] + 1 < copy.size[axis])
      {
        const double low = std::min(copy.values[voxel], copy.values[voxel + strides[axis]]);
        const double high = std::max(copy.values[voxel], copy.values[voxel + strides[axis]]);
        const bool   isAcross = low < threshold && high >= threshold;
        sum += isAcross ? high - low : 0.0;
        pairs += isAcross ? 1.0 : 0.0;
      }
    }
  }
  return pairs > 0.0 ? sum / pairs : 0.0;
}

/** The thresholds to try, those with the strongest edges first: the two between three intensity classes; the midpoint
 * of the dark and the bright class, for volumes with two intensities; the upper one between three classes of the voxels
 * brighter than the dark class (in CT, between soft tissue and bone); and the lower one between three classes of the
 * voxels brighter than that (in CT, between spongy and compact bone). Thresholds within the texture of a class or next
 * to the dark class are omitted if there are others. */
std::vector<double>
ThresholdsOf(const VolumeView & copy, const std::vector<float> & sample, const std::array<double, 4> & classes)
{
  const auto bright = std::lower_bound(sample.begin(), sample.end(), static_cast<float>(classes[1]));
  const auto brightClasses = FindIntensityClasses({ bright, sample.end() });
  const auto brightest = std::lower_bound(sample.begin(), sample.end(), static_cast<float>(brightClasses[2]));
  const auto brightestClasses =
    brightest == sample.end() ? brightClasses : FindIntensityClasses({ brightest, sample.end() });
  std::vector<std::pair<double, double>> all; // negative step and threshold
  for (const double threshold :
       { classes[1], classes[2], 0.5 * (classes[0] + classes[3]), brightClasses[2], brightestClasses[1] })
  {
    all.emplace_back(-MeanStepAcross(copy, threshold), threshold);
  }
  std::sort(all.begin(), all.end());
  const double        contrast = classes[3] - classes[0];
  std::vector<double> thresholds;
  for (const auto & [step, threshold] : all)
  {
    const bool isInDark = threshold < classes[0] + LeastStep * contrast; // smoothing would move the border outward
    if (-step >= LeastStep * contrast && !isInDark)
    {
      thresholds.push_back(threshold);
    }
  }
  if (thresholds.empty())
  {
    thresholds.push_back(all.front().second);
  }
  return thresholds;
}

/** A choice and the objects it shows on the copy. */
struct Trial
{
  HeatParameterChoice choice;
  HeatObjectList      objects;
};

HeatObjectList
FindObjectsOf(const std::vector<float> & heat, const VolumeView & copy)
{
  const auto image = itk::Image<float, 3>::New();
  image->SetRegions(itk::Image<float, 3>::SizeType{ { copy.size[0], copy.size[1], copy.size[2] } });
  image->SetSpacing(itk::Vector<double, 3>(copy.spacing.data()));
  image->Allocate();
  std::copy(heat.begin(), heat.end(), image->GetBufferPointer());
  constexpr double  onCopy = 0.2; // objects have fewer voxels on a copy, and therefore a lower probability
  HeatObjectOptions options;
  options.leastProbability = onCopy;
  return FindHeatObjects({ image.GetPointer() }, options);
}

/** The times to try, keyed by the step on the copy. */
std::map<std::uint64_t, std::uint64_t>
TimesOnCopy(const ReducedVolume & copy, const std::optional<std::uint64_t> & given)
{
  std::map<std::uint64_t, std::uint64_t> timeOfStep;
  for (const std::uint64_t time :
       given ? std::vector<std::uint64_t>{ *given } : std::vector<std::uint64_t>(Times.begin(), Times.end()))
  {
    const double step = static_cast<double>(time) / (copy.factor * copy.factor);
    timeOfStep[std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(step)))] = time;
  }
  return timeOfStep;
}

/** Tries a choice on the copy; sets its time steps, unless they are given, and the number of its objects. */
Trial
TryTimes(const ReducedVolume &                  copy,
         const CumulativeHeatDiffusionOptions & options,
         const GivenHeatParameters &            given,
         const HeatParameterChoice &            choice,
         const Progress &                       progress)
{
  CumulativeHeatDiffusionSettings settings{ options };
  choice.ApplyTo(settings);
  settings.intensityWindow = choice.intensityWindow;
  settings.untilSteady = false;
  const auto timeOfStep = TimesOnCopy(copy, given.timeSteps);
  for (const auto & [step, time] : timeOfStep)
  {
    settings.snapshotSteps.push_back(step);
  }
  settings.timeSteps = settings.snapshotSteps.back();
  std::vector<float> heat(copy.NumberOfVoxels());
  Trial              best{ choice, {} };
  best.choice.regions = 0.0;
  best.choice.timeReason = given.timeSteps ? "" : "of five times, the first that shows about as many objects as any";
  DiffuseCumulativeHeat(
    copy,
    settings,
    heat.data(),
    nullptr,
    [&](std::uint64_t step, const std::vector<float> & now) {
      if (*std::max_element(now.begin(), now.end()) <= 0.0F)
      {
        return;
      }
      HeatObjectList objects = FindObjectsOf(now, copy);
      const double   number = SumOfProbabilities(objects.objects);
      if (number > ClearlyMore * best.choice.regions)
      {
        best.choice.regions = number;
        best.choice.timeSteps = timeOfStep.at(step);
        best.objects = std::move(objects);
      }
    },
    progress);
  return best;
}

/** One trial for each threshold. The one with the most objects comes first; among nearly equal ones, the one with the
 * strongest edges. */
std::vector<Trial>
TryThresholds(const ReducedVolume &                  copy,
              const std::vector<double> &            thresholds,
              double                                 contrast,
              const std::array<double, 3> &          spacing,
              const CumulativeHeatDiffusionOptions & options,
              const GivenHeatParameters &            given,
              const Progress &                       progress)
{
  std::vector<Trial> trials;
  std::size_t        best = 0;
  for (std::size_t i = 0; i < thresholds.size(); ++i)
  {
    const double share = 1.0 / thresholds.size();
    trials.push_back(TryTimes(copy,
                              options,
                              given,
                              Apply(given, ParametersAtThreshold(thresholds[i], contrast, spacing)),
                              progress.Part("Choosing parameters", i * share, (i + 1) * share)));
    best = trials[i].choice.regions > ClearlyMore * trials[best].choice.regions ? i : best;
  }
  std::rotate(trials.begin(), trials.begin() + best, trials.begin() + best + 1);
  std::stable_sort(trials.begin() + 1, trials.end(), [](const Trial & a, const Trial & b) {
    return a.choice.regions > b.choice.regions;
  });
  return trials;
}
} // namespace

HeatParameterChoice
ParametersAtThreshold(double threshold, double contrast, const std::array<double, 3> & spacing)
{
  constexpr int       digits = 4;
  HeatParameterChoice choice;
  const double        half = HalfWindow * contrast;
  choice.intensityWindow = { { RoundedNumber(threshold - half, digits), RoundedNumber(threshold + half, digits) } };
  choice.p = Steepness;
  choice.smoothing = RoundedNumber(SmoothingPerSpacing * SmallestSpacing(spacing), 2);
  choice.timeSteps = EvenSteps;
  choice.windowReason = "narrow, such that only edges across " + NumberText(threshold, digits) + " insulate";
  choice.pReason = "with this window, any edge across it insulates";
  choice.smoothingReason = "0.8 of the smallest spacing, against noise";
  return choice;
}

std::vector<HeatParameterChoice>
ChooseObjectWindows(const VolumeView &                     volume,
                    const CumulativeHeatDiffusionOptions & options,
                    const GivenHeatParameters &            given,
                    const Progress &                       progress)
{
  CheckOptions(options);
  const auto          spacing = options.ignoreSpacing ? std::array<double, 3>{ { 1.0, 1.0, 1.0 } } : volume.spacing;
  const ReducedVolume copy = CopyOf({ volume.values, volume.size, spacing });
  const auto          sample = SampleIntensities(copy);
  const auto          classes = FindIntensityClasses(sample);
  const double        contrast = classes[3] - classes[0];
  if (given.intensityWindow)
  {
    const auto choice = Apply(given, ParametersAtThreshold(0.0, contrast, spacing));
    return { given.timeSteps ? choice : TryTimes(copy, options, given, choice, progress).choice };
  }
  if (!(contrast > 0.0))
  {
    auto choice = Apply(given, ParametersAtThreshold(classes[0], 1.0, spacing));
    choice.windowReason = "the volume is constant: it has no objects";
    return { choice };
  }
  const auto thresholds = ThresholdsOf(copy, sample, classes);
  auto       trials = TryThresholds(copy, thresholds, contrast, spacing, options, given, progress);
  std::vector<HeatParameterChoice> choices;
  HeatObjectList                   list = std::move(trials[0].objects);
  for (Trial & trial : trials)
  {
    const bool   isFirst = choices.empty();
    const double added = isFirst || trial.choice.regions == 0.0 ? 0.0 : AddWindowObjects(trial.objects, list);
    if (isFirst || added >= LeastAdded)
    {
      trial.choice.windowReason +=
        ", of " + std::to_string(thresholds.size()) + " thresholds " +
        (isFirst ? "the one that shows most objects (" + NumberText(trial.choice.regions, 3) + ", by probability)"
                 : "one that shows further objects (" + NumberText(added, 3) + ", by probability)");
      choices.push_back(trial.choice);
    }
  }
  return choices;
}

HeatParameterChoice
ChooseObjectParameters(const VolumeView &                     volume,
                       const CumulativeHeatDiffusionOptions & options,
                       const GivenHeatParameters &            given,
                       const Progress &                       progress)
{
  return ChooseObjectWindows(volume, options, given, progress).front();
}
} // namespace shapeton
