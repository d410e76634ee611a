#include "shapetonObjectParameters.h"

#include "shapetonHeatObjects.h"
#include "shapetonIntensityClasses.h"
#include "shapetonNumberText.h"
#include "shapetonReducedVolume.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
/** Half width of the window in units of the contrast: wider ones (5 %) leave half of the bones of the foot connected.
 */
constexpr double HalfWindow = 0.0125;
/** Any p above 2 insulates edges of half the window. */
constexpr double        Steepness = 10.0;
constexpr double        SmoothingPerSpacing = 0.8;
constexpr std::uint64_t EvenSteps = 100'000;

/** The number that a user types to repeat the run. */
double
Rounded(double value, int digits)
{
  const std::string text = NumberText(value, digits);
  double            rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

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

/** Sum of the probabilities of the objects on the copy. */
double
CountObjects(const ReducedVolume & copy, CumulativeHeatDiffusionSettings settings, const HeatParameterChoice & choice)
{
  settings.spacing = copy.spacing;
  settings.intensityWindow = choice.intensityWindow;
  settings.p = choice.p;
  settings.smoothing = choice.smoothing;
  const double steps = static_cast<double>(choice.timeSteps) / (copy.factor * copy.factor);
  settings.timeSteps = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(steps)));
  settings.histogramSteps.clear();
  settings.snapshotSteps.clear();
  settings.wantComponents = false;
  const auto heat = itk::Image<float, 3>::New();
  heat->SetRegions(itk::Image<float, 3>::SizeType{ { copy.size[0], copy.size[1], copy.size[2] } });
  heat->SetSpacing(itk::Vector<double, 3>(copy.spacing.data()));
  heat->Allocate(true);
  DiffuseCumulativeHeat(copy.values.data(), copy.size, settings, heat->GetBufferPointer());
  const float * const first = heat->GetBufferPointer();
  if (*std::max_element(first, first + copy.values.size()) <= 0.0F)
  {
    return 0.0;
  }
  double sum = 0.0;
  for (const HeatObject & object : FindHeatObjects({ heat.GetPointer() }).objects)
  {
    sum += object.probability;
  }
  return sum;
}
} // namespace

HeatParameterChoice
ParametersAtThreshold(double threshold, double contrast, const std::array<double, 3> & spacing)
{
  constexpr int       digits = 4;
  HeatParameterChoice choice;
  const double        half = HalfWindow * contrast;
  choice.intensityWindow = { { Rounded(threshold - half, digits), Rounded(threshold + half, digits) } };
  choice.p = Steepness;
  choice.smoothing = Rounded(SmoothingPerSpacing * SmallestSpacing(spacing), 2);
  choice.timeSteps = EvenSteps;
  choice.windowReason = "narrow, such that only edges across " + NumberText(threshold, digits) + " insulate";
  choice.pReason = "with this window, any edge across it insulates";
  choice.smoothingReason = "0.8 of the smallest spacing, against noise";
  choice.timeReason = "heat is even inside of objects, and little of it has passed their contacts";
  return choice;
}

HeatParameterChoice
ChooseObjectParameters(const float *                           intensities,
                       const std::array<std::size_t, 3> &      size,
                       const CumulativeHeatDiffusionSettings & settings,
                       const GivenHeatParameters &             given,
                       const Progress &                        progress)
{
  const auto          spacing = settings.ignoreSpacing ? std::array<double, 3>{ { 1.0, 1.0, 1.0 } } : settings.spacing;
  const ReducedVolume copy = ReduceVolume(intensities, size, spacing);
  const auto          classes = FindIntensityClasses(SampleIntensities(copy.values));
  const double        contrast = classes[3] - classes[0];
  if (given.intensityWindow)
  {
    return Apply(given, ParametersAtThreshold(0.0, contrast, spacing));
  }
  if (!(contrast > 0.0))
  {
    auto choice = Apply(given, ParametersAtThreshold(classes[0], 1.0, spacing));
    choice.windowReason = "the volume is constant: it has no objects";
    return choice;
  }
  HeatParameterChoice best;
  double              most = -1.0;
  for (const int threshold : { 1, 2 })
  {
    auto         choice = Apply(given, ParametersAtThreshold(classes[threshold], contrast, spacing));
    const double objects = CountObjects(copy, settings, choice);
    choice.windowReason += ", " + std::string(threshold == 1 ? "the lower" : "the upper") +
                           " of two thresholds between three intensity classes: it shows more objects (" +
                           NumberText(objects, 3) + ", by probability) than the other";
    if (objects > most)
    {
      most = objects;
      best = choice;
    }
    progress("Choosing parameters", threshold / 2.0);
  }
  best.regions = most;
  return best;
}
} // namespace shapeton
