#include "shapetonFoldProbability.h"

#include "shapetonColonCylinder.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Curvature at the pixels; `ofPoints` as in ColonPosition. */
double
CurvatureAt(const FlatColonGrid & grid, const Eigen::VectorXd & ofPoints, int column, int row)
{
  const FlatSample sample = grid.SampleOfPixel(column, row);
  if (sample.face < 0 || sample.isBridged)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (ofPoints.size() == 0)
  {
    return sample.curvature;
  }
  double curvature = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    curvature += sample.barycentric[corner] * ofPoints[grid.Faces()(sample.face, corner)];
  }
  return curvature;
}

/** Probability (0 to 1) from inward curvature. */
std::vector<float>
BulgeOfPixels(const ColonPosition & position)
{
  const FlatColonGrid & grid = position.flat->Grid();
  std::vector<float>    curvature(static_cast<std::size_t>(grid.Rows()) * grid.Columns());
  ParallelFor(grid.Rows(), [&](std::size_t row) {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      curvature[row * grid.Columns() + column] =
        static_cast<float>(CurvatureAt(grid, position.curvature, column, static_cast<int>(row)));
    }
  });
  std::vector<float> sorted;
  std::copy_if(
    curvature.begin(), curvature.end(), std::back_inserter(sorted), [](float value) { return std::isfinite(value); });
  if (sorted.empty())
  {
    return std::vector<float>(curvature.size(), 0.0F);
  }
  std::sort(sorted.begin(), sorted.end());
  const float low = sorted[sorted.size() / 2];
  const float high = std::max(sorted[sorted.size() * 95 / 100], low + 1e-6F);
  for (float & value : curvature)
  {
    const float t = std::isfinite(value) ? std::clamp((value - low) / (high - low), 0.0F, 1.0F) : 0.0F;
    value = t * t * (3.0F - 2.0F * t);
  }
  return curvature;
}

/** Draws a Gaussian at a position of the map; where Gaussians overlap, the maximum is used. v may be outside [0,
 * circumference]. */
void
DrawPoint(const FlatColonGrid & grid, const Eigen::Vector2d & uv, double pixel, std::vector<float> & picture)
{
  constexpr double deviation = 2.5; // mm; chosen
  const int        reach = static_cast<int>(std::ceil(3.0 * deviation / pixel));
  const double     around = grid.Circumference();
  const auto       center = grid.PixelOfUv({ uv.x(), uv.y() - std::floor(uv.y() / around) * around });
  for (int j = -reach; j <= reach; ++j)
  {
    const int row = ((center.row + j) % grid.Rows() + grid.Rows()) % grid.Rows();
    for (int i = std::max(-reach, -center.column); i <= std::min(reach, grid.Columns() - 1 - center.column); ++i)
    {
      const double square = (i * i + j * j) * pixel * pixel / (deviation * deviation);
      float &      value = picture[static_cast<std::size_t>(row) * grid.Columns() + center.column + i];
      value = std::max(value, static_cast<float>(std::exp(-0.5 * square)));
    }
  }
}

/** Probability (0 to 1) from the distance to the line from one end of a fold through its center to the other end. */
std::vector<float>
DrawFolds(const ColonPosition & position)
{
  const FlatColonGrid & grid = position.flat->Grid();
  const double          around = grid.Circumference();
  const double          pixel = (grid.UvOfPixel(1, 0) - grid.UvOfPixel(0, 0)).norm();
  std::vector<float>    picture(static_cast<std::size_t>(grid.Rows()) * grid.Columns(), 0.0F);
  for (const HaustralFold & fold : position.folds)
  {
    for (const Eigen::Vector2d & end : fold.endUv)
    {
      const Eigen::Vector2d half(end.x() - fold.centerUv.x(),
                                 TurnDifference(end.y() / around, fold.centerUv.y() / around) * around);
      const int             pieces = std::max(2, static_cast<int>(half.norm() / pixel) + 1);
      for (int k = 0; k <= pieces; ++k)
      {
        DrawPoint(grid, fold.centerUv + half * k / pieces, pixel, picture);
      }
    }
  }
  return picture;
}
} // namespace

std::vector<float>
FoldProbability(const ColonPosition & position)
{
  const std::vector<float> drawn = DrawFolds(position);
  std::vector<float>       probability = BulgeOfPixels(position);
  std::transform(probability.begin(), probability.end(), drawn.begin(), probability.begin(), [](float a, float b) {
    return 0.5F * (a + b);
  });
  return probability;
}
} // namespace shapeton
