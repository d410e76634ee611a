#ifndef shapetonTestFrames_h
#define shapetonTestFrames_h

#include "shapetonTestImages.h"

#include <Eigen/Core>

namespace basetest
{
inline Eigen::Vector3d
ToEigen(const itk::Point<double, 3> & point)
{
  return Eigen::Vector3d(point.GetDataPointer());
}

/** An image of zeros with its first voxel at `corner`; the columns of `axes` are its directions. */
template <typename TImage>
typename TImage::Pointer
NewImageInFrame(const typename TImage::SizeType & size,
                const Eigen::Vector3d &           spacing,
                const Eigen::Vector3d &           corner,
                const Eigen::Matrix3d &           axes = Eigen::Matrix3d::Identity())
{
  const Eigen::Matrix3d rows = axes.transpose();
  return NewImage<TImage>(size,
                          { { spacing[0], spacing[1], spacing[2] } },
                          { { corner[0], corner[1], corner[2] } },
                          itk::Matrix<double, 3, 3>(vnl_matrix_fixed<double, 3, 3>(rows.data())));
}
} // namespace basetest

#endif
