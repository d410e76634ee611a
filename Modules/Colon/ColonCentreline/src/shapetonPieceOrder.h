#ifndef shapetonPieceOrder_h
#define shapetonPieceOrder_h

#include "shapetonColonExtent.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
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
  /** Of the widest ball within `endReach` of the end, mm. */
  double radius{ 0.0 };
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

/** mm along the line within which the caecum and the rectum are wide. */
constexpr double endReach = 30.0;

/** Of the widest ball within `endReach` of the end of a way, mm; `radii` at its points. */
double
RadiusNearEnd(const std::vector<Eigen::Vector3d> & points, const std::vector<double> & radii);

/** The most pieces that can be ordered: time doubles with each. */
constexpr int mostJoinPieces = 14;

/** Joins longer than this (mm) are longer than a collapsed stretch. */
constexpr double longestJoin = 150.0;

/** The tips of two ends that lie closest together; a tip far back on the side of its end seems farther. */
std::array<int, 2>
ClosestTips(const JoinEnd & a, const JoinEnd & b);

/** The caecum lies caudal and on the right, and is wide, while the colon tapers where it collapses: fills in what other
 * ends cost as the last one. `usualRadius` is LumenCells::UsualRadius. */
void
PreferCaecum(const ColonExtent & extent, double usualRadius, std::vector<JoinPiece> & pieces);

/** The order with the least sum of joins and of what leaving pieces out costs; the first piece and its direction are
 * given. Exact: dynamic programming over subsets (Held, Karp 1962). Pieces that would cost more than they bring are
 * left out. `cost` gets the sum, mm. */
std::vector<PlacedPiece>
OrderPieces(const std::vector<JoinPiece> & pieces, const PlacedPiece & first, double * cost = nullptr);

/** The end nearest to the anus: the piece, and whether it is its end 1. */
PlacedPiece
FindRectum(const std::vector<JoinPiece> & pieces, const ColonExtent & extent);
} // namespace shapeton

#endif
