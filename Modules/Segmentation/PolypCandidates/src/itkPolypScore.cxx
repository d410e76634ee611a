#include "itkPolypScore.h"

#include "itkWallBulges.h"

#include <algorithm>
#include <cmath>

namespace itk
{
PolypFeatures
FeaturesOf(const WallBulge & bulge)
{
  PolypFeatures features;
  features.shapeIndex = bulge.shapeIndex;
  features.roundness = bulge.leastWidth / bulge.greatestWidth;
  features.solidAngle = bulge.solidAngle;
  features.prominence = bulge.height / bulge.greatestWidth;
  features.width = bulge.greatestWidth;
  return features;
}

std::array<double, numberOfPolypTerms>
TermsOf(const PolypFeatures & features)
{
  const auto logarithm = [](double value) { return std::log(std::max(value, 1e-3)); };
  return { { features.shapeIndex,
             logarithm(features.roundness),
             logarithm(features.solidAngle / (2.0 * M_PI)),
             logarithm(features.prominence),
             logarithm(features.width / 10.0) } };
}

// Printed by Testing/Validation's FitPolypScore; see the README for what it was run on.
const PolypWeights &
FittedPolypWeights()
{
  static const PolypWeights weights{ { 44.400, 4.038, 1.354, 0.101, 1.455, -29.218 } };
  return weights;
}

double
PolypScore(const PolypFeatures & features, const PolypWeights & weights)
{
  const auto terms = TermsOf(features);
  double     sum = weights.back();
  for (int i = 0; i < numberOfPolypTerms; ++i)
  {
    sum += weights[i] * terms[i];
  }
  return 1.0 / (1.0 + std::exp(-sum));
}
} // namespace itk
