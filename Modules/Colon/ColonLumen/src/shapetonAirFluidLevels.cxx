#include "shapetonAirFluidLevels.h"

#include "shapetonDisjointSets.h"
#include "shapetonPi.h"
#include "shapetonPrincipalAxes.h"
#include "shapetonQuantiles.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace shapeton
{
GravitySteps::GravitySteps(const ColonGrid & grid, const Eigen::Vector3d & gravity) : direction(gravity.normalized())
{
  const Eigen::Vector3d perMm = (grid.axes.inverse() * direction).cwiseQuotient(grid.spacing);
  step = 1.0 / perMm.cwiseAbs().maxCoeff();
  m_VoxelsPerStep = perMm * step;
  int most = 0;
  (grid.axes.transpose() * direction).cwiseAbs().minCoeff(&most);
  const Eigen::Vector3d axis = grid.axes.col(most);
  across[0] = (axis - axis.dot(direction) * direction).normalized();
  across[1] = direction.cross(across[0]);
}

LateralCells::LateralCells(const std::vector<Place> & places, double cellSize) : m_CellSize(cellSize)
{
  if (places.empty())
  {
    m_Begin.assign(1, 0);
    return;
  }
  const auto byA =
    std::minmax_element(places.begin(), places.end(), [](const Place & p, const Place & q) { return p.a < q.a; });
  const auto byB =
    std::minmax_element(places.begin(), places.end(), [](const Place & p, const Place & q) { return p.b < q.b; });
  m_Low = { { byA.first->a, byB.first->b } };
  m_Size = { { this->CellOf(byA.second->a - m_Low[0]) + 1, this->CellOf(byB.second->b - m_Low[1]) + 1 } };
  m_Begin.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] + 1, 0);
  std::vector<std::size_t> cells(places.size());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    cells[p] =
      this->CellOf(places[p].a - m_Low[0]) + static_cast<std::size_t>(this->CellOf(places[p].b - m_Low[1])) * m_Size[0];
    ++m_Begin[cells[p] + 1];
  }
  for (std::size_t c = 1; c < m_Begin.size(); ++c)
  {
    m_Begin[c] += m_Begin[c - 1];
  }
  m_Order.resize(places.size());
  auto next = m_Begin;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    m_Order[next[cells[p]]++] = static_cast<int>(p);
  }
}

namespace
{
/** Finds the half height within three steps below a gas voxel; returns false if the gas continues or the grid ends. */
bool
FloorBelow(const ColonGrid &    grid,
           const VoxelValues &  hu,
           std::size_t          voxel,
           const GravitySteps & fall,
           double               half,
           float &              depth)
{
  const auto v = grid.Voxel(voxel);
  float      above = hu[voxel];
  for (int t = 1; t <= 3; ++t)
  {
    const auto o = fall.Offset(t);
    if (!grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
    {
      return false;
    }
    const float value = hu[grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
    if (value >= half)
    {
      const double part = (half - above) / std::max(1.0F, value - above);
      depth = static_cast<float>(grid.Position(voxel).dot(fall.direction) + (t - 1 + part) * fall.step);
      return true;
    }
    above = value;
  }
  return false;
}
} // namespace

std::vector<Floor>
FloorsOfGas(const ColonGrid &         grid,
            const VoxelValues &       hu,
            const VoxelRuns &         gas,
            const RunLabels &         pieces,
            const std::vector<char> & use,
            const GravitySteps &      fall,
            const ColonThresholds &   thresholds)
{
  std::vector<Floor> floors;
  const auto         down = fall.Offset(1);
  ForEachRun(gas, [&](std::size_t r, int j, int k) {
    if (!use[pieces.ofRun[r]])
    {
      return;
    }
    for (int i = gas.runs[r].begin; i < gas.runs[r].end; ++i)
    {
      float      depth = 0.0F;
      const auto voxel = grid.Index(i, j, k);
      if (grid.Holds(i + down[0], j + down[1], k + down[2]) &&
          hu[grid.Index(i + down[0], j + down[1], k + down[2])] >= thresholds.gasSeed &&
          FloorBelow(grid, hu, voxel, fall, thresholds.gasBoundary, depth))
      {
        floors.push_back({ voxel, pieces.ofRun[r], depth });
      }
    }
  });
  return floors;
}

namespace
{
/** Depths below the half height, in standard deviations of the blur, where a blurred step reaches 99.2 % and 99.9 %. */
constexpr double EdgeInBlurs = 2.4;
constexpr double EndInBlurs = 3.0;
/** Greater than any length in mm. */
constexpr double Beyond = 1e9;

/** Intensity profiles along gravity under floors. */
class BelowFloors
{
public:
  BelowFloors(const ColonGrid &          grid,
              const VoxelValues &        hu,
              const std::vector<Floor> & floors,
              const GravitySteps &       fall,
              double                     tissue)
    : m_Grid(grid)
    , m_Hu(hu)
    , m_Floors(floors)
    , m_Fall(fall)
    , m_Tissue(tissue)
    , m_Blur(std::sqrt(UsualBlur * UsualBlur + UniformVariance(fall.step)))
  {}

  /** \param floors: indices of the floors of the level. */
  void
  Measure(const std::vector<std::size_t> & floors, Level & level) const
  {
    std::vector<double> deep;
    std::vector<double> edge;
    for (const auto f : floors)
    {
      double value = 0.0;
      if (this->Below(f, value))
      {
        deep.push_back(value);
      }
      if (this->EdgeBelow(f, value))
      {
        edge.push_back(value);
      }
    }
    level.below = UpperMedian(deep);
    level.edge = std::max(UpperMedian(edge), this->EndOfSteepRise(floors));
  }

private:
  /** Intensity below the blurred part of the rise under one floor; returns false if the grid ends. */
  bool
  Below(std::size_t floor, double & mean) const
  {
    constexpr double begin = 3.0, end = 6.5; // mm; chosen: below the blur of a level
    const auto       v = m_Grid.Voxel(m_Floors[floor].voxel);
    double           sum = 0.0;
    int              count = 0;
    for (int t = static_cast<int>(std::ceil(begin / m_Fall.step)); t * m_Fall.step <= end; ++t, ++count)
    {
      const auto o = m_Fall.Offset(t);
      if (!m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        return false;
      }
      sum += m_Hu[m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
    }
    mean = sum / std::max(1, count);
    return count > 0;
  }

  /** Linearly interpolated value at depth EdgeInBlurs below the half height of one floor; returns false outside the
   * grid. */
  bool
  EdgeBelow(std::size_t f, double & value) const
  {
    const auto   v = m_Grid.Voxel(m_Floors[f].voxel);
    const double own = m_Grid.Position(m_Floors[f].voxel).dot(m_Fall.direction);
    const double steps = (m_Floors[f].depth - own + EdgeInBlurs * m_Blur) / m_Fall.step;
    const int    t = static_cast<int>(std::floor(steps));
    double       ends[2];
    for (const int e : { 0, 1 })
    {
      const auto o = m_Fall.Offset(t + e);
      if (!m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        return false;
      }
      ends[e] = m_Hu[m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
    }
    value = ends[0] + (steps - t) * (ends[1] - ends[0]);
    return true;
  }

  /** Rise of the values below one floor. */
  struct Rise
  {
    double end{ 0.0 }; ///< end of the rise of a level
    bool   isOver{ false };
    double excess{ 0.0 }; ///< variance of the rise beyond the blur, relative to the contribution of a thin wall
  };

  /** False outside the grid. Unlike the intermediate values, the variance of a sampled rise hardly depends on the
   * positions of the voxels, even if they are as large as the rise. */
  bool
  RiseBelow(std::size_t f, Rise & rise) const
  {
    const auto   v = m_Grid.Voxel(m_Floors[f].voxel);
    const double own = m_Grid.Position(m_Floors[f].voxel).dot(m_Fall.direction);
    const int    last = static_cast<int>(std::ceil((m_Floors[f].depth - own + EndInBlurs * m_Blur) / m_Fall.step));
    double       sums[3] = { 0.0, 0.0, 0.0 };
    double       gas = 0.0;
    double       next = 0.0;
    for (int t = -1; t <= last + 1; ++t)
    {
      const auto o = m_Fall.Offset(t);
      if (!m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
      {
        return false;
      }
      const double value = m_Hu[m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
      next = value;
      if (t > last)
      {
        break;
      }
      const double z = (t - 0.5) * m_Fall.step;
      const double weight = t < 0 ? 0.0 : value - rise.end;
      gas = t < 0 ? value : gas;
      sums[0] += weight;
      sums[1] += weight * z;
      sums[2] += weight * z * z;
      rise.end = value;
    }
    const double mean = sums[1] / sums[0];
    const double variance = sums[2] / sums[0] - mean * mean - m_Blur * m_Blur - m_Fall.step * m_Fall.step / 12.0;
    const double share = (m_Tissue - gas) / (rise.end - gas);
    rise.excess = variance / (share * (1.0 - share) * ThinnestWall * ThinnestWall);
    rise.isOver = rise.end - m_Tissue > LeastAtEdge * (next - m_Tissue);
    return rise.end > m_Tissue + LeastTagging && gas < m_Tissue;
  }

  /** Intensity of the matter directly below a level if its rise is explained by the blur alone; a large negative value
   * otherwise. */
  double
  EndOfSteepRise(const std::vector<std::size_t> & floors) const
  {
    std::vector<double> ends;
    std::vector<double> excesses;
    for (const auto f : floors)
    {
      Rise rise;
      if (this->RiseBelow(f, rise))
      {
        ends.push_back(rise.end);
        excesses.push_back(rise.isOver ? rise.excess : Beyond);
      }
    }
    return 2 * ends.size() > floors.size() && UpperMedian(excesses) < 0.5 ? UpperMedian(ends) : -Beyond;
  }

  const ColonGrid &          m_Grid;
  const VoxelValues &        m_Hu;
  const std::vector<Floor> & m_Floors;
  const GravitySteps &       m_Fall;
  double                     m_Tissue;
  double                     m_Blur; ///< mm, including voxel size
};
constexpr double MinimumWidth = 1.5;  // mm; larger than a strip along the bottom of a straight tube
constexpr double HighestStepIn = 0.8; // mm between neighbors of one level
/** Limits for a flat floor: the floors within a radius (in mm, with a minimum in voxels) lie in a plane. Only floors
 * whose heights differ by less than a fraction of the radius are counted. They must reach a minimum number and a
 * minimum fraction of the columns, and must not exceed a maximum residual (mm, plus an increase per mm of the step
 * along gravity, which quantizes depths). Real levels are flat to within 0.4 mm. The sensitivity was not measured. */
constexpr double PlaneRadius = 3.0;
constexpr double PlaneRadiusInVoxels = 1.6;
constexpr double PlaneSteepness = 0.7;
constexpr int    LeastInPlane = 5;
constexpr double PlaneShare = 0.7;
constexpr double PlaneResidual = 0.2;
constexpr double PlaneResidualPerStep = 0.1;

struct Plane
{
  Eigen::Vector2d slope{ 0.0, 0.0 };
  double          depth{ 0.0 };
  double          residual{ 0.0 };
  double          count{ 0.0 };
};

/** Accumulated sums for fitting a plane to points, relative to an origin. */
class PlaneFit
{
public:
  void
  Add(double a, double b, double depth)
  {
    const Eigen::Vector3d x(1.0, a, b);
    m_Normal += x * x.transpose();
    m_Right += depth * x;
    m_Square += depth * depth;
  }
  Plane
  Solve() const
  {
    Plane plane;
    plane.count = m_Normal(0, 0);
    const Eigen::Vector3d c = m_Normal.ldlt().solve(m_Right);
    plane.depth = c[0];
    plane.slope = c.tail<2>();
    plane.residual = std::sqrt(std::max(0.0, (m_Square - c.dot(m_Right)) / std::max(1.0, plane.count)));
    return plane;
  }

private:
  Eigen::Matrix3d m_Normal{ Eigen::Matrix3d::Zero() };
  Eigen::Vector3d m_Right{ Eigen::Vector3d::Zero() };
  double          m_Square{ 0.0 };
};

/** A level, and the indices of its floors. */
struct FloorsOfLevel
{
  std::vector<std::size_t> floors;
  Level                    level;
};

/** Finds flat floors and groups them into levels. */
class LevelFinder
{
public:
  LevelFinder(const ColonGrid &          grid,
              const std::vector<Floor> & floors,
              const GravitySteps &       fall,
              const LevelLimits &        limits)
    : m_Grid(grid)
    , m_Floors(floors)
    , m_Fall(fall)
    , m_Limits(limits)
    , m_Radius(std::max(PlaneRadius, PlaneRadiusInVoxels * grid.spacing.maxCoeff()))
    , m_Places(this->Places())
    , m_Cells(m_Places, m_Radius)
  {}

  /** Largest first. */
  std::vector<FloorsOfLevel>
  Find() const
  {
    const auto                   flat = this->FlatFloors();
    std::map<int, FloorsOfLevel> levels;
    auto                         sets = this->Neighbors(flat);
    for (std::size_t f = 0; f < m_Floors.size(); ++f)
    {
      if (flat[f])
      {
        levels[sets.Find(static_cast<int>(f))].floors.push_back(f);
      }
    }
    std::vector<FloorsOfLevel> found;
    for (auto & [first, part] : levels)
    {
      if (part.floors.size() * m_Fall.ColumnArea(m_Grid) >= m_Limits.area && this->Measure(part.floors, part.level))
      {
        found.push_back(std::move(part));
      }
    }
    std::stable_sort(
      found.begin(), found.end(), [](const auto & p, const auto & q) { return p.level.area > q.level.area; });
    return found;
  }

private:
  std::vector<LateralCells::Place>
  Places() const
  {
    std::vector<LateralCells::Place> places(m_Floors.size());
    for (std::size_t f = 0; f < m_Floors.size(); ++f)
    {
      const auto p = m_Grid.Position(m_Floors[f].voxel);
      places[f] = { static_cast<float>(p.dot(m_Fall.across[0])), static_cast<float>(p.dot(m_Fall.across[1])) };
    }
    return places;
  }

  bool
  IsFlat(std::size_t f) const
  {
    PlaneFit fit;
    m_Cells.ForEachNear(m_Places[f].a, m_Places[f].b, [&](int g) {
      const double a = m_Places[g].a - m_Places[f].a;
      const double b = m_Places[g].b - m_Places[f].b;
      const double depth = m_Floors[g].depth - m_Floors[f].depth;
      if (a * a + b * b <= m_Radius * m_Radius && std::abs(depth) < PlaneSteepness * m_Radius)
      {
        fit.Add(a, b, depth);
      }
    });
    const Plane  plane = fit.Solve();
    const double expected = Pi * m_Radius * m_Radius / m_Fall.ColumnArea(m_Grid);
    return plane.count >= LeastInPlane && plane.count >= PlaneShare * expected &&
           plane.slope.norm() <= m_Limits.slope && plane.residual <= PlaneResidual + PlaneResidualPerStep * m_Fall.step;
  }

  std::vector<char>
  FlatFloors() const
  {
    std::vector<char>     flat(m_Floors.size());
    constexpr std::size_t block = 1024; // floors per task; chosen so that tasks outweigh their start
    ParallelFor((m_Floors.size() + block - 1) / block, [&](std::size_t i) {
      for (auto f = i * block; f < std::min(m_Floors.size(), (i + 1) * block); ++f)
      {
        flat[f] = this->IsFlat(f);
      }
    });
    return flat;
  }

  DisjointSets<>
  Neighbors(const std::vector<char> & flat) const
  {
    DisjointSets sets(m_Floors.size());
    const double reach = std::min(m_Radius, 1.5 * m_Grid.spacing.maxCoeff());
    for (std::size_t f = 0; f < m_Floors.size(); ++f)
    {
      if (!flat[f])
      {
        continue;
      }
      m_Cells.ForEachNear(m_Places[f].a, m_Places[f].b, [&](int g) {
        const double a = m_Places[g].a - m_Places[f].a;
        const double b = m_Places[g].b - m_Places[f].b;
        if (flat[g] && m_Floors[g].gas == m_Floors[f].gas && a * a + b * b <= reach * reach &&
            std::abs(m_Floors[g].depth - m_Floors[f].depth) < HighestStepIn)
        {
          sets.Join(static_cast<int>(f), g);
        }
      });
    }
    return sets;
  }

  bool
  Measure(const std::vector<std::size_t> & floors, Level & level) const
  {
    Eigen::Vector2d mean(0.0, 0.0);
    for (const auto f : floors)
    {
      mean += Eigen::Vector2d(m_Places[f].a, m_Places[f].b) / static_cast<double>(floors.size());
    }
    PlaneFit        fit;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    const double    base = m_Floors[floors[0]].depth;
    for (const auto f : floors)
    {
      const Eigen::Vector2d d = Eigen::Vector2d(m_Places[f].a, m_Places[f].b) - mean;
      covariance += d * d.transpose() / static_cast<double>(floors.size());
      fit.Add(d[0], d[1], m_Floors[f].depth - base);
    }
    const Plane plane = fit.Solve();
    level.depth = base + plane.depth;
    level.slope = plane.slope;
    level.center = mean;
    level.gas = m_Floors[floors[0]].gas;
    level.area = floors.size() * m_Fall.ColumnArea(m_Grid);
    for (const auto f : floors)
    {
      level.voxels.push_back(m_Floors[f].voxel);
    }
    level.width = std::sqrt(PrincipalAxes(covariance).values[0]);
    return level.width >= MinimumWidth;
  }

  const ColonGrid &                m_Grid;
  const std::vector<Floor> &       m_Floors;
  const GravitySteps &             m_Fall;
  const LevelLimits &              m_Limits;
  double                           m_Radius;
  std::vector<LateralCells::Place> m_Places;
  LateralCells                     m_Cells;
};

} // namespace

std::vector<Level>
FindLevels(const ColonGrid &          grid,
           const VoxelValues &        hu,
           const std::vector<Floor> & floors,
           const GravitySteps &       fall,
           double                     tissue,
           const LevelLimits &        limits)
{
  const BelowFloors  below(grid, hu, floors, fall, tissue);
  std::vector<Level> levels;
  for (FloorsOfLevel & found : LevelFinder(grid, floors, fall, limits).Find())
  {
    below.Measure(found.floors, found.level);
    levels.push_back(std::move(found.level));
  }
  return levels;
}

namespace
{
constexpr double FirstDepth = 1.2;   // mm below the half height; the rise above is too steep for the test
constexpr double GreatestDip = 0.3;  // relative to the lower contrast of level fluid and target
constexpr double NoiseInDip = 2.0;   // standard deviations
constexpr double LogisticRate = 1.7; // approximates the normal distribution within 1 %
constexpr int    Bisections = 20;    // of an interval of two steps; the error is 2^-19 steps

/** Approximate cumulative normal distribution with the value `half` at 0. */
double
ShareOfRise(double depth, double half, double blur)
{
  return 1.0 / (1.0 + (1.0 / half - 1.0) * std::exp(-LogisticRate * depth / blur));
}

/** Error in the depth of the half height due to linear interpolation if the rise is thinner than a voxel; `above` is
 * the depth of the upper voxel, at most 0. */
double
ErrorOfLine(double above, double step, double half, double blur)
{
  double low = -step;
  double high = step;
  for (int n = 0; n < Bisections; ++n)
  {
    const double error = 0.5 * (low + high);
    const double upper = ShareOfRise(above - error, half, blur);
    const double lower = ShareOfRise(above + step - error, half, blur);
    (upper - above / step * (lower - upper) > half ? low : high) = error;
  }
  return 0.5 * (low + high);
}
} // namespace

LevelColumn::LevelColumn(const ColonGrid &       grid,
                         const VoxelValues &     hu,
                         const GravitySteps &    fall,
                         const ColonThresholds & thresholds,
                         double                  noise,
                         double                  smoothing)
  : m_Grid(grid)
  , m_Hu(hu)
  , m_Fall(fall)
  , m_Thresholds(thresholds)
  , m_Noise(noise)
  , m_Blur(std::sqrt(UsualBlur * UsualBlur + smoothing * smoothing + UniformVariance(fall.step)))
{}

bool
LevelColumn::IsOpen(const Level & level, const std::array<int, 3> & floor, int steps) const
{
  const auto value = [&](int t) {
    const auto o = m_Fall.Offset(t);
    return m_Hu[m_Grid.Index(floor[0] + o[0], floor[1] + o[1], floor[2] + o[2])];
  };
  const auto &    t = m_Thresholds;
  const auto      top = m_Grid.Position(Eigen::Vector3d(floor[0], floor[1], floor[2]));
  Eigen::Vector2d place(top.dot(m_Fall.across[0]), top.dot(m_Fall.across[1]));
  const double    line = top.dot(m_Fall.direction) - level.depth - level.slope.dot(place - level.center);
  const double    plateau = std::min<double>(level.Fluid(), value(steps));
  const double    half = (t.gasBoundary - t.gas) / std::max(1.0, plateau - t.gas);
  const double    above = line - m_Fall.step * std::ceil(line / m_Fall.step);
  const double    below = line - ErrorOfLine(above, m_Fall.step, half, m_Blur);
  const double    most = std::max(GreatestDip * (plateau - t.tissue), NoiseInDip * m_Noise);
  for (int n = 1; n < steps; ++n)
  {
    const double depth = below + n * m_Fall.step;
    const double share = ShareOfRise(depth, half, m_Blur);
    if (depth >= FirstDepth && value(n) < t.gas + share * (plateau - t.gas) - most)
    {
      return false;
    }
  }
  return true;
}
} // namespace shapeton
