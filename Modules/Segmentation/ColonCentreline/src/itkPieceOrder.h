#ifndef itkPieceOrder_h
#define itkPieceOrder_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace itk
{
/** One end of a piece, LPS in mm. */
struct JoinEnd
{
  Eigen::Vector3d position;
  /** Unit vector out of the piece along its line. */
  Eigen::Vector3d out;
  /** Points of the wall at the end, where a join may begin; the position where there are none. */
  std::vector<Eigen::Vector3d> tips;
  /** Of each tip what the piece is shorter to it than to its farthest tip, mm. */
  std::vector<double> shortfalls;
  /** What it costs when the colon ends here, mm. */
  double asCaecum{ 0.0 };
};

struct JoinPiece
{
  std::array<JoinEnd, 2> ends;
  /** mm. */
  double length{ 0.0 };
  /** It must be used. */
  bool isWanted{ false };
};

/** A piece of the colon, passed from end 0 to end 1 or the other way. */
struct PlacedPiece
{
  int  piece{ 0 };
  bool isReversed{ false };
};

/** The most pieces that can be ordered: time doubles with each. */
constexpr int mostJoinPieces = 14;

/** Joins longer than this (mm) are longer than a collapsed stretch. */
constexpr double longestJoin = 150.0;

/** The tips of two ends that lie closest together; a tip far back on the side of its end seems farther. */
std::array<int, 2>
ClosestTips(const JoinEnd & a, const JoinEnd & b);

/** The caecum lies caudal and on the right: fills in what other ends cost as the last one. */
void
PreferCaecum(const Eigen::Vector3d & lowest, const Eigen::Vector3d & highest, std::vector<JoinPiece> & pieces);

/** The order with the least sum of joins and of what leaving pieces out costs; the first piece and its direction are
 * given. Exact: dynamic programming over subsets (Held, Karp 1962). Pieces that would cost more than they bring are
 * left out. `cost` gets the sum, mm. */
std::vector<PlacedPiece>
OrderPieces(const std::vector<JoinPiece> & pieces, const PlacedPiece & first, double * cost = nullptr);

/** Where ends lie in the patient tells which one is the rectum: the index of the piece and of the end. */
PlacedPiece
FindRectum(const std::vector<JoinPiece> & pieces, const Eigen::Vector3d & lowest, const Eigen::Vector3d & highest);
} // namespace itk

#endif
