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
  /** Points of the wall at the end, where a join may begin; the position if there are none. */
  std::vector<Eigen::Vector3d> tips;
  /** For each tip the length missing to the farthest tip, mm. */
  std::vector<double> shortfalls;
  /** Radius of the widest ball within `endReach` of the end, mm. */
  double radius{ 0.0 };
  /** Cost of ending the colon here, mm. */
  double asCecum{ 0.0 };
};

struct JoinPiece
{
  std::array<JoinEnd, 2> ends;
  /** Length, mm. */
  double length{ 0.0 };
  /** Whether the piece must be used. */
  bool isWanted{ false };
};

/** A piece of the colon, traversed from end 0 to end 1 or in reverse. */
struct PlacedPiece
{
  int  piece{ 0 };
  bool isReversed{ false };
};

/** Length of the wide part of cecum and rectum along the line, mm. */
constexpr double endReach = 30.0;

/** Radius of the widest ball within `endReach` of the end of a path, mm; `radii` at its points. */
double
RadiusNearEnd(const std::vector<Eigen::Vector3d> & points, const std::vector<double> & radii);

/** Maximum number of pieces that can be ordered: time doubles with each. */
constexpr int mostJoinPieces = 14;

/** Joins longer than this (mm) are longer than a collapsed stretch. */
constexpr double longestJoin = 150.0;

/** The closest tips of two ends; a tip far back on the side of its end counts as farther. */
std::array<int, 2>
ClosestTips(const JoinEnd & a, const JoinEnd & b);

/** Sets the cost of each end as the last one. The cecum is caudal, on the right and wide, while the colon tapers where
 * it collapses. `usualRadius` is LumenCells::UsualRadius. */
void
PreferCecum(const ColonExtent & extent, double usualRadius, std::vector<JoinPiece> & pieces);

/** The order with the least sum of joins and of penalties for omitted pieces, with the first piece and its direction
 * given. Exact: dynamic programming over subsets (Held, Karp 1962). Pieces that cost more than they contribute are left
 * out. `cost` returns the sum, mm. */
std::vector<PlacedPiece>
OrderPieces(const std::vector<JoinPiece> & pieces, const PlacedPiece & first, double * cost = nullptr);

/** The end nearest to the anus: its piece, and whether it is end 1. */
PlacedPiece
FindRectum(const std::vector<JoinPiece> & pieces, const ColonExtent & extent);
} // namespace shapeton

#endif
