// Fits the weights of ProbabilityOf() in Filtering/HeatObjects and prints them. usage: FitHeatObjects; takes minutes.
// Uses random scenes, seeds 1 to 40, at both thresholds between three intensity classes. An object is right if its Dice
// with a label, or with a label and those nested in it, is at least 0.85. Logistic regression by Newton's method with a
// small penalty.
#include "LogisticRegression.h"
#include "RandomScenes.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonIntensityClasses.h"
#include "shapetonObjectParameters.h"
#include "shapetonTestImages.h"

#include <iostream>

using namespace shapeton;

namespace
{
/** All regions of one scene at a threshold. */
void
AddRegions(const SceneVolume & volume, const HeatParameterChoice & choice, LogisticSamples & samples)
{
  CumulativeHeatDiffusionSettings settings;
  choice.ApplyTo(settings);
  const auto heat = NewImageOn<itk::Image<float, 3>>(volume.image, true);
  DiffuseCumulativeHeat(VolumeView(volume.image.GetPointer()), settings, heat->GetBufferPointer());
  HeatObjectOptions options;
  options.leastProbability = 0.0;
  const auto list = FindHeatObjects({ heat }, options);
  const auto agreement = CompareObjects(list, volume.labels);
  for (std::size_t i = 0; i < list.objects.size(); ++i)
  {
    const auto      terms = ProbabilityTerms(list.objects[i]);
    Eigen::VectorXd withConstant(5);
    withConstant << Eigen::Map<const Eigen::Vector4d>(terms.data()), 1.0;
    samples.Add(withConstant, agreement.dice[i] >= wholeObject);
  }
}

/** Weights of the terms and the constant. */
Eigen::VectorXd
Fit(const LogisticSamples & samples)
{
  Eigen::VectorXd penalties = Eigen::VectorXd::Ones(5);
  penalties[4] = 0.0; // the constant
  return FitLogistic(samples, penalties);
}
} // namespace

int
main()
{
  constexpr unsigned int seeds = 40;
  constexpr unsigned int side = 104;
  LogisticSamples        samples;
  for (unsigned int seed = 1; seed <= seeds; ++seed)
  {
    const SceneVolume volume = SampleScene(seed, side);
    const auto        classes = FindIntensityClasses(SampleIntensities(VolumeView(volume.image.GetPointer())));
    for (const int threshold : { 1, 2 })
    {
      AddRegions(
        volume, ParametersAtThreshold(classes[threshold], classes[3] - classes[0], { 1.0, 1.0, 1.0 }), samples);
    }
  }
  std::cout << samples.terms.size()
            << " regions; weights of range, growth, compactness, voxels, and the constant: " << Fit(samples).transpose()
            << std::endl;
}
