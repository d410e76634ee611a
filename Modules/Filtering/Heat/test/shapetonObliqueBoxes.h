#ifndef shapetonObliqueBoxes_h
#define shapetonObliqueBoxes_h

#include "shapetonHeatSeeds.h"
#include "shapetonTestErrors.h"
#include "shapetonTestImages.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>

namespace obliqueboxes
{
using ImageType = itk::Image<short, 3>;
using shapeton::SeedImage;

/** Three boxes of 0, 300 and 600 along x, on an oblique and anisotropic grid. */
inline ImageType::Pointer
MakeBoxes()
{
  const auto image = basetest::NewImage<ImageType>(
    { { 30, 14, 9 } }, { 0.8, 1.1, 2.0 }, { -40.0, 25.0, 300.0 }, basetest::Rotation(1, -0.5));
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(static_cast<short>(300 * (it.GetIndex()[0] / 10)));
  }
  return image;
}

inline std::size_t
Count(const SeedImage * image, unsigned short label)
{
  const auto * const begin = image->GetBufferPointer();
  return static_cast<std::size_t>(
    std::count(begin, begin + image->GetLargestPossibleRegion().GetNumberOfPixels(), label));
}

/** Whether `work` throws with a message that contains `part`. */
inline testing::AssertionResult
Refuses(const std::function<void()> & work, const std::string & part)
{
  return basetest::Refuses<itk::ExceptionObject>(work, part);
}
} // namespace obliqueboxes

#endif
