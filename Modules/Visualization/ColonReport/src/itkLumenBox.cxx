#include "itkLumenBox.h"

#include "itkVolumeReader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
std::vector<std::size_t>
LumenAreas(const Image<unsigned char, 3> * lumen, unsigned int axis)
{
  const auto               region = lumen->GetBufferedRegion();
  std::vector<std::size_t> areas(region.GetSize(axis), 0);
  const unsigned char *    value = lumen->GetBufferPointer();
  const auto               size = region.GetSize();
  SizeValueType            index[3];
  for (index[2] = 0; index[2] < size[2]; ++index[2])
  {
    for (index[1] = 0; index[1] < size[1]; ++index[1])
    {
      for (index[0] = 0; index[0] < size[0]; ++index[0])
      {
        areas[index[axis]] += *value++ != 0 ? 1 : 0;
      }
    }
  }
  return areas;
}

void
CheckParts(const ColonParts & colon)
{
  if (!colon.lumen || colon.lumen->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("a picture of the colon needs its lumen");
  }
  if (colon.ct &&
      (colon.ct->GetBufferedRegion() != colon.lumen->GetBufferedRegion() || !HaveSameGrid(colon.ct, colon.lumen)))
  {
    throw std::invalid_argument("the CT and the lumen of a colon lie on different grids");
  }
}

ImageRegion<3>
LumenBox(const Image<unsigned char, 3> * lumen, double mm)
{
  Index<3> first;
  Index<3> last;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::vector<std::size_t> areas = LumenAreas(lumen, axis);
    const auto                     isFilled = [](std::size_t area) { return area > 0; };
    const auto                     begin = std::find_if(areas.begin(), areas.end(), isFilled);
    const auto                     end = std::find_if(areas.rbegin(), areas.rend(), isFilled).base();
    if (begin == areas.end())
    {
      throw std::invalid_argument("the lumen of the colon is empty");
    }
    const auto start = lumen->GetBufferedRegion().GetIndex(axis);
    const auto room = static_cast<IndexValueType>(std::ceil(mm / lumen->GetSpacing()[axis]));
    first[axis] = start + (begin - areas.begin()) - room;
    last[axis] = start + (end - areas.begin()) - 1 + room;
  }
  ImageRegion<3> box;
  box.SetIndex(first);
  box.SetUpperIndex(last);
  box.Crop(lumen->GetBufferedRegion());
  return box;
}
} // namespace itk
