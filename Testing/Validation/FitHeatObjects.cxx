// Fits the weights of ProbabilityOf() in Filtering/HeatObjects and prints them. usage: FitHeatObjects; takes minutes.
// Uses random scenes, seeds 1 to 40, at both thresholds between three intensity classes. An object is right if its Dice
// with a label, or with a label and those nested in it, is at least 0.85. Logistic regression by Newton's method with a
// small penalty.
#include "RandomScenes.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonIntensityClasses.h"
#include "shapetonObjectParameters.h"

#include <Eigen/Dense>

#include <cstdio>

using namespace shapeton;

int
main()
{
  constexpr unsigned int seeds = 40;
  constexpr unsigned int side = 104;
  for (unsigned int seed = 1; seed <= seeds; ++seed)
  {
    const SceneVolume        volume = SampleScene(seed, side);
    const float * const      values = volume.image->GetBufferPointer();
    const std::size_t        voxels = volume.image->GetBufferedRegion().GetNumberOfPixels();
    const std::vector<float> all(values, values + voxels);
    const auto               classes = FindIntensityClasses(SampleIntensities(all));
    for (const int threshold : { 1, 2 })
    {
      const auto choice = ParametersAtThreshold(classes[threshold], classes[3] - classes[0], { 1.0, 1.0, 1.0 });
      CumulativeHeatDiffusionSettings settings;
      settings.intensityWindow = choice.intensityWindow;
      settings.p = choice.p;
      settings.smoothing = choice.smoothing;
      settings.timeSteps = choice.timeSteps;
      const auto heat = itk::Image<float, 3>::New();
      heat->CopyInformation(volume.image);
      heat->SetRegions(volume.image->GetBufferedRegion());
      heat->Allocate(true);
      DiffuseCumulativeHeat(values, { side, side, side }, settings, heat->GetBufferPointer());
      HeatObjectOptions objects;
      objects.leastProbability = 0.0;
      const auto list = FindHeatObjects({ heat }, objects);
      const auto agreement = CompareObjects(list, { heat.GetPointer() }, volume.labels);
      for (std::size_t i = 0; i < list.objects.size(); ++i)
      {
        const auto & o = list.objects[i];
        std::printf("%u %d %d %llu %g %g %g %g %g %g\n",
                    seed,
                    threshold,
                    o.isWarm,
                    static_cast<unsigned long long>(o.voxels),
                    o.growth,
                    o.range,
                    o.contrast,
                    o.compactness,
                    o.cut,
                    agreement.dice[i]);
      }
      std::fprintf(stderr, "seed %u threshold %d: %zu objects, labels:", seed, threshold, list.objects.size());
      for (const double dice : agreement.diceOfLabel)
      {
        std::fprintf(stderr, " %.2f", dice);
      }
      std::fprintf(stderr, "\n");
    }
  }
}
