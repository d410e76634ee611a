#include "RegistrationTrial.h"

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
AddFoundLandmarks(const LandmarkExam & exam, ColonPosition & position)
{
  const ColonLandmarks landmarks = FindColonLandmarks(*position.flat, exam.centerline);
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

bool
IsBorderPoint(const FlatColonGrid & grid, const Eigen::Vector2d & uv)
{
  constexpr double close = 15.0; // mm
  return std::min(uv.y(), grid.Circumference() - uv.y()) <= close;
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

/** Sets `outcome` of each fold of the source. */
void
CountPoints(const ColonPosition &                   source,
            const TrueFolds &                       truth,
            const std::vector<int> &                foldOf,
            const std::vector<FeaturePointCounts> & outcome,
            RegistrationScore &                     score)
{
  for (std::size_t i = 0; i < source.folds.size(); ++i)
  {
    const int segment = foldOf[i] >= 0 ? truth.SegmentOf(foldOf[i]) : 0;
    for (const Eigen::Vector2d & uv : source.folds[i].endUv)
    {
      for (const int row : { 0, segment })
      {
        score.allPoints[row].Add(outcome[i]);
        if (IsBorderPoint(source.flat->Grid(), uv))
        {
          score.borderPoints[row].Add(outcome[i]);
        }
        if (segment == 0)
        {
          break;
        }
      }
    }
  }
}

bool
IsSeen(const ColonPosition & position, const HaustralFold & fold)
{
  return position.isExcluded.empty() || !position.isExcluded[position.flat->Grid().PixelOfUv(fold.centerUv).column];
}

/** True fold of each detected one; -1 for false positives. */
std::vector<int>
FoldsSeen(const ColonPosition & position, const TrueFolds & truth, std::vector<char> & isSeen)
{
  std::vector<int> folds;
  for (const HaustralFold & fold : position.folds)
  {
    const int index = truth.NearestTo(fold.center);
    folds.push_back(index >= 0 ? truth.NumberOf(index) : -1);
    isSeen.push_back(IsSeen(position, fold) ? 1 : 0);
  }
  return folds;
}

void
MeasureMatches(const ColonPosition &           source,
               const ColonPosition &           target,
               const TrueFolds &               sourceTruth,
               const TrueFolds &               targetTruth,
               const SupineProneRegistration & registration,
               RegistrationScore &             score)
{
  std::vector<char>      isSourceSeen;
  std::vector<char>      isTargetSeen;
  const std::vector<int> ofSource = FoldsSeen(source, sourceTruth, isSourceSeen);
  const std::vector<int> ofTarget = FoldsSeen(target, targetTruth, isTargetSeen);
  std::map<int, int>     seenInTarget;
  for (std::size_t j = 0; j < ofTarget.size(); ++j)
  {
    seenInTarget[ofTarget[j]] += isTargetSeen[j];
  }
  std::vector<FeaturePointCounts> outcome(source.folds.size());
  for (std::size_t i = 0; i < ofSource.size(); ++i)
  {
    outcome[i].unmatched = isSourceSeen[i];
    score.common += isSourceSeen[i] && ofSource[i] >= 0 && seenInTarget[ofSource[i]] > 0;
  }
  for (const FoldMatch & match : registration.matches)
  {
    if (isSourceSeen[match.source] && isTargetSeen[match.target])
    {
      const bool isRight = ofSource[match.source] >= 0 && ofSource[match.source] == ofTarget[match.target];
      outcome[match.source] = { isRight ? 1 : 0, isRight ? 0 : 1, 0 };
      score.right += isRight;
      ++score.pairs;
    }
  }
  CountPoints(source, sourceTruth, ofSource, outcome, score);
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
CompareSchemes(const ColonPosition &           source,
               const ColonPosition &           target,
               const SupineProneRegistration & registration,
               const std::vector<PointPair> &  pairs,
               RegistrationScore &             score)
{
  const std::pair<RegistrationScheme, const char *> schemes[] = {
    { RegistrationScheme::Rectangles, "1 flat rectangles stretched, one rotation" },
    { RegistrationScheme::Centerline, "2 centerlines, one rotation" },
    { RegistrationScheme::Landmarks, "3 flexures and taeniae" },
    { RegistrationScheme::Warping, "4 cylindrical warping" },
    { RegistrationScheme::Published, "6 published: quasi-conformal through flexures, a taenia and folds" },
    { RegistrationScheme::QuasiConformal, "7 quasi-conformal through the matched folds" }
  };
  for (const auto & [scheme, name] : schemes)
  {
    const CylinderMap map = MapOfScheme(scheme, source, target, registration);
    score.schemes[name] = { SummaryOf(ErrorsOfPoints(registration, map, pairs)), map.Flips() };
  }
  score.schemes["5 cylindrical warping with folds, robust (the result)"] = { score.errors, score.flips };
}
} // namespace

void
FeaturePointCounts::Add(const FeaturePointCounts & other)
{
  correct += other.correct;
  wrong += other.wrong;
  unmatched += other.unmatched;
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
MakeColonPosition(const LandmarkExam & exam, const std::string & name, bool hasTrueLandmarks)
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
    AddFoundLandmarks(exam, position);
  }
  return position;
}

RegistrationScore
TryRegistration(const LandmarkExam & first, const LandmarkExam & second, bool hasTrueLandmarks, bool comparesSchemes)
{
  RegistrationScore score;
  try
  {
    const ColonPosition           source = MakeColonPosition(first, "the first position", hasTrueLandmarks);
    const ColonPosition           target = MakeColonPosition(second, "the second position", hasTrueLandmarks);
    const Stopwatch               watch;
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
    MeasureMatches(source, target, TrueFolds(*first.anatomy), TrueFolds(*second.anatomy), registration, score);
    if (comparesSchemes)
    {
      CompareSchemes(source, target, registration, pairs, score);
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
