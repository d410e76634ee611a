#include "shapetonTaeniaMarkers.h"

#include "shapetonExceptions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace shapeton
{
namespace
{
constexpr double farthestMarker = 15.0; // mm from the wall; chosen: farther markers are of another surface
constexpr double bumpLength = 30.0;     // mm, standard deviation of the shift by a marker

double
Bump(double distance)
{
  return std::exp(-0.5 * distance * distance / (bumpLength * bumpLength));
}

/** Moves one track through all its markers by adding bumps. */
void
BendTrack(const TaeniaEvidence &                  evidence,
          const std::vector<const TaeniaPass *> & passes,
          int                                     track,
          TaeniaTracks &                          tracks)
{
  const auto      size = static_cast<Eigen::Index>(passes.size());
  Eigen::MatrixXd overlap(size, size);
  Eigen::VectorXd offset(size);
  const auto      arcOf = [&](Eigen::Index i) { return evidence.arcLength[passes[i]->mark.row]; };
  for (Eigen::Index i = 0; i < size; ++i)
  {
    offset[i] = TurnsBetween(passes[i]->mark.angle, tracks[passes[i]->mark.row][track]);
    for (Eigen::Index j = 0; j < size; ++j)
    {
      // Contradictory markers at nearly the same position are averaged by the ridge term.
      overlap(i, j) = Bump(arcOf(i) - arcOf(j)) + (i == j ? 1e-3 : 0.0);
    }
  }
  const Eigen::VectorXd weights = overlap.ldlt().solve(offset);
  for (int row = 0; row < evidence.rows; ++row)
  {
    for (Eigen::Index i = 0; i < size; ++i)
    {
      tracks[row][track] += weights[i] * Bump(evidence.arcLength[row] - arcOf(i));
    }
  }
}
} // namespace

std::vector<TaeniaPass>
LocateMarkers(const std::vector<Eigen::Vector3d> & markers,
              const FlatColonGrid &                grid,
              const FlatColonLocator &             locator,
              TaeniaEvidence &                     evidence,
              std::vector<UsedMarker> &            used)
{
  std::vector<TaeniaPass> passes;
  for (const Eigen::Vector3d & marker : markers)
  {
    TaeniaPass pass;
    pass.place = locator.Find(marker);
    pass.point = marker;
    if (pass.place.distance > farthestMarker)
    {
      throw InputError("marker " + std::to_string(passes.size() + 1) + " is " +
                       std::to_string(static_cast<int>(std::lround(pass.place.distance))) +
                       " mm from the wall; markers of taeniae must be on it (LPS, mm). Set it on this surface.");
    }
    pass.mark.row = std::min(pass.place.pixel.column / evidence.columnsPerRow, evidence.rows - 1);
    pass.mark.angle = evidence.turns.FromMap(pass.mark.row, (pass.place.pixel.row + 0.5) / grid.Rows());
    evidence.marks.push_back(pass.mark);
    passes.push_back(pass);
    used.push_back({ marker, 0, pass.place.distance, 0.0 });
  }
  return passes;
}

void
PassThroughMarkers(const TaeniaEvidence & evidence, std::vector<TaeniaPass> & passes, TaeniaTracks & tracks)
{
  for (TaeniaPass & pass : passes)
  {
    const TaeniaAngles & row = tracks[pass.mark.row];
    const auto           distance = [&](int t) { return std::abs(TurnsBetween(row[t], pass.mark.angle)); };
    pass.track = distance(1) < distance(0) ? 1 : 0;
    pass.track = distance(2) < distance(pass.track) ? 2 : pass.track;
  }
  for (int track = 0; track < 3; ++track)
  {
    std::vector<const TaeniaPass *> own;
    for (const TaeniaPass & pass : passes)
    {
      if (pass.track == track)
      {
        own.push_back(&pass);
      }
    }
    if (!own.empty())
    {
      BendTrack(evidence, own, track, tracks);
    }
  }
}

void
InsertMarkers(const std::vector<TaeniaPass> & passes, ColonTaeniae & taeniae)
{
  std::array<std::set<std::size_t>, 3> taken;
  for (std::size_t m = 0; m < passes.size(); ++m)
  {
    const TaeniaPass & pass = passes[m];
    ColonTaenia &      taenia = taeniae.taeniae[pass.track];
    std::size_t        nearest = 0;
    double             least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < taenia.uv.size(); ++i)
    {
      const double distance = std::abs(taenia.uv[i].x() - pass.place.uv.x());
      if (distance < least)
      {
        least = distance;
        nearest = i;
      }
    }
    taeniae.markers[m].taenia = pass.track + 1;
    if (taenia.points.empty())
    {
      continue;
    }
    if (taken[pass.track].insert(nearest).second)
    {
      taenia.points[nearest] = pass.place.surfacePoint;
      taenia.uv[nearest] = pass.place.uv;
      taenia.confidence[nearest] = 1.0;
    }
    taeniae.markers[m].distanceOfTaenia = (taenia.points[nearest] - pass.place.surfacePoint).norm();
  }
}
} // namespace shapeton
