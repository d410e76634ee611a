#ifndef shapetonLevelSurface_h
#define shapetonLevelSurface_h

#include "shapetonFall.h"
#include "shapetonLocalFluid.h"

#include <optional>

namespace shapeton
{
/** Where gas meets fluid, finer than voxels: the depth at which values pass the mean of gas and local fluid. */
class LevelSurface
{
public:
  /** `labels`: 1 gas, 2 fluid. */
  LevelSurface(const ColonGrid &                  grid,
               const std::vector<float> &         hu,
               const std::vector<unsigned char> & labels,
               const Fall &                       fall,
               const LocalFluid &                 fluid,
               double                             gas);

  /** The depth of the level around a voxel minus the voxel's own depth, mm: positive in gas above it. Nothing where no
   * level lies within 5 mm across and 4 mm along gravity. */
  std::optional<double>
  HeightAbove(std::size_t voxel) const;

  /** Standard deviation of the blur across the levels, voxels included, mm; from the steepness of the levels. */
  double
  Blur() const
  {
    return m_Blur;
  }

private:
  void
  Collect(const std::vector<float> &         hu,
          const std::vector<unsigned char> & labels,
          const LocalFluid &                 fluid,
          double                             gas);
  bool
  Crossing(const std::vector<float> & hu, std::size_t voxel, double half, double & depth, double & rise) const;
  void
  MeasureBlur(std::vector<double> & shares);

  const ColonGrid &                m_Grid;
  const Fall &                     m_Fall;
  std::vector<LateralCells::Place> m_Places;
  std::vector<float>               m_Depths;
  LateralCells                     m_Cells;
  double                           m_Blur;
};
} // namespace shapeton

#endif
