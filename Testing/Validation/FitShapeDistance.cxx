// Fits the constants of SignatureDistance() and ProbabilityOfSameShape() and prints them. usage: FitShapeDistance;
// takes some minutes. Uses generated shapes, seeds 1 to 64, and their copies.
//
// Units: root mean squares of the differences between copies and their shapes. Parts: fraction of copies whose nearest
// shape is the correct one, for each combination of parts. Probability: for random halves of the shapes, all copies are
// searched in that half; logistic regression (Newton's method) predicts whether the nearest entry is correct.
#include "LogisticRegression.h"
#include "ShapeCollection.h"

#include "shapetonPhiloxStream.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace shapeton;

namespace
{
constexpr unsigned int firstSeed = 1;
constexpr int          numberOfShapes = 64;
constexpr int          numberOfHalves = 8;
constexpr unsigned int allParts = 63;
using Parts = std::array<double, 6>;

Parts
PartsOf(const SignatureDifference & difference)
{
  return { difference.remainingHeat, difference.displacement, difference.spectrum,
           difference.surface,       difference.elongation,   difference.flatness };
}

/** A copy and its differences from all originals. */
struct Query
{
  std::size_t        shape;
  std::string        kind;
  std::vector<Parts> differences;
};

std::vector<Query>
Compare(const std::vector<MeasuredShape> & shapes)
{
  std::vector<Query> queries;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    for (const ShapeCopy & copy : shapes[i].copies)
    {
      Query query{ i, copy.kind, {} };
      for (const MeasuredShape & shape : shapes)
      {
        query.differences.push_back(PartsOf(DifferenceOf(copy.signature, shape.original)));
      }
      queries.push_back(query);
    }
  }
  return queries;
}

Parts
RootMeanSquares(const std::vector<Query> & queries)
{
  Parts units{};
  for (std::size_t part = 0; part < units.size(); ++part)
  {
    double sum = 0.0;
    for (const Query & query : queries)
    {
      sum += std::pow(query.differences[query.shape][part], 2);
    }
    units[part] = std::sqrt(sum / static_cast<double>(queries.size()));
  }
  return units;
}

/** Root mean square of the parts in a bit set, in units of each part. */
double
Distance(const Parts & difference, const Parts & units, unsigned int used)
{
  double sum = 0.0;
  int    count = 0;
  for (std::size_t part = 0; part < difference.size(); ++part)
  {
    if ((used >> part & 1U) != 0)
    {
      sum += std::pow(difference[part] / units[part], 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

void
PrintCombinations(const std::vector<Query> & queries, const Parts & units)
{
  const std::pair<const char *, unsigned int> combinations[] = {
    { "heat that leaves", 1 },    { "displacement", 2 },
    { "both curves", 3 },         { "spectrum", 4 },
    { "curves and spectrum", 7 }, { "surface, elongation, flatness", 56 },
    { "spectrum and those", 60 }, { "all", allParts }
  };
  std::printf("nearest of %d right:\n", numberOfShapes);
  for (const auto & [name, used] : combinations)
  {
    int right = 0;
    for (const Query & query : queries)
    {
      std::vector<double> distances;
      for (const Parts & difference : query.differences)
      {
        distances.push_back(Distance(difference, units, used));
      }
      const auto nearest = std::min_element(distances.begin(), distances.end()) - distances.begin();
      right += static_cast<std::size_t>(nearest) == query.shape ? 1 : 0;
    }
    std::printf("  %s: %.4f\n", name, static_cast<double>(right) / static_cast<double>(queries.size()));
  }
}

void
AddHalf(const std::vector<Query> & queries,
        const Parts &              units,
        const std::vector<bool> &  isEntry,
        LogisticSamples &          samples)
{
  for (const Query & query : queries)
  {
    std::size_t nearest = 0;
    double      first = 1e300, second = 1e300;
    for (std::size_t i = 0; i < isEntry.size(); ++i)
    {
      const double distance = isEntry[i] ? Distance(query.differences[i], units, allParts) : 1e300;
      second = distance < first ? first : std::min(second, distance);
      nearest = distance < first ? i : nearest;
      first = std::min(first, distance);
    }
    const Eigen::Vector3d terms(1.0, std::log(first), std::log(std::min(10.0, second / first)));
    samples.Add(terms, nearest == query.shape); // terms: constant, distance, margin
  }
}

LogisticSamples
DrawHalves(const std::vector<Query> & queries, const Parts & units)
{
  LogisticSamples samples;
  for (unsigned int half = 0; half < numberOfHalves; ++half)
  {
    PhiloxStream      stream(half, 0, 0);
    std::vector<bool> isEntry(numberOfShapes);
    for (std::size_t i = 0; i < isEntry.size(); ++i)
    {
      isEntry[i] = stream.Unit() < 0.5;
    }
    AddHalf(queries, units, isEntry, samples);
  }
  return samples;
}
} // namespace

int
main()
{
  const auto  shapes = Measure(GeneratedShapes(firstSeed, numberOfShapes));
  const auto  queries = Compare(shapes);
  const Parts units = RootMeanSquares(queries);
  std::printf("%zu copies; units:", queries.size());
  for (const double unit : units)
  {
    std::printf(" %.4f", unit);
  }
  std::printf("\n");
  PrintCombinations(queries, units);
  // With a light penalty, so a solution exists for fully separated shapes.
  const Eigen::Vector3d weights = FitLogistic(DrawHalves(queries, units), Eigen::VectorXd::Ones(3));
  std::printf("probability: %.3f, %.3f, %.3f\n", weights[0], weights[1], weights[2]);
  return 0;
}
