#ifndef shapetonColonVolume_h
#define shapetonColonVolume_h

#include "shapetonVoxelGrid.h"
#include "itkImage.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** Where the voxels of a working grid lie. Its third axis is the axis of the image that is closest to the patient's
 * long axis, so that its slices are axial; the other two keep their order. */
struct ColonGrid : VoxelGrid
{
  Eigen::Vector3d    spacing;
  Eigen::Matrix3d    axes;   ///< unit directions in LPS, one in each column
  Eigen::Vector3d    origin; ///< centre of the first voxel, LPS, mm
  std::array<int, 3> imageAxis{ { 0, 1, 2 } };
  std::array<int, 3> corner{ { 0, 0, 0 } }; ///< the first voxel in the whole grid

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

/** SquaredDistances() of a mask on a working grid. */
std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask);

/** Calls `body(indexInImage, indexInGrid)` for all voxels of a part; each slice of the grid by one thread. */
template <typename TBody>
void
ForEachVoxel(const itk::ImageBase<3> * image, const ColonGrid & grid, const TBody & body);
} // namespace shapeton

#include "shapetonColonVolume.hxx"

#endif
