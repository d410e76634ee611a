#ifndef shapetonArcLengthField_h
#define shapetonArcLengthField_h

#include "shapetonCentrelineGeometry.h"

#include <cstdint>

namespace shapeton
{
/** Which place of the centreline belongs to a place of the wall: the closest one that can be reached within the lumen,
 * so that loops that touch do not get each other's. */
class ArcLengthField
{
public:
  /** One curve with the point array `arcLength`. */
  ArcLengthField(const LumenMaskImage * lumen, const CurveSet & centreline);

  /** In mm; may be asked by several threads. */
  double
  ArcLengthAt(const Eigen::Vector3d & point) const;

  /** That of the closest point of the curve, for the middle of a voxel of the lumen, by its number in the buffer. */
  double
  ArcLengthOfVoxel(std::int64_t voxel) const;

private:
  static constexpr std::int32_t Nowhere = -1;

  void
  Spread(const LumenMaskImage * lumen);
  Eigen::Vector3d
  PointOfVoxel(std::int64_t voxel) const;
  std::int32_t
  SiteNear(const Eigen::Vector3d & point) const;
  std::int32_t
  ClosestSite(const Eigen::Vector3d & point) const;

  GridGeometry              m_Grid;
  itk::Size<3>              m_Size;
  VertexMatrix              m_Points; ///< of the curve, in order
  std::vector<double>       m_ArcLengths;
  std::vector<std::int32_t> m_Sites; ///< row of m_Points for each voxel
};
} // namespace shapeton

#endif
