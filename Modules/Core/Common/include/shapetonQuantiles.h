#ifndef shapetonQuantiles_h
#define shapetonQuantiles_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shapeton
{
/** \name Quantiles
 * The functions differ in the rank assigned to a fraction of n values, where the smallest value has rank 0. All return
 * 0 if there are no values. */
///@{
/** The value of rank n / 2, rounded down. \ingroup ShapetonCommon */
template <typename TValue>
TValue
UpperMedian(std::vector<TValue> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.empty() ? TValue{} : *middle;
}

/** The value of rank `share` (n - 1), rounded down. \ingroup ShapetonCommon */
template <typename TValue>
TValue
LowerQuantile(std::vector<TValue> values, double share)
{
  if (values.empty())
  {
    return {};
  }
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** The value of rank `share` (n - 1), rounded to the nearest rank. \ingroup ShapetonCommon */
template <typename TValue>
TValue
NearestQuantile(std::vector<TValue> values, double share)
{
  if (values.empty())
  {
    return {};
  }
  const auto place = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** The value of rank `share` (n - 1), interpolated between the two nearest ranks. \ingroup ShapetonCommon */
inline double
InterpolatedQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto   below = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), below, values.end());
  const double low = *below;
  const double high = below + 1 < values.end() ? *std::min_element(below + 1, values.end()) : low;
  return low + (rank - std::floor(rank)) * (high - low);
}

/** The value of rank `share` n, rounded down and at most n - 1, of values in ascending order.
 * \ingroup ShapetonCommon */
template <typename TValue>
TValue
SortedQuantile(const std::vector<TValue> & sorted, double share)
{
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  return sorted.empty() ? TValue{} : sorted[std::min(rank, sorted.size() - 1)];
}
///@}
} // namespace shapeton

#endif
