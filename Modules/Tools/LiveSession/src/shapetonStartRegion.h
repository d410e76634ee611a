#ifndef shapetonStartRegion_h
#define shapetonStartRegion_h

#include "itkImage.h"

#include <vector>

namespace shapeton
{
using StartMask = itk::Image<unsigned char, 3>;

/** A ball in space: LPS, mm. A stroke of a brush is a row of balls. */
struct Ball
{
  itk::Point<double, 3> center;
  double                radius{ 0.0 };
};

/** The voxels whose centers are in one of the balls; null if there are none. */
StartMask::Pointer
MaskOfBalls(const itk::ImageBase<3> * image, const std::vector<Ball> & balls);

/** The voxels connected by faces to `seed` for which `isInside(voxel)` is true; null if it is false at the seed. */
template <typename TInside>
StartMask::Pointer
MaskOfComponent(const itk::ImageBase<3> * image, const itk::Index<3> & seed, const TInside & isInside)
{
  const auto mask = StartMask::New();
  mask->CopyInformation(image);
  mask->SetRegions(image->GetLargestPossibleRegion());
  mask->Allocate(true);
  std::vector<itk::Index<3>> front;
  const auto                 take = [&](const itk::Index<3> & index) {
    if (mask->GetBufferedRegion().IsInside(index) && mask->GetPixel(index) == 0 && isInside(mask->ComputeOffset(index)))
    {
      mask->SetPixel(index, 1);
      front.push_back(index);
    }
  };
  take(seed);
  if (front.empty())
  {
    return nullptr;
  }
  while (!front.empty())
  {
    const itk::Index<3> index = front.back();
    front.pop_back();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (const int step : { -1, 1 })
      {
        itk::Index<3> neighbor = index;
        neighbor[axis] += step;
        take(neighbor);
      }
    }
  }
  return mask;
}
} // namespace shapeton

#endif
