#ifndef shapetonTissueBox_h
#define shapetonTissueBox_h

#include "shapetonPolypShapeDiffusion.h"

#include <array>
#include <vector>

namespace shapeton
{
/** A part of a volume as plain arrays (x fastest), used as input of shape diffusion. */
class TissueBox
{
public:
  /** The voxels of the lumen grid within `margin` mm of the points (LPS, mm), clipped to the grid. Intensities are 1 in
   * tissue and 0 in the lumen. */
  TissueBox(const PolypLumenImage * lumen, const std::vector<Eigen::Vector3d> & points, double margin);

  const std::array<std::size_t, 3> &
  Size() const
  {
    return m_Size;
  }
  std::size_t
  NumberOfVoxels() const
  {
    return m_Size[0] * m_Size[1] * m_Size[2];
  }
  /** Voxel size, mm. */
  std::array<double, 3>
  Spacing() const;
  double
  LongestSide() const;
  const std::vector<float> &
  Intensities() const
  {
    return m_Intensities;
  }
  /** Replaces the binary values by HU from a CT on the same grid, clamped to [-1000, 200] and scaled to [0, 1]. */
  void
  TakeIntensities(const itk::Image<float, 3> * ct);
  /** Mask of the tissue within `depth` mm of the lumen, measured along the axes. */
  std::vector<unsigned char>
  TissueNearLumen(double depth) const;
  /** Mean of tissue values at the points; points outside the box contribute 0. */
  double
  MeanAt(const std::vector<float> & values, const std::vector<Eigen::Vector3d> & points) const;
  /** The index of a voxel; -1 outside the box. */
  std::ptrdiff_t
  VoxelAt(const Eigen::Vector3d & point) const;

private:
  const PolypLumenImage *    m_Lumen;
  PolypLumenImage::IndexType m_First{};
  std::array<std::size_t, 3> m_Size{ { 0, 0, 0 } };
  std::vector<unsigned char> m_IsLumen;
  std::vector<float>         m_Intensities;
};
} // namespace shapeton

#endif
