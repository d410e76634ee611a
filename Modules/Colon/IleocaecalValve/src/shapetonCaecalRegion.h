#ifndef shapetonCaecalRegion_h
#define shapetonCaecalRegion_h

#include "shapetonCurveSet.h"
#include "shapetonLumenDistance.h"
#include "shapetonVoxelGrid.h"
#include "shapetonVoxelValues.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** \class CaecalRegion
 * \brief The caecal end of a colon on cubic voxels along the patient's axes, whatever the axes and spacings of the
 * image, so that what is measured here depends on neither. */
class CaecalRegion
{
public:
  /** mm, of a voxel. */
  static constexpr double Step = 1.25;
  /** mm along the line, before its end, where a valve may lie. */
  static constexpr double Reach = 160.0;

  /** \param ct HU on the grid of the labels; null where there is none.
   * \param margin around the line's last part, mm. */
  CaecalRegion(const LumenMask *            labels,
               const itk::Image<float, 3> * ct,
               const CurveSet &             centreline,
               double                       margin = 60.0);

  const VoxelGrid &
  Grid() const
  {
    return m_Grid;
  }
  bool
  HasIntensities() const
  {
    return !m_Hounsfield.empty();
  }
  Eigen::Vector3d
  PointOf(std::size_t voxel) const
  {
    const auto v = m_Grid.Voxel(voxel);
    return m_Origin + Step * Eigen::Vector3d(v[0], v[1], v[2]);
  }
  /** -1 outside. */
  std::ptrdiff_t
  VoxelAt(const Eigen::Vector3d & point) const;
  bool
  IsLumen(std::size_t voxel) const
  {
    return m_IsLumen[voxel] != 0;
  }
  const std::vector<unsigned char> &
  Lumen() const
  {
    return m_IsLumen;
  }
  /** HU; of no meaning without intensities. */
  float
  Hounsfield(std::size_t voxel) const
  {
    return m_Hounsfield[voxel];
  }
  /** mm before the end of the line: of the line's point from where the lumen was reached, also in tissue next to it;
   * beyond Reach where it was not reached. */
  float
  BeforeEnd(std::size_t voxel) const
  {
    return m_BeforeEnd[voxel];
  }
  /** mm from a voxel of tissue to the nearest one of the lumen; 0 in the lumen. */
  float
  FromLumen(std::size_t voxel) const
  {
    return m_FromLumen[voxel];
  }

private:
  void
  PlaceGrid(const CurveSet & centreline, const Eigen::VectorXd & beforeEnd, double margin);
  void
  Sample(const LumenMask * labels, const itk::Image<float, 3> * ct);
  void
  MeasureBeforeEnd(const CurveSet & centreline, const Eigen::VectorXd & beforeEnd);
  void
  MeasureFromLumen();

  VoxelGrid                  m_Grid;
  Eigen::Vector3d            m_Origin{ Eigen::Vector3d::Zero() };
  std::vector<unsigned char> m_IsLumen;
  std::vector<float>         m_Hounsfield;
  std::vector<float>         m_BeforeEnd;
  VoxelValues                m_FromLumen;
};
} // namespace shapeton

#endif
