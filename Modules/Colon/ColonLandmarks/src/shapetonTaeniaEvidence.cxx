#include "shapetonTaeniaEvidence.h"

#include "shapetonFlatColonAxis.h"
#include "shapetonGaussianWeights.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"
#include "shapetonSmoothedRows.h"
#include "shapetonWallBetweenFolds.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double rowLength = 2.8; // mm of the map
/** Weights of the three kinds of evidence, and the standard deviations of their smoothing in rows and angles. Chosen on
 * phantoms of the development seeds; the sensitivity of each was not measured. */
constexpr double foldWeight = 12.0;
constexpr double foldRows = 6.0;
constexpr double foldAngles = 2.0;
constexpr double endWeight = 40.0;
constexpr double endRows = 6.0;
constexpr double endAngles = 3.5;
constexpr double wallRows = 6.0;
constexpr double wallAngles = 2.0;
/** Distance (mm) from fold ends, which are at the border of a taenia, to its center. */
constexpr double halfBand = 6.0;
/** Maximum evidence against a taenia, above the row median; limited since folds occasionally cross taeniae. */
constexpr double mostAgainst = 1.0;
/** Length (mm) over which evidence fades out at the ends of the tube, where the wall closes. */
constexpr double fadingLength = 40.0;
/** Minimum sine of the angle between a fold and the tube, since longitudinal folds may end anywhere. */
constexpr double leastSine = 0.35;

using Cells = std::vector<double>;

/** Periodic around the tube, constant beyond its ends. */
Cells
Smoothed(const Cells & cells, int rows, double alongRows, double aroundAngles)
{
  const std::vector<double> around = GaussianWeights(aroundAngles, 4.0);
  const int                 reachAround = static_cast<int>(around.size()) / 2;
  Cells                     turned(cells.size(), 0.0);
  for (int row = 0; row < rows; ++row)
  {
    for (int a = 0; a < anglesAround; ++a)
    {
      for (int k = -reachAround; k <= reachAround; ++k)
      {
        turned[row * anglesAround + a] +=
          around[k + reachAround] * cells[row * anglesAround + (a + k + 2 * anglesAround) % anglesAround];
      }
    }
  }
  return SmoothedRows(turned, rows, alongRows);
}

/** Fold fraction of each cell. */
Cells
FoldDensity(const FlatColonGrid & grid, const HaustralFolds & folds, const TaeniaEvidence & evidence)
{
  Cells density(static_cast<std::size_t>(evidence.rows) * anglesAround, 0.0);
  Cells count(density.size(), 0.0);
  for (int column = 0; column < evidence.rows * evidence.columnsPerRow; ++column)
  {
    for (int row = 0; row < grid.Rows(); ++row)
    {
      const double isFold = folds.labels->GetPixel({ { column, row } }) > 0 ? 1.0 : 0.0;
      evidence.ForCellsOfPixel(column, row, [&](std::size_t cell, double share) {
        density[cell] += share * isFold;
        count[cell] += share;
      });
    }
  }
  for (std::size_t i = 0; i < density.size(); ++i)
  {
    density[i] /= count[i];
  }
  return density;
}

void
BoundWhatSpeaksAgainst(TaeniaEvidence & evidence)
{
  for (auto row = evidence.cost.begin(); row != evidence.cost.end(); row += anglesAround)
  {
    const float median = UpperMedian(std::vector<float>(row, row + anglesAround));
    std::transform(row, row + anglesAround, row, [median](float cost) {
      const double beside = cost - median;
      return static_cast<float>(beside > 0.0 ? mostAgainst * std::tanh(beside / mostAgainst) : beside);
    });
  }
}

std::vector<FoldEnd>
EndsOfFolds(const FlatColonGrid & grid, const HaustralFolds & folds, const TaeniaEvidence & evidence)
{
  std::vector<FoldEnd> ends;
  for (const HaustralFold & fold : folds.folds)
  {
    if (std::abs(std::sin(fold.angle * Pi / 180.0)) < leastSine)
    {
      continue;
    }
    for (const Eigen::Vector2d & uv : fold.endUv)
    {
      const double row = std::min((grid.PixelOfUv(uv).column + 0.5) / evidence.columnsPerRow, evidence.rows - 0.5);
      const auto   turnsOf = [&](const Eigen::Vector2d & place) {
        return evidence.turns.FromMap(static_cast<int>(row), (grid.PixelOfUv(place).row + 0.5) / grid.Rows());
      };
      const double outwards = std::copysign(halfBand / evidence.girth[static_cast<int>(row)],
                                            TurnsBetween(turnsOf(uv), turnsOf(fold.centerUv)));
      const double angle = turnsOf(uv) + outwards;
      ends.push_back({ row, angle - std::floor(angle) });
    }
  }
  return ends;
}
} // namespace

TaeniaEvidence
MakeTaeniaEvidence(const FlatColon & flat, const ColonWallTube & tube, const HaustralFolds & folds, TaeniaRule rule)
{
  const FlatColonGrid & grid = flat.Grid();
  const FlatColonAxis & axis = flat.Axis();
  TaeniaEvidence        evidence;
  evidence.columnsPerRow = std::max(1, static_cast<int>(std::lround(rowLength / grid.PixelSize())));
  evidence.rows = std::max(1, grid.Columns() / evidence.columnsPerRow);
  evidence.columnsPerRow = std::min(evidence.columnsPerRow, grid.Columns());
  evidence.turns = rule == TaeniaRule::Published ? WallTurns::OfMap(grid, evidence.rows)
                                                 : WallTurns(grid, evidence.rows, evidence.columnsPerRow);
  for (int row = 0; row < evidence.rows; ++row)
  {
    const int column = std::min(static_cast<int>((row + 0.5) * evidence.columnsPerRow), grid.Columns() - 1);
    evidence.arcLength.push_back(tube.ArcLengthOfU(grid.UvOfPixel(column, 0).x()));
    evidence.girth.push_back(TwoPi * axis.radii[column]);
  }
  evidence.ends = EndsOfFolds(grid, folds, evidence);

  Cells ends(static_cast<std::size_t>(evidence.rows) * anglesAround, 0.0);
  for (const FoldEnd & end : evidence.ends)
  {
    ends[static_cast<int>(end.row) * anglesAround + TaeniaEvidence::CellOf(end.angle)] += 1.0;
  }
  const Cells endDensity = Smoothed(ends, evidence.rows, endRows, endAngles);
  const Cells foldDensity = Smoothed(FoldDensity(grid, folds, evidence), evidence.rows, foldRows, foldAngles);
  const Cells wall = Smoothed(WallBetweenFolds(grid, axis, folds, evidence), evidence.rows, wallRows, wallAngles);
  for (std::size_t i = 0; i < endDensity.size(); ++i)
  {
    const double s = evidence.arcLength[i / anglesAround];
    const double toEnd = std::min(s - evidence.arcLength.front(), evidence.arcLength.back() - s);
    const double share = std::clamp(toEnd / fadingLength, 0.0, 1.0);
    evidence.cost.push_back(
      static_cast<float>(share * (foldWeight * foldDensity[i] - endWeight * endDensity[i] - wall[i])));
  }
  BoundWhatSpeaksAgainst(evidence);
  return evidence;
}

TaeniaTracks
SmoothedTracks(const TaeniaTracks & tracks, double deviation)
{
  const std::vector<double> kernel = GaussianWeights(deviation, 4.0);
  const int                 reach = static_cast<int>(kernel.size()) / 2;
  const int                 last = static_cast<int>(tracks.size()) - 1;
  TaeniaTracks              result(tracks.size(), TaeniaAngles{ 0.0, 0.0, 0.0 });
  for (int row = 0; row <= last; ++row)
  {
    for (int k = -reach; k <= reach; ++k)
    {
      for (int t = 0; t < 3; ++t)
      {
        result[row][t] += kernel[k + reach] * tracks[std::clamp(row + k, 0, last)][t];
      }
    }
  }
  return result;
}
} // namespace shapeton
