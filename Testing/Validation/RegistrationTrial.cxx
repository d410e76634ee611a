#include "RegistrationTrial.h"

#include "Tables.h"
#include "Times.h"

#include "shapetonColonLandmarks.h"
#include "shapetonColonTaeniae.h"
#include "shapetonExceptions.h"

#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
/** Positions along the centerline (mm) of the borders between true segments. */
std::array<double, 4>
TrueFlexures(const LandmarkExam & exam)
{
  const CurveSet        truth = exam.anatomy->Centerline();
  const Eigen::VectorXd segment = PointValues(truth, "segment", "the truth");
  const Eigen::VectorXd arcLength = PointValues(exam.centerline, "arcLength", "the centerline");
  std::array<double, 4> flexures;
  flexures.fill(std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index i = 1; i < segment.size(); ++i)
  {
    const int flexure = static_cast<int>(segment[i]) - 2;
    if (segment[i] != segment[i - 1] && flexure >= 0 && flexure < 4)
    {
      Eigen::Index nearest = 0;
      (exam.centerline.V.rowwise() - truth.V.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
      flexures[flexure] = arcLength[nearest];
    }
  }
  return flexures;
}

void
AddFoundLandmarks(const LandmarkExam & exam, ColonPosition & position, TaeniaNames * names)
{
  const ColonLandmarks landmarks = FindColonLandmarks(*position.flat, exam.centerline);
  if (names != nullptr)
  {
    *names = landmarks.taeniaNames;
  }
  position.taeniae = TaeniaCurves(landmarks.taeniae);
  for (std::size_t k = 0; k < landmarks.flexures.flexures.size(); ++k)
  {
    const ColonFlexure & flexure = landmarks.flexures.flexures[k];
    if (flexure.isFound)
    {
      position.flexures[k] = flexure.arcLength;
      position.flexureConfidence[k] = flexure.confidence;
    }
  }
}

/** True folds of a phantom, to identify detected ones. */
class TrueFolds
{
public:
  explicit TrueFolds(const ColonAnatomy & anatomy)
    : m_Folds(anatomy.Folds()), m_Height(PointValues(m_Folds, "crestHeight", "the truth"))
  {}

  /** Index of the fold with the nearest crest (at least 1 mm above the wall) within 6 mm; -1 if there is
   * none. */
  int
  NearestTo(const Eigen::Vector3d & point) const
  {
    constexpr double reach = 6.0; // mm
    double           least = reach * reach;
    int              nearest = -1;
    for (std::size_t f = 0; f < m_Folds.curves.size(); ++f)
    {
      for (const int vertex : m_Folds.curves[f])
      {
        const double square = (m_Folds.V.row(vertex).transpose() - point).squaredNorm();
        if (m_Height[vertex] >= 1.0 && square < least)
        {
          least = square;
          nearest = static_cast<int>(f);
        }
      }
    }
    return nearest;
  }
  /** Number of the fold, identical in all positions of one patient. */
  int
  NumberOf(int index) const
  {
    return this->ValueOf("fold", index);
  }
  /** Colon segment, 1 to 6, of the fold with this number. */
  int
  SegmentOf(int number) const
  {
    for (int index = 0; index < static_cast<int>(m_Folds.curves.size()); ++index)
    {
      if (this->NumberOf(index) == number)
      {
        return this->ValueOf("segment", index);
      }
    }
    return 0;
  }

private:
  int
  ValueOf(const char * name, int index) const
  {
    return static_cast<int>(std::lround(FindSurfaceArray(m_Folds.cellArrays, name)->values(index, 0)));
  }

  CurveSet        m_Folds;
  Eigen::VectorXd m_Height;
};

/** A position with the true number of each detected fold (-1 for false positives), and whether it is visible. */
struct KnownFolds
{
  KnownFolds(const ColonPosition & one, const ColonAnatomy & anatomy) : position(one), truth(anatomy)
  {
    for (const HaustralFold & fold : position.folds)
    {
      const int index = truth.NearestTo(fold.center);
      number.push_back(index >= 0 ? truth.NumberOf(index) : -1);
      isSeen.push_back(position.isExcluded.empty() ||
                       !position.isExcluded[position.flat->Grid().PixelOfUv(fold.centerUv).column]);
    }
  }

  const ColonPosition & position;
  TrueFolds             truth;
  std::vector<int>      number;
  std::vector<char>     isSeen;
};

/** Adds to the row of a true fold and to that of the whole colon. */
void
AddPoints(const KnownFolds & folds, int fold, const FeaturePointCounts & counts, FeaturePointTable & table)
{
  const int segment = folds.number[fold] >= 0 ? folds.truth.SegmentOf(folds.number[fold]) : 0;
  table[0].Add(counts);
  if (segment > 0)
  {
    table[segment].Add(counts);
  }
}

/** Whether both landmarks are whole folds or ends on the same side of their fold. */
bool
AreOnOneSide(const KnownFolds &              source,
             const KnownFolds &              target,
             const FoldMatch &               match,
             const SupineProneRegistration & registration)
{
  const auto side = [](const ColonCylinder & cylinder, const KnownFolds & folds, const FoldLandmark & landmark) {
    const double center = cylinder.PlaceOfUv(folds.position.folds[landmark.fold].centerUv).turn;
    return TurnDifference(cylinder.PlaceOfUv(landmark.Uv(folds.position.folds)).turn, center) > 0.0;
  };
  return match.source.end < 0 ||
         side(*registration.source, source, match.source) == side(*registration.target, target, match.target);
}

/** Counts the ends of visible folds, and those that are matched; a fold is counted as two ends. */
FeaturePointTable
CountPoints(const KnownFolds & source, const KnownFolds & target, const SupineProneRegistration & registration)
{
  FeaturePointTable table;
  const auto        endsOf = [](const FoldLandmark & landmark) { return landmark.end < 0 ? 2 : 1; };
  for (const FoldLandmark & landmark : registration.sourceLandmarks)
  {
    AddPoints(source, landmark.fold, { source.isSeen[landmark.fold] ? endsOf(landmark) : 0, 0, 0, 0 }, table);
  }
  for (const FoldLandmark & landmark : registration.targetLandmarks)
  {
    AddPoints(target, landmark.fold, { 0, target.isSeen[landmark.fold] ? endsOf(landmark) : 0, 0, 0 }, table);
  }
  for (const FoldMatch & match : registration.matches)
  {
    const int from = match.source.fold;
    const int to = match.target.fold;
    if (source.isSeen[from] && target.isSeen[to])
    {
      const bool isRight = source.number[from] >= 0 && source.number[from] == target.number[to] &&
                           AreOnOneSide(source, target, match, registration);
      const int ends = endsOf(match.source);
      AddPoints(source, from, { 0, 0, isRight ? ends : 0, isRight ? 0 : ends }, table);
    }
  }
  return table;
}

/** Number of visible folds of the source that are also seen in the target. */
int
CommonFolds(const KnownFolds & source, const KnownFolds & target)
{
  std::map<int, int> seenInTarget;
  for (std::size_t j = 0; j < target.number.size(); ++j)
  {
    seenInTarget[target.number[j]] += target.isSeen[j];
  }
  int common = 0;
  for (std::size_t i = 0; i < source.number.size(); ++i)
  {
    common += source.isSeen[i] && source.number[i] >= 0 && seenInTarget[source.number[i]] > 0;
  }
  return common;
}

void
MeasureMatches(const KnownFolds &              source,
               const KnownFolds &              target,
               const SupineProneRegistration & registration,
               RegistrationScore &             score)
{
  score.points = CountPoints(source, target, registration);
  score.right = score.points[0].correct / 2;
  score.pairs = score.right + score.points[0].wrong / 2;
  score.common = CommonFolds(source, target);
}

/** The true taenia (0 to 2) at each point of the found ones; -1 in the rectum, which has none. */
class KnownTaeniae
{
public:
  KnownTaeniae(const CurveSet & found, const ColonAnatomy & anatomy)
    : m_Arc(PointValues(found, "arcLength", "the taeniae")), m_Curves(found.curves), m_True(found.V.rows())
  {
    const CurveSet truth = anatomy.Taeniae();
    m_Names = FindSurfaceArray(truth.cellArrays, "name")->values;
    for (Eigen::Index point = 0; point < found.V.rows(); ++point)
    {
      constexpr double reach = 30.0; // mm; taeniae are at most 25 mm from one of the true ones
      double           least = reach * reach;
      m_True[point] = -1;
      for (std::size_t curve = 0; curve < truth.curves.size(); ++curve)
      {
        for (const int vertex : truth.curves[curve])
        {
          const double square = (truth.V.row(vertex) - found.V.row(point)).squaredNorm();
          m_True[point] = square < least ? static_cast<int>(curve) : m_True[point];
          least = std::min(least, square);
        }
      }
    }
  }

  const std::vector<int> &
  PointsOf(int curve) const
  {
    return m_Curves[curve];
  }
  double
  ArcOf(int point) const
  {
    return m_Arc[point];
  }
  int
  TrueAt(int point) const
  {
    return m_True[point];
  }
  int
  TrueAt(int curve, double s) const
  {
    const std::vector<int> & points = m_Curves[curve];
    return m_True[*std::min_element(
      points.begin(), points.end(), [&](int a, int b) { return std::abs(m_Arc[a] - s) < std::abs(m_Arc[b] - s); })];
  }
  /** Along most of the curve. */
  int
  TrueOf(int curve) const
  {
    std::array<int, 3> points{};
    for (const int point : m_Curves[curve])
    {
      points[std::max(m_True[point], 0)] += m_True[point] >= 0;
    }
    return static_cast<int>(std::max_element(points.begin(), points.end()) - points.begin());
  }

  /** The true name along most of the curve. */
  TaeniaName
  NameOf(int curve) const
  {
    return static_cast<TaeniaName>(std::lround(m_Names(this->TrueOf(curve), 0)));
  }

private:
  Eigen::VectorXd               m_Arc;
  std::vector<std::vector<int>> m_Curves;
  std::vector<int>              m_True;
  SurfaceArray::ValueMatrix     m_Names;
};

TaeniaNameScore
ScoreOfNames(const TaeniaNames & names, const KnownTaeniae & truth)
{
  TaeniaNameScore score{ names.AreKnown(), names.AreKnown(), names.reason };
  for (int curve = 0; names.AreKnown() && curve < 3; ++curve)
  {
    score.areRight = score.areRight && names.names[curve] == truth.NameOf(curve);
  }
  return score;
}

TaeniaScore
ScoreOfTaeniae(const KnownTaeniae & source, const KnownTaeniae & target, const SupineProneRegistration & registration)
{
  const CommonTaeniae & common = registration.taeniae;
  TaeniaScore           score{ common.AreKnown(), common.AreKnown(), common.probability, 0.0 };
  int                   same = 0;
  int                   all = 0;
  for (int curve = 0; common.AreKnown() && curve < 3; ++curve)
  {
    score.areRight = score.areRight && source.TrueOf(curve) == target.TrueOf(common.target[curve]);
    for (const int point : source.PointsOf(curve))
    {
      const CylinderPlace place{ source.ArcOf(point), 0.0 };
      if (source.TrueAt(point) >= 0 && !IsExcludedAt(registration, place))
      {
        same += source.TrueAt(point) == target.TrueAt(common.target[curve], registration.map.Forward(place).s);
        ++all;
      }
    }
  }
  score.share = ShareOf(same, all);
  return score;
}

Reliability
ReliabilityOf(const std::vector<PointError> & errors)
{
  Reliability reliability(LocalClasses);
  for (const PointError & error : errors)
  {
    if (error.kind == PointError::Kind::Counted)
    {
      reliability.Add(error.confidence, error.inSpace <= ConfidentDistance);
    }
  }
  return reliability;
}

void
CompareSchemes(const KnownFolds &              source,
               const KnownFolds &              target,
               const SupineProneRegistration & registration,
               const std::vector<PointPair> &  pairs,
               RegistrationScore &             score)
{
  const std::pair<RegistrationScheme, const char *> schemes[] = {
    { RegistrationScheme::Rectangles, "1 flat rectangles stretched, one rotation" },
    { RegistrationScheme::Centerline, "2 centerlines, one rotation" },
    { RegistrationScheme::Landmarks, "3 flexures and taeniae" },
    { RegistrationScheme::Warping, "4 cylindrical warping" },
    { RegistrationScheme::QuasiConformal, "7 quasi-conformal through the matched folds" }
  };
  for (const auto & [scheme, name] : schemes)
  {
    const CylinderMap map = MapOfScheme(scheme, source.position, target.position, registration);
    score.schemes[name] = { SummaryOf(ErrorsOfPoints(registration, map, pairs)), map.Flips() };
  }
  score.schemes["5 cylindrical warping with folds, robust (the result)"] = { score.errors, score.flips };
  SupineProneSettings options;
  options.map = SupineProneMap::Published;
  const SupineProneRegistration published = RegisterColonPositions(source.position, target.position, options);
  score.publishedPoints = CountPoints(source, target, published);
  score.schemes["6 published: quasi-conformal through flexures, a taenia and ends of folds near it"] = {
    SummaryOf(ErrorsOfPoints(published, published.map, pairs)), published.figures.flips
  };
}
} // namespace

void
FeaturePointCounts::Add(const FeaturePointCounts & other)
{
  source += other.source;
  target += other.target;
  correct += other.correct;
  wrong += other.wrong;
}

std::vector<PointPair>
TruePairs(const ColonAnatomy & source, const ColonAnatomy & target)
{
  const CurveSet        a = source.Correspondence();
  const CurveSet        b = target.Correspondence();
  const Eigen::VectorXd idOfA = PointValues(a, "materialId", "the truth");
  const Eigen::VectorXd idOfB = PointValues(b, "materialId", "the truth");
  const Eigen::VectorXd collapsedA = PointValues(a, "collapsed", "the truth");
  const Eigen::VectorXd collapsedB = PointValues(b, "collapsed", "the truth");
  std::map<long, int>   rowOfId;
  for (Eigen::Index i = 0; i < idOfB.size(); ++i)
  {
    rowOfId[std::lround(idOfB[i])] = static_cast<int>(i);
  }
  std::vector<PointPair> pairs;
  for (Eigen::Index i = 0; i < idOfA.size(); ++i)
  {
    const auto found = rowOfId.find(std::lround(idOfA[i]));
    if (found != rowOfId.end() && collapsedA[i] == 0.0 && collapsedB[found->second] == 0.0)
    {
      pairs.push_back({ a.V.row(i), b.V.row(found->second) });
    }
  }
  return pairs;
}

ColonPosition
MakeColonPosition(const LandmarkExam & exam, const std::string & name, bool hasTrueLandmarks, TaeniaNames * names)
{
  ColonPosition position;
  position.name = name;
  position.flat = std::make_shared<FlatColon>(exam.flat);
  position.centerline = exam.centerline;
  position.isExcluded = FindExcludedColumns(*position.flat, position.centerline);
  position.folds = FindHaustralFolds(*position.flat).folds;
  if (hasTrueLandmarks)
  {
    position.taeniae = exam.anatomy->Taeniae();
    position.flexures = TrueFlexures(exam);
  }
  else
  {
    AddFoundLandmarks(exam, position, names);
  }
  return position;
}

RegistrationScore
TryRegistration(const LandmarkExam & first, const LandmarkExam & second, bool hasTrueLandmarks, bool comparesSchemes)
{
  RegistrationScore score;
  try
  {
    std::array<TaeniaNames, 2> names;
    const ColonPosition        source = MakeColonPosition(first, "the first position", hasTrueLandmarks, &names[0]);
    const ColonPosition        target = MakeColonPosition(second, "the second position", hasTrueLandmarks, &names[1]);
    const Stopwatch            watch;
    const SupineProneRegistration registration = RegisterColonPositions(source, target);
    score.seconds = watch.Seconds();
    const std::vector<PointPair>  pairs = TruePairs(*first.anatomy, *second.anatomy);
    const std::vector<PointError> errors = ErrorsOfPoints(registration, registration.map, pairs);
    score.errors = SummaryOf(errors);
    score.local = ReliabilityOf(errors);
    score.frame = MeasureRegistrationErrors(registration, pairs, true);
    score.flips = registration.figures.flips;
    score.isFlagged = registration.confidence.isFlagged;
    score.confidence = registration.confidence.whole;
    const KnownFolds ofSource(source, *first.anatomy);
    const KnownFolds ofTarget(target, *second.anatomy);
    MeasureMatches(ofSource, ofTarget, registration, score);
    const KnownTaeniae ofFirst(source.taeniae, *first.anatomy);
    const KnownTaeniae ofSecond(target.taeniae, *second.anatomy);
    score.taeniae = ScoreOfTaeniae(ofFirst, ofSecond, registration);
    score.names = { ScoreOfNames(names[0], ofFirst), ScoreOfNames(names[1], ofSecond) };
    if (comparesSchemes)
    {
      CompareSchemes(ofSource, ofTarget, registration, pairs, score);
    }
  }
  catch (const Exception & error)
  {
    score.failure = error.what();
  }
  return score;
}

bool
AreToldApart(const LandmarkExam & first, const LandmarkExam & second)
{
  try
  {
    return RegisterColonPositions(MakeColonPosition(first, "the first patient", false),
                                  MakeColonPosition(second, "the second patient", false))
      .confidence.isFlagged;
  }
  catch (const Exception &)
  {
    return true;
  }
}
