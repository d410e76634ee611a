#include "shapetonShapeSearch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Coefficients computed by FitShapeDistance. */
constexpr SignatureDifference DifferenceOfCopies{ 0.0263, 0.0106, 0.0097, 0.0412, 0.0054, 0.0075 };
constexpr double              ProbabilityConstant = -1.650;
constexpr double              ProbabilityOfDistance = -1.354;
constexpr double              ProbabilityOfMargin = 2.042;

/** Heat considered as zero. */
constexpr double NegligibleHeat = 0.01;
constexpr double GreatestMargin = 10.0;
/** Distance between equal signatures; smaller than the distance between copies. */
constexpr double LeastDifference = 1e-3;

template <std::size_t Size>
double
RootMeanSquare(const std::array<double, Size> & a, const std::array<double, Size> & b, double offset)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < Size; ++i)
  {
    const double difference = std::log(a[i] + offset) - std::log(b[i] + offset);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(Size));
}

double
LogRatio(double a, double b)
{
  return std::abs(std::log(a) - std::log(b));
}

double
RelativeSurface(const ShapeSignature & shape)
{
  return shape.surface / std::cbrt(shape.volume * shape.volume);
}

/** Distance of the nearest entry whose name differs from that of the overall nearest; infinity if there is none. */
double
SecondDistance(const std::vector<ShapeNeighbor> & ranking, const std::vector<NamedShape> & entries)
{
  const std::string & first = entries[ranking.front().entry].name;
  const auto          second = std::find_if(ranking.begin(), ranking.end(), [&](const ShapeNeighbor & neighbor) {
    return entries[neighbor.entry].name != first;
  });
  return second == ranking.end() ? ranking.front().distance : second->distance;
}
} // namespace

SignatureDifference
DifferenceOf(const ShapeSignature & a, const ShapeSignature & b)
{
  SignatureDifference difference;
  difference.remainingHeat = RootMeanSquare(a.remainingHeat, b.remainingHeat, NegligibleHeat);
  difference.displacement = RootMeanSquare(a.displacement, b.displacement, 0.0);
  difference.spectrum = RootMeanSquare(a.spectrum, b.spectrum, 0.0);
  difference.surface = LogRatio(RelativeSurface(a), RelativeSurface(b));
  difference.elongation = LogRatio(a.elongation, b.elongation);
  difference.flatness = LogRatio(a.flatness, b.flatness);
  return difference;
}

double
SignatureDistance(const ShapeSignature & a, const ShapeSignature & b)
{
  const SignatureDifference   difference = DifferenceOf(a, b);
  const SignatureDifference & unit = DifferenceOfCopies;
  const double parts[] = { difference.remainingHeat / unit.remainingHeat, difference.displacement / unit.displacement,
                           difference.spectrum / unit.spectrum,           difference.surface / unit.surface,
                           difference.elongation / unit.elongation,       difference.flatness / unit.flatness };
  double       sum = 0.0;
  for (const double part : parts)
  {
    sum += part * part;
  }
  return std::sqrt(sum / std::size(parts));
}

double
ProbabilityOfSameShape(double distance, double margin)
{
  const double logit = ProbabilityConstant + ProbabilityOfDistance * std::log(std::max(distance, LeastDifference)) +
                       ProbabilityOfMargin * std::log(std::clamp(margin, 1.0, GreatestMargin));
  return 1.0 / (1.0 + std::exp(-logit));
}

ShapeSearchResult
FindShape(const ShapeSignature & shape, const std::vector<NamedShape> & entries, const ShapeSearchOptions & options)
{
  CheckOptions(options);
  if (entries.empty())
  {
    throw std::invalid_argument("The list of entries is empty");
  }
  ShapeSearchResult result;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    result.neighbors.push_back({ i, SignatureDistance(shape, entries[i].signature) });
  }
  std::stable_sort(result.neighbors.begin(), result.neighbors.end(), [](const auto & a, const auto & b) {
    return a.distance < b.distance;
  });
  const double first = std::max(result.neighbors.front().distance, LeastDifference);
  result.probability = ProbabilityOfSameShape(first, SecondDistance(result.neighbors, entries) / first);
  result.neighbors.resize(std::min<std::size_t>(options.nearest, result.neighbors.size()));
  return result;
}
} // namespace shapeton
