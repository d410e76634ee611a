#include "itkPieceOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double never = std::numeric_limits<double>::infinity();

/** mm that a join seems to be long: ends that look away from each other are farther apart. */
double
JoinCost(const JoinEnd & a, const JoinEnd & b)
{
  const Eigen::Vector3d between = b.position - a.position;
  const double          distance = between.norm();
  const Eigen::Vector3d straight = distance > 0.0 ? Eigen::Vector3d(between / distance) : a.out;
  const double          turns = 2.0 - a.out.dot(straight) + b.out.dot(straight);
  return 5.0 + distance * (1.0 + 0.35 * turns) + 2.0 * std::max(0.0, distance - longestJoin);
}

/** mm of joins that a piece is worth. */
double
LeavingCost(const JoinPiece & piece)
{
  return piece.isWanted ? 1e6 : 60.0 + piece.length;
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
    : m_Pieces(pieces), m_States(2 * pieces.size()), m_Entries((std::size_t{ 1 } << pieces.size()) * m_States)
  {}

  Entry &
  At(std::size_t set, std::size_t state)
  {
    return m_Entries[set * m_States + state];
  }

  /** State 2 p + r: the piece p is the last one, r where it is reversed. */
  void
  Extend(std::size_t set, std::size_t state)
  {
    const Entry     from = this->At(set, state);
    const JoinEnd & leaves = m_Pieces[state / 2].ends[state % 2 == 0 ? 1 : 0];
    for (std::size_t next = 0; next < m_States; ++next)
    {
      const std::size_t bit = std::size_t{ 1 } << (next / 2);
      if ((set & bit) != 0)
      {
        continue;
      }
      const double cost = from.cost + JoinCost(leaves, m_Pieces[next / 2].ends[next % 2]);
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
  std::size_t                    m_States;
  std::vector<Entry>             m_Entries;
};
} // namespace

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
      if (joins + leftOut < least)
      {
        least = joins + leftOut;
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
FindRectum(const std::vector<JoinPiece> & pieces, const Eigen::Vector3d & lowest, const Eigen::Vector3d & highest)
{
  const double middle = 0.5 * (lowest[0] + highest[0]);
  double       least = never;
  PlacedPiece  best;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (int e = 0; e < 2; ++e)
    {
      const Eigen::Vector3d & at = pieces[p].ends[e].position;
      // LPS: z grows towards the head, y towards the back.
      const double score = (at[2] - lowest[2]) + 0.7 * std::abs(at[0] - middle) + 0.5 * (highest[1] - at[1]);
      if (score < least)
      {
        least = score;
        best = { static_cast<int>(p), e == 1 };
      }
    }
  }
  return best;
}
} // namespace itk
