#ifndef shapetonArcLengthField_h
#define shapetonArcLengthField_h

#include "shapetonCenterlineGeometry.h"

#include <cstdint>

namespace shapeton
{
/** Maps a wall point to the closest centerline point, measured within the lumen to separate touching loops. */
class ArcLengthField
{
public:
  /** Requires one curve with the point array `arcLength`. */
  ArcLengthField(const LumenMaskImage * lumen, const CurveSet & centerline);

  /** Distance along the centerline, mm; thread-safe. */
  double
  ArcLengthAt(const Eigen::Vector3d & point) const;

  /** Value at the curve point closest to the center of a lumen voxel, given by its buffer index. */
  double
  ArcLengthOfVoxel(std::int64_t voxel) const;

  /** Center of a voxel, given by its buffer index. */
  Eigen::Vector3d
  PointOfVoxel(std::int64_t voxel) const;

private:
  static constexpr std::int32_t Nowhere = -1; ///< no site

  void
  Spread(const LumenMaskImage * lumen);
  std::int32_t
  SiteNear(const Eigen::Vector3d & point) const;
  std::int32_t
  ClosestSite(const Eigen::Vector3d & point) const;

  GridGeometry              m_Grid;
  itk::Size<3>              m_Size;
  VertexMatrix              m_Points; ///< points of the curve, in order
  std::vector<double>       m_ArcLengths;
  std::vector<std::int32_t> m_Sites; ///< row of m_Points for each voxel
};
} // namespace shapeton

#endif
