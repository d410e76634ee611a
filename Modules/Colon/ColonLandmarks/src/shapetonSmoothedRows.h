#ifndef shapetonSmoothedRows_h
#define shapetonSmoothedRows_h

#include <vector>

namespace shapeton
{
/** Weights of a Gaussian at whole numbers as far as four standard deviations to both sides; their sum is 1. */
std::vector<double>
GaussianWeights(double deviation);

/** Values in so many rows along the tube, averaged along them with a Gaussian of this standard deviation, rows;
 * constant beyond the ends. */
std::vector<double>
SmoothedRows(const std::vector<double> & values, int rows, double deviation);
} // namespace shapeton

#endif
