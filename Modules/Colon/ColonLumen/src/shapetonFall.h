#ifndef shapetonFall_h
#define shapetonFall_h

#include "shapetonColonVolume.h"

namespace shapeton
{
/** A voxel's way down along gravity: step t leads to the voxel nearest to the point t steps below. The steps are as
 * long as it takes to pass from voxel to voxel, so that they are columns where gravity is within a few degrees of an
 * axis. */
struct Fall
{
  Eigen::Vector3d direction;   ///< of gravity, unit vector in LPS
  Eigen::Vector3d across[2];   ///< perpendicular to it and to each other
  double          step{ 1.0 }; ///< mm

  Fall(const ColonGrid & grid, const Eigen::Vector3d & gravity);

  std::array<int, 3>
  Offset(int steps) const
  {
    return { { static_cast<int>(std::lround(steps * m_VoxelsPerStep[0])),
               static_cast<int>(std::lround(steps * m_VoxelsPerStep[1])),
               static_cast<int>(std::lround(steps * m_VoxelsPerStep[2])) } };
  }
  /** Area that one column stands for, mm^2. */
  double
  ColumnArea(const ColonGrid & grid) const
  {
    return grid.VoxelVolume() / step;
  }

private:
  Eigen::Vector3d m_VoxelsPerStep;
};

/** Points in a plane, sorted into square cells, to find those near a place. */
class LateralCells
{
public:
  struct Place
  {
    float a, b;
  };
  LateralCells(const std::vector<Place> & places, double cellSize);

  /** Calls `body(index)` for all points of the 3 by 3 cells around a place: at least those within the cell size. */
  template <typename TBody>
  void
  ForEachNear(double a, double b, const TBody & body) const
  {
    const int ca = this->CellOf(a - m_Low[0]);
    const int cb = this->CellOf(b - m_Low[1]);
    for (int y = std::max(cb - 1, 0); y <= std::min(cb + 1, m_Size[1] - 1); ++y)
    {
      for (int x = std::max(ca - 1, 0); x <= std::min(ca + 1, m_Size[0] - 1); ++x)
      {
        const std::size_t cell = x + static_cast<std::size_t>(y) * m_Size[0];
        for (auto p = m_Begin[cell]; p < m_Begin[cell + 1]; ++p)
        {
          body(m_Order[p]);
        }
      }
    }
  }

private:
  int
  CellOf(double x) const
  {
    return static_cast<int>(std::floor(x / m_CellSize));
  }

  double                   m_CellSize;
  std::array<double, 2>    m_Low{ { 0.0, 0.0 } };
  std::array<int, 2>       m_Size{ { 0, 0 } };
  std::vector<std::size_t> m_Begin;
  std::vector<int>         m_Order;
};
} // namespace shapeton

#endif
