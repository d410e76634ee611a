#include "shapetonPublishedMap.h"

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

/** Constraints on a map from landmarks. */
class PublishedConditions
{
public:
  PublishedConditions(const ColonPair & pair, const FlatPair & flat, const CylinderMap & frame)
    : m_Pair(pair), m_Flat(flat), m_TargetTaenia(MainTaeniaOfTarget(pair, frame))
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
  /** The target taenia nearest to the first (best supported) source taenia. */
  static int
  MainTaeniaOfTarget(const ColonPair & pair, const CylinderMap & frame)
  {
    constexpr double      step = 10.0; // mm; chosen: taeniae are smooth
    std::array<double, 3> away{};
    for (double s = pair.sourceCylinder->Begin(); pair.AreTaeniaeKnown() && s < pair.sourceCylinder->End(); s += step)
    {
      const CylinderPlace at = frame.Forward({ s, pair.sourceTaeniae.At(0, s) });
      for (int taenia = 0; taenia < 3; ++taenia)
      {
        away[taenia] += std::abs(TurnDifference(pair.targetTaeniae.At(taenia, at.s), at.turn));
      }
    }
    return static_cast<int>(std::min_element(away.begin(), away.end()) - away.begin());
  }

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

/** The pair with fold matching restricted to segments. */
ColonPair
SegmentWise(ColonPair pair)
{
  pair.breaks.assign(pair.frame.from.begin() + 1, pair.frame.from.end() - 1);
  return pair;
}

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

/** Weight of the center of each pair, computed from its residual as in SmoothCorrection. */
std::vector<double>
PairWeights(const ColonPair & pair, const CylinderMap & map, const FoldMatching & matching)
{
  const double        robust = SmoothCorrectionOptions().robust;
  const PlaceMap      forward = [&](const CylinderPlace & place) { return map.Forward(place); };
  const auto          constraints = ConstraintsOfFolds(pair, forward, matching);
  std::vector<double> weights;
  for (std::size_t i = 0; i < constraints.size(); i += 3)
  {
    weights.push_back(1.0 / (1.0 + constraints[i].displacement.squaredNorm() / (robust * robust)));
  }
  return weights;
}

/** A quasi-conformal map through all landmarks of the pair and additional ones. */
class LandmarkMapper
{
public:
  LandmarkMapper(const ColonPair & pair, const CylinderMap & frame, double greatestDilatation)
    : m_Flat(pair), m_Conditions(pair, m_Flat, frame), m_Values(m_Flat.ValuesOf(frame))
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
FindPublishedMap(const ColonPair &   wholePair,
                 const CylinderMap & frame,
                 FoldMatchingMethod  method,
                 double              greatestDilatation,
                 const Progress &    progress)
{
  const ColonPair   pair = SegmentWise(wholePair);
  LandmarkMapper    mapper(pair, frame, greatestDilatation);
  const CylinderMap start(mapper.Flat().NodesOf(mapper.Find({}, progress.Part("", 0.0, 0.5)).values));
  PublishedMap      published;
  published.matching = MatchFoldsAbout(
    pair, [&](const CylinderPlace & place) { return start.Forward(place); }, method);
  const QuasiConformalMap map = mapper.Find(LandmarksOf(pair, start, published.matching), progress.Part("", 0.5, 1.0));
  published.map = CylinderMap(mapper.Flat().NodesOf(map.values));
  published.pairWeights = PairWeights(pair, published.map, published.matching);
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
  LandmarkMapper mapper(pair, start, greatestDilatation);
  return CylinderMap(mapper.Flat().NodesOf(mapper.Find(LandmarksOf(pair, start, matching), {}).values));
}
} // namespace shapeton
