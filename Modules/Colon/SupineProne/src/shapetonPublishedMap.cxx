#include "shapetonPublishedMap.h"

#include "shapetonExceptions.h"
#include "shapetonFlatPair.h"
#include "shapetonMatchedFolds.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace shapeton
{
namespace
{
/** A source position and its prescribed image. */
struct Landmark
{
  CylinderPlace source;
  CylinderPlace target;
};

/** The target taenia nearest to the first (best supported) source taenia. */
int
MainTaeniaOfTarget(const ColonPair & pair, const CylinderMap & frame)
{
  constexpr double      step = 10.0; // mm; chosen: taeniae are smooth
  std::array<double, 3> away{};
  for (double s = pair.sourceCylinder->Begin(); s < pair.sourceCylinder->End(); s += step)
  {
    const CylinderPlace at = frame.Forward({ s, pair.sourceTaeniae.At(0, s) });
    for (int taenia = 0; taenia < 3; ++taenia)
    {
      away[taenia] += std::abs(TurnDifference(pair.targetTaeniae.At(taenia, at.s), at.turn));
    }
  }
  return static_cast<int>(std::min_element(away.begin(), away.end()) - away.begin());
}

/** Constraints on a map from landmarks. */
class PublishedConditions
{
public:
  PublishedConditions(const ColonPair & pair, const FlatPair & flat, int targetTaenia)
    : m_Pair(pair), m_Flat(flat), m_TargetTaenia(targetTaenia)
  {}

  MapConditions
  operator()(const CylinderValues & values) const
  {
    MapConditions conditions;
    this->AddCircles(values, conditions.along);
    this->AddTaenia(values, conditions.around);
    for (const Landmark & landmark : landmarks)
    {
      conditions.along.push_back(m_Flat.Along(landmark.source, landmark.target.s, values));
      conditions.around.push_back(m_Flat.Around(landmark.source, landmark.target.turn, values));
    }
    return conditions;
  }

  std::vector<Landmark> landmarks;

private:
  /** Adds ends and flexures. */
  void
  AddCircles(const CylinderValues & values, std::vector<MapCondition> & along) const
  {
    for (std::size_t i = 0; i < m_Pair.frame.from.size(); ++i)
    {
      for (int angle = 0; angle < m_Flat.Equations().Angles(); ++angle)
      {
        along.push_back(m_Flat.Along({ m_Pair.frame.from[i], m_Flat.TurnOfAngle(angle) }, m_Pair.frame.to[i], values));
      }
    }
  }

  /** Fixes the initial rotation if there are neither taeniae nor other landmarks. */
  void
  AddTaenia(const CylinderValues & values, std::vector<MapCondition> & around) const
  {
    if (!m_Pair.AreTaeniaeKnown() && landmarks.empty())
    {
      const CylinderPlace first{ m_Flat.SOfRow(0), 0.0 };
      around.push_back(m_Flat.Around(first, m_Flat.Mapped(first, values).turn, values));
    }
    for (int row = 0; m_Pair.AreTaeniaeKnown() && row < m_Flat.Equations().Rows(); ++row)
    {
      const double        s = m_Flat.SOfRow(row);
      const CylinderPlace place{ s, m_Pair.sourceTaeniae.At(0, s) };
      const CylinderPlace mapped = m_Flat.Mapped(place, values);
      around.push_back(m_Flat.Around(place, m_Pair.targetTaeniae.At(m_TargetTaenia, mapped.s), values));
    }
  }

  const ColonPair & m_Pair;
  const FlatPair &  m_Flat;
  int               m_TargetTaenia;
};

/** Landmarks at the ends of matched folds. */
std::vector<Landmark>
LandmarksOf(const ColonPair & pair, const CylinderMap & map, const FoldMatching & matching)
{
  const PlaceMap        forward = [&](const CylinderPlace & place) { return map.Forward(place); };
  std::vector<Landmark> landmarks;
  int                   point = 0;
  for (const DisplacementConstraint & constraint : ConstraintsOfFolds(pair, forward, matching))
  {
    const bool isMiddle = point++ % 3 == 0;
    if (!isMiddle)
    {
      const CylinderPlace at = map.Forward(constraint.place);
      landmarks.push_back(
        { constraint.place,
          { at.s + constraint.displacement.x(), at.turn + constraint.displacement.y() / pair.Around() } });
    }
  }
  return landmarks;
}

/** The ends of all folds of one position. */
struct FoldEnds
{
  std::vector<FoldLandmark>  landmarks;
  std::vector<CylinderPlace> places;
  std::vector<FeaturePoint>  points;
  /** Index among the ends near the main taenia; -1 elsewhere. */
  std::vector<int> border;

  std::vector<FoldLandmark>
  BorderLandmarks() const
  {
    std::vector<FoldLandmark> near;
    for (std::size_t i = 0; i < landmarks.size(); ++i)
    {
      if (border[i] >= 0)
      {
        near.push_back(landmarks[i]);
      }
    }
    return near;
  }
};

/** Finds the ends of folds, and where they are in their segment of the target. */
class FoldEndFinder
{
public:
  FoldEndFinder(const ColonPair & pair, const CylinderMap & start, int targetTaenia, double border)
    : m_Pair(pair), m_Start(start), m_TargetTaenia(targetTaenia), m_Border(border)
  {}

  FoldEnds
  OfSource() const
  {
    return this->Find(
      m_Pair.source.folds, *m_Pair.sourceCylinder, m_Pair.sourceTaeniae, 0, [&](const CylinderPlace & own) {
        return m_Start.Forward(own);
      });
  }
  FoldEnds
  OfTarget() const
  {
    return this->Find(
      m_Pair.target.folds, *m_Pair.targetCylinder, m_Pair.targetTaeniae, m_TargetTaenia, [](const CylinderPlace & own) {
        return own;
      });
  }

private:
  FoldEnds
  Find(const std::vector<HaustralFold> & folds,
       const ColonCylinder &             cylinder,
       const TaeniaAngles &              taeniae,
       int                               taenia,
       const PlaceMap &                  toTarget) const
  {
    FoldEnds ends;
    int      near = 0;
    for (std::size_t fold = 0; fold < folds.size(); ++fold)
    {
      for (const int end : { 0, 1 })
      {
        const CylinderPlace own = cylinder.PlaceOfUv(folds[fold].endUv[end]);
        const double        fromTaenia = std::abs(TurnDifference(own.turn, taeniae.At(taenia, own.s)));
        ends.landmarks.push_back({ static_cast<int>(fold), end });
        ends.places.push_back(own);
        ends.points.push_back(this->PointAt(toTarget(own)));
        ends.border.push_back(fromTaenia * cylinder.Around() <= m_Border ? near++ : -1);
      }
    }
    return ends;
  }

  FeaturePoint
  PointAt(const CylinderPlace & place) const
  {
    constexpr double            half = 0.5; // turns
    const std::vector<double> & borders = m_Pair.frame.to;
    const auto                  next = std::upper_bound(borders.begin() + 1, borders.end() - 1, place.s);
    const double                middle = half * (*(next - 1) + *next);
    const double turn = TurnDifference(place.turn, m_Pair.targetTaeniae.At(m_TargetTaenia, place.s) + half);
    return { place.s,
             place.turn * m_Pair.Around(),
             std::hypot(place.s - middle, turn * m_Pair.Around()),
             static_cast<int>(next - borders.begin()) };
  }

  const ColonPair &   m_Pair;
  const CylinderMap & m_Start;
  int                 m_TargetTaenia;
  double              m_Border;
};

/** Keeps the pairs of ends near the main taenia, with indices among these. */
FoldMatching
BorderPairs(const FoldMatching & all, const FoldEnds & source, const FoldEnds & target)
{
  FoldMatching matching = all;
  matching.pairs.clear();
  matching.costs.clear();
  for (std::size_t k = 0; k < all.pairs.size(); ++k)
  {
    const int i = source.border[all.pairs[k].first];
    const int j = target.border[all.pairs[k].second];
    if (i >= 0 && j >= 0)
    {
      matching.pairs.emplace_back(i, j);
      matching.costs.push_back(all.costs[k]);
    }
  }
  return matching;
}

/** Landmarks at the matched ends near the main taenia. */
std::vector<Landmark>
LandmarksOf(const FoldMatching & all, const FoldEnds & source, const FoldEnds & target)
{
  std::vector<Landmark> landmarks;
  for (const auto & [i, j] : all.pairs)
  {
    if (source.border[i] >= 0 && target.border[j] >= 0)
    {
      landmarks.push_back({ source.places[i], target.places[j] });
    }
  }
  return landmarks;
}

/** Weight of each landmark, computed from its residual as in SmoothCorrection. */
std::vector<double>
WeightsOf(const std::vector<Landmark> & landmarks, const CylinderMap & map, double around)
{
  const double        robust = SmoothCorrectionOptions().robust;
  std::vector<double> weights;
  for (const Landmark & landmark : landmarks)
  {
    const CylinderPlace mapped = map.Forward(landmark.source);
    const double        along = mapped.s - landmark.target.s;
    const double        across = TurnDifference(mapped.turn, landmark.target.turn) * around;
    weights.push_back(1.0 / (1.0 + (along * along + across * across) / (robust * robust)));
  }
  return weights;
}

/** A quasi-conformal map through all landmarks of the pair and additional ones. */
class LandmarkMapper
{
public:
  LandmarkMapper(const ColonPair & pair, const CylinderMap & frame, int targetTaenia, double greatestDilatation)
    : m_Flat(pair), m_Conditions(pair, m_Flat, targetTaenia), m_Values(m_Flat.ValuesOf(frame))
  {
    m_Options.greatest = greatestDilatation;
  }

  /** Starts from the previous map. */
  QuasiConformalMap
  Find(std::vector<Landmark> landmarks, const Progress & progress)
  {
    m_Options.progress = progress;
    m_Conditions.landmarks = std::move(landmarks);
    QuasiConformalMap map = FindQuasiConformalMap(m_Flat.Equations(), m_Values, std::cref(m_Conditions), m_Options);
    m_Values = map.values;
    return map;
  }
  const FlatPair &
  Flat() const
  {
    return m_Flat;
  }

private:
  FlatPair              m_Flat;
  PublishedConditions   m_Conditions;
  CylinderValues        m_Values;
  QuasiConformalOptions m_Options;
};
} // namespace

PublishedMap
FindPublishedMap(const ColonPair &          pair,
                 const CylinderMap &        frame,
                 const SupineProneOptions & options,
                 const Progress &           progress)
{
  if (!pair.AreTaeniaeKnown())
  {
    throw InputError("the published map needs the taeniae of both positions; use the default map");
  }
  const int               main = MainTaeniaOfTarget(pair, frame);
  LandmarkMapper          mapper(pair, frame, main, options.greatestDilatation);
  const CylinderMap       start(mapper.Flat().NodesOf(mapper.Find({}, progress.Part("", 0.0, 0.5)).values));
  const FoldEndFinder     finder(pair, start, main, options.border);
  const FoldEnds          source = finder.OfSource();
  const FoldEnds          target = finder.OfTarget();
  const FoldMatching      all = MatchFeaturePoints(source.points, target.points, pair.Around(), options.distanceWeight);
  const auto              landmarks = LandmarksOf(all, source, target);
  const QuasiConformalMap map = mapper.Find(landmarks, progress.Part("", 0.5, 1.0));
  PublishedMap            published;
  published.map = CylinderMap(mapper.Flat().NodesOf(map.values));
  published.sourceLandmarks = source.BorderLandmarks();
  published.targetLandmarks = target.BorderLandmarks();
  published.matching = BorderPairs(all, source, target);
  published.pairWeights = WeightsOf(landmarks, published.map, pair.Around());
  published.greatestDilatation = map.greatest;
  published.solves = map.solves;
  published.greatestMiss = map.greatestMiss;
  return published;
}

CylinderMap
QuasiConformalMapThrough(const ColonPair &    wholePair,
                         const CylinderMap &  start,
                         const FoldMatching & matching,
                         double               greatestDilatation)
{
  ColonPair pair = wholePair;
  pair.frame = EndFrame(pair.frame);
  pair.sourceTaeniae.isKnown = false;
  LandmarkMapper mapper(pair, start, 0, greatestDilatation);
  return CylinderMap(mapper.Flat().NodesOf(mapper.Find(LandmarksOf(pair, start, matching), {}).values));
}
} // namespace shapeton
