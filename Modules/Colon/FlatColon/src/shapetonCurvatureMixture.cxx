#include "shapetonCurvatureMixture.h"

#include "shapetonQuantiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int         rounds = 60;         // of expectation maximization; chosen: bounds the time
constexpr std::size_t mostSamples = 60000; // pixels; chosen: bounds the time of the fit
/** Minimum standard deviation of a class, 1/mm. Walls are not smoother than this, and it prevents classes from
 * collapsing. */
constexpr double leastDeviation = 0.01;
constexpr double greatestOdds = 6.0;
/** Initial mean curvature of folds, 1/mm: 0.1 at the rim of a fold 10 mm thick, reduced to about half by smoothing. */
constexpr double leastFold = 0.05;

/** Maximum weight of a pixel, in median pixel areas. A pixel of a pouch may cover thousands of square millimeters with
 * an unrepresentative curvature. */
constexpr double greatestArea = 20.0;

/** Initial mean of a class, as a quantile of the curvature, and its initial fraction. The sensitivity of the fit to the
 * start was not measured. */
struct Start
{
  double quantile;
  double share;
};
constexpr Start startOfWall{ 0.40, 0.5 };
constexpr Start startOfUneven{ 0.80, 0.4 };
constexpr Start startOfFold{ 0.97, 0.1 };

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
  const double most = samples.areas.empty() ? 0.0 : greatestArea * LowerQuantile(samples.areas, 0.5);
  for (double & area : samples.areas)
  {
    area = std::min(area, most);
  }
  return samples;
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

/** Area, and area-weighted sums of values and of their squares, for one class. */
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
    return { mean, std::max(leastDeviation, std::sqrt(std::max(0.0, second / area - mean * mean))), area / whole };
  }
};

/** Updates the classes; returns false if a class is empty. */
bool
Improve(const Samples & samples, CurvatureMixture & mixture)
{
  const std::array<CurvatureMixture::Class *, 3> classes{ &mixture.wall, &mixture.uneven, &mixture.fold };
  std::array<Moments, 3>                         moments;
  for (std::size_t i = 0; i < samples.values.size(); ++i)
  {
    const double          value = samples.values[i];
    std::array<double, 3> densities;
    double                sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      // Folds bulge more than the wall; this excludes weaker bulges, such as pouches.
      const bool isPossible = k < 2 || value > mixture.wall.mean;
      densities[k] = isPossible ? Density(*classes[k], value) + 1e-12 : 0.0;
      sum += densities[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      moments[k].Add(densities[k] / sum * samples.areas[i], value);
    }
  }
  const double whole = moments[0].area + moments[1].area + moments[2].area;
  for (int k = 0; k < 3; ++k)
  {
    if (!(moments[k].area > 0.0))
    {
      return false;
    }
    *classes[k] = moments[k].ToClass(whole);
  }
  return true;
}
} // namespace

double
CurvatureMixture::LogOdds(double curvature) const
{
  constexpr double least = 1e-30; // density; prevents the logarithm of 0
  const double     ofFold = Density(fold, curvature) / fold.share;
  const double     ofRest = (Density(wall, curvature) + Density(uneven, curvature)) / (wall.share + uneven.share);
  const double     odds = std::log((ofFold + least) / (ofRest + least));
  const double     signedOdds = curvature > fold.mean   ? std::max(odds, 0.0)
                                : curvature < wall.mean ? std::min(odds, 0.0)
                                                        : odds;
  return std::clamp(signedOdds, -greatestOdds, greatestOdds);
}

CurvatureMixture
FitCurvatureMixture(const FoldPicture & picture)
{
  const Samples    samples = TakeSamples(picture);
  CurvatureMixture mixture{
    { 0.0, 1.0, startOfWall.share }, { 0.0, 1.0, startOfUneven.share }, { 0.0, 1.0, startOfFold.share }, false
  };
  if (samples.values.empty())
  {
    return mixture;
  }
  const double half = std::max(leastDeviation, 0.5 * Deviation(samples.values));
  mixture.wall = { LowerQuantile(samples.values, startOfWall.quantile), half, startOfWall.share };
  mixture.uneven = { LowerQuantile(samples.values, startOfUneven.quantile), half, startOfUneven.share };
  mixture.fold = { LowerQuantile(samples.values, startOfFold.quantile), half, startOfFold.share };
  bool isAlive = true;
  for (int round = 0; round < rounds && isAlive; ++round)
  {
    isAlive = Improve(samples, mixture);
  }
  mixture.hasFolds = isAlive && mixture.fold.mean >= leastFold;
  return mixture;
}
} // namespace shapeton
