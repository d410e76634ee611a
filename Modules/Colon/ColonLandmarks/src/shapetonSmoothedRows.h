#ifndef shapetonSmoothedRows_h
#define shapetonSmoothedRows_h

#include <vector>

namespace shapeton
{
/** Row values smoothed along the tube by a Gaussian of this standard deviation (rows); constant beyond the ends. */
std::vector<double>
SmoothedRows(const std::vector<double> & values, int rows, double deviation);
} // namespace shapeton

#endif
