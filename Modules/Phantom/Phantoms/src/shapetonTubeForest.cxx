#include "shapetonTubeForest.h"

#include "shapetonForEachCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;

constexpr double forestCell = 5.0; // mm
// Maximum factor by which distance to the axis minus radius overestimates the distance, for radii that change by less
// than a third of a mm per mm.
constexpr double taperSlope = 1.1;

class TubeForest
{
public:
  TubeForest(std::vector<TaperedTube> tubes, double reach) : m_Tubes(std::move(tubes)), m_Reach(reach)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      double low = this->Low(m_Tubes.front(), i);
      double high = this->High(m_Tubes.front(), i);
      for (const auto & tube : m_Tubes)
      {
        low = std::min(low, this->Low(tube, i));
        high = std::max(high, this->High(tube, i));
      }
      m_Corner[i] = low;
      m_Size[i] = static_cast<int>(std::ceil((high - low) / forestCell)) + 1;
    }
    m_Cells.resize(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2]);
    for (std::size_t i = 0; i < m_Tubes.size(); ++i)
    {
      this->Insert(static_cast<int>(i));
    }
  }

  double
  Distance(const PointType & point) const
  {
    std::array<int, 3> cell;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double x = (point[i] - m_Corner[i]) / forestCell;
      if (x < 0.0 || x >= m_Size[i])
      {
        return m_Reach;
      }
      cell[i] = static_cast<int>(x);
    }
    double least = m_Reach;
    for (const int i : m_Cells[this->NumberOf(cell)])
    {
      least = std::min(least, DistanceTo(m_Tubes[i], point));
    }
    return least;
  }

private:
  double
  Low(const TaperedTube & tube, unsigned int axis) const
  {
    return std::min(tube.from[axis] - tube.fromRadius, tube.to[axis] - tube.toRadius) - m_Reach;
  }

  double
  High(const TaperedTube & tube, unsigned int axis) const
  {
    return std::max(tube.from[axis] + tube.fromRadius, tube.to[axis] + tube.toRadius) + m_Reach;
  }

  std::size_t
  NumberOf(const std::array<int, 3> & cell) const
  {
    return (static_cast<std::size_t>(cell[2]) * m_Size[1] + cell[1]) * m_Size[0] + cell[0];
  }

  static double
  DistanceTo(const TaperedTube & tube, const PointType & p)
  {
    const auto   along = tube.to - tube.from;
    const double squared = along.GetSquaredNorm();
    const double t = squared > 0.0 ? std::clamp(((p - tube.from) * along) / squared, 0.0, 1.0) : 0.0;
    const double radius = tube.fromRadius + t * (tube.toRadius - tube.fromRadius);
    return (p - (tube.from + along * t)).GetNorm() - radius;
  }

  // The distance of a point of a cell differs from that of its center by at most half the diagonal.
  void
  Insert(int number)
  {
    const double       halfDiagonal = 0.5 * std::sqrt(3.0) * forestCell;
    const auto &       tube = m_Tubes[number];
    std::array<int, 3> first;
    std::array<int, 3> end;
    for (unsigned int i = 0; i < 3; ++i)
    {
      first[i] = static_cast<int>((this->Low(tube, i) - m_Corner[i]) / forestCell);
      end[i] = static_cast<int>((this->High(tube, i) - m_Corner[i]) / forestCell) + 1;
    }
    ForEachCell(first, end, 1, [&](const std::array<int, 3> & cell) {
      const PointType middle = m_Corner + MakeVector(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5) * forestCell;
      if (DistanceTo(tube, middle) < taperSlope * (m_Reach + halfDiagonal))
      {
        m_Cells[this->NumberOf(cell)].push_back(number);
      }
    });
  }

  std::vector<TaperedTube>      m_Tubes;
  double                        m_Reach; // mm
  PointType                     m_Corner;
  std::array<int, 3>            m_Size;
  std::vector<std::vector<int>> m_Cells;
};
} // namespace

PhantomSolid
ForestSolid(const std::vector<TaperedTube> & tubes, double reach)
{
  if (tubes.empty())
  {
    return { [reach](const PointType &) { return reach; } };
  }
  const auto forest = std::make_shared<const TubeForest>(tubes, reach);
  return { [forest](const PointType & p) { return forest->Distance(p); }, taperSlope };
}
} // namespace shapeton
