#include "shapetonFinalMap.h"

#include "shapetonBeltramiProjection.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    mapAngles = 36;
constexpr double mapStep = 4.0; // mm

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
AddMatches(const ColonPair & pair, const CorrectedWarp & corrected, SupineProneRegistration & registration)
{
  for (std::size_t k = 0; k < corrected.matching.pairs.size(); ++k)
  {
    const auto [i, j] = corrected.matching.pairs[k];
    const CylinderPlace from = pair.sourceCylinder->PlaceOfUv(pair.source.folds[i].centreUv);
    const CylinderPlace to = pair.targetCylinder->PlaceOfUv(pair.target.folds[j].centreUv);
    const CylinderPlace mapped = registration.map.Forward(from);
    FoldMatch           match;
    match.source = i;
    match.target = j;
    match.cost = corrected.matching.costs[k];
    match.residual = std::hypot(mapped.s - to.s, TurnDifference(mapped.turn, to.turn) * pair.Around());
    match.weight = corrected.pairWeights[k];
    match.segment = SegmentOf(registration, from.s);
    registration.matches.push_back(match);
  }
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
           SupineProneRegistration & registration)
{
  BeltramiProjectionOptions options;
  options.greatest = greatestDilatation;
  const BeltramiProjection projection =
    ProjectToBijection(NodesOf(pair, corrected.Map(pair)), pair.sourceCylinder->Around(), pair.Around(), options);
  registration.map = CylinderMap(projection.nodes);
  registration.figures.flips = registration.map.Flips();
  registration.figures.flipsBeforeProjection = projection.flipsBefore;
  registration.figures.greatestDilatation = projection.greatest;
  AddMatches(pair, corrected, registration);
  MarkExcluded(pair, registration);
}
} // namespace shapeton
