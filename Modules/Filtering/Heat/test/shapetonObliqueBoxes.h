#ifndef shapetonObliqueBoxes_h
#define shapetonObliqueBoxes_h

#include "shapetonHeatSeeds.h"
#include "shapetonTestErrors.h"

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
  auto image = ImageType::New();
  image->SetRegions(itk::Size<3>{ { 30, 14, 9 } });
  const double              spacing[3] = { 0.8, 1.1, 2.0 };
  const double              origin[3] = { -40.0, 25.0, 300.0 };
  itk::Matrix<double, 3, 3> direction;
  direction.SetIdentity();
  direction[0][0] = direction[2][2] = std::cos(0.5);
  direction[0][2] = -std::sin(0.5);
  direction[2][0] = std::sin(0.5);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
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
