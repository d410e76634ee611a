#include "shapetonTaeniaEvidence.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Gaps in cells: minimum 45 degrees, maximum 225 degrees. */
constexpr int leastApart = 9;
constexpr int gaps = 37;
/** Cost of a step of all three tracks together, and of one track alone. Equal turn costs for the three tracks increase
 * the fraction within 10 mm from 0.973 to 0.987 on hard phantoms (seeds 1 to 8); doubling the turn cost and quadrupling
 * the cost of uneven gaps increases it from 0.833 to 0.954 on realistic 6 (prone). */
constexpr float turnCost = 0.8F;
constexpr float moveCost = 0.7F;
constexpr float unevenCost = 0.008F;
/** Huber threshold (cells) for the deviation of a gap from a third of the wall. */
constexpr double usualUnevenness = 2.0;
/** Cost per cell between a marker and the nearest track; exceeds any evidence. */
constexpr float markCost = 50.0F;
constexpr float forbidden = 1e30F;

/** Cost of uneven gaps: sum of Huber losses. */
float
UnevenCost(double first, double second)
{
  const double even = anglesAround / 3.0;
  double       sum = 0.0;
  for (const double gap : { first, second, anglesAround - first - second })
  {
    const double off = std::abs(gap - even);
    sum += off < usualUnevenness ? off * off : usualUnevenness * (2.0 * off - usualUnevenness);
  }
  return static_cast<float>(unevenCost * sum);
}

double
CellsBetween(double a, double b)
{
  return std::abs(std::remainder(a - b, static_cast<double>(anglesAround)));
}

/** Dynamic programming over states (angle of the first track, gap to the second, gap to the third). */
class JointProgram
{
public:
  explicit JointProgram(const TaeniaEvidence & evidence)
    : m_Evidence(evidence)
    , m_Best(States, 0.0F)
    , m_Next(States, 0.0F)
    , m_Steps(States * static_cast<std::size_t>(evidence.rows), 0)
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
  /** Number of angles of the first track times the number of values of each of the two gaps. */
  static constexpr std::size_t States = static_cast<std::size_t>(anglesAround) * gaps * gaps;

  void
  Advance(int row, int a, const std::vector<double> & marks)
  {
    const Arrivals arrivals = this->ArrivalsAt(a);
    std::copy(
      arrivals.steps.begin(), arrivals.steps.end(), &m_Steps[States * row + static_cast<std::size_t>(a) * gaps * gaps]);
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

  /** For each state of one angle, the minimum cost to reach it from the previous row, and the steps, encoded in base 3:
   * all tracks (times 27), the first, second and third alone (9, 3, 1); the digit 2 stands for -1. */
  struct Arrivals
  {
    std::array<float, gaps * gaps>         cost;
    std::array<unsigned char, gaps * gaps> steps;
  };

  /** Number of codes of the steps of three tracks (back, none, forward), in base 3. */
  static constexpr int allTracks = 27;

  /** Place value of a track in Arrivals::steps, and the changes in the two gaps caused by its step. */
  struct Track
  {
    int place;
    int gap;
    int nextGap;
  };

  /** Place values of base 3. A step forward narrows the gap ahead of the track and widens the gap behind it. */
  static constexpr Track first{ 9, -1, 0 };
  static constexpr Track second{ 3, 1, -1 };
  static constexpr Track third{ 1, 0, 1 };

  static int
  CodeOf(int step, int place)
  {
    return place * (step < 0 ? 2 : step);
  }

  static int
  StepOf(int steps, int place)
  {
    const int code = steps / place % 3;
    return code == 2 ? -1 : code;
  }

  Arrivals
  ArrivalsAt(int a) const
  {
    Arrivals arrivals = this->Turned(a);
    for (const int step : { -1, 1 })
    {
      TakeMoved(this->Turned(a - step), first, step, arrivals);
    }
    for (const Track & track : { second, third })
    {
      const Arrivals before = arrivals;
      for (const int step : { -1, 1 })
      {
        TakeMoved(before, track, step, arrivals);
      }
    }
    return arrivals;
  }

  const float *
  BestAt(int a) const
  {
    return &m_Best[static_cast<std::size_t>((a + anglesAround) % anglesAround) * gaps * gaps];
  }

  /** Applies steps of all tracks together. */
  Arrivals
  Turned(int a) const
  {
    Arrivals turned;
    std::copy_n(this->BestAt(a), gaps * gaps, turned.cost.begin());
    turned.steps.fill(0);
    for (const int step : { -1, 1 })
    {
      const float * const before = this->BestAt(a - step);
      for (int state = 0; state < gaps * gaps; ++state)
      {
        const bool isLess = before[state] + turnCost < turned.cost[state];
        turned.cost[state] = isLess ? before[state] + turnCost : turned.cost[state];
        turned.steps[state] = isLess ? CodeOf(step, allTracks) : turned.steps[state];
      }
    }
    return turned;
  }

  /** Moves a single track by one step where that reduces the cost. */
  static void
  TakeMoved(const Arrivals & before, const Track & track, int step, Arrivals & after)
  {
    const int  g = -step * track.gap;
    const int  h = -step * track.nextGap;
    const auto begin = [](int offset) { return std::max(0, -offset); };
    const auto end = [](int offset) { return std::min(gaps, gaps - offset); };
    for (int row = begin(g); row < end(g); ++row)
    {
      for (int column = begin(h); column < end(h); ++column)
      {
        const int  state = row * gaps + column;
        const int  other = state + g * gaps + h;
        const bool isLess = before.cost[other] + moveCost < after.cost[state];
        after.cost[state] = isLess ? before.cost[other] + moveCost : after.cost[state];
        after.steps[state] = isLess ? before.steps[other] + CodeOf(step, track.place) : after.steps[state];
      }
    }
  }

  /** Cell centers in turns; tracks are unwrapped. */
  TaeniaTracks
  Trace() const
  {
    TaeniaTracks tracks(m_Evidence.rows);
    const auto   last = static_cast<int>(std::min_element(m_Best.begin(), m_Best.end()) - m_Best.begin());
    int          angle = last / (gaps * gaps); // not wrapped
    int          g = last / gaps % gaps;
    int          h = last % gaps;
    for (int row = m_Evidence.rows - 1; row >= 0; --row)
    {
      const int two = angle + g + leastApart;
      tracks[row] = { (angle + 0.5) / anglesAround,
                      (two + 0.5) / anglesAround,
                      (two + h + leastApart + 0.5) / anglesAround };
      const std::size_t wrapped = ((angle % anglesAround) + anglesAround) % anglesAround;
      const int         steps = m_Steps[States * row + (wrapped * gaps + g) * gaps + h];
      const auto        stepOf = [&](const Track & track) { return StepOf(steps, track.place); };
      angle -= StepOf(steps, allTracks) + stepOf(first);
      g -= first.gap * stepOf(first) + second.gap * stepOf(second);
      h -= second.nextGap * stepOf(second) + third.nextGap * stepOf(third);
    }
    return tracks;
  }

  const TaeniaEvidence &         m_Evidence;
  std::vector<float>             m_Best;
  std::vector<float>             m_Next;
  std::vector<unsigned char>     m_Steps;
  std::array<float, gaps * gaps> m_Uneven{};
};

/** The gaps after the first track and after the next one, in cells. */
std::array<double, 2>
GapsOf(const TaeniaAngles & tracks)
{
  const auto gapTo = [&](int t) {
    const double turns = tracks[t] - tracks[0];
    return anglesAround * (turns - std::floor(turns));
  };
  const double near = std::min(gapTo(1), gapTo(2));
  const double far = std::max(gapTo(1), gapTo(2));
  return { near, far - near };
}

/** Cost of the steps for the cheapest common rotation: zero, or the step of one of the tracks. */
double
CostOfSteps(const TaeniaAngles & before, const TaeniaAngles & after)
{
  std::array<double, 3> steps;
  for (int t = 0; t < 3; ++t)
  {
    steps[t] = anglesAround * TurnsBetween(after[t], before[t]);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const double turn : { 0.0, steps[0], steps[1], steps[2] })
  {
    double cost = turnCost * std::abs(turn);
    for (const double step : steps)
    {
      cost += moveCost * std::abs(step - turn);
    }
    least = std::min(least, cost);
  }
  return least;
}
} // namespace

TaeniaTracks
JointTaeniae(const TaeniaEvidence & evidence, const Progress & progress)
{
  return JointProgram(evidence).Run(progress);
}

double
EnergyOfTaeniae(const TaeniaEvidence & evidence, const TaeniaTracks & tracks)
{
  double sum = 0.0;
  for (int row = 0; row < evidence.rows; ++row)
  {
    const std::array<double, 2> apart = GapsOf(tracks[row]);
    sum += UnevenCost(apart[0], apart[1]) + (row > 0 ? CostOfSteps(tracks[row - 1], tracks[row]) : 0.0);
    for (const double angle : tracks[row])
    {
      sum += evidence.CostAt(row, TaeniaEvidence::CellOf(angle));
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
