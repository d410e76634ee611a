#include "shapetonDistanceToBackground.h"

#include "shapetonSquaredDistances.h"

namespace shapeton
{
std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask)
{
  std::vector<float> squares(mask.size());
  SquaredDistances({ mask.data(), grid.stride[1], grid.stride[2] },
                   { static_cast<std::size_t>(grid.size[0]),
                     static_cast<std::size_t>(grid.size[1]),
                     static_cast<std::size_t>(grid.size[2]) },
                   { grid.spacing[0], grid.spacing[1], grid.spacing[2] },
                   squares.data());
  return squares;
}
} // namespace shapeton
