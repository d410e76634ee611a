// Fits the weights of ProbabilityOf() in Filtering/HeatObjects and prints them. usage: FitHeatObjects; takes minutes.
// Uses random scenes, seeds 1 to 40, at both thresholds between three intensity classes. An object is right if its Dice
// with a label, or with a label and those nested in it, is at least 0.85. Logistic regression by Newton's method with a
// small penalty.
#include "LogisticRegression.h"
#include "RandomScenes.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonIntensityClasses.h"
#include "shapetonObjectParameters.h"

#include <iostream>

using namespace shapeton;

namespace
{
struct Samples
{
  std::vector<std::array<double, 4>> terms;
  std::vector<double>                isWhole;
};

/** All regions of one scene at a threshold. */
void
AddRegions(const SceneVolume & volume, const HeatParameterChoice & choice, Samples & samples)
{
  CumulativeHeatDiffusionSettings settings;
  choice.ApplyTo(settings);
  const auto heat = itk::Image<float, 3>::New();
  heat->CopyInformation(volume.image);
  heat->SetRegions(volume.image->GetBufferedRegion());
  heat->Allocate(true);
  DiffuseCumulativeHeat(VolumeView(volume.image.GetPointer()), settings, heat->GetBufferPointer());
  HeatObjectOptions options;
  options.leastProbability = 0.0;
  const auto list = FindHeatObjects({ heat }, options);
  const auto agreement = CompareObjects(list, volume.labels);
  for (std::size_t i = 0; i < list.objects.size(); ++i)
  {
    samples.terms.push_back(ProbabilityTerms(list.objects[i]));
    samples.isWhole.push_back(agreement.dice[i] >= wholeObject ? 1.0 : 0.0);
  }
}

/** Weights of the terms and the constant. */
Eigen::VectorXd
Fit(const Samples & samples)
{
  const auto      rows = static_cast<Eigen::Index>(samples.terms.size());
  Eigen::MatrixXd terms(rows, 5);
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    terms.row(i) << samples.terms[i][0], samples.terms[i][1], samples.terms[i][2], samples.terms[i][3], 1.0;
  }
  Eigen::VectorXd penalties = Eigen::VectorXd::Ones(5);
  penalties[4] = 0.0; // the constant
  return FitLogistic(
    terms, Eigen::Map<const Eigen::VectorXd>(samples.isWhole.data(), rows), Eigen::VectorXd::Ones(rows), penalties);
}
} // namespace

int
main()
{
  constexpr unsigned int seeds = 40;
  constexpr unsigned int side = 104;
  Samples                samples;
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
