#include "shapetonColonVolume.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The image axes in the order of the working grid: the one closest to the patient's long axis comes last. */
std::array<int, 3>
WorkingOrder(const itk::ImageBase<3> * image)
{
  int axial = 2;
  for (int a = 0; a < 3; ++a)
  {
    if (std::abs(image->GetDirection()(2, a)) > std::abs(image->GetDirection()(2, axial)) + 1e-9)
    {
      axial = a;
    }
  }
  return { { axial == 0 ? 1 : 0, axial == 2 ? 1 : 2, axial } };
}

void
SetStrides(ColonGrid & grid)
{
  grid.stride = {
    { 1, static_cast<std::size_t>(grid.size[0]), static_cast<std::size_t>(grid.size[0]) * grid.size[1] }
  };
}
} // namespace

ColonGrid
ColonGrid::Part(const VoxelBox & box) const
{
  ColonGrid part = *this;
  for (int a = 0; a < 3; ++a)
  {
    part.size[a] = box.high[a] - box.low[a];
    part.corner[a] += box.low[a];
  }
  part.origin = this->Position(Eigen::Vector3d(box.low[0], box.low[1], box.low[2]));
  SetStrides(part);
  return part;
}

VoxelBox
ColonGrid::Widened(const VoxelBox & box, double margin) const
{
  VoxelBox wide = box;
  for (int a = 0; a < 3; ++a)
  {
    const int voxels = static_cast<int>(std::ceil(margin / spacing[a]));
    wide.low[a] = std::max(0, box.low[a] - voxels);
    wide.high[a] = std::min(size[a], box.high[a] + voxels);
  }
  return wide;
}

ColonGrid
GridOfImage(const itk::ImageBase<3> * image)
{
  ColonGrid             grid;
  const auto            region = image->GetBufferedRegion();
  itk::Point<double, 3> origin;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  grid.imageAxis = WorkingOrder(image);
  for (int a = 0; a < 3; ++a)
  {
    const int axis = grid.imageAxis[a];
    grid.size[a] = static_cast<int>(region.GetSize(axis));
    grid.spacing[a] = image->GetSpacing()[axis];
    grid.origin[a] = origin[a];
    for (int r = 0; r < 3; ++r)
    {
      grid.axes(r, a) = image->GetDirection()(r, axis);
    }
  }
  SetStrides(grid);
  return grid;
}

std::vector<float>
LoadVoxels(const ColonImage * image, const ColonGrid & grid)
{
  std::vector<float> voxels(grid.NumberOfVoxels());
  const float *      values = image->GetBufferPointer();
  ForEachVoxel(image, grid, [&](std::size_t from, std::size_t to) {
    const float v = values[from];
    voxels[to] = v > -1100.0F ? std::min(v, 32767.0F) : -1100.0F;
  });
  return voxels;
}

std::vector<float>
CropVoxels(const std::vector<float> & voxels, const ColonGrid & grid, const VoxelBox & box)
{
  const ColonGrid    part = grid.Part(box);
  std::vector<float> crop(part.NumberOfVoxels());
  ParallelFor(part.size[2], [&](std::size_t k) {
    for (int j = 0; j < part.size[1]; ++j)
    {
      const auto * from = &voxels[grid.Index(box.low[0], j + box.low[1], static_cast<int>(k) + box.low[2])];
      std::copy(from, from + part.size[0], &crop[part.Index(0, j, static_cast<int>(k))]);
    }
  });
  return crop;
}
} // namespace shapeton
