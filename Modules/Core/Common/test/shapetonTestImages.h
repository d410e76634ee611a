#ifndef shapetonTestImages_h
#define shapetonTestImages_h

#include "shapetonMappedImage.h"

#include <array>
#include <cmath>

namespace basetest
{
/** Rotation about an axis, radians. */
inline itk::Matrix<double, 3, 3>
Rotation(unsigned int axis, double angle)
{
  const unsigned int        a = (axis + 1) % 3, b = (axis + 2) % 3;
  itk::Matrix<double, 3, 3> matrix;
  matrix.SetIdentity();
  matrix(a, a) = matrix(b, b) = std::cos(angle);
  matrix(b, a) = std::sin(angle);
  matrix(a, b) = -matrix(b, a);
  return matrix;
}

/** An image of zeros. */
template <typename TImage>
typename TImage::Pointer
NewImage(const typename TImage::SizeType & size,
         const std::array<double, 3> &     spacing = { { 1.0, 1.0, 1.0 } },
         const std::array<double, 3> &     origin = {},
         const itk::Matrix<double, 3, 3> & direction = Rotation(0, 0.0))
{
  const auto image = TImage::New();
  image->SetRegions(size);
  image->SetSpacing(spacing.data());
  image->SetOrigin(origin.data());
  image->SetDirection(direction);
  image->Allocate(true);
  return image;
}

/** An image on the grid of another one, without pixels. */
template <typename TImage>
typename TImage::Pointer
WithoutPixels(const itk::ImageBase<3> * grid)
{
  const auto image = TImage::New();
  image->CopyInformation(grid);
  image->SetRegions(grid->GetLargestPossibleRegion());
  return image;
}

/** Calls `body` with the index and the point of each voxel. */
template <typename TBody>
void
ForVoxels(const itk::ImageBase<3> * image, const TBody & body)
{
  const auto voxels = static_cast<itk::OffsetValueType>(image->GetBufferedRegion().GetNumberOfPixels());
  for (itk::OffsetValueType i = 0; i < voxels; ++i)
  {
    const itk::Index<3>   index = image->ComputeIndex(i);
    itk::Point<double, 3> point;
    image->TransformIndexToPhysicalPoint(index, point);
    body(index, point);
  }
}

/** Sets each voxel to the value of a function at its point. */
template <typename TImage, typename TFunction>
void
Sample(TImage * image, const TFunction & valueAt)
{
  ForVoxels(image, [&](const itk::Index<3> & index, const itk::Point<double, 3> & point) {
    image->SetPixel(index, static_cast<typename TImage::PixelType>(valueAt(point)));
  });
}
} // namespace basetest

#endif
