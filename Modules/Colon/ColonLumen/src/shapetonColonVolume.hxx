#ifndef shapetonColonVolume_hxx
#define shapetonColonVolume_hxx

#include "shapetonParallelFor.h"

namespace shapeton
{
template <typename TBody>
void
ForEachVoxel(const itk::ImageBase<3> * image, const ColonGrid & grid, const TBody & body)
{
  const auto *               offsets = image->GetOffsetTable();
  std::array<std::size_t, 3> step;
  std::size_t                first = 0;
  for (int a = 0; a < 3; ++a)
  {
    step[a] = static_cast<std::size_t>(offsets[grid.imageAxis[a]]);
    first += step[a] * grid.corner[a];
  }
  ParallelFor(grid.size[2], [&](std::size_t k) {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      std::size_t from = first + j * step[1] + k * step[2];
      std::size_t to = grid.Index(0, j, static_cast<int>(k));
      for (int i = 0; i < grid.size[0]; ++i, from += step[0], ++to)
      {
        body(from, to);
      }
    }
  });
}
} // namespace shapeton

#endif
