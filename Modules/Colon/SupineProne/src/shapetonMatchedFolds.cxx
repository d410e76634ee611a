#include "shapetonMatchedFolds.h"

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
FoldFeature
FeatureOf(const ColonPair & pair, const ColonCylinder & cylinder, const HaustralFold & fold, const PlaceMap * map)
{
  const CylinderPlace own = cylinder.PlaceOfUv(fold.centerUv);
  const double        s = map ? own.s : pair.frame.Inverse()(own.s);
  const auto          group = std::count_if(pair.breaks.begin(), pair.breaks.end(), [s](double at) { return s > at; });
  const CylinderPlace place = map ? (*map)(own) : own;
  return {
    place.s, place.turn * pair.Around(), std::max(1.0, fold.length), std::max(1.0, fold.area), static_cast<int>(group)
  };
}

void
AddFolds(const ColonPair &                     pair,
         const PlaceMap &                      map,
         const HaustralFold &                  a,
         const HaustralFold &                  b,
         std::vector<DisplacementConstraint> & constraints)
{
  const auto constraint = [&](const Eigen::Vector2d & from, const Eigen::Vector2d & to) {
    const CylinderPlace place = pair.sourceCylinder->PlaceOfUv(from);
    const CylinderPlace start = map(place);
    const CylinderPlace goal = pair.targetCylinder->PlaceOfUv(to);
    const double        around = TurnDifference(goal.turn, start.turn) * pair.Around();
    return DisplacementConstraint{ place, { goal.s - start.s, around } };
  };
  const auto endsOf = [&](bool isTurned) {
    return std::array<DisplacementConstraint, 2>{ constraint(a.endUv[0], b.endUv[isTurned ? 1 : 0]),
                                                  constraint(a.endUv[1], b.endUv[isTurned ? 0 : 1]) };
  };
  const auto straight = endsOf(false);
  const auto turned = endsOf(true);
  const auto cost = [](const std::array<DisplacementConstraint, 2> & ends) {
    return ends[0].displacement.squaredNorm() + ends[1].displacement.squaredNorm();
  };
  constraints.push_back(constraint(a.centerUv, b.centerUv));
  const auto & ends = cost(turned) < cost(straight) ? turned : straight;
  constraints.insert(constraints.end(), ends.begin(), ends.end());
}
} // namespace

FoldMatching
MatchFoldsAbout(const ColonPair & pair, const PlaceMap & map, FoldMatchingMethod method)
{
  std::vector<FoldFeature> source;
  std::vector<FoldFeature> target;
  for (const HaustralFold & fold : pair.source.folds)
  {
    source.push_back(FeatureOf(pair, *pair.sourceCylinder, fold, &map));
  }
  for (const HaustralFold & fold : pair.target.folds)
  {
    target.push_back(FeatureOf(pair, *pair.targetCylinder, fold, nullptr));
  }
  FoldMatchingOptions options;
  options.method = method;
  return MatchFolds(source, target, pair.Around(), options);
}

std::vector<DisplacementConstraint>
ConstraintsOfFolds(const ColonPair & pair, const PlaceMap & map, const FoldMatching & matching)
{
  std::vector<DisplacementConstraint> constraints;
  for (const auto & [i, j] : matching.pairs)
  {
    AddFolds(pair, map, pair.source.folds[i], pair.target.folds[j], constraints);
  }
  return constraints;
}
} // namespace shapeton
