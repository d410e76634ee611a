#include "shapetonCylindricalWarping.h"

#include "shapetonRowCosts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr float infinite = std::numeric_limits<float>::infinity(); // cost of states that cannot be reached
/** Maximum number of target rows per source row. In collapsed stretches, where the centerline takes a shortcut, lengths
 * differ much more. */
constexpr int           greatestAdvance = 3;
constexpr int           greatestUnseenAdvance = 8;
constexpr unsigned char jumped = 255; ///< code of a jump step

/** Searches for the optimal state (offset, rotation) of each row: the target row is 2 * row + offset - reach, and the
 * rotation is the rounded rotation of the frame + rotation - width. */
class WarpSearch
{
public:
  WarpSearch(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options)
    : m_Source(source)
    , m_Target(target)
    , m_Options(options)
    , m_Reach(static_cast<int>(options.band / target.step))
    , m_Costs(source, target, m_Reach, options)
  {
    m_Angles = source.Angles();
    m_Offsets = 2 * m_Reach + 1;
    m_Width = rotation.empty() ? m_Angles / 2 : static_cast<int>(std::lround(options.rotationBand * m_Angles));
    m_Rotations = rotation.empty() ? m_Angles : 2 * m_Width + 1;
    m_IsFree = rotation.empty();
    for (int row = 0; row < source.Rows(); ++row)
    {
      m_Center.push_back(rotation.empty() ? 0 : static_cast<int>(std::lround(rotation[row] * m_Angles)));
    }
  }

  CylindricalWarp
  Run(const PiecewiseLine & frame)
  {
    const int          rows = m_Source.Rows();
    const auto         states = static_cast<std::size_t>(m_Offsets) * m_Rotations;
    std::vector<float> before(states);
    m_Step.assign(states * rows, 0);
    m_Origin.assign(static_cast<std::size_t>(rows) * m_Offsets, 0);
    for (int row = 0; row < rows; ++row)
    {
      const std::vector<float> cost = m_Costs.OfRow(row, m_Center[row] - m_Width, m_Rotations);
      before = row == 0 ? cost : this->Advance(row, before, cost);
      m_Options.progress((row + 1.0) / rows);
    }
    return this->Trace(frame, before);
  }

private:
  std::vector<float>
  Advance(int row, const std::vector<float> & before, const std::vector<float> & cost)
  {
    std::vector<float> now(cost.size(), infinite);
    unsigned char *    taken = m_Step.data() + cost.size() * row;
    const int          turned = this->Turned(row);
    for (int offset = 0; offset < m_Offsets; ++offset)
    {
      const bool   isUnseen = this->IsUnseen(row) || this->IsTargetUnseen(2 * row + offset - m_Reach);
      const double ease = isUnseen ? m_Options.excludedEase : 1.0;
      const int    steps = 3 * (isUnseen ? greatestUnseenAdvance : greatestAdvance) + 3;
      for (int rotation = 0; rotation < m_Rotations; ++rotation)
      {
        const std::size_t state = static_cast<std::size_t>(offset) * m_Rotations + rotation;
        float             best = infinite;
        for (int step = 0; step < steps; ++step)
        {
          const int from = this->StateBefore(offset, rotation, turned, step);
          if (from >= 0)
          {
            const double bend = step / 3 - 2;
            const double stiff =
              m_Options.slopeWeight * bend * bend + m_Options.rotationWeight * std::abs(step % 3 - 1);
            const float sum = before[from] + static_cast<float>(ease * stiff);
            taken[state] = sum < best ? static_cast<unsigned char>(step) : taken[state];
            best = std::min(best, sum);
          }
        }
        now[state] = best + cost[state];
      }
    }
    this->Jump(row, before, cost, now);
    return now;
  }

  /** Where the wall is not visible, the path may continue at any rotation and at any later row. */
  void
  Jump(int row, const std::vector<float> & before, const std::vector<float> & cost, std::vector<float> & now)
  {
    std::vector<int> least; // best state of each offset
    for (int offset = 0; offset < m_Offsets; ++offset)
    {
      const auto begin = before.begin() + static_cast<std::ptrdiff_t>(offset) * m_Rotations;
      least.push_back(static_cast<int>(std::min_element(begin, begin + m_Rotations) - before.begin()));
    }
    for (int offset = 0; offset < m_Offsets; ++offset)
    {
      if (!this->IsUnseen(row) && !this->IsTargetUnseen(2 * row + offset - m_Reach))
      {
        continue;
      }
      int & origin = m_Origin[static_cast<std::size_t>(row) * m_Offsets + offset];
      float best = infinite;
      for (int from = 0; from <= std::min(offset + 2, m_Offsets - 1); ++from)
      {
        const double leap = m_Options.jumpCost + m_Options.leapCost * std::abs(offset - from);
        const float  sum = before[least[from]] + static_cast<float>(leap);
        origin = sum < best ? least[from] : origin;
        best = std::min(best, sum);
      }
      for (int rotation = 0; rotation < m_Rotations; ++rotation)
      {
        const std::size_t state = static_cast<std::size_t>(offset) * m_Rotations + rotation;
        if (best + cost[state] < now[state])
        {
          now[state] = best + cost[state];
          m_Step[cost.size() * row + state] = jumped;
        }
      }
    }
  }

  bool
  IsTargetUnseen(int row) const
  {
    return row >= 0 && row < m_Target.Rows() && m_Target.isExcluded[row];
  }

  bool
  IsUnseen(int row) const
  {
    return m_Source.isExcluded[row] || m_Source.isExcluded[row - 1];
  }

  /** Number of steps by which the frame rotates from the previous row to this one. Where the wall is not visible, the
   * path follows the frame. */
  int
  Turned(int row) const
  {
    const int     turned = m_Center[row] - m_Center[row - 1];
    constexpr int greatest = 1; // steps of rotation; larger steps of the frame are ignored
    return this->IsUnseen(row) || std::abs(turned) > greatest ? 0 : turned;
  }

  /** The previous state for step = 3 * (number of target rows) + (change in rotation) + 1; -1 if there is none. */
  int
  StateBefore(int offset, int rotation, int turned, int step) const
  {
    const int from = offset + 2 - step / 3;
    int       fromRotation = rotation + turned - (step % 3 - 1);
    fromRotation = m_IsFree ? (fromRotation + m_Rotations) % m_Rotations : fromRotation;
    const bool isInside = from >= 0 && from < m_Offsets && fromRotation >= 0 && fromRotation < m_Rotations;
    return isInside ? from * m_Rotations + fromRotation : -1;
  }

  CylindricalWarp
  Trace(const PiecewiseLine & frame, const std::vector<float> & last) const
  {
    const int       rows = m_Source.Rows();
    const auto      best = std::min_element(last.begin(), last.end());
    int             state = static_cast<int>(best - last.begin());
    Eigen::MatrixXd path(rows, 2);
    double          springs = 0.0;
    for (int row = rows - 1; row >= 0; --row)
    {
      const int offset = state / m_Rotations;
      const int rotation = state % m_Rotations;
      springs += m_Costs.SpringOf(offset);
      path.row(row) << m_Target.begin + (2 * row + offset - m_Reach) * m_Target.step,
        static_cast<double>(m_Center[row] + rotation - m_Width) / m_Angles;
      if (row > 0)
      {
        const int step = m_Step[last.size() * row + state];
        state = step == jumped ? m_Origin[static_cast<std::size_t>(row) * m_Offsets + offset]
                               : this->StateBefore(offset, rotation, this->Turned(row), step);
      }
    }
    CylindricalWarp warp;
    warp.energy = (*best - springs) / rows;
    for (int row = 0; row < rows; ++row)
    {
      warp.s.push_back(m_Source.begin + row * m_Source.step);
      path(row, 0) -= warp.s.back();
      path(row, 1) = row > 0 ? path(row - 1, 1) + TurnDifference(path(row, 1), path(row - 1, 1)) : path(row, 1);
    }
    for (int row = 0; row < rows; ++row)
    {
      const Eigen::RowVector2d mean = this->Smoothed(path, row);
      warp.targetS.push_back(frame(warp.s[row] + mean[0]));
      warp.rotation.push_back(mean[1]);
    }
    return warp;
  }

  Eigen::RowVector2d
  Smoothed(const Eigen::MatrixXd & path, int row) const
  {
    const int          reach = static_cast<int>(std::ceil(3.0 * m_Options.smoothing));
    const int          last = static_cast<int>(path.rows()) - 1;
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    double             weights = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
      const double t = i / m_Options.smoothing;
      const double weight = std::exp(-0.5 * t * t);
      sum += weight * path.row(std::clamp(row + i, 0, last));
      weights += weight;
    }
    return sum / weights;
  }

  const CylinderPicture &    m_Source;
  const CylinderPicture &    m_Target;
  CylindricalWarpingOptions  m_Options;
  std::vector<int>           m_Center;
  std::vector<unsigned char> m_Step;
  std::vector<int>           m_Origin; ///< origin of a jump to a row and an offset
  int                        m_Reach;
  RowCosts                   m_Costs;
  int                        m_Angles{ 1 };
  int                        m_Offsets{ 1 };
  int                        m_Width{ 0 };
  int                        m_Rotations{ 1 };
  bool                       m_IsFree{ false };
};
} // namespace

CylindricalWarp
WarpCylinder(const CylinderPicture &           source,
             const CylinderPicture &           target,
             const PiecewiseLine &             frame,
             const std::vector<double> &       rotation,
             const CylindricalWarpingOptions & options)
{
  return WarpSearch(source, target, rotation, options).Run(frame);
}
} // namespace shapeton
