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
  /** Unit vector along the centerline, pointing out of the piece. */
  Eigen::Vector3d out;
  /** Wall points at the end where a join may begin; the position itself if none exist. */
  std::vector<Eigen::Vector3d> tips;
  /** For each tip, the path length (mm) by which the farthest tip exceeds it. */
  std::vector<double> shortfalls;
  /** Radius of the widest ball within `endReach` of the end, mm. */
  double radius{ 0.0 };
  /** Cost if the colon ends here, mm. */
  double asCecum{ 0.0 };
};

struct JoinPiece
{
  std::array<JoinEnd, 2> ends;
  /** Length, mm. */
  double length{ 0.0 };
  /** Fraction of the length that counts if the piece is omitted, 0 to 1: less for lumen as narrow as small bowel. */
  double weight{ 1.0 };
  /** Whether the piece must be used. */
  bool isWanted{ false };
};

/** A piece of the colon, traversed from end 0 to end 1 or in reverse. */
struct PlacedPiece
{
  int  piece{ 0 };
  bool isReversed{ false };
};

/** Length of the wide part of the cecum and of the rectum along the line, mm. */
constexpr double endReach = 30.0;

/** Radius (mm) of the widest ball within `endReach` of the end of a path; `radii` are given at its points. */
double
RadiusNearEnd(const std::vector<Eigen::Vector3d> & points, const std::vector<double> & radii);

/** Maximum number of pieces to order; each additional piece doubles the run time. */
constexpr int mostJoinPieces = 14;

/** Maximum length of a collapsed stretch, mm. */
constexpr double longestJoin = 150.0;

/** The closest tips of two ends; the distance includes the shortfall of each tip. */
std::array<int, 2>
ClosestTips(const JoinEnd & a, const JoinEnd & b);

/** Sets the cost of treating each end as the cecum: low for a caudal, wide end on the right, high for a tapering,
 * collapsed end. `usualRadius` is LumenCells::UsualRadius. */
void
PreferCecum(const ColonExtent & extent, double usualRadius, std::vector<JoinPiece> & pieces);

/** Weight of a piece with these radii along its line, mm: the area of its median section relative to the usual one, at
 * most 1. */
double
WeightOf(std::vector<double> radii, double usualRadius);

/** The order that minimizes the sum of join costs and penalties for omitted pieces, for a given first piece and
 * direction. Exact, by dynamic programming over subsets (Held, Karp 1962). `cost` returns the sum, mm. */
std::vector<PlacedPiece>
OrderPieces(const std::vector<JoinPiece> & pieces, const PlacedPiece & first, double * cost = nullptr);

/** The end nearest to the anus: its piece, and whether it is end 1. */
PlacedPiece
FindRectum(const std::vector<JoinPiece> & pieces, const ColonExtent & extent);
} // namespace shapeton

#endif
