#include "shapetonLevels.h"

#include "shapetonBelowLevel.h"
#include "shapetonDisjointSets.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace shapeton
{
namespace
{
constexpr double MaximumSlope = 0.1;  // tangent
constexpr double MinimumArea = 30.0;  // mm^2
constexpr double MinimumWidth = 1.5;  // mm: a strip along the bottom of a straight tube is thinner
constexpr double HighestStepIn = 0.8; // mm between neighbours of one level

struct Plane
{
  Eigen::Vector2d slope{ 0.0, 0.0 };
  double          depth{ 0.0 };
  double          residual{ 0.0 };
  double          count{ 0.0 };
};

/** Sums for a plane through points, relative to one place. */
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

/** Decides which floors are flat and which of them belong together. */
class LevelFinder
{
public:
  LevelFinder(const ColonGrid & grid, const std::vector<Floor> & floors, const Fall & fall)
    : m_Grid(grid)
    , m_Floors(floors)
    , m_Fall(fall)
    , m_Radius(std::max(3.0, 1.6 * grid.spacing.maxCoeff()))
    , m_Places(this->Places())
    , m_Cells(m_Places, m_Radius)
  {}

  /** The largest first; their floors are indices. */
  std::vector<Level>
  Find() const
  {
    const auto           flat = this->FlatFloors();
    std::map<int, Level> levels;
    auto                 sets = this->Neighbours(flat);
    for (std::size_t f = 0; f < m_Floors.size(); ++f)
    {
      if (flat[f])
      {
        levels[sets.Find(static_cast<int>(f))].floors.push_back(f);
      }
    }
    std::vector<Level> found;
    for (auto & entry : levels)
    {
      if (entry.second.floors.size() * m_Fall.ColumnArea(m_Grid) >= MinimumArea && this->Measure(entry.second))
      {
        found.push_back(entry.second);
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const Level & p, const Level & q) { return p.area > q.area; });
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
      if (a * a + b * b <= m_Radius * m_Radius && std::abs(depth) < 0.7 * m_Radius)
      {
        fit.Add(a, b, depth);
      }
    });
    const Plane  plane = fit.Solve();
    const double expected = 3.14159 * m_Radius * m_Radius / m_Fall.ColumnArea(m_Grid);
    return plane.count >= 5 && plane.count >= 0.7 * expected && plane.slope.norm() <= MaximumSlope &&
           plane.residual <= 0.2 + 0.1 * m_Fall.step;
  }

  std::vector<char>
  FlatFloors() const
  {
    std::vector<char>     flat(m_Floors.size());
    constexpr std::size_t block = 1024;
    ParallelFor((m_Floors.size() + block - 1) / block, [&](std::size_t i) {
      for (auto f = i * block; f < std::min(m_Floors.size(), (i + 1) * block); ++f)
      {
        flat[f] = this->IsFlat(f);
      }
    });
    return flat;
  }

  DisjointSets<>
  Neighbours(const std::vector<char> & flat) const
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
  Measure(Level & level) const
  {
    Eigen::Vector2d mean(0.0, 0.0);
    for (const auto f : level.floors)
    {
      mean += Eigen::Vector2d(m_Places[f].a, m_Places[f].b) / static_cast<double>(level.floors.size());
    }
    PlaneFit        fit;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    const double    base = m_Floors[level.floors[0]].depth;
    for (const auto f : level.floors)
    {
      const Eigen::Vector2d d = Eigen::Vector2d(m_Places[f].a, m_Places[f].b) - mean;
      covariance += d * d.transpose() / static_cast<double>(level.floors.size());
      fit.Add(d[0], d[1], m_Floors[f].depth - base);
    }
    const Plane plane = fit.Solve();
    level.depth = base + plane.depth;
    level.slope = plane.slope;
    level.centre = mean;
    level.gas = m_Floors[level.floors[0]].gas;
    level.area = level.floors.size() * m_Fall.ColumnArea(m_Grid);
    level.width = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[0]);
    return level.width >= MinimumWidth;
  }

  const ColonGrid &                m_Grid;
  const std::vector<Floor> &       m_Floors;
  const Fall &                     m_Fall;
  double                           m_Radius;
  std::vector<LateralCells::Place> m_Places;
  LateralCells                     m_Cells;
};

} // namespace

std::vector<Level>
FindLevels(const ColonGrid &          grid,
           const std::vector<float> & hu,
           const std::vector<Floor> & floors,
           const Fall &               fall,
           double                     tissue)
{
  std::vector<Level> levels = LevelFinder(grid, floors, fall).Find();
  for (Level & level : levels)
  {
    MeasureBelow(grid, hu, floors, fall, tissue, level);
    for (auto & f : level.floors)
    {
      f = floors[f].voxel;
    }
  }
  return levels;
}
} // namespace shapeton
