#include "shapetonCorrectedWarp.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
FoldFeature
FeatureOf(const ColonPair & pair, const ColonCylinder & cylinder, const HaustralFold & fold, const RowMap * map)
{
  const CylinderPlace own = cylinder.PlaceOfUv(fold.centreUv);
  const double        s = map ? own.s : pair.frame.Inverse()(own.s);
  const auto          group = std::count_if(pair.breaks.begin(), pair.breaks.end(), [s](double at) { return s > at; });
  const CylinderPlace place = map ? (*map)(own) : own;
  return {
    place.s, place.turn * pair.Around(), std::max(1.0, fold.length), std::max(1.0, fold.area), static_cast<int>(group)
  };
}

FoldMatching
MatchAbout(const ColonPair & pair, const RowMap & map, FoldMatchingMethod method)
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

/** Where the middle and the ends of a fold are to move, more than the warp moves them. Ends are paired as they lie. */
void
AddFolds(const ColonPair &                     pair,
         const RowMap &                        warp,
         const HaustralFold &                  a,
         const HaustralFold &                  b,
         std::vector<DisplacementConstraint> & constraints)
{
  const auto constraint = [&](const Eigen::Vector2d & from, const Eigen::Vector2d & to, double weight) {
    const CylinderPlace place = pair.sourceCylinder->PlaceOfUv(from);
    const CylinderPlace start = warp(place);
    const CylinderPlace goal = pair.targetCylinder->PlaceOfUv(to);
    const double        around = TurnDifference(goal.turn, start.turn) * pair.Around();
    return DisplacementConstraint{ place, { goal.s - start.s, around }, weight };
  };
  const auto endsOf = [&](bool isTurned) {
    return std::array<DisplacementConstraint, 2>{ constraint(a.endUv[0], b.endUv[isTurned ? 1 : 0], 1.0),
                                                  constraint(a.endUv[1], b.endUv[isTurned ? 0 : 1], 1.0) };
  };
  const auto straight = endsOf(false);
  const auto turned = endsOf(true);
  const auto cost = [](const std::array<DisplacementConstraint, 2> & ends) {
    return ends[0].displacement.squaredNorm() + ends[1].displacement.squaredNorm();
  };
  constraints.push_back(constraint(a.centreUv, b.centreUv, 1.0));
  const auto & ends = cost(turned) < cost(straight) ? turned : straight;
  constraints.insert(constraints.end(), ends.begin(), ends.end());
}

/** Of each pair its middle and its ends. */
std::vector<DisplacementConstraint>
ConstraintsOfFolds(const ColonPair & pair, const CorrectedWarp & corrected)
{
  const RowMap                        warp = corrected.Warp(pair);
  std::vector<DisplacementConstraint> constraints;
  for (const auto & [i, j] : corrected.matching.pairs)
  {
    AddFolds(pair, warp, pair.source.folds[i], pair.target.folds[j], constraints);
  }
  return constraints;
}

/** Taeniae of the source are to come to lie on those of the target, where the map takes them along the colon. In the
 * rectum the muscle is one coat without bands; what is found there are mere continuations. */
std::vector<DirectionConstraint>
ConstraintsOfTaeniae(const ColonPair & pair, const RowMap & map, double deviation)
{
  constexpr double                 step = 6.0;      // mm
  constexpr double                 greatest = 15.0; // mm: farther away it is another one, or none
  constexpr double                 rectum = 100.0;  // mm from the anal verge
  std::vector<DirectionConstraint> constraints;
  const double                     begin = pair.sourceCylinder->Begin() + rectum;
  for (double s = begin; pair.AreTaeniaeKnown() && s < pair.sourceCylinder->End(); s += step)
  {
    for (int taenia = 0; taenia < 3; ++taenia)
    {
      const CylinderPlace place{ s, pair.sourceTaeniae.At(taenia, s) };
      const CylinderPlace at = map(place);
      double              nearest = greatest;
      for (int other = 0; other < 3; ++other)
      {
        const double away = TurnDifference(pair.targetTaeniae.At(other, at.s), at.turn) * pair.Around();
        nearest = std::abs(away) < std::abs(nearest) ? away : nearest;
      }
      if (std::abs(nearest) < greatest && !IsExcluded(pair.source, *pair.sourceCylinder, place) &&
          !IsExcluded(pair.target, *pair.targetCylinder, at))
      {
        const double sofar = map.correction ? map.correction->At(place).y() : 0.0;
        constraints.push_back(
          { place, Eigen::Vector2d::UnitY(), nearest + sofar, 1.0 / (deviation * deviation), true });
      }
    }
  }
  return constraints;
}

/** Each round about the map of the one before. */
void
MatchAndFit(const ColonPair & pair, FoldMatchingMethod method, int rounds, CorrectedWarp & corrected)
{
  for (int round = 0; round < rounds; ++round)
  {
    const RowMap map = corrected.Map(pair);
    corrected.matching = MatchAbout(pair, map, method);
    FitCorrection(pair, map, {}, corrected);
  }
}
} // namespace

CylinderPlace
RowMap::operator()(const CylinderPlace & place) const
{
  CylinderPlace mapped{ s(place.s), place.turn + rotation(place.s) };
  if (correction)
  {
    const Eigen::Vector2d more = correction->At(place);
    mapped.s += more.x();
    mapped.turn += more.y() / around;
  }
  return mapped;
}

RowMap
CorrectedWarp::Warp(const ColonPair & pair) const
{
  return { { warp.s, warp.targetS }, { warp.s, warp.rotation }, nullptr, pair.Around() };
}

RowMap
CorrectedWarp::Map(const ColonPair & pair) const
{
  RowMap map = this->Warp(pair);
  map.correction = correction;
  return map;
}

double
CorrectedWarp::Support() const
{
  double support = 0.0;
  for (const double weight : pairWeights)
  {
    support += weight - 0.5;
  }
  return support;
}

void
FitCorrection(const ColonPair &                pair,
              const RowMap &                   map,
              std::vector<DirectionConstraint> more,
              CorrectedWarp &                  corrected)
{
  std::vector<DirectionConstraint> directions = ConstraintsOfTaeniae(pair, map, corrected.taeniaDeviation);
  directions.insert(directions.end(), more.begin(), more.end());
  SmoothCorrectionOptions options;
  options.stiffness = corrected.stiffness;
  const auto correction = std::make_shared<SmoothCorrection>(
    pair.sourceCylinder->Begin(), pair.sourceCylinder->End(), pair.Around(), options);
  const std::vector<double> weights = correction->Fit(ConstraintsOfFolds(pair, corrected), directions);
  corrected.correction = correction;
  corrected.pairWeights.clear();
  for (std::size_t i = 0; i < corrected.matching.pairs.size(); ++i)
  {
    corrected.pairWeights.push_back(weights[3 * i]); // of the middle
  }
}

CorrectedWarp
CorrectWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method)
{
  CorrectedWarp corrected;
  corrected.warp = warp;
  MatchAndFit(pair, method, 2, corrected);
  return corrected;
}

CorrectedWarp
CorrectChosenWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method)
{
  CorrectedWarp corrected;
  corrected.warp = warp;
  corrected.taeniaDeviation = 6.0;
  corrected.stiffness = 1.0;
  MatchAndFit(pair, method, 3, corrected);
  return corrected;
}

CorrectedWarp
CorrectWarpExactly(const ColonPair & pair, const CylindricalWarp & warp)
{
  SmoothCorrectionOptions options;
  options.step = 4.0;
  options.angles = 36;
  options.deviation = 0.1;
  options.iterations = 1;
  CorrectedWarp corrected;
  corrected.warp = warp;
  corrected.matching = MatchAbout(pair, corrected.Warp(pair), FoldMatchingMethod::Hungarian);
  const auto correction = std::make_shared<SmoothCorrection>(
    pair.sourceCylinder->Begin(), pair.sourceCylinder->End(), pair.Around(), options);
  correction->Fit(ConstraintsOfFolds(pair, corrected));
  corrected.correction = correction;
  corrected.pairWeights.assign(corrected.matching.pairs.size(), 1.0);
  return corrected;
}
} // namespace shapeton
