#include "shapetonPolypScore.h"

#include "shapetonWallBulges.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
PolypFeatures
FeaturesOf(const WallBulge & bulge)
{
  PolypFeatures features;
  features.shapeIndex = bulge.shapeIndex;
  features.roundness = bulge.leastWidth / bulge.greatestWidth;
  features.solidAngle = bulge.solidAngle;
  features.hollowness = -bulge.footCurvature * bulge.greatestWidth;
  features.curvedness = bulge.curvedness;
  features.prominence = bulge.height / bulge.greatestWidth;
  return features;
}

std::array<double, numberOfPolypTerms>
TermsOf(const PolypFeatures & features)
{
  constexpr double leastRoundness = 1e-3, leastHollowness = 0.05; // chosen: bound the logarithms
  constexpr double sharp = 0.25; // 1/mm; phantom polyps of at least 5.5 mm reach 0.28, false bulges on CT 0.3 to 0.7
  return { { features.shapeIndex,
             std::log(std::max(features.roundness, leastRoundness)),
             std::log(std::max(features.hollowness, leastHollowness)),
             std::log(std::max(features.curvedness / sharp, 1.0)) } };
}

// Fitted by FitPolypScore of Testing/Validation; see Documentation/validation/colon-polyps.md for the data and later
// tests of the weights.
const PolypWeights &
FittedPolypWeights()
{
  static const PolypWeights weights{ { 26.100, 5.838, 3.900, -8.594, -17.886 } };
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
} // namespace shapeton
