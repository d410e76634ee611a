#ifndef shapetonStartRegion_h
#define shapetonStartRegion_h

#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"

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

/** One layer of voxels: those with the coordinate of a voxel along an axis. */
StartMask::Pointer
MaskOfPlane(const itk::ImageBase<3> * image, const itk::Index<3> & voxel, unsigned int axis);

/** The voxels of either mask; the second one may be null. */
StartMask::Pointer
UnionOf(const StartMask * first, const StartMask * second);

/** The voxels connected by faces to `seed` for which `isInside(voxel)` is true; null if it is false at the seed. */
template <typename TInside>
StartMask::Pointer
MaskOfComponent(const itk::ImageBase<3> * image, const itk::Index<3> & seed, const TInside & isInside)
{
  const auto mask = NewImageOn<StartMask>(image, true);
  const auto first = static_cast<std::size_t>(mask->ComputeOffset(seed));
  return FillComponent(GridOf(mask), first, isInside, mask->GetBufferPointer()) ? mask : nullptr;
}
} // namespace shapeton

#endif
