#include "shapetonTaeniaEvidence.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Cells: 45 degrees; up to 225 degrees. The conformal map widens the side of a flat section that is farther away. */
constexpr int   leastApart = 9;
constexpr int   gaps = 37;
constexpr float turnCost = 0.35F;
constexpr float gapCost = 0.25F;
constexpr float unevenCost = 0.002F;
/** Of a cell that the nearest track lies off a marker: more than any evidence. */
constexpr float markCost = 50.0F;
constexpr float forbidden = 1e30F;

/** Three gaps that are uneven. */
float
UnevenCost(double first, double second)
{
  const double even = anglesAround / 3.0;
  const double third = anglesAround - first - second;
  return static_cast<float>(unevenCost * ((first - even) * (first - even) + (second - even) * (second - even) +
                                          (third - even) * (third - even)));
}

double
CellsBetween(double a, double b)
{
  return std::abs(std::remainder(a - b, static_cast<double>(anglesAround)));
}

/** The joint programme over states (angle of the first track, gap to the second, gap to the third). */
class JointProgramme
{
public:
  explicit JointProgramme(const TaeniaEvidence & evidence)
    : m_Evidence(evidence)
    , m_Best(States, 0.0F)
    , m_Next(States, 0.0F)
    , m_From(States * static_cast<std::size_t>(evidence.rows), 0)
  {
    for (int g = 0; g < gaps; ++g)
    {
      for (int h = 0; h < gaps; ++h)
      {
        const int  third = anglesAround - (g + leastApart) - (h + leastApart);
        const bool isAllowed = third >= leastApart && third < leastApart + gaps;
        m_Uneven[g * gaps + h] = isAllowed ? UnevenCost(g + leastApart, h + leastApart) : forbidden;
      }
    }
  }

  TaeniaTracks
  Run(const Progress & progress)
  {
    for (int row = 0; row < m_Evidence.rows; ++row)
    {
      std::vector<double> marks;
      for (const TaeniaMark & mark : m_Evidence.marks)
      {
        if (mark.row == row)
        {
          marks.push_back(mark.angle * anglesAround - 0.5);
        }
      }
      ParallelFor(anglesAround, [&](std::size_t a) { this->Advance(row, static_cast<int>(a), marks); });
      m_Best.swap(m_Next);
      progress((row + 1.0) / m_Evidence.rows);
    }
    return this->Trace();
  }

private:
  static constexpr std::size_t States = static_cast<std::size_t>(anglesAround) * gaps * gaps;

  void
  Advance(int row, int a, const std::vector<double> & marks)
  {
    const Arrivals arrivals = this->ArrivalsAt(a);
    std::copy(
      arrivals.from.begin(), arrivals.from.end(), &m_From[States * row + static_cast<std::size_t>(a) * gaps * gaps]);
    for (int g = 0; g < gaps; ++g)
    {
      for (int h = 0; h < gaps; ++h)
      {
        const std::size_t state = (static_cast<std::size_t>(a) * gaps + g) * gaps + h;
        const float       uneven = m_Uneven[g * gaps + h];
        if (uneven >= forbidden)
        {
          m_Next[state] = forbidden;
          continue;
        }
        const int second = (a + g + leastApart) % anglesAround;
        const int third = (second + h + leastApart) % anglesAround;
        float     cost =
          uneven + m_Evidence.CostAt(row, a) + m_Evidence.CostAt(row, second) + m_Evidence.CostAt(row, third);
        for (const double mark : marks)
        {
          cost += markCost * static_cast<float>(std::min(
                               { CellsBetween(a, mark), CellsBetween(second, mark), CellsBetween(third, mark) }));
        }
        m_Next[state] = row == 0 ? cost : cost + arrivals.cost[g * gaps + h];
      }
    }
  }

  /** The states of one angle: what it costs at least to come to each from the row before, and from where. */
  struct Arrivals
  {
    std::array<float, gaps * gaps>         cost;
    std::array<unsigned char, gaps * gaps> from; ///< steps of angle, first and second gap, plus one each, in base 3
  };

  Arrivals
  ArrivalsAt(int a) const
  {
    Arrivals            turned;
    const float * const same = &m_Best[static_cast<std::size_t>(a) * gaps * gaps];
    std::copy_n(same, gaps * gaps, turned.cost.begin());
    turned.from.fill(9);
    for (const int step : { -1, 1 })
    {
      const std::size_t   angle = (a + step + anglesAround) % anglesAround;
      const float * const other = &m_Best[angle * gaps * gaps];
      for (int state = 0; state < gaps * gaps; ++state)
      {
        const bool isLess = other[state] + turnCost < turned.cost[state];
        turned.cost[state] = isLess ? other[state] + turnCost : turned.cost[state];
        turned.from[state] = isLess ? 9 * (step + 1) : turned.from[state];
      }
    }
    return GapChanged(GapChanged(turned, gaps, 3), 1, 1);
  }

  /** Of the gap whose neighbours lie `stride` apart, `place` in the code. */
  static Arrivals
  GapChanged(const Arrivals & before, int stride, int place)
  {
    Arrivals after = before;
    for (int state = 0; state < gaps * gaps; ++state)
    {
      after.from[state] += place;
      for (const int step : { -1, 1 })
      {
        const int gap = state / stride % gaps + step;
        const int other = state + step * stride;
        if (gap >= 0 && gap < gaps && before.cost[other] + gapCost < after.cost[state])
        {
          after.cost[state] = before.cost[other] + gapCost;
          after.from[state] = before.from[other] + place * (step + 1);
        }
      }
    }
    return after;
  }

  /** Middles of the cells in turns; each track without jumps. */
  TaeniaTracks
  Trace() const
  {
    TaeniaTracks tracks(m_Evidence.rows);
    std::size_t  state = std::min_element(m_Best.begin(), m_Best.end()) - m_Best.begin();
    int          angle = static_cast<int>(state / (gaps * gaps)); // not wrapped
    for (int row = m_Evidence.rows - 1; row >= 0; --row)
    {
      const int g = static_cast<int>(state / gaps % gaps);
      const int h = static_cast<int>(state % gaps);
      const int second = angle + g + leastApart;
      tracks[row] = { (angle + 0.5) / anglesAround,
                      (second + 0.5) / anglesAround,
                      (second + h + leastApart + 0.5) / anglesAround };
      const int from = m_From[States * row + state];
      angle += row > 0 ? from / 9 - 1 : 0;
      const std::size_t wrapped = ((angle % anglesAround) + anglesAround) % anglesAround;
      state = row > 0 ? (wrapped * gaps + g + from / 3 % 3 - 1) * gaps + h + from % 3 - 1 : state;
    }
    return tracks;
  }

  const TaeniaEvidence &         m_Evidence;
  std::vector<float>             m_Best;
  std::vector<float>             m_Next;
  std::vector<unsigned char>     m_From;
  std::array<float, gaps * gaps> m_Uneven{};
};

/** The tracks of a row in the order of their angles from the first on, in cells: first angle, two gaps. */
std::array<double, 3>
AngleAndGaps(const TaeniaAngles & tracks)
{
  const auto gapTo = [&](int t) {
    const double turns = tracks[t] - tracks[0];
    return anglesAround * (turns - std::floor(turns));
  };
  const double near = std::min(gapTo(1), gapTo(2));
  const double far = std::max(gapTo(1), gapTo(2));
  return { anglesAround * tracks[0], near, far - near };
}
} // namespace

TaeniaTracks
JointTaeniae(const TaeniaEvidence & evidence, const Progress & progress)
{
  return JointProgramme(evidence).Run(progress);
}

double
EnergyOfTaeniae(const TaeniaEvidence & evidence, const TaeniaTracks & tracks)
{
  double sum = 0.0;
  for (int row = 0; row < evidence.rows; ++row)
  {
    const std::array<double, 3> state = AngleAndGaps(tracks[row]);
    sum += UnevenCost(state[1], state[2]);
    for (const double angle : tracks[row])
    {
      sum += evidence.CostAt(row, TaeniaEvidence::CellOf(angle));
    }
    if (row > 0)
    {
      const std::array<double, 3> before = AngleAndGaps(tracks[row - 1]);
      sum += turnCost * std::abs(state[0] - before[0]) +
             gapCost * (std::abs(state[1] - before[1]) + std::abs(state[2] - before[2]));
    }
  }
  for (const TaeniaMark & mark : evidence.marks)
  {
    double least = 0.5;
    for (const double angle : tracks[mark.row])
    {
      least = std::min(least, std::abs(TurnsBetween(angle, mark.angle)));
    }
    sum += markCost * anglesAround * least;
  }
  return sum / std::max(evidence.rows, 1);
}
} // namespace shapeton
