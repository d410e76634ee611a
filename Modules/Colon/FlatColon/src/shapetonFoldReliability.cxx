#include "shapetonFoldReliability.h"

#include "shapetonSurfaceLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double widthOfBorder = 10.0; ///< mm

/** Distance to the cut at v = 0, mm on the surface. */
double
DistanceToBorder(const FlatColonGrid & grid, const Eigen::Vector2d & uv)
{
  const FlatPixel  pixel = grid.PixelOfUv(uv);
  const FlatSample sample = grid.SampleOfPixel(pixel.column, pixel.row);
  const double     scale = sample.face >= 0 ? sample.scale : 1.0;
  return scale * std::min(uv.y(), grid.Circumference() - uv.y());
}

double
DistanceToCurves(const CurveSet & curves, const Eigen::Vector3d & point)
{
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int> & curve : curves.curves)
  {
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const Eigen::Vector3d a = curves.V.row(curve[i]);
      const Eigen::Vector3d b = curves.V.row(curve[std::min(i + 1, curve.size() - 1)]);
      least = std::min(least, (ClosestPointOfTriangle(point, a, b, b) - point).norm());
    }
  }
  return least;
}
} // namespace

void
RateFold(const FoldPicture &         picture,
         const CurvatureMixture &    mixture,
         const HaustralFoldOptions & options,
         MeasuredFold &              measured)
{
  if (options.scheme == HaustralFoldScheme::Published)
  {
    measured.fold.reliability = std::clamp(measured.fold.meanCurvature / options.publishedLow, 0.0, 1.0);
    return;
  }
  double sum = 0.0;
  for (const FlatPixel & pixel : measured.pixels)
  {
    const double odds = mixture.LogOdds(picture.curvature[picture.Index(pixel.column, pixel.row)]);
    sum += 1.0 / (1.0 + std::exp(-odds));
  }
  measured.fold.reliability = std::clamp(2.0 * sum / static_cast<double>(measured.pixels.size()) - 1.0, 0.0, 1.0);
}

void
RateEnds(const FlatColonGrid & grid, const CurveSet * taeniae, std::vector<MeasuredFold> & folds)
{
  for (MeasuredFold & measured : folds)
  {
    HaustralFold & fold = measured.fold;
    for (int end = 0; end < 2; ++end)
    {
      const double distance =
        taeniae ? DistanceToCurves(*taeniae, fold.ends[end]) : DistanceToBorder(grid, fold.endUv[end]);
      const double z = distance / widthOfBorder;
      fold.endReliability[end] = fold.reliability * (0.5 + 0.5 * std::exp(-0.5 * z * z));
    }
  }
}
} // namespace shapeton
