#include "shapetonRegistrationResults.h"

#include "shapetonColonPointMapper.h"
#include "shapetonFoldTruth.h"
#include "shapetonIleocecalValve.h"
#include "shapetonJson.h"
#include "shapetonParallelFor.h"
#include "shapetonRegistrationDocument.h"

#include <algorithm>
#include <array>
#include <limits>

namespace shapeton
{
namespace
{
SurfaceArray &
AddArray(SurfaceMesh & surface, const std::string & name, int columns, bool areIntegers = false)
{
  surface.pointArrays.push_back({ name, SurfaceArray::ValueMatrix(surface.V.rows(), columns), areIntegers });
  return surface.pointArrays.back();
}

/** The surface `flat` with the corresponding point of the other position at each vertex. */
template <typename TMap>
SurfaceMesh
MappedSurface(const SurfaceMesh & flat, const TMap & map, const Progress & progress)
{
  SurfaceMesh surface = flat;
  surface.facts.clear();
  const SurfaceArray::ValueMatrix uv = FindSurfaceArray(flat.pointArrays, "uv")->values;
  constexpr int                   newArrays = 5; // their addresses are kept
  surface.pointArrays.reserve(surface.pointArrays.size() + newArrays);
  SurfaceArray & mapped = AddArray(surface, "mapped", 3);
  SurfaceArray & mappedUv = AddArray(surface, "mappedUv", 2);
  SurfaceArray & displacement = AddArray(surface, "displacement", 3);
  SurfaceArray & confidence = AddArray(surface, "confidence", 1);
  SurfaceArray & excluded = AddArray(surface, "excluded", 1, true);
  const auto     mapVertex = [&](std::size_t i) {
    const auto        row = static_cast<Eigen::Index>(i);
    const MappedPoint to = map(uv.row(row).transpose());
    mapped.values.row(row) = to.point;
    mappedUv.values.row(row) = to.uv;
    displacement.values.row(row) = to.point.transpose() - flat.V.row(row);
    confidence.values(row, 0) = to.confidence;
    excluded.values(row, 0) = to.isExcluded;
  };
  ParallelFor(static_cast<std::size_t>(flat.V.rows()), mapVertex, progress);
  return surface;
}

/** Name of the segment; "" outside all. */
std::string
SegmentAt(const std::vector<ColonSegmentExtent> & segments, double arcLength)
{
  const ColonSegmentExtent * const segment = FindSegment(segments, arcLength);
  return segment != nullptr ? segment->name : "";
}

/** Fraction of the columns of the flat map that are excluded. */
Json
ExcludedShare(const ColonPosition & position)
{
  const auto excluded = std::count(position.isExcluded.begin(), position.isExcluded.end(), 1);
  return RoundedJson(static_cast<double>(excluded) / position.flat->Grid().Columns());
}

/** Places a valve that only one position shows in the other one, unless its place is not visible there. */
void
TransferValve(const IleocecalValve & valve, const MappedPoint & to, const CurveSet & otherLine, ValveSearch & other)
{
  if (to.isExcluded)
  {
    return;
  }
  IleocecalValve mapped = valve;
  Eigen::Index   nearest = 0;
  mapped.position = to.point;
  mapped.confidence *= to.confidence;
  mapped.attenuation = std::numeric_limits<double>::quiet_NaN();
  (otherLine.V.rowwise() - to.point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  mapped.arcLength = PointValues(otherLine, "arcLength", "the centerline")[nearest];
  other.valve = mapped;
  other.reason.clear();
}

class Telling
{
public:
  Telling(const ColonPositionFiles &      supine,
          const ColonPositionFiles &      prone,
          const SupineProneRegistration & registration,
          const std::vector<PointPair> &  truth)
    : m_Supine(supine)
    , m_Prone(prone)
    , m_Registration(registration)
    , m_Verdicts(FoldTruth(supine, prone, registration, truth).Judge(registration.matches))
  {
    m_Results.points = truth;
  }

  RegistrationResults
  Run(const Progress & progress)
  {
    const ColonPointMapper mapper(m_Registration);
    progress(0.1);
    m_Results.supineToProne = MappedSurface(
      m_Supine.position.flat->Surface(),
      [&](const Eigen::Vector2d & uv) { return mapper.ForwardUv(uv); },
      progress.Part("", 0.1, 0.5));
    m_Results.proneToSupine = MappedSurface(
      m_Prone.position.flat->Surface(),
      [&](const Eigen::Vector2d & uv) { return mapper.InverseUv(uv); },
      progress.Part("", 0.5, 1.0));
    this->TellMatches();
    this->CountSegments();
    RegistrationErrors frame;
    if (!m_Results.points.empty())
    {
      m_Results.errors = ErrorsOfPoints(m_Registration, m_Registration.map, m_Results.points);
      frame = MeasureRegistrationErrors(m_Registration, m_Results.points, true);
    }
    m_Results.document = DocumentOf(m_Registration, m_Results, frame);
    const auto valve = this->FindValve(mapper);
    m_Results.document["ileocecalValve"] = { { "supine", ValveToJson(valve[0]) }, { "prone", ValveToJson(valve[1]) } };
    m_Results.document["map"]["excludedShareOfSupine"] = ExcludedShare(m_Supine.position);
    m_Results.document["map"]["excludedShareOfProne"] = ExcludedShare(m_Prone.position);
    return std::move(m_Results);
  }

private:
  /** The valve in the supine and in the prone position. Where only one of them shows it, the other has it at the mapped
   * place. */
  std::array<ValveSearch, 2>
  FindValve(const ColonPointMapper & mapper) const
  {
    const CurveSet &             supineLine = m_Supine.position.centerline;
    const CurveSet &             proneLine = m_Prone.position.centerline;
    const auto                   supine = ValveCandidatesOf(supineLine);
    std::vector<Eigen::Vector3d> inProne;
    for (const IleocecalValve & candidate : supine)
    {
      inProne.push_back(mapper.Forward(candidate.position).point);
    }
    auto found = FindValveInBoth(supine, ValveCandidatesOf(proneLine), inProne);
    if (found[0].valve && !found[1].valve)
    {
      TransferValve(*found[0].valve, mapper.Forward(found[0].valve->position), proneLine, found[1]);
    }
    else if (found[1].valve && !found[0].valve)
    {
      TransferValve(*found[1].valve, mapper.Inverse(found[1].valve->position), supineLine, found[0]);
    }
    return found;
  }

  double
  SupineArc(const FoldLandmark & landmark) const
  {
    return m_Registration.source->PlaceOfUv(landmark.Uv(m_Supine.position.folds)).s;
  }

  double
  ProneArc(const FoldLandmark & landmark) const
  {
    return m_Registration.target->PlaceOfUv(landmark.Uv(m_Prone.position.folds)).s;
  }

  void
  TellMatches()
  {
    const std::vector<HaustralFold> & supine = m_Supine.position.folds;
    const std::vector<HaustralFold> & prone = m_Prone.position.folds;
    for (const FoldMatch & match : m_Registration.matches)
    {
      MatchedFolds row;
      row.supineFold = supine[match.source.fold].label;
      row.proneFold = prone[match.target.fold].label;
      row.supinePoint = match.source.Point(supine);
      row.pronePoint = match.target.Point(prone);
      row.supineArcLength = this->SupineArc(match.source);
      row.proneArcLength = this->ProneArc(match.target);
      row.segment = SegmentAt(m_Supine.segments, row.supineArcLength);
      row.cost = match.cost;
      row.residual = match.residual;
      row.weight = match.weight;
      row.verdict = m_Verdicts[IndexOf(m_Registration.sourceLandmarks, match.source)];
      m_Results.matches.push_back(row);
    }
  }

  /** The row of a segment; "" for unknown segments. */
  SegmentMatches &
  RowOf(const std::string & segment)
  {
    const auto found = std::find_if(m_Results.segments.begin(),
                                    m_Results.segments.end(),
                                    [&](const SegmentMatches & row) { return row.segment == segment; });
    if (found != m_Results.segments.end())
    {
      return *found;
    }
    m_Results.segments.emplace_back();
    m_Results.segments.back().segment = segment;
    return m_Results.segments.back();
  }

  void
  CountSegments()
  {
    for (const ColonSegmentExtent & segment : m_Supine.segments)
    {
      this->RowOf(segment.name);
    }
    for (std::size_t i = 0; i < m_Verdicts.size(); ++i)
    {
      const FoldLandmark & landmark = m_Registration.sourceLandmarks[i];
      SegmentMatches &     row = this->RowOf(SegmentAt(m_Supine.segments, this->SupineArc(landmark)));
      ++row.supineFolds;
      row.correct += m_Verdicts[i] == FoldVerdict::Correct;
      row.wrong += m_Verdicts[i] == FoldVerdict::Wrong;
      row.unmatched += m_Verdicts[i] == FoldVerdict::Unmatched;
    }
    for (const MatchedFolds & match : m_Results.matches)
    {
      SegmentMatches & row = this->RowOf(match.segment);
      (match.IsFollowed() ? row.followed : row.contradicted) += 1;
    }
    this->CountProne();
    for (SegmentMatches & row : m_Results.segments)
    {
      row.supineAlone = row.supineFolds - row.followed - row.contradicted;
      row.confidence = this->ConfidenceOf(row.segment);
    }
  }

  void
  CountProne()
  {
    const std::vector<FoldLandmark> & landmarks = m_Registration.targetLandmarks;
    std::vector<char>                 isMatched(landmarks.size(), 0);
    for (const FoldMatch & match : m_Registration.matches)
    {
      isMatched[IndexOf(landmarks, match.target)] = 1;
    }
    for (std::size_t j = 0; j < landmarks.size(); ++j)
    {
      SegmentMatches & row = this->RowOf(SegmentAt(m_Prone.segments, this->ProneArc(landmarks[j])));
      ++row.proneFolds;
      row.proneAlone += !isMatched[j];
    }
  }

  double
  ConfidenceOf(const std::string & segment) const
  {
    const CylinderNodes & nodes = m_Registration.map.Nodes();
    double                sum = 0.0;
    int                   number = 0;
    for (int i = 0; i < nodes.Rows(); ++i)
    {
      const bool isWithin = SegmentAt(m_Supine.segments, nodes.begin + i * nodes.step) == segment;
      for (int j = 0; isWithin && j < nodes.Angles(); ++j)
      {
        if (!m_Registration.isExcluded(i, j))
        {
          sum += m_Registration.confidence.ofNodes(i, j);
          ++number;
        }
      }
    }
    return sum / number; // NaN if no part is visible
  }

  const ColonPositionFiles &      m_Supine;
  const ColonPositionFiles &      m_Prone;
  const SupineProneRegistration & m_Registration;
  std::vector<FoldVerdict>        m_Verdicts; ///< verdicts of the supine landmarks
  RegistrationResults             m_Results;
};
} // namespace

std::string
NameOf(FoldVerdict verdict)
{
  switch (verdict)
  {
    case FoldVerdict::Correct:
      return "correct";
    case FoldVerdict::Wrong:
      return "wrong";
    case FoldVerdict::Unmatched:
      return "unmatched";
    default:
      return "";
  }
}

RegistrationResults
MakeRegistrationResults(const ColonPositionFiles &      supine,
                        const ColonPositionFiles &      prone,
                        const SupineProneRegistration & registration,
                        const std::vector<PointPair> &  truth,
                        const Progress &                progress)
{
  return Telling(supine, prone, registration, truth).Run(progress);
}
} // namespace shapeton
