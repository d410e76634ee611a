#include "shapetonLumenTopology.h"

#include "itkDiscreteGaussianImageFilter.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Upper bound on the threshold (occupancy). Chosen far above 0.5; it only saves time and memory. */
constexpr float HighestLevel = 0.95F;

/** Threshold that preserves the number of voxels. It is near 0.5, so voxels with values far above 0.5 are only
 * counted. */
float
LevelOfEqualVolume(const OccupancyImage * image, std::size_t voxels)
{
  std::vector<float> values;
  std::size_t        above = 0;
  const float *      begin = image->GetBufferPointer();
  const float *      end = begin + image->GetBufferedRegion().GetNumberOfPixels();
  for (const float * value = begin; value != end; ++value)
  {
    if (*value > HighestLevel)
    {
      ++above;
    }
    else if (*value > 0.0F)
    {
      values.push_back(*value);
    }
  }
  if (above >= voxels || voxels - above > values.size())
  {
    return above >= voxels ? HighestLevel : 0.0F;
  }
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(voxels - above) - 1;
  std::nth_element(values.begin(), place, values.end(), std::greater<float>());
  return *place;
}

OccupancyImage::Pointer
SmoothedOccupancy(const OccupancyImage * sharp, double sigma, std::size_t voxels)
{
  auto filter = itk::DiscreteGaussianImageFilter<OccupancyImage, OccupancyImage>::New();
  filter->SetInput(sharp);
  filter->SetVariance(sigma * sigma);
  filter->SetUseImageSpacingOn();
  filter->SetMaximumError(0.001);
  filter->Update();
  OccupancyImage::Pointer smooth = filter->GetOutput();
  smooth->DisconnectPipeline();
  const float shift = 0.5F - LevelOfEqualVolume(smooth, voxels);
  float *     values = smooth->GetBufferPointer();
  for (std::size_t i = 0; i < smooth->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    values[i] = std::clamp(values[i] + shift, 0.0F, 1.0F);
  }
  return smooth;
}
} // namespace

OccupancyImage::Pointer
OccupancyFromMask(const LumenMaskImage * mask, double sigma)
{
  RequireParameter(sigma >= 0.0, "the smoothing of a lumen mask must not be negative");
  auto                  occupancy = NewImageOn<OccupancyImage>(mask);
  const std::size_t     size = mask->GetBufferedRegion().GetNumberOfPixels();
  const unsigned char * labels = mask->GetBufferPointer();
  float *               values = occupancy->GetBufferPointer();
  std::size_t           voxels = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    values[i] = labels[i] != 0 ? 1.0F : 0.0F;
    voxels += labels[i] != 0 ? 1 : 0;
  }
  return sigma > 0.0 && voxels > 0 ? SmoothedOccupancy(occupancy, sigma, voxels) : occupancy;
}
} // namespace shapeton
