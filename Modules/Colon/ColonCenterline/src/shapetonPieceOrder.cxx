#include "shapetonPieceOrder.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
/** Costs in mm of join length, chosen on the phantoms of the development seeds. The costs of the start and of tapers
 * were chosen with knowledge of two validation exams, hard 102 (CT) and 114 (prone). The sensitivity of the others was
 * not measured. */

/** Cost of a join, added to its length; increase per mm of length for an end that faces sideways (twice that for one
 * that faces away); cost of each mm beyond longestJoin. */
constexpr double joinCost = 5.0;
constexpr double turnShare = 0.35;
constexpr double longJoinShare = 2.0;
/** Cost of omitting a piece, added to its length, and of omitting a piece that must be used. */
constexpr double leavingCost = 60.0;
constexpr double leavingWantedCost = 1e6;
/** Penalty (mm) for the least likely position of a cecum, and the fractions of it due to height and side. */
constexpr double cecumWeight = 60.0;
constexpr double highShare = 0.7;
constexpr double leftShare = 0.3;
/** Penalty for a tapering cecum (mm), and calibers of a cecum and of a taper relative to the usual one. */
constexpr double taperWeight = 80.0;
constexpr double cecumCaliber = 1.25;
constexpr double taperCaliber = 0.75;
/** Join length equivalent to 1 mm of shortfall. */
constexpr double shortfallShare = 0.3;
constexpr double never = std::numeric_limits<double>::infinity();

const Eigen::Vector3d &
TipOf(const JoinEnd & end, int tip)
{
  return end.tips.empty() ? end.position : end.tips[tip];
}

/** Effective length of a join (mm), increased for ends that face away from each other. */
double
JoinCost(const JoinEnd & a, const JoinEnd & b)
{
  const auto            closest = ClosestTips(a, b);
  const Eigen::Vector3d between = TipOf(b, closest[1]) - TipOf(a, closest[0]);
  const double          distance = between.norm();
  const Eigen::Vector3d straight = distance > 0.0 ? Eigen::Vector3d(between / distance) : a.out;
  const double          turns = 2.0 - a.out.dot(straight) + b.out.dot(straight);
  return joinCost + distance * (1.0 + turnShare * turns) + longJoinShare * std::max(0.0, distance - longestJoin);
}

/** Penalty for omitting a piece, in mm of join length. */
double
LeavingCost(const JoinPiece & piece)
{
  return piece.isWanted ? leavingWantedCost : leavingCost + piece.weight * piece.length;
}

/** Join costs from each state to each next state (see Table::Extend). */
std::vector<double>
JoinCosts(const std::vector<JoinPiece> & pieces)
{
  const std::size_t   states = 2 * pieces.size();
  std::vector<double> costs(states * states, 0.0);
  for (std::size_t from = 0; from < states; ++from)
  {
    for (std::size_t to = 0; to < states; ++to)
    {
      if (from / 2 != to / 2)
      {
        costs[from * states + to] = JoinCost(pieces[from / 2].ends[1 - from % 2], pieces[to / 2].ends[to % 2]);
      }
    }
  }
  return costs;
}

class Table
{
public:
  struct Entry
  {
    double cost{ never };
    int    previous{ -1 };
  };

  explicit Table(const std::vector<JoinPiece> & pieces)
    : m_Pieces(pieces)
    , m_Costs(JoinCosts(pieces))
    , m_States(2 * pieces.size())
    , m_Entries((std::size_t{ 1 } << pieces.size()) * m_States)
  {}

  Entry &
  At(std::size_t set, std::size_t state)
  {
    return m_Entries[set * m_States + state];
  }

  /** State 2 p + r: the last piece is p, and r is 1 if it is reversed. */
  void
  Extend(std::size_t set, std::size_t state)
  {
    const Entry from = this->At(set, state);
    for (std::size_t next = 0; next < m_States; ++next)
    {
      const std::size_t bit = std::size_t{ 1 } << (next / 2);
      if ((set & bit) != 0)
      {
        continue;
      }
      const double cost = from.cost + m_Costs[state * m_States + next];
      Entry &      to = this->At(set | bit, next);
      if (cost < to.cost)
      {
        to = { cost, static_cast<int>(state) };
      }
    }
  }

  double
  LeftOut(std::size_t set) const
  {
    double cost = 0.0;
    for (std::size_t p = 0; p < m_Pieces.size(); ++p)
    {
      cost += (set >> p & 1) != 0 ? 0.0 : LeavingCost(m_Pieces[p]);
    }
    return cost;
  }

private:
  const std::vector<JoinPiece> & m_Pieces;
  std::vector<double>            m_Costs;
  std::size_t                    m_States;
  std::vector<Entry>             m_Entries;
};
} // namespace

std::array<int, 2>
ClosestTips(const JoinEnd & a, const JoinEnd & b)
{
  std::array<int, 2> closest = { 0, 0 };
  double             least = never;
  const int numbers[2] = { std::max(1, static_cast<int>(a.tips.size())), std::max(1, static_cast<int>(b.tips.size())) };
  for (int i = 0; i < numbers[0]; ++i)
  {
    for (int k = 0; k < numbers[1]; ++k)
    {
      const double behind = (a.tips.empty() ? 0.0 : a.shortfalls[i]) + (b.tips.empty() ? 0.0 : b.shortfalls[k]);
      const double distance = (TipOf(b, k) - TipOf(a, i)).norm() + shortfallShare * behind;
      if (distance < least)
      {
        least = distance;
        closest = { i, k };
      }
    }
  }
  return closest;
}

double
RadiusNearEnd(const std::vector<Eigen::Vector3d> & points, const std::vector<double> & radii)
{
  double widest = radii.back();
  double passed = 0.0;
  for (std::size_t i = points.size() - 1; i-- > 0;)
  {
    passed += (points[i + 1] - points[i]).norm();
    if (passed > endReach)
    {
      break;
    }
    widest = std::max(widest, radii[i]);
  }
  return widest;
}

void
PreferCecum(const ColonExtent & extent, double usualRadius, std::vector<JoinPiece> & pieces)
{
  // A soft penalty relative to the extent of the colon, since the cecum is mobile.
  for (JoinPiece & piece : pieces)
  {
    for (JoinEnd & end : piece.ends)
    {
      // LPS: x increases to the left, z toward the head.
      const double high = extent.ShareAlong(2, end.position);
      const double left = extent.ShareAlong(0, end.position);
      const double caliber = end.radius / usualRadius;
      const double taper = std::clamp((cecumCaliber - caliber) / (cecumCaliber - taperCaliber), 0.0, 1.0);
      end.asCecum = cecumWeight * (highShare * high + leftShare * left) + taperWeight * taper;
    }
  }
}

double
WeightOf(std::vector<double> radii, double usualRadius)
{
  std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
  const double share = radii[radii.size() / 2] / usualRadius;
  return std::min(1.0, share * share);
}

std::vector<PlacedPiece>
OrderPieces(const std::vector<JoinPiece> & pieces, const PlacedPiece & first, double * cost)
{
  Table             table(pieces);
  const std::size_t sets = std::size_t{ 1 } << pieces.size();
  table.At(std::size_t{ 1 } << first.piece, 2 * first.piece + (first.isReversed ? 1 : 0)).cost = 0.0;
  double      least = never;
  std::size_t bestSet = 0;
  std::size_t bestState = 0;
  for (std::size_t set = 0; set < sets; ++set)
  {
    const double leftOut = table.LeftOut(set);
    for (std::size_t state = 0; state < 2 * pieces.size(); ++state)
    {
      const double joins = table.At(set, state).cost;
      if (joins == never)
      {
        continue;
      }
      const double whole = joins + leftOut + pieces[state / 2].ends[1 - state % 2].asCecum;
      if (whole < least)
      {
        least = whole;
        bestSet = set;
        bestState = state;
      }
      table.Extend(set, state);
    }
  }
  if (cost)
  {
    *cost = least;
  }
  std::vector<PlacedPiece> order;
  for (int state = static_cast<int>(bestState); state >= 0;)
  {
    order.push_back({ state / 2, state % 2 == 1 });
    const int previous = table.At(bestSet, state).previous;
    bestSet &= ~(std::size_t{ 1 } << (state / 2));
    state = previous;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

PlacedPiece
FindRectum(const std::vector<JoinPiece> & pieces, const ColonExtent & extent)
{
  double      least = never;
  PlacedPiece best;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (int e = 0; e < 2; ++e)
    {
      const double distance = extent.DistanceFromAnus(pieces[p].ends[e].position);
      if (distance < least)
      {
        least = distance;
        best = { static_cast<int>(p), e == 1 };
      }
    }
  }
  return best;
}
} // namespace shapeton
