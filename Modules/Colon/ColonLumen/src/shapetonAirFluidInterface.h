#ifndef shapetonAirFluidInterface_h
#define shapetonAirFluidInterface_h

#include "shapetonAirFluidLevels.h"
#include "shapetonColonVolume.h"

#include <optional>

namespace shapeton
{
/** Local intensity of tagged fluid: means of the voxels deep in the fluid over cells of about 2 mm, smoothed with a
 * standard deviation of about 3 mm and extrapolated to the surroundings. */
class LocalFluid
{
public:
  /** Averages voxels where `fluid` is nonzero and that are at least 2 mm from voxels where it is zero; `fallback` is
   * the value far from them. */
  LocalFluid(const ColonGrid & grid, const VoxelValues & hu, const std::vector<unsigned char> & fluid, double fallback);

  /** Linear interpolation between the cells. */
  double
  At(int i, int j, int k) const;

private:
  void
  Accumulate(const ColonGrid & grid, const VoxelValues & hu, const std::vector<unsigned char> & fluid);
  void
  Spread();
  std::size_t
  Cell(int x, int y, int z) const
  {
    return x + m_Size[0] * (y + static_cast<std::size_t>(m_Size[1]) * z);
  }

  std::array<int, 3> m_Edge; ///< voxels per cell along each axis
  std::array<int, 3> m_Size;
  double             m_Fallback;
  std::vector<float> m_Sum;
  std::vector<float> m_Weight;
};

/** Subvoxel interface between gas and fluid: the depth at which values cross the mean of the gas and the local fluid
 * intensity. */
class LevelSurface
{
public:
  /** `labels`: 1 gas, 2 fluid. */
  LevelSurface(const ColonGrid &                  grid,
               const VoxelValues &                hu,
               const std::vector<unsigned char> & labels,
               const GravitySteps &               fall,
               const LocalFluid &                 fluid,
               double                             gas);

  /** Depth (mm) of the nearby level relative to the voxel, positive in the gas above it. Empty if no level is within 5
   * mm perpendicular to gravity and 4 mm along it. */
  std::optional<double>
  HeightAbove(std::size_t voxel) const;

  /** Standard deviation (mm) of the blur across the levels, including the effect of voxel size, measured from the slope
   * at the levels. */
  double
  Blur() const
  {
    return m_Blur;
  }

private:
  void
  Collect(const VoxelValues & hu, const std::vector<unsigned char> & labels, const LocalFluid & fluid, double gas);
  bool
  Crossing(const VoxelValues & hu, std::size_t voxel, double half, double & depth, double & rise) const;
  void
  MeasureBlur(const std::vector<double> & shares);

  const ColonGrid &                m_Grid;
  const GravitySteps &             m_Fall;
  std::vector<LateralCells::Place> m_Places;
  std::vector<float>               m_Depths;
  LateralCells                     m_Cells;
  double                           m_Blur;
};
} // namespace shapeton

#endif
