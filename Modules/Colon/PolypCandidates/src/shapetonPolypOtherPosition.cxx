#include "shapetonPolypSearch.h"

#include "shapetonCandidateList.h"
#include "shapetonExceptions.h"
#include "shapetonFacePlace.h"
#include "shapetonSurfaceLocator.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double leastConfidence = 0.3;  // of the map at a place, 0 to 1; chosen: the viewer dims the place below it
constexpr double farthestFromMap = 10.0; // mm, mean; chosen: farther candidates are of another colon

const SurfaceArray &
ArrayOf(const SurfaceMesh & map, const char * name, int components, const std::string & what)
{
  const SurfaceArray * const array = FindSurfaceArray(map.pointArrays, name);
  if (array == nullptr || array->values.cols() != components)
  {
    throw InputError(what + ": the point array " + name + " is missing; give a folder written by ColonRegistration");
  }
  return *array;
}

/** See PolypInOtherPosition::likeness. */
double
Likeness(const PolypCandidate & candidate, const OtherPolypCandidate & other, double distance)
{
  // The mean registration error of phantoms is 4.8 mm. The likeness is below 0.01 for 68 of 91 candidates that are not
  // at a polyp, and for 3 candidates at polyps of at least 5.5 mm.
  constexpr double deviation = 8.0, deviationOfLogWidth = 0.5; // mm
  const double     away = distance / deviation;
  const double     wider =
    std::isfinite(other.diameter) ? std::log(other.diameter / candidate.diameter) / deviationOfLogWidth : 0.0;
  return other.score * std::exp(-0.5 * (away * away + wider * wider));
}

void
FindMostAlike(const PolypCandidate &                   candidate,
              const std::vector<OtherPolypCandidate> & others,
              PolypInOtherPosition &                   place)
{
  constexpr double            alike = 0.1; // likeness; chosen: 2.1 deviations at a score of 1
  const OtherPolypCandidate * best = nullptr;
  const OtherPolypCandidate * nearest = nullptr;
  const auto away = [&](const OtherPolypCandidate & other) { return (other.position - place.point).norm(); };
  for (const OtherPolypCandidate & other : others)
  {
    const double likeness = Likeness(candidate, other, away(other));
    if (best == nullptr || likeness > place.likeness)
    {
      best = &other;
      place.likeness = likeness;
    }
    nearest = nearest == nullptr || away(other) < away(*nearest) ? &other : nearest;
  }
  place.isSeen = !place.isExcluded && place.likeness >= alike;
  if (const OtherPolypCandidate * const shown = place.likeness >= alike ? best : nearest)
  {
    place.candidate = shown->number;
    place.distance = away(*shown);
  }
}

/** Flatness; 1 for a flat head. Two fifths of the flat polyps visible in one position are missed in the other, and
 * stool is rarely flat. */
double
Flatness(const PolypCandidate & candidate)
{
  constexpr double prominence = 0.24, width = 0.03; // height per diameter; chosen
  return 1.0 / (1.0 + std::exp((candidate.height / candidate.diameter - prominence) / width));
}

/** Probability of a polyp, given the shape score and the evidence from the other position. Logistic regression on the
 * CT of realistic phantoms (seeds 2 to 7: 89 polyps, 91 other candidates); see
 * Documentation/validation/colon-polyps.md.
 */
double
ProbabilityInPair(const PolypCandidate & candidate)
{
  constexpr double ofScore = 0.27, ofLikeness = 4.85, ofFlatness = 2.65, constant = -2.69;
  // Minimum score; limits its log odds to +-6.9.
  constexpr double least = 1e-3;
  const double     score = std::clamp(candidate.shapeScore, least, 1.0 - least);
  const double     logOdds = ofScore * std::log(score / (1.0 - score)) + ofLikeness * candidate.other->likeness +
                         ofFlatness * Flatness(candidate) + constant;
  return 1.0 / (1.0 + std::exp(-logOdds));
}
} // namespace

double
MeanDistanceToWall(const SurfaceMesh & wall, const VertexMatrix & points)
{
  constexpr Eigen::Index most = 1000; // points; enough for a mean
  if (points.rows() == 0)
  {
    return 0.0;
  }
  const SurfaceLocator locator(wall.V, wall.F);
  const Eigen::Index   every = (points.rows() + most - 1) / most;
  double               sum = 0.0;
  Eigen::Index         number = 0;
  for (Eigen::Index i = 0; i < points.rows(); i += every)
  {
    sum += locator.FindClosest(points.row(i).transpose()).distance;
    ++number;
  }
  return sum / static_cast<double>(number);
}

std::vector<OtherPolypCandidate>
AsOthers(const std::vector<PolypCandidate> & candidates)
{
  std::vector<OtherPolypCandidate> others;
  for (const PolypCandidate & candidate : candidates)
  {
    const bool   isWeighed = candidate.other && std::isfinite(candidate.other->ownScore);
    const double score = isWeighed ? candidate.other->ownScore : candidate.score;
    others.push_back({ candidate.number, candidate.position, candidate.diameter, score });
  }
  return others;
}

void
FindInOtherPosition(const SurfaceMesh &                      map,
                    const std::string &                      what,
                    const std::vector<OtherPolypCandidate> & others,
                    std::vector<PolypCandidate> &            candidates)
{
  const SurfaceArray & mapped = ArrayOf(map, "mapped", 3, what);
  const SurfaceArray & confidence = ArrayOf(map, "confidence", 1, what);
  const SurfaceArray & excluded = ArrayOf(map, "excluded", 1, what);
  VertexMatrix         places(candidates.size(), 3);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    places.row(static_cast<Eigen::Index>(i)) = candidates[i].position.transpose();
  }
  if (MeanDistanceToWall(map, places) > farthestFromMap)
  {
    throw InputError(what + ": candidates are more than 10 mm from the registered wall; give the "
                            "registration of this colon");
  }
  const SurfaceLocator locator(map.V, map.F);
  for (PolypCandidate & candidate : candidates)
  {
    const SurfaceLocator::Closest closest = locator.FindClosest(candidate.position);
    const Eigen::Vector3d         weights = BarycentricOf(map, closest.face, closest.point);
    PolypInOtherPosition          place;
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = map.F(closest.face, k);
      place.point += weights[k] * mapped.values.row(vertex).transpose();
      place.confidence += weights[k] * confidence.values(vertex, 0);
      place.isExcluded = place.isExcluded || excluded.values(vertex, 0) != 0.0;
    }
    place.isExcluded = place.isExcluded || place.confidence < leastConfidence;
    FindMostAlike(candidate, others, place);
    candidate.other = place;
  }
}

void
WeighByOtherPosition(double confidence, std::vector<PolypCandidate> & candidates)
{
  RequireParameter(confidence >= 0.0 && confidence <= 1.0, "the confidence of a registration must be between 0 and 1");
  for (PolypCandidate & candidate : candidates)
  {
    if (!candidate.other || candidate.other->isExcluded || candidate.lookalike == PolypLookalike::Valve ||
        candidate.shapeScore <= 0.0)
    {
      continue;
    }
    PolypInOtherPosition & other = *candidate.other;
    other.ownScore = candidate.score;
    const double ofTissue = candidate.score / candidate.shapeScore;
    const double weighed = ofTissue * ProbabilityInPair(candidate);
    candidate.score = confidence * weighed + (1.0 - confidence) * candidate.score;
    // No remark for a valve or a bubble, or if the registration is unreliable.
    const bool isTold = ofTissue > 0.5 && confidence >= LeastRegistrationConfidence;
    AddRemark(isTold && !other.isSeen
                ? "no similar candidate in the other position: look at the place there; most stool moves"
                : "",
              candidate);
  }
  SortByScore(candidates);
}
} // namespace shapeton
