#include "shapetonCorrectedWarp.h"

#include "shapetonMatchedFolds.h"

#include <cmath>

namespace shapeton
{
namespace
{
/** Constraints that map taeniae of the source to taeniae of the target. The rectum is excluded: its muscle does not
 * form bands, so taeniae there are only extrapolated. */
std::vector<DirectionConstraint>
ConstraintsOfTaeniae(const ColonPair & pair, const RowMap & map, double deviation)
{
  constexpr double                 step = 6.0;      // mm
  constexpr double                 greatest = 15.0; // mm; at larger distances it is another taenia
  constexpr double                 rectum = 100.0;  // mm from the anal verge; chosen, see colon-registration.md
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

/** Matches folds iteratively, each time under the previous map. */
void
MatchAndFit(const ColonPair &  pair,
            FoldMatchingMethod method,
            int                rounds,
            CorrectedWarp &    corrected,
            const Progress &   progress)
{
  for (int round = 0; round < rounds; ++round)
  {
    const RowMap map = corrected.Map(pair);
    corrected.matching = MatchFoldsAbout(pair, map, method);
    FitCorrection(pair, map, {}, corrected, progress.Part("", double(round) / rounds, (round + 1.0) / rounds));
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
              CorrectedWarp &                  corrected,
              const Progress &                 progress)
{
  std::vector<DirectionConstraint> directions = ConstraintsOfTaeniae(pair, map, corrected.taeniaDeviation);
  directions.insert(directions.end(), more.begin(), more.end());
  SmoothCorrectionOptions options;
  options.stiffness = corrected.stiffness;
  const auto correction = std::make_shared<SmoothCorrection>(
    pair.sourceCylinder->Begin(), pair.sourceCylinder->End(), pair.Around(), options);
  const std::vector<double> weights =
    correction->Fit(ConstraintsOfFolds(pair, corrected.Warp(pair), corrected.matching), directions, progress);
  corrected.correction = correction;
  corrected.pairWeights.clear();
  for (std::size_t i = 0; i < corrected.matching.pairs.size(); ++i)
  {
    corrected.pairWeights.push_back(weights[3 * i]); // weight of the center
  }
}

CorrectedWarp
CorrectWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method, const Progress & progress)
{
  CorrectedWarp corrected;
  corrected.warp = warp;
  MatchAndFit(pair, method, 2, corrected, progress);
  return corrected;
}

CorrectedWarp
CorrectChosenWarp(const ColonPair &       pair,
                  const CylindricalWarp & warp,
                  FoldMatchingMethod      method,
                  const Progress &        progress)
{
  CorrectedWarp    corrected;
  constexpr double deviation = 6.0; // mm; chosen: twice that of folds, see the header
  corrected.warp = warp;
  corrected.taeniaDeviation = deviation;
  corrected.stiffness = 1.0;
  MatchAndFit(pair, method, 3, corrected, progress);
  return corrected;
}
} // namespace shapeton
