#include "shapetonRectumPlace.h"

#include "shapetonColonExtent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double RectumLead = 30.0;     // mm nearer to the anus than the colon
constexpr double FarthestRectum = 60.0; // mm; loops of small bowel in the pelvis lie above, or in front

/** Calls `body(piece, point)` for both ends of all runs. */
template <typename TBody>
void
ForEachEnd(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, const TBody & body)
{
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    for (const int i : { set.runs[r].begin, set.runs[r].end - 1 })
    {
      body(labels.ofRun[r], grid.Position(Eigen::Vector3d(i, j, k)));
    }
  });
}

ColonExtent
ExtentOfBowel(const ColonEvidence & evidence)
{
  ColonExtent extent;
  ForEachEnd(evidence.grid, evidence.gas.set, evidence.gas.labels, [&](int piece, const Eigen::Vector3d & point) {
    if (evidence.isCandidate[piece])
    {
      extent.Include(point);
    }
  });
  return extent;
}

/** Of the nearest voxel of each piece. */
std::vector<double>
DistancesFromAnus(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, const ColonExtent & extent)
{
  std::vector<double> distances(labels.number + 1, std::numeric_limits<double>::infinity());
  ForEachEnd(grid, set, labels, [&](int piece, const Eigen::Vector3d & point) {
    distances[piece] = std::min(distances[piece], extent.DistanceFromAnus(point));
  });
  return distances;
}

/** Infinite where none is chosen. */
double
NearestOf(const std::vector<double> & distances, const std::vector<char> & isChosen)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < isChosen.size(); ++p)
  {
    nearest = isChosen[p] ? std::min(nearest, distances[p]) : nearest;
  }
  return nearest;
}
} // namespace

std::vector<char>
PiecesNearerToAnus(const ColonEvidence & evidence, const VoxelRuns & set, const RunLabels & labels)
{
  const ColonExtent extent = ExtentOfBowel(evidence);
  const auto        ofGas = DistancesFromAnus(evidence.grid, evidence.gas.set, evidence.gas.labels, extent);
  const auto        ofBright = DistancesFromAnus(evidence.grid, evidence.brightSet, evidence.brightLabels, extent);
  const double      colon = std::min(NearestOf(ofGas, evidence.isColon), NearestOf(ofBright, evidence.isColonBright));
  std::vector<char> areNearer;
  for (const double distance : DistancesFromAnus(evidence.grid, set, labels, extent))
  {
    areNearer.push_back(std::isfinite(colon) && distance <= std::min(FarthestRectum, colon - RectumLead));
  }
  areNearer[0] = 0;
  return areNearer;
}
} // namespace shapeton
