#include "itkHaustralFolds.h"

#include "itkFlatCoordinateMap.h"
#include "itkFoldMask.h"
#include "itkFoldShape.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
void
RequireValid(const HaustralFoldOptions & options)
{
  for (const double value : { options.minimumLength, options.minimumArea, options.smoothness, options.smoothingTime })
  {
    RequireUsage(value >= 0.0 && std::isfinite(value),
                 "the least length and area of a fold, smoothness and time of smoothing must not be negative");
  }
  RequireUsage(options.minimumElongation >= 1.0, "the least elongation of a fold must be at least 1");
  RequireUsage(options.minimumAngle >= 0.0 && options.minimumAngle <= 90.0,
               "the least angle of a fold against the tube must be from 0 to 90 degrees");
  RequireUsage(options.contrast > 0.0, "the contrast of the outline must be greater than 0");
  RequireUsage(options.publishedLow < options.publishedHigh, "the published interval must not be empty");
}

std::vector<char>
MaskOf(const FoldPicture & picture, const HaustralFoldOptions & options)
{
  if (options.scheme == HaustralFoldScheme::Published)
  {
    return ThresholdFolds(picture, options);
  }
  const CurvatureMixture mixture = FitCurvatureMixture(picture);
  return mixture.hasFolds ? CutFolds(picture, mixture, options) : std::vector<char>(picture.Size(), 0);
}

bool
IsFold(const HaustralFold & fold, const HaustralFoldOptions & options)
{
  return fold.length >= options.minimumLength && fold.area >= options.minimumArea &&
         fold.elongation >= options.minimumElongation && std::abs(fold.angle) >= options.minimumAngle;
}

Image<unsigned short, 2>::Pointer
EmptyLabels(const FlatColonGrid & grid)
{
  const auto labels = Image<unsigned short, 2>::New();
  SetFlatSpace(grid, labels);
  labels->Allocate(true);
  return labels;
}
} // namespace

HaustralFolds
FindHaustralFolds(const FlatColonGrid & grid, const HaustralFoldOptions & options)
{
  RequireValid(options);
  const FoldPicture                                picture = MakeFoldPicture(grid, options);
  std::vector<std::pair<HaustralFold, FoldPixels>> found;
  for (FoldPixels & pixels : ConnectedFolds(picture, MaskOf(picture, options)))
  {
    const HaustralFold fold = MeasureFold(grid, picture, pixels, 0.03);
    if (IsFold(fold, options))
    {
      found.emplace_back(fold, std::move(pixels));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto & a, const auto & b) {
    return a.first.centreUv.x() < b.first.centreUv.x();
  });
  HaustralFolds folds;
  folds.labels = EmptyLabels(grid);
  if (found.size() > std::numeric_limits<unsigned short>::max())
  {
    throw InputError("there are more than 65535 folds; is the surface very noisy?");
  }
  for (auto & [fold, pixels] : found)
  {
    fold.label = static_cast<int>(folds.folds.size()) + 1;
    for (const FlatPixel & pixel : pixels)
    {
      folds.labels->GetBufferPointer()[picture.Index(pixel.column, pixel.row)] =
        static_cast<unsigned short>(fold.label);
    }
    folds.folds.push_back(fold);
  }
  if (folds.folds.empty())
  {
    folds.warnings.push_back("no haustral folds were found: the wall is smooth, or what bulges is too small");
  }
  return folds;
}
} // namespace itk
