#ifndef shapetonCecalRegion_h
#define shapetonCecalRegion_h

#include "shapetonCurveSet.h"
#include "shapetonLumenDistance.h"
#include "shapetonVoxelGrid.h"
#include "shapetonVoxelValues.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** \class CecalRegion
 * \brief The cecal end of a colon, resampled to cubic voxels along the patient axes. */
class CecalRegion
{
public:
  /** Voxel size, mm. */
  static constexpr double Step = 1.25;
  /** Length (mm) of the end section of the line where the valve may be. */
  static constexpr double Reach = 160.0;

  /** \param ct HU on the grid of the labels; may be null.
   * \param margin around the last part of the line, mm. */
  CecalRegion(const LumenMask *            labels,
              const itk::Image<float, 3> * ct,
              const CurveSet &             centerline,
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
  /** Index of a voxel; -1 outside. */
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
  /** HU; undefined if there are no intensities. */
  float
  Hounsfield(std::size_t voxel) const
  {
    return m_Hounsfield[voxel];
  }
  /** Distance (mm) to the end of the line from the line point nearest to a voxel of the lumen or adjacent tissue;
   * greater than Reach if the voxel was not reached. */
  float
  BeforeEnd(std::size_t voxel) const
  {
    return m_BeforeEnd[voxel];
  }
  /** Distance (mm) from a tissue voxel to the nearest lumen voxel; 0 in the lumen. */
  float
  FromLumen(std::size_t voxel) const
  {
    return m_FromLumen[voxel];
  }

private:
  void
  PlaceGrid(const CurveSet & centerline, const Eigen::VectorXd & beforeEnd, double margin);
  void
  Sample(const LumenMask * labels, const itk::Image<float, 3> * ct);
  void
  MeasureBeforeEnd(const CurveSet & centerline, const Eigen::VectorXd & beforeEnd);
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
