#include "shapetonColonVolume.h"

#include "shapetonSquaredDistances.h"

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
} // namespace

ColonGrid
ColonGrid::Part(const VoxelBox & box) const
{
  ColonGrid part = *this;
  part.SetSize({ { box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2] } });
  for (int a = 0; a < 3; ++a)
  {
    part.corner[a] += box.low[a];
  }
  part.origin = this->Position(Eigen::Vector3d(box.low[0], box.low[1], box.low[2]));
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
  std::array<int, 3>    size;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  grid.imageAxis = WorkingOrder(image);
  for (int a = 0; a < 3; ++a)
  {
    const int axis = grid.imageAxis[a];
    size[a] = static_cast<int>(region.GetSize(axis));
    grid.spacing[a] = image->GetSpacing()[axis];
    grid.origin[a] = origin[a];
    for (int r = 0; r < 3; ++r)
    {
      grid.axes(r, a) = image->GetDirection()(r, axis);
    }
  }
  grid.SetSize(size);
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

std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask)
{
  return SquaredDistances(grid, { { grid.spacing[0], grid.spacing[1], grid.spacing[2] } }, mask);
}
} // namespace shapeton
