#include "shapetonLumenBox.h"

#include "shapetonImageGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Position of the first nonzero value at or after `begin`, or `end` if there is none. Tests eight voxels at once,
 * because most of a volume is not lumen. */
const unsigned char *
NextFilled(const unsigned char * begin, const unsigned char * end)
{
  std::uint64_t eight = 0;
  while (end - begin >= static_cast<std::ptrdiff_t>(sizeof(eight)))
  {
    std::memcpy(&eight, begin, sizeof(eight));
    if (eight != 0)
    {
      break;
    }
    begin += sizeof(eight);
  }
  return std::find_if(begin, end, [](unsigned char label) { return label != 0; });
}
} // namespace

LumenAreas
AreasOf(const itk::Image<unsigned char, 3> * lumen)
{
  const auto size = lumen->GetBufferedRegion().GetSize();
  LumenAreas areas;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    areas[axis].assign(size[axis], 0);
  }
  for (itk::SizeValueType row = 0; row < size[1] * size[2]; ++row)
  {
    const unsigned char * const begin = lumen->GetBufferPointer() + row * size[0];
    const unsigned char * const end = begin + size[0];
    for (const unsigned char * voxel = NextFilled(begin, end); voxel != end; voxel = NextFilled(voxel + 1, end))
    {
      ++areas[0][voxel - begin];
      ++areas[1][row % size[1]];
      ++areas[2][row / size[1]];
    }
  }
  return areas;
}

itk::ImageRegion<3>
LumenBox(const itk::Image<unsigned char, 3> * lumen, const LumenAreas & areas, double margin)
{
  const auto    isFilled = [](std::size_t area) { return area > 0; };
  itk::Index<3> first;
  itk::Index<3> last;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto begin = std::find_if(areas[axis].begin(), areas[axis].end(), isFilled);
    const auto end = std::find_if(areas[axis].rbegin(), areas[axis].rend(), isFilled).base();
    if (begin == areas[axis].end())
    {
      throw std::invalid_argument("the lumen of the colon is empty");
    }
    const auto start = lumen->GetBufferedRegion().GetIndex(axis);
    const auto room = static_cast<itk::IndexValueType>(std::ceil(margin / lumen->GetSpacing()[axis]));
    first[axis] = start + (begin - areas[axis].begin()) - room;
    last[axis] = start + (end - areas[axis].begin()) - 1 + room;
  }
  itk::ImageRegion<3> box;
  box.SetIndex(first);
  box.SetUpperIndex(last);
  box.Crop(lumen->GetBufferedRegion());
  return box;
}

void
CheckParts(const ColonParts & colon)
{
  if (!colon.lumen || colon.lumen->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("a picture of the colon requires its lumen");
  }
  if (colon.ct &&
      (colon.ct->GetBufferedRegion() != colon.lumen->GetBufferedRegion() || !HaveSameGrid(colon.ct, colon.lumen)))
  {
    throw std::invalid_argument("the CT and the lumen of a colon have different grids");
  }
}
} // namespace shapeton
