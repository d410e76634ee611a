#ifndef shapetonTaeniaEvidence_h
#define shapetonTaeniaEvidence_h

#include "shapetonColonTaeniae.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonHaustralFolds.h"
#include "shapetonProgress.h"
#include "shapetonWallTurns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shapeton
{
/** Angles of the three taeniae for one row, in turns around the tube along the grid row, as in WallTurns. */
using TaeniaAngles = std::array<double, 3>;
/** Angles for each row along the tube; tracks are unwrapped. */
using TaeniaTracks = std::vector<TaeniaAngles>;

/** The end of a fold. */
struct FoldEnd
{
  double row{ 0.0 };
  double angle{ 0.0 }; ///< turns, [0, 1)
};

/** A point through which a taenia must pass. */
struct TaeniaMark
{
  int    row{ 0 };
  double angle{ 0.0 };
};

/** Number of evidence cells around the tube. */
constexpr int anglesAround = 72;

/** Evidence of taeniae, derived from folds, on a grid of rows along the tube and angles around it. */
struct TaeniaEvidence
{
  int rows{ 0 };
  /** Number of grid columns per row. */
  int columnsPerRow{ 1 };
  /** rows x anglesAround: low where a taenia is likely. */
  std::vector<float> cost;
  /** Distance along the centerline and around the wall, mm. */
  std::vector<double>     arcLength;
  std::vector<double>     girth;
  std::vector<FoldEnd>    ends;
  std::vector<TaeniaMark> marks;
  /** Defines all angles used here. */
  WallTurns turns;

  float
  CostAt(int row, int angle) const
  {
    return cost[static_cast<std::size_t>(row) * anglesAround + angle];
  }
  /** Calls take(cell, share) for each cell that overlaps a pixel of the grid. */
  template <typename TTake>
  void
  ForCellsOfPixel(int column, int pixelRow, const TTake & take) const
  {
    const int row = column / columnsPerRow;
    turns.ForCellsOfPixel(row, pixelRow, anglesAround, [&](int cell, double share) {
      take(static_cast<std::size_t>(row) * anglesAround + cell, share);
    });
  }

  /** The cell of an angle in turns. */
  static int
  CellOf(double turns)
  {
    return std::min(static_cast<int>((turns - std::floor(turns)) * anglesAround), anglesAround - 1);
  }
};

/** Computes the evidence in wall angles, or in map angles for the published rule. */
TaeniaEvidence
MakeTaeniaEvidence(const FlatColon & flat, const ColonWallTube & tube, const HaustralFolds & folds, TaeniaRule rule);

/** The best three tracks by dynamic programming. */
TaeniaTracks
JointTaeniae(const TaeniaEvidence & evidence, const Progress & progress);

/** Mean energy per row. */
double
EnergyOfTaeniae(const TaeniaEvidence & evidence, const TaeniaTracks & tracks);

/** Tracks of windowed fuzzy C-means. With `thirds`: the most compact track, and two tracks one third and two thirds of
 * the circumference away from it. Empty if there are too few fold ends. */
TaeniaTracks
FuzzyTaeniae(const TaeniaEvidence & evidence, bool thirds);

/** Smooths tracks over the rows with a Gaussian of this standard deviation. */
TaeniaTracks
SmoothedTracks(const TaeniaTracks & tracks, double deviation);

/** a - b in turns, in [-0.5, 0.5]. */
inline double
TurnsBetween(double a, double b)
{
  return std::remainder(a - b, 1.0);
}
} // namespace shapeton

#endif
