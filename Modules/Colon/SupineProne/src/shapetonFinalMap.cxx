#include "shapetonFinalMap.h"

#include "shapetonBeltramiProjection.h"
#include "shapetonPublishedMap.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    mapAngles = 36; // nodes around; chosen with mapStep: 3.5 mm at a radius of 20 mm
constexpr double mapStep = 4.0;  // mm; chosen far below the distance between folds

int
SegmentOf(const SupineProneRegistration & registration, double s)
{
  int segment = 0;
  for (const auto & flexure : registration.flexures)
  {
    segment += s > flexure.first;
  }
  return segment;
}

void
AddMatches(const ColonPair & pair, const std::vector<double> & weights, SupineProneRegistration & registration)
{
  for (std::size_t k = 0; k < registration.matching.pairs.size(); ++k)
  {
    const auto [i, j] = registration.matching.pairs[k];
    FoldMatch match;
    match.source = registration.sourceLandmarks[i];
    match.target = registration.targetLandmarks[j];
    const CylinderPlace from = pair.sourceCylinder->PlaceOfUv(match.source.Uv(pair.source.folds));
    const CylinderPlace to = pair.targetCylinder->PlaceOfUv(match.target.Uv(pair.target.folds));
    const CylinderPlace mapped = registration.map.Forward(from);
    match.cost = registration.matching.costs[k];
    match.residual = std::hypot(mapped.s - to.s, TurnDifference(mapped.turn, to.turn) * pair.Around());
    match.weight = weights[k];
    match.segment = SegmentOf(registration, from.s);
    registration.matches.push_back(match);
  }
}

std::vector<FoldLandmark>
WholeFolds(const ColonPosition & position)
{
  std::vector<FoldLandmark> landmarks;
  for (int fold = 0; fold < static_cast<int>(position.folds.size()); ++fold)
  {
    landmarks.push_back({ fold, -1 });
  }
  return landmarks;
}

void
MarkExcluded(const ColonPair & pair, SupineProneRegistration & registration)
{
  const CylinderNodes & nodes = registration.map.Nodes();
  registration.isExcluded.setZero(nodes.Rows(), nodes.Angles());
  for (int i = 0; i < nodes.Rows(); ++i)
  {
    for (int j = 0; j < nodes.Angles(); ++j)
    {
      const CylinderPlace place{ nodes.begin + i * nodes.step, static_cast<double>(j) / nodes.Angles() };
      registration.isExcluded(i, j) = IsExcluded(pair.source, *pair.sourceCylinder, place) ||
                                      IsExcluded(pair.target, *pair.targetCylinder, nodes.At(i, j));
    }
  }
}

/** `weights` are the weights of the pairs of registration.matching. */
void
FillIn(const ColonPair &           pair,
       CylinderMap                 map,
       const std::vector<double> & weights,
       SupineProneRegistration &   registration)
{
  registration.map = std::move(map);
  registration.figures.flips = registration.map.Flips();
  AddMatches(pair, weights, registration);
  MarkExcluded(pair, registration);
}
} // namespace

CylinderNodes
NodesOf(const ColonPair & pair, const RowMap & map)
{
  CylinderNodes nodes;
  const double  length = pair.sourceCylinder->End() - pair.sourceCylinder->Begin();
  const int     rows = std::max(2, static_cast<int>(std::ceil(length / mapStep)) + 1);
  nodes.begin = pair.sourceCylinder->Begin();
  nodes.step = length / (rows - 1);
  nodes.s.resize(rows, mapAngles);
  nodes.turn.resize(rows, mapAngles);
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < mapAngles; ++j)
    {
      const CylinderPlace place = map({ nodes.begin + i * nodes.step, static_cast<double>(j) / mapAngles });
      nodes.s(i, j) = place.s;
      nodes.turn(i, j) = place.turn;
    }
  }
  return nodes;
}

void
ProjectMap(const ColonPair &         pair,
           const CorrectedWarp &     corrected,
           double                    greatestDilatation,
           SupineProneRegistration & registration,
           const Progress &          progress)
{
  BeltramiProjectionOptions options;
  options.greatest = greatestDilatation;
  options.progress = progress;
  const BeltramiProjection projection =
    ProjectToBijection(NodesOf(pair, corrected.Map(pair)), pair.sourceCylinder->Around(), pair.Around(), options);
  registration.sourceLandmarks = WholeFolds(pair.source);
  registration.targetLandmarks = WholeFolds(pair.target);
  registration.matching = corrected.matching;
  registration.figures.flipsBeforeProjection = projection.flipsBefore;
  registration.figures.greatestDilatation = projection.greatest;
  FillIn(pair, CylinderMap(projection.nodes), corrected.pairWeights, registration);
}

void
MapAsPublished(const ColonPair &          pair,
               const SupineProneOptions & options,
               SupineProneRegistration &  registration,
               const Progress &           progress)
{
  const PublishedMap published = FindPublishedMap(pair, registration.frame, options, progress);
  registration.sourceLandmarks = published.sourceLandmarks;
  registration.targetLandmarks = published.targetLandmarks;
  registration.matching = published.matching;
  registration.figures.greatestDilatation = published.greatestDilatation;
  registration.figures.solves = published.solves;
  registration.figures.greatestMiss = published.greatestMiss;
  FillIn(pair, published.map, published.pairWeights, registration);
  if (registration.figures.flips > 0)
  {
    registration.warnings.push_back("the published map flips " + std::to_string(registration.figures.flips) +
                                    " triangles, where it is not one-to-one");
  }
}
} // namespace shapeton
