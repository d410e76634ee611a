#ifndef shapetonGaussianWeights_h
#define shapetonGaussianWeights_h

#include <cmath>
#include <vector>

namespace shapeton
{
/** Weights of a Gaussian with this standard deviation at integer offsets, up to `reach` standard deviations on both
 * sides. They sum to 1; the middle weight belongs to offset 0. For a deviation of 0, returns a single weight of 1.
 * \ingroup ShapetonCommon */
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
