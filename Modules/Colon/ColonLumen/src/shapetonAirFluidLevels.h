#ifndef shapetonAirFluidLevels_h
#define shapetonAirFluidLevels_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonVolume.h"
#include "shapetonVoxelRuns.h"

namespace shapeton
{
/** Path from a voxel along gravity: step t is the voxel nearest to the point t steps below. The step length is the
 * distance between voxels, so paths are voxel columns if gravity is within a few degrees of an axis. */
struct GravitySteps
{
  Eigen::Vector3d direction;   ///< of gravity, unit vector in LPS
  Eigen::Vector3d across[2];   ///< perpendicular to gravity and to each other
  double          step{ 1.0 }; ///< mm

  GravitySteps(const ColonGrid & grid, const Eigen::Vector3d & gravity);

  std::array<int, 3>
  Offset(int steps) const
  {
    return { { static_cast<int>(std::lround(steps * m_VoxelsPerStep[0])),
               static_cast<int>(std::lround(steps * m_VoxelsPerStep[1])),
               static_cast<int>(std::lround(steps * m_VoxelsPerStep[2])) } };
  }
  /** Area represented by one column, mm^2. */
  double
  ColumnArea(const ColonGrid & grid) const
  {
    return grid.VoxelVolume() / step;
  }

private:
  Eigen::Vector3d m_VoxelsPerStep;
};

/** Points in a plane, binned into square cells for neighbor search. */
class LateralCells
{
public:
  struct Place
  {
    float a, b;
  };
  LateralCells(const std::vector<Place> & places, double cellSize);

  /** Calls `body(index)` for all points in the 3 by 3 cells around a position, which include all points within the cell
   * size. */
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

/** The lower end of gas. */
struct Floor
{
  std::size_t voxel; ///< lowest gas voxel
  int         gas;   ///< index of the gas piece
  float       depth; ///< of the half height, along gravity, mm
};

/** The floors of all pieces of gas for which `use` is true. */
std::vector<Floor>
FloorsOfGas(const ColonGrid &         grid,
            const VoxelValues &       hu,
            const VoxelRuns &         gas,
            const RunLabels &         pieces,
            const std::vector<char> & use,
            const GravitySteps &      fall,
            const ColonThresholds &   thresholds);

constexpr double LeastTagging = 100.0; // HU above tissue; chosen: untagged fluid has less
constexpr double LeastAtEdge = 0.7;    // relative to the fluid contrast; the rise of a level ends here
constexpr double StepsToFluid = 3.0;   // from a gas voxel above a level; two may be in the rise

/** A flat part of a gas floor, at depth + slope . (position - center), in mm along and perpendicular to gravity. */
struct Level
{
  int                 gas{ 0 };     ///< the gas piece above
  double              area{ 0.0 };  ///< mm^2
  double              width{ 0.0 }; ///< standard deviation along the shorter side, mm
  double              depth{ 0.0 };
  Eigen::Vector2d     slope;
  Eigen::Vector2d     center;
  std::vector<size_t> voxels;       ///< gas voxels directly above
  double              below{ 0.0 }; ///< median intensity 3 to 6 mm below
  double              edge{ 0.0 };  ///< median intensity about 2 mm below, beyond the rise of a level

  /** Intensity of the matter below the level; shallow pools are brightest near it. */
  double
  Fluid() const
  {
    return below > edge ? below : edge;
  }
  /** Whether there is bright matter directly below, with no wall in between. */
  bool
  IsTagged(double tissue) const
  {
    return this->Fluid() > tissue + LeastTagging && edge - tissue > LeastAtEdge * (this->Fluid() - tissue);
  }
};

/** Criteria for a flat part of a floor to be a level. */
struct LevelLimits
{
  double slope; ///< maximum tangent of the angle to the plane perpendicular to gravity
  double area;  ///< minimum, mm^2
};

/** Perpendicular to gravity to within 6 degrees. Walls are curved; the bottom of a haustrum is flat over a few mm^2. */
constexpr LevelLimits FlatLevels{ 0.1, 30.0 };

/** Criteria for levels that are accepted only with bright fluid directly below them. Breath and flow during the scan
 * tilt the level of a narrow stretch; one in the sigmoid of a real patient has a slope of 0.2 over 50 mm. */
constexpr LevelLimits TiltedLevels{ 0.35, 20.0 };

/** Thickness (mm) of the wall between gas and the fluid in another bowel. Larger voxels hide it. */
constexpr double ThinnestWall = 2.0;

/** Finds flat parts of floors that satisfy the limits, largest first. */
std::vector<Level>
FindLevels(const ColonGrid &          grid,
           const VoxelValues &        hu,
           const std::vector<Floor> & floors,
           const GravitySteps &       fall,
           double                     tissue,
           const LevelLimits &        limits = FlatLevels);

/** Tests columns along gravity, from a level down to bright matter, for walls.
 *
 * Below a level, values rise according to the blur and then remain constant. If they rise more slowly, or drop before
 * the bright matter, a wall is in between and the bright matter is in another bowel. */
class LevelColumn
{
public:
  /** Numbers of columns from levels to one piece of bright matter. */
  struct Votes
  {
    std::size_t open{ 0 };
    std::size_t all{ 0 };

    /** Two-thirds majority, since noise affects single columns. */
    bool
    AreOpen() const
    {
      return 3 * open > 2 * all;
    }
  };

  /** `noise`: standard deviation in HU; `smoothing`: sigma of the prefilter in mm. */
  LevelColumn(const ColonGrid &       grid,
              const VoxelValues &     hu,
              const GravitySteps &    fall,
              const ColonThresholds & thresholds,
              double                  noise,
              double                  smoothing);

  /** Whether no wall is visible between the level and the voxel `steps` below one of its floors. */
  bool
  IsOpen(const Level & level, const std::array<int, 3> & floor, int steps) const;

private:
  const ColonGrid &       m_Grid;
  const VoxelValues &     m_Hu;
  const GravitySteps &    m_Fall;
  const ColonThresholds & m_Thresholds;
  double                  m_Noise;
  double                  m_Blur; ///< mm, voxels included
};
} // namespace shapeton

#endif
