#ifndef shapetonGaussianWeights_h
#define shapetonGaussianWeights_h

#include <cmath>
#include <vector>

namespace shapeton
{
/** Weights of a Gaussian with this standard deviation at whole numbers, as far as `reach` standard deviations to both
 * sides; their sum is 1, and the middle one is that of 0. A single weight of 1 where the deviation is 0.
 * \ingroup Base */
inline std::vector<double>
GaussianWeights(double deviation, double reach)
{
  const int           last = static_cast<int>(std::ceil(reach * deviation));
  std::vector<double> weights;
  double              sum = 0.0;
  for (int i = -last; i <= last; ++i)
  {
    weights.push_back(last > 0 ? std::exp(-0.5 * i * i / (deviation * deviation)) : 1.0);
    sum += weights.back();
  }
  for (double & weight : weights)
  {
    weight /= sum;
  }
  return weights;
}
} // namespace shapeton

#endif
