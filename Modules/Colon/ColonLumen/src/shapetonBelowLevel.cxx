#include "shapetonBelowLevel.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double UsualBlur = 0.8; // mm, standard deviation of the scanner's
constexpr double EdgeInBlurs = 2.4;
constexpr double EndInBlurs = 3.0;
constexpr double ThinnestWall = 2.0; // mm

double
Median(std::vector<double> & values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Values along gravity under floors. */
class BelowFloors
{
public:
  BelowFloors(const ColonGrid &          grid,
              const std::vector<float> & hu,
              const std::vector<Floor> & floors,
              const Fall &               fall,
              double                     tissue)
    : m_Grid(grid)
    , m_Hu(hu)
    , m_Floors(floors)
    , m_Fall(fall)
    , m_Tissue(tissue)
    , m_Blur(std::sqrt(UsualBlur * UsualBlur + fall.step * fall.step / 12.0))
  {}

  void
  Measure(Level & level) const
  {
    std::vector<double> deep;
    std::vector<double> edge;
    for (const auto f : level.floors)
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
    level.below = Median(deep);
    level.edge = std::max(Median(edge), this->EndOfSteepRise(level));
  }

private:
  /** What is below one floor, 3 to 6 mm deep; false where the grid ends. */
  bool
  Below(std::size_t floor, double & mean) const
  {
    const auto v = m_Grid.Voxel(m_Floors[floor].voxel);
    double     sum = 0.0;
    int        count = 0;
    for (int t = static_cast<int>(std::ceil(3.0 / m_Fall.step)); t * m_Fall.step <= 6.5; ++t, ++count)
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

  /** The value at some depth below the half-height of one floor, linear between voxels; false beyond the grid. */
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

  /** How values rise below one floor. */
  struct Rise
  {
    double end{ 0.0 }; ///< where the rise of a level is over
    bool   isOver{ false };
    double excess{ 0.0 }; ///< variance of the rise beyond that of the blur, as a share of what a thin wall adds to it
  };

  /** False beyond the grid. The variance of a sampled rise hardly depends on where the voxels lie, not even where they
   * are as large as the rise is thick: values in between do. */
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

  /** What lies right below a level whose rise is as steep as the blur lets it be; nothing where it is not. */
  double
  EndOfSteepRise(const Level & level) const
  {
    std::vector<double> ends;
    std::vector<double> excesses;
    for (const auto f : level.floors)
    {
      Rise rise;
      if (this->RiseBelow(f, rise))
      {
        ends.push_back(rise.end);
        excesses.push_back(rise.isOver ? rise.excess : 1e9);
      }
    }
    return 2 * ends.size() > level.floors.size() && Median(excesses) < 0.5 ? Median(ends) : -1e9;
  }

  const ColonGrid &          m_Grid;
  const std::vector<float> & m_Hu;
  const std::vector<Floor> & m_Floors;
  const Fall &               m_Fall;
  double                     m_Tissue;
  double                     m_Blur; ///< mm, voxels included
};
} // namespace

void
MeasureBelow(const ColonGrid &          grid,
             const std::vector<float> & hu,
             const std::vector<Floor> & floors,
             const Fall &               fall,
             double                     tissue,
             Level &                    level)
{
  BelowFloors(grid, hu, floors, fall, tissue).Measure(level);
}
} // namespace shapeton
