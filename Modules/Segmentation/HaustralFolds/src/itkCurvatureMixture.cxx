#include "itkCurvatureMixture.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr int         rounds = 40;
constexpr std::size_t mostSamples = 200000;
constexpr double      leastDeviation = 1e-4; ///< 1/mm
constexpr double      greatestOdds = 6.0;
/** 1/mm that folds must bulge more than the wall does: the rim of a fold 4 mm thick has a mean curvature of 0.25, of
 * which smoothing leaves about half. */
constexpr double leastContrast = 0.04;

struct Samples
{
  std::vector<double> values;
  std::vector<double> areas;
};

Samples
TakeSamples(const FoldPicture & picture)
{
  Samples           samples;
  const std::size_t step = 1 + picture.Size() / mostSamples;
  for (std::size_t pixel = 0; pixel < picture.Size(); pixel += step)
  {
    if (picture.isWall[pixel])
    {
      samples.values.push_back(picture.curvature[pixel]);
      samples.areas.push_back(picture.AreaOf(pixel));
    }
  }
  return samples;
}

double
Percentile(std::vector<double> values, double share)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double
Deviation(const std::vector<double> & values)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values)
  {
    sum += value;
    squares += value * value;
  }
  const auto number = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / number - sum / number * (sum / number)));
}

double
Density(const CurvatureMixture::Class & one, double value)
{
  const double z = (value - one.mean) / one.deviation;
  return one.share * std::exp(-0.5 * z * z) / one.deviation;
}

/** Area, and its sums with values and their squares, of one class. */
struct Moments
{
  double area{ 0.0 };
  double first{ 0.0 };
  double second{ 0.0 };

  void
  Add(double part, double value)
  {
    area += part;
    first += part * value;
    second += part * value * value;
  }
  CurvatureMixture::Class
  ToClass(double whole) const
  {
    const double mean = first / area;
    return { mean, std::sqrt(std::max(0.0, second / area - mean * mean)) + leastDeviation, area / whole };
  }
};

/** False where a class has died out. */
bool
Improve(const Samples & samples, CurvatureMixture & mixture)
{
  Moments wall;
  Moments fold;
  for (std::size_t i = 0; i < samples.values.size(); ++i)
  {
    const double value = samples.values[i];
    const double ofWall = Density(mixture.wall, value) + 1e-12;
    const double ofFold = Density(mixture.fold, value) + 1e-12;
    const double share = ofFold / (ofWall + ofFold);
    wall.Add((1.0 - share) * samples.areas[i], value);
    fold.Add(share * samples.areas[i], value);
  }
  if (!(wall.area > 0.0 && fold.area > 0.0))
  {
    return false;
  }
  const double whole = wall.area + fold.area;
  mixture.wall = wall.ToClass(whole);
  mixture.fold = fold.ToClass(whole);
  return true;
}
} // namespace

double
CurvatureMixture::LogOdds(double curvature) const
{
  const auto   zSquare = [curvature](const Class & one) { return std::pow((curvature - one.mean) / one.deviation, 2); };
  const double odds = std::log(fold.share / wall.share) + std::log(wall.deviation / fold.deviation) +
                      0.5 * (zSquare(wall) - zSquare(fold));
  const double signedOdds = curvature > fold.mean   ? std::max(odds, 0.0)
                            : curvature < wall.mean ? std::min(odds, 0.0)
                                                    : odds;
  return std::clamp(signedOdds, -greatestOdds, greatestOdds);
}

CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture)
{
  const Samples    samples = TakeSamples(picture);
  CurvatureMixture mixture{ { 0.0, 1.0, 0.85 }, { 1.0, 1.0, 0.15 }, false };
  if (samples.values.empty())
  {
    return mixture;
  }
  const double half = std::max(leastDeviation, 0.5 * Deviation(samples.values));
  mixture.wall = { Percentile(samples.values, 0.40), half, 0.85 };
  mixture.fold = { Percentile(samples.values, 0.96), half, 0.15 };
  bool isAlive = true;
  for (int round = 0; round < rounds && isAlive; ++round)
  {
    isAlive = Improve(samples, mixture);
  }
  mixture.hasFolds = isAlive && mixture.fold.mean > 0.0 && mixture.fold.mean - mixture.wall.mean >= leastContrast;
  return mixture;
}
} // namespace itk
