#include "shapetonFoldTruth.h"

#include "shapetonFlatColonLocator.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace shapeton
{
namespace
{
/** The positions of a point on both unrolled walls. */
struct PlacePair
{
  CylinderPlace source;
  CylinderPlace target;
};

std::vector<PlacePair>
PlacesOf(const SupineProneRegistration & registration, const std::vector<PointPair> & points)
{
  constexpr double       greatestDistance = 10.0; // mm from the wall; chosen
  std::vector<PlacePair> places;
  if (points.empty())
  {
    return places;
  }
  const FlatColonLocator source(registration.sourceFlat->Grid());
  const FlatColonLocator target(registration.targetFlat->Grid());
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

/** Displacement (mm along and around) between two positions. */
Eigen::Vector2d
Way(const CylinderPlace & from, const CylinderPlace & to, double around)
{
  return { to.s - from.s, TurnDifference(to.turn, from.turn) * around };
}

/** Moves a position together with the nearby points; empty if there are none. */
std::optional<CylinderPlace>
Moved(const CylinderPlace & place, const std::vector<PlacePair> & pairs, double around)
{
  constexpr double reach = 10.0; // mm; see the header
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

/** Planar distance from a point to the segment from a to b. */
double
DistanceToLine(const Eigen::Vector2d & place, const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  const Eigen::Vector2d edge = b - a;
  const double          square = edge.squaredNorm();
  const double          share = square > 0.0 ? std::clamp((place - a).dot(edge) / square, 0.0, 1.0) : 0.0;
  return (place - a - share * edge).norm();
}

/** End, center and end of a crest in the plane, mm. */
using PlanarCrest = std::array<Eigen::Vector2d, 3>;

double
MeanDistance(const PlanarCrest & from, const PlanarCrest & to)
{
  const std::array<Eigen::Vector2d, 5> places{
    { from[0], 0.5 * (from[0] + from[1]), from[1], 0.5 * (from[1] + from[2]), from[2] }
  };
  double sum = 0.0;
  for (const Eigen::Vector2d & place : places)
  {
    sum += std::min(DistanceToLine(place, to[0], to[1]), DistanceToLine(place, to[1], to[2]));
  }
  return sum / static_cast<double>(places.size());
}

std::array<CylinderPlace, 3>
PlacesOfCrest(const HaustralFold & fold, const ColonCylinder & cylinder)
{
  return {
    { cylinder.PlaceOfUv(fold.endUv[0]), cylinder.PlaceOfUv(fold.centerUv), cylinder.PlaceOfUv(fold.endUv[1]) }
  };
}

/** Moves a crest; an end without nearby points is moved together with the center. Empty if no points are near the
 * center. */
std::optional<std::array<CylinderPlace, 3>>
MovedCrest(const std::array<CylinderPlace, 3> & crest, const std::vector<PlacePair> & pairs, double around)
{
  const std::optional<CylinderPlace> middle = Moved(crest[1], pairs, around);
  if (!middle)
  {
    return std::nullopt;
  }
  std::array<CylinderPlace, 3> moved{ { *middle, *middle, *middle } };
  for (const int end : { 0, 2 })
  {
    const std::optional<CylinderPlace> known = Moved(crest[end], pairs, around);
    moved[end] = known ? *known
                       : CylinderPlace{ middle->s + crest[end].s - crest[1].s,
                                        middle->turn + TurnDifference(crest[end].turn, crest[1].turn) };
  }
  return moved;
}

/** Fold crest projected to the plane, relative to a position. */
PlanarCrest
Unrolled(const std::array<CylinderPlace, 3> & crest, const CylinderPlace & about, double around)
{
  return { { Way(about, crest[0], around), Way(about, crest[1], around), Way(about, crest[2], around) } };
}
} // namespace

int
IndexOf(const std::vector<FoldLandmark> & landmarks, const FoldLandmark & landmark)
{
  const auto found = std::find_if(landmarks.begin(), landmarks.end(), [&](const FoldLandmark & one) {
    return one.fold == landmark.fold && one.end == landmark.end;
  });
  return static_cast<int>(found - landmarks.begin());
}

FoldTruth::FoldTruth(const ColonPositionFiles &      supine,
                     const ColonPositionFiles &      prone,
                     const SupineProneRegistration & registration,
                     const std::vector<PointPair> &  points)
  : m_Registration(registration)
  , m_IsKnown(registration.sourceLandmarks.size(), 0)
  , m_Same(registration.sourceLandmarks.size())
{
  const std::vector<PlacePair> places = PlacesOf(registration, points);
  for (std::size_t i = 0; i < m_Same.size(); ++i)
  {
    const FoldLandmark & from = registration.sourceLandmarks[i];
    const auto           moved = MovedCrest(
      PlacesOfCrest(supine.position.folds[from.fold], *registration.source), places, registration.source->Around());
    m_IsKnown[i] = moved.has_value();
    for (std::size_t j = 0; moved && j < registration.targetLandmarks.size(); ++j)
    {
      const FoldLandmark & to = registration.targetLandmarks[j];
      const HaustralFold & fold = prone.position.folds[to.fold];
      if (this->IsSameFold(*moved, fold) && (from.end < 0 || this->IsSameEnd(*moved, from.end, fold, to.end)))
      {
        m_Same[i].push_back(static_cast<int>(j));
      }
    }
  }
}

bool
FoldTruth::IsSameFold(const Crest & moved, const HaustralFold & fold) const
{
  constexpr double  greatest = 8.0; // mm; see the header
  const double      around = m_Registration.target->Around();
  const PlanarCrest own = Unrolled(moved, moved[1], around);
  const PlanarCrest other = Unrolled(PlacesOfCrest(fold, *m_Registration.target), moved[1], around);
  return std::min(MeanDistance(own, other), MeanDistance(other, own)) < greatest;
}

bool
FoldTruth::IsSameEnd(const Crest & moved, int supineEnd, const HaustralFold & fold, int end) const
{
  const CylinderPlace & from = moved[supineEnd == 0 ? 0 : 2];
  const auto            distance = [&](int other) {
    return Way(from, m_Registration.target->PlaceOfUv(fold.endUv[other]), m_Registration.target->Around()).norm();
  };
  return distance(end) <= distance(1 - end);
}

std::vector<FoldVerdict>
FoldTruth::Judge(const std::vector<FoldMatch> & matches) const
{
  std::vector<FoldVerdict> verdicts(m_Same.size(), FoldVerdict::Unknown);
  std::vector<char>        isAlone(m_Same.size(), 1);
  std::set<int>            taken;
  for (const FoldMatch & match : matches)
  {
    const int                source = IndexOf(m_Registration.sourceLandmarks, match.source);
    const int                target = IndexOf(m_Registration.targetLandmarks, match.target);
    const std::vector<int> & same = m_Same[source];
    isAlone[source] = 0;
    if (m_IsKnown[source])
    {
      const bool isCorrect = std::find(same.begin(), same.end(), target) != same.end();
      verdicts[source] = isCorrect ? FoldVerdict::Correct : FoldVerdict::Wrong;
      if (isCorrect)
      {
        taken.insert(target);
      }
    }
  }
  for (std::size_t i = 0; i < m_Same.size(); ++i)
  {
    const bool hasFree =
      std::any_of(m_Same[i].begin(), m_Same[i].end(), [&](int other) { return taken.count(other) == 0; });
    if (isAlone[i] && hasFree)
    {
      verdicts[i] = FoldVerdict::Unmatched;
    }
  }
  return verdicts;
}
} // namespace shapeton
