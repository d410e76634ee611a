#ifndef shapetonColonVolume_h
#define shapetonColonVolume_h

#include "itkImage.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** A box of voxels [low, high). */
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

/** Where the voxels of a working grid lie. Its third axis is the axis of the image that is closest to the patient's
 * long axis, so that its slices are axial; the other two keep their order. */
struct ColonGrid
{
  std::array<int, 3>         size{ { 0, 0, 0 } };
  std::array<std::size_t, 3> stride{ { 1, 0, 0 } };
  Eigen::Vector3d            spacing;
  Eigen::Matrix3d            axes;   ///< unit directions in LPS, one in each column
  Eigen::Vector3d            origin; ///< centre of the first voxel, LPS, mm
  std::array<int, 3>         imageAxis{ { 0, 1, 2 } };
  std::array<int, 3>         corner{ { 0, 0, 0 } }; ///< the first voxel in the whole grid

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
  Eigen::Vector3d
  Position(const Eigen::Vector3d & voxel) const
  {
    return origin + axes * spacing.cwiseProduct(voxel);
  }
  Eigen::Vector3d
  Position(std::size_t index) const
  {
    const auto v = this->Voxel(index);
    return this->Position(Eigen::Vector3d(v[0], v[1], v[2]));
  }
  /** Continuous voxel coordinates of a point in LPS. */
  Eigen::Vector3d
  VoxelOf(const Eigen::Vector3d & position) const
  {
    return (axes.inverse() * (position - origin)).cwiseQuotient(spacing);
  }
  double
  VoxelVolume() const
  {
    return spacing.prod();
  }
  /** The part of this grid in a box. */
  ColonGrid
  Part(const VoxelBox & box) const;
  /** The box with a margin in mm on all sides, inside the grid. */
  VoxelBox
  Widened(const VoxelBox & box, double margin) const;
};

/** Calls `body(index)` for the voxels that share a face with this one. */
template <typename TBody>
void
ForEachNeighbour(const ColonGrid & grid, std::size_t voxel, const TBody & body)
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

using ColonImage = itk::Image<float, 3>;

ColonGrid
GridOfImage(const itk::ImageBase<3> * image);

/** The part of an image in a working grid. Values are limited to [-1100, 32767]: padding counts as air; what is not a
 * number counts as padding. */
std::vector<float>
LoadVoxels(const ColonImage * image, const ColonGrid & grid);

/** The part of a working volume in a box. */
std::vector<float>
CropVoxels(const std::vector<float> & voxels, const ColonGrid & grid, const VoxelBox & box);

/** Calls `body(indexInImage, indexInGrid)` for all voxels of a part; each slice of the grid by one thread. */
template <typename TBody>
void
ForEachVoxel(const itk::ImageBase<3> * image, const ColonGrid & grid, const TBody & body);
} // namespace shapeton

#include "shapetonColonVolume.hxx"

#endif
