#ifndef shapetonSmoothedRows_h
#define shapetonSmoothedRows_h

#include <vector>

namespace shapeton
{
/** Values in so many rows along the tube, averaged along them with a Gaussian of this standard deviation, rows;
 * constant beyond the ends. */
std::vector<double>
SmoothedRows(const std::vector<double> & values, int rows, double deviation);
} // namespace shapeton

#endif
