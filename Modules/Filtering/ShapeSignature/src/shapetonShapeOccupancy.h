#ifndef shapetonShapeOccupancy_h
#define shapetonShapeOccupancy_h

#include "shapetonVoxelRuns.h"

#include "itkImageBase.h"

#include <Eigen/Core>

namespace shapeton
{
/** Volume, center and extent of a set of voxels, in LPS mm. */
struct ShapeMoments
{
  double          volume{ 0.0 };
  Eigen::Vector3d center{ Eigen::Vector3d::Zero() };
  /** Along the longest, the middle and the shortest principal axis; voxels count as boxes. */
  Eigen::Vector3d deviations{ Eigen::Vector3d::Zero() };
  /** The axes in columns; right-handed. */
  Eigen::Matrix3d axes{ Eigen::Matrix3d::Identity() };
};

ShapeMoments
MomentsOf(const VoxelRuns & shape, const itk::ImageBase<3> * image);

/** The filled fraction of each voxel of a grid along the principal axes. The outermost layer is empty. */
struct ShapeOccupancy
{
  VoxelGrid          grid;
  std::vector<float> values;
};

/** \param spacing grid spacing, mm. */
ShapeOccupancy
OccupancyOf(const VoxelRuns & shape, const itk::ImageBase<3> * image, const ShapeMoments & moments, double spacing);
} // namespace shapeton

#endif
