#ifndef shapetonVoxelGrid_h
#define shapetonVoxelGrid_h

#include <array>
#include <cstddef>
#include <vector>

namespace shapeton
{
/** A box of voxels [low, high). \ingroup ShapetonCommon */
struct VoxelBox
{
  std::array<int, 3> low{ { 0, 0, 0 } };
  std::array<int, 3> high{ { 0, 0, 0 } };

  bool
  IsEmpty() const
  {
    return low[0] >= high[0] || low[1] >= high[1] || low[2] >= high[2];
  }
};

/** \class VoxelGrid
 * \brief Memory layout of voxels, first axis fastest: conversion from a voxel to its index and back.
 *
 * \ingroup ShapetonCommon */
struct VoxelGrid
{
  std::array<int, 3>         size{ { 0, 0, 0 } };
  std::array<std::size_t, 3> stride{ { 1, 0, 0 } }; ///< index offset of the next voxel along each axis

  VoxelGrid() = default;
  VoxelGrid(int ni, int nj, int nk) { this->SetSize({ { ni, nj, nk } }); }

  void
  SetSize(const std::array<int, 3> & voxels)
  {
    size = voxels;
    stride = { { 1, static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[0]) * size[1] } };
  }
  std::size_t
  NumberOfVoxels() const
  {
    return static_cast<std::size_t>(size[0]) * size[1] * size[2];
  }
  std::size_t
  Index(int i, int j, int k) const
  {
    return i + j * stride[1] + k * stride[2];
  }
  std::array<int, 3>
  Voxel(std::size_t index) const
  {
    const auto row = index / stride[1];
    return {
      { static_cast<int>(index % stride[1]), static_cast<int>(row % size[1]), static_cast<int>(row / size[1]) }
    };
  }
  bool
  Holds(int i, int j, int k) const
  {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }
  /** Index offset of a step of i, j and k voxels; negative steps are allowed. */
  std::ptrdiff_t
  Offset(int i, int j, int k) const
  {
    return i + j * static_cast<std::ptrdiff_t>(stride[1]) + k * static_cast<std::ptrdiff_t>(stride[2]);
  }
};

/** Calls `body(index)` for the face neighbors of this voxel. \ingroup ShapetonCommon */
template <typename TBody>
void
ForEachNeighbor(const VoxelGrid & grid, std::size_t voxel, const TBody & body)
{
  const auto v = grid.Voxel(voxel);
  for (int a = 0; a < 3; ++a)
  {
    if (v[a] > 0)
    {
      body(voxel - grid.stride[a]);
    }
    if (v[a] + 1 < grid.size[a])
    {
      body(voxel + grid.stride[a]);
    }
  }
}

/** Sets `mask`, which is 0, to 1 at the voxels connected to `seed` by faces for which `isInside(index)` holds. Returns
 * whether it holds at the seed. \ingroup ShapetonCommon */
template <typename TInside>
bool
FillComponent(const VoxelGrid & grid, std::size_t seed, const TInside & isInside, unsigned char * mask)
{
  std::vector<std::size_t> open;
  const auto               take = [&](std::size_t voxel) {
    if (mask[voxel] == 0 && isInside(voxel))
    {
      mask[voxel] = 1;
      open.push_back(voxel);
    }
  };
  take(seed);
  const bool isSeedInside = !open.empty();
  while (!open.empty())
  {
    const std::size_t voxel = open.back();
    open.pop_back();
    ForEachNeighbor(grid, voxel, take);
  }
  return isSeedInside;
}
} // namespace shapeton

#endif
