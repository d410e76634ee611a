#ifndef shapetonDiffusionTestImages_h
#define shapetonDiffusionTestImages_h

#include "shapetonDiffusionTestVolumes.h"
#include "shapetonTestImages.h"

namespace shapeton
{
namespace test
{
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeImage(const Volume & volume, double scale = 1.0)
{
  auto image = basetest::NewImage<itk::Image<TPixel, 3>>({ { volume.size[0], volume.size[1], volume.size[2] } });
  std::transform(volume.values.begin(), volume.values.end(), image->GetBufferPointer(), [scale](float value) {
    return static_cast<TPixel>(scale * value);
  });
  return image;
}

/** The voxels of an image in memory, x fastest. */
template <typename TImage>
std::vector<typename TImage::PixelType>
VoxelsOf(const TImage * image)
{
  const auto * const voxels = image->GetBufferPointer();
  return { voxels, voxels + image->GetBufferedRegion().GetNumberOfPixels() };
}
} // namespace test
} // namespace shapeton

#endif
