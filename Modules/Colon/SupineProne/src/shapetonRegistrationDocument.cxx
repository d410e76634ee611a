#include "shapetonRegistrationDocument.h"

#include "shapetonJson.h"

namespace shapeton
{
namespace
{
Json
ConfidenceToJson(const RegistrationConfidence & confidence)
{
  Json json;
  json["whole"] = RoundedJson(confidence.whole);
  json["flagged"] = confidence.isFlagged;
  json["reasons"] = confidence.reasons;
  json["matchedShare"] = RoundedJson(confidence.matchedShare);
  json["contradictedShare"] = RoundedJson(confidence.contradictedShare);
  json["energy"] = RoundedJson(confidence.energy);
  json["energiesOfTaeniae"] = Json::array();
  for (const double energy : confidence.energies)
  {
    json["energiesOfTaeniae"].push_back(RoundedJson(energy));
  }
  json["marginOfTaeniae"] = RoundedJson(confidence.margin);
  json["marginOfSense"] = RoundedJson(confidence.senseMargin);
  json["residual"] = RoundedJson(confidence.residual);
  return json;
}

Json
SegmentToJson(const SegmentMatches & row, bool hasTruth)
{
  Json json;
  json["segment"] = row.segment.empty() ? Json(nullptr) : Json(row.segment);
  json["confidence"] = RoundedJson(row.confidence);
  json["supineFolds"] = row.supineFolds;
  json["proneFolds"] = row.proneFolds;
  json["followed"] = row.followed;
  json["contradicted"] = row.contradicted;
  json["supineAlone"] = row.supineAlone;
  json["proneAlone"] = row.proneAlone;
  if (hasTruth)
  {
    json["correct"] = row.correct;
    json["wrong"] = row.wrong;
    json["unmatched"] = row.unmatched;
  }
  return json;
}

/** Ratio of a part to a total, which may be zero. */
Json
Share(int share, int whole)
{
  return whole > 0 ? RoundedJson(static_cast<double>(share) / whole) : Json(nullptr);
}

Json
MatchesToJson(const SupineProneRegistration & registration, const RegistrationResults & results)
{
  SegmentMatches sum;
  for (const SegmentMatches & row : results.segments)
  {
    sum.supineFolds += row.supineFolds;
    sum.proneFolds += row.proneFolds;
    sum.followed += row.followed;
    sum.contradicted += row.contradicted;
    sum.correct += row.correct;
    sum.wrong += row.wrong;
    sum.unmatched += row.unmatched;
  }
  Json json;
  json["supineFolds"] = sum.supineFolds;
  json["proneFolds"] = sum.proneFolds;
  json["pairs"] = results.matches.size();
  json["followed"] = sum.followed;
  json["contradicted"] = sum.contradicted;
  if (!results.points.empty())
  {
    json["correct"] = sum.correct;
    json["wrong"] = sum.wrong;
    json["unmatched"] = sum.unmatched;
    json["precision"] = Share(sum.correct, sum.correct + sum.wrong);
    json["recall"] = Share(sum.correct, sum.correct + sum.wrong + sum.unmatched);
  }
  json["energy"] = RoundedJson(registration.matching.primal);
  json["leastPossible"] = RoundedJson(registration.matching.bound);
  json["gap"] = RoundedJson(registration.matching.Gap());
  return json;
}

Json
ErrorsToJson(const RegistrationErrors & errors)
{
  Json json;
  json["counted"] = errors.inSpace.size();
  json["excluded"] = errors.excluded;
  json["offSurface"] = errors.offSurface;
  json["mean"] = RoundedJson(errors.Mean());
  json["halfInterval"] = RoundedJson(errors.HalfInterval());
  json["median"] = RoundedJson(errors.Median());
  json["percentile95"] = RoundedJson(errors.Percentile95());
  json["shareWithin10"] = errors.inSpace.empty() ? Json(nullptr) : RoundedJson(errors.ShareWithin10());
  json["meanOnMap"] = RoundedJson(errors.MeanOnMap());
  return json;
}

Json
TaeniaeToJson(const CommonTaeniae & taeniae)
{
  Json json{ { "proneOfSupine", nullptr }, { "probability", RoundedJson(taeniae.probability) } };
  if (taeniae.AreKnown())
  {
    json["proneOfSupine"] = { taeniae.target[0] + 1, taeniae.target[1] + 1, taeniae.target[2] + 1 };
  }
  return json;
}

Json
FiguresToJson(const RegistrationFigures & figures)
{
  Json json;
  json["flips"] = figures.flips;
  json["flipsBeforeProjection"] = figures.flipsBeforeProjection;
  json["greatestDilatation"] = RoundedJson(figures.greatestDilatation);
  if (figures.solves > 0) // the published map
  {
    json["solves"] = figures.solves;
    json["greatestMiss"] = RoundedJson(figures.greatestMiss);
  }
  return json;
}
} // namespace

Json
DocumentOf(const SupineProneRegistration & registration,
           const RegistrationResults &     results,
           const RegistrationErrors &      frame)
{
  const bool hasTruth = !results.points.empty();
  Json       json;
  json["confidence"] = ConfidenceToJson(registration.confidence);
  json["map"] = FiguresToJson(registration.figures);
  json["flexures"] = Json::array();
  for (const auto & [supine, prone] : registration.flexures)
  {
    json["flexures"].push_back({ { "supine", RoundedJson(supine) }, { "prone", RoundedJson(prone) } });
  }
  json["taeniae"] = TaeniaeToJson(registration.taeniae);
  json["matches"] = MatchesToJson(registration, results);
  json["segments"] = Json::array();
  for (const SegmentMatches & row : results.segments)
  {
    json["segments"].push_back(SegmentToJson(row, hasTruth));
  }
  if (hasTruth)
  {
    const RegistrationErrors errors = SummaryOf(results.errors);
    json["errors"] = ErrorsToJson(errors);
    json["errorsOfFrame"] = ErrorsToJson(frame);
    json["frameOverMap"] = RoundedJson(frame.Mean() / errors.Mean());
  }
  return json;
}
} // namespace shapeton
