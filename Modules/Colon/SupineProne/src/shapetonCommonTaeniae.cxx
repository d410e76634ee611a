#include "shapetonCommonTaeniae.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Mean distance (turns) of the mapped source taeniae from those of the target, if taenia i is taenia i + shift. */
double
DistanceOfShift(const ColonPair & pair, const CylinderMap & map, double s, int shift)
{
  double sum = 0.0;
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    const CylinderPlace mapped = map.Forward({ s, pair.sourceTaeniae.At(taenia, s) });
    sum += std::abs(TurnDifference(mapped.turn, pair.targetTaeniae.At((taenia + shift) % 3, mapped.s)));
  }
  return sum / 3.0;
}

/** Sum of the votes for each shift, and number of rows with a vote. */
struct Votes
{
  std::array<double, 3> ofShift{};
  int                   rows{ 0 };

  void
  Add(const ColonPair & pair, const SupineProneRegistration & registration, double s)
  {
    const CylinderPlace first{ s, pair.sourceTaeniae.At(0, s) };
    if (IsExcludedAt(registration, first))
    {
      return;
    }
    std::array<double, 3> distance{};
    for (int shift = 0; shift < 3; ++shift)
    {
      distance[shift] = DistanceOfShift(pair, registration.map, s, shift);
    }
    const auto best = std::min_element(distance.begin(), distance.end()) - distance.begin();
    ofShift[best] += ConfidenceAt(registration, first);
    ++rows;
  }
};
} // namespace

CommonTaeniae
FindCommonTaeniae(const ColonPair & pair, const SupineProneRegistration & registration)
{
  constexpr double least = 0.5; // see the header of the result
  CommonTaeniae    common;
  if (!pair.AreTaeniaeKnown() || registration.confidence.isFlagged)
  {
    return common;
  }
  const CylinderNodes & nodes = registration.map.Nodes();
  Votes                 votes;
  for (int row = 0; row < nodes.Rows(); ++row)
  {
    votes.Add(pair, registration, nodes.begin + row * nodes.step);
  }
  const auto best = std::max_element(votes.ofShift.begin(), votes.ofShift.end());
  common.probability = votes.rows > 0 ? *best / votes.rows : 0.0;
  for (int taenia = 0; common.probability >= least && taenia < 3; ++taenia)
  {
    const auto shift = static_cast<int>(best - votes.ofShift.begin());
    common.target[pair.sourceTaeniae.curves[taenia]] = pair.targetTaeniae.curves[(taenia + shift) % 3];
  }
  return common;
}
} // namespace shapeton
