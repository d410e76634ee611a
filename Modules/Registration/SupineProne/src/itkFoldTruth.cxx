#include "itkFoldTruth.h"

#include "itkFlatColonLocator.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace itk
{
namespace
{
/** A point on both unrolled walls. */
struct PlacePair
{
  CylinderPlace source;
  CylinderPlace target;
};

std::vector<PlacePair>
PlacesOf(const SupineProneRegistration & registration, const std::vector<PointPair> & points)
{
  constexpr double       greatestDistance = 10.0; // mm from the wall
  std::vector<PlacePair> places;
  if (points.empty())
  {
    return places;
  }
  const FlatColonLocator source(*registration.sourceGrid);
  const FlatColonLocator target(*registration.targetGrid);
  for (const PointPair & pair : points)
  {
    const FlatPlace from = source.Find(pair.source);
    const FlatPlace to = target.Find(pair.target);
    if (from.distance < greatestDistance && to.distance < greatestDistance)
    {
      places.push_back({ registration.source->PlaceOfUv(from.uv), registration.target->PlaceOfUv(to.uv) });
    }
  }
  return places;
}

/** mm along and around from one place to another. */
Eigen::Vector2d
Way(const CylinderPlace & from, const CylinderPlace & to, double around)
{
  return { to.s - from.s, TurnDifference(to.turn, from.turn) * around };
}

/** Where a place goes as the points around it do; nothing where there are none. */
std::optional<CylinderPlace>
Moved(const CylinderPlace & place, const std::vector<PlacePair> & pairs, double around)
{
  constexpr double reach = 10.0; // mm
  double           weights = 0.0;
  CylinderPlace    moved{ 0.0, 0.0 };
  double           firstTurn = 0.0;
  for (const PlacePair & pair : pairs)
  {
    const double distance = Way(place, pair.source, around).norm();
    if (distance > reach)
    {
      continue;
    }
    const double weight = 1.0 / (1.0 + distance * distance);
    const double turn = pair.target.turn - pair.source.turn;
    firstTurn = weights > 0.0 ? firstTurn : turn;
    moved.s += weight * (pair.target.s - pair.source.s);
    moved.turn += weight * TurnDifference(turn, firstTurn);
    weights += weight;
  }
  if (weights == 0.0)
  {
    return std::nullopt;
  }
  return CylinderPlace{ place.s + moved.s / weights, place.turn + firstTurn + moved.turn / weights };
}

/** Of the origin to the line from a to b. */
double
DistanceToLine(const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  const Eigen::Vector2d edge = b - a;
  const double          square = edge.squaredNorm();
  const double          share = square > 0.0 ? std::clamp(-a.dot(edge) / square, 0.0, 1.0) : 0.0;
  return (a + share * edge).norm();
}

double
DistanceToCrest(const CylinderPlace & place, const HaustralFold & fold, const ColonCylinder & cylinder)
{
  const auto way = [&](const Eigen::Vector2d & uv) { return Way(place, cylinder.PlaceOfUv(uv), cylinder.Around()); };
  const Eigen::Vector2d middle = way(fold.centreUv);
  return std::min(DistanceToLine(way(fold.endUv[0]), middle), DistanceToLine(middle, way(fold.endUv[1])));
}
} // namespace

FoldTruth::FoldTruth(const ColonPositionFiles &      supine,
                     const ColonPositionFiles &      prone,
                     const SupineProneRegistration & registration,
                     const std::vector<PointPair> &  points)
  : m_Partner(supine.position.folds.size(), Unknown)
{
  constexpr double             greatest = 8.0; // mm
  const std::vector<PlacePair> places = PlacesOf(registration, points);
  for (std::size_t i = 0; i < m_Partner.size(); ++i)
  {
    const CylinderPlace own = registration.source->PlaceOfUv(supine.position.folds[i].centreUv);
    const auto          moved = Moved(own, places, registration.source->Around());
    if (!moved)
    {
      continue;
    }
    m_Partner[i] = NotFound;
    double least = greatest;
    for (std::size_t j = 0; j < prone.position.folds.size(); ++j)
    {
      const double distance = DistanceToCrest(*moved, prone.position.folds[j], *registration.target);
      if (distance < least)
      {
        least = distance;
        m_Partner[i] = static_cast<int>(j);
      }
    }
  }
}

FoldVerdict
FoldTruth::OfPair(int supine, int prone) const
{
  return m_Partner[supine] == Unknown ? FoldVerdict::Unknown
         : m_Partner[supine] == prone ? FoldVerdict::Correct
                                      : FoldVerdict::Wrong;
}

FoldVerdict
FoldTruth::OfAlone(int supine) const
{
  return m_Partner[supine] >= 0 ? FoldVerdict::Unmatched : FoldVerdict::Unknown;
}
} // namespace itk
