#include "shapetonFluidWithoutGas.h"

#include "shapetonRectumPlace.h"
#include "shapetonRunPieces.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double LeastMl = 50.0;
constexpr double LeastRadius = 14.0; // mm; small bowel is 25 mm wide, and voxels add to it
constexpr double RectumMl = 20.0;
constexpr double RectumRadius = 10.0; // mm
constexpr double LeastLength = 2.5;   // volumes of the inscribed ball
constexpr double WellTagged = 300.0;  // HU above tissue
constexpr double SimilarShare = 0.25; // of the fluid's contrast

/** In the middle of the largest ball, mean of up to 27 voxels: a ball that the border of the image cuts may have its
 * middle there. */
bool
IsAsBright(const ColonEvidence & evidence, const std::array<int, 3> & middle)
{
  double sum = 0.0;
  int    number = 0;
  for (int n = 0; n < 27; ++n)
  {
    const std::array<int, 3> v{ { middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1 } };
    if (evidence.grid.Holds(v[0], v[1], v[2]))
    {
      sum += evidence.hu[evidence.grid.Index(v[0], v[1], v[2])];
      ++number;
    }
  }
  const auto & t = evidence.thresholds;
  return std::abs(sum / number - t.fluid) < SimilarShare * (t.fluid - t.tissue);
}
} // namespace

std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence)
{
  std::vector<FluidWithoutGas> taken;
  if (!evidence.isTagged || evidence.thresholds.fluid - evidence.thresholds.tissue < WellTagged)
  {
    return taken;
  }
  const auto pieces = PiecesOfRuns(evidence.brightSet, evidence.brightLabels);
  const auto areNearer = PiecesNearerToAnus(evidence, evidence.brightSet, evidence.brightLabels);
  for (int p = 1; p <= evidence.brightLabels.number; ++p)
  {
    const double ml = 1e-3 * evidence.grid.VoxelVolume() * static_cast<double>(pieces[p].voxels);
    if (evidence.isColonBright[p] || ml < (areNearer[p] ? RectumMl : LeastMl))
    {
      continue;
    }
    const auto   deepest = FindDeepestVoxel(evidence.grid, evidence.brightSet, evidence.brightLabels, p, pieces[p]);
    const auto & v = deepest.voxel;
    const double ballMl = 4.18879e-3 * deepest.radius * deepest.radius * deepest.radius;
    const bool   isWide = ml >= LeastMl && deepest.radius >= LeastRadius;
    if ((isWide || (areNearer[p] && deepest.radius >= RectumRadius)) && ml >= LeastLength * ballMl &&
        IsAsBright(evidence, v))
    {
      evidence.isColonBright[p] = 1;
      evidence.brightSeeds.push_back(v);
      taken.push_back({ ml, !isWide, evidence.grid.Position(evidence.grid.Index(v[0], v[1], v[2])) });
    }
  }
  return taken;
}
} // namespace shapeton
