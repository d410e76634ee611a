#include "shapetonIleocecalValve.h"

#include "shapetonCecalRegion.h"
#include "shapetonExceptions.h"
#include "shapetonPlaceInWords.h"
#include "shapetonValveLogOdds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
/** Field arrays of the centerline: position (3 numbers), arc length, length and width in mm; confidence from 0 to 1. */
constexpr const char * arrayName = "ileocecalValve";
constexpr const char * candidatesName = "ileocecalValveCandidates";
constexpr int          valuesInArray = 7;

/** Rounded down, so that a value below the limit is not printed as the limit. */
std::string
PerCent(double share)
{
  return std::to_string(static_cast<int>(std::floor(100.0 * share))) + " %";
}

/** Probability that the valve is this candidate or an adjacent one on the same fold; at most one candidate is the
 * valve. */
double
ProbabilityNear(const IleocecalValve & best, const std::vector<IleocecalValve> & candidates)
{
  constexpr double next = 25.0; // mm; chosen: candidates on one fold
  return std::accumulate(
    candidates.begin(), candidates.end(), 0.0, [&best](double sum, const IleocecalValve & candidate) {
      return (candidate.position - best.position).norm() <= next ? sum + candidate.confidence : sum;
    });
}

double
LengthOf(const CurveSet & centerline)
{
  return PointValues(centerline, "arcLength", "the centerline").maxCoeff();
}

/** Decides from the probabilities of the candidates. */
ValveSearch
Decided(std::vector<IleocecalValve> candidates)
{
  constexpr double leastConfidence = 0.5; // chosen: more likely the valve than not
  constexpr double leastKept = 0.001;     // chosen: the other scan may show the place better
  ValveSearch      search;
  if (candidates.empty())
  {
    search.reason = "no bulge of the wall was found near the end of the centerline";
    return search;
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const IleocecalValve & a, const IleocecalValve & b) {
    return a.confidence > b.confidence;
  });
  IleocecalValve best = candidates.front();
  best.confidence = ProbabilityNear(best, candidates);
  if (best.confidence >= leastConfidence)
  {
    search.valve = best;
  }
  else
  {
    search.reason = "no candidate is likely enough: the best one is at " + PlaceInWords(best.position) + " with " +
                    PerCent(best.confidence);
  }
  candidates.erase(std::find_if(candidates.begin(),
                                candidates.end(),
                                [](const IleocecalValve & one) { return one.confidence < leastKept; }),
                   candidates.end());
  search.candidates = std::move(candidates);
  return search;
}

/** Odds of each candidate against no candidate being the valve. */
std::vector<double>
OddsOf(const std::vector<IleocecalValve> & candidates)
{
  constexpr double leastRest = 1e-6; // of rounded numbers
  double           none = 1.0;
  for (const IleocecalValve & candidate : candidates)
  {
    none -= candidate.confidence;
  }
  std::vector<double> odds;
  for (const IleocecalValve & candidate : candidates)
  {
    odds.push_back(candidate.confidence / std::max(none, leastRest));
  }
  return odds;
}

/** For each place of the first scan the nearest one of the second, which has no nearer partner; -1 for none. */
std::vector<int>
PartnersOf(const std::vector<Eigen::Vector3d> & first, const std::vector<IleocecalValve> & second)
{
  constexpr double reach = 20.0; // mm; chosen: the error of a registration, and of the middle of a valve
  struct Pair
  {
    double      distance;
    std::size_t first, second;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    for (std::size_t j = 0; j < second.size(); ++j)
    {
      pairs.push_back({ (first[i] - second[j].position).norm(), i, j });
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair & a, const Pair & b) { return a.distance < b.distance; });
  std::vector<int>  partners(first.size(), -1);
  std::vector<bool> isTaken(second.size(), false);
  for (const Pair & pair : pairs)
  {
    if (pair.distance <= reach && partners[pair.first] == -1 && !isTaken[pair.second])
    {
      partners[pair.first] = static_cast<int>(pair.second);
      isTaken[pair.second] = true;
    }
  }
  return partners;
}

SurfaceArray
ArrayOf(const char * name, const std::vector<IleocecalValve> & valves)
{
  SurfaceArray array{ name, SurfaceArray::ValueMatrix(valves.size(), valuesInArray), false };
  for (std::size_t row = 0; row < valves.size(); ++row)
  {
    const IleocecalValve & valve = valves[row];
    array.values.row(static_cast<Eigen::Index>(row)) << valve.position.transpose(), valve.arcLength, valve.length,
      valve.width, valve.confidence;
  }
  return array;
}

std::vector<IleocecalValve>
ValvesOf(const char * name, const CurveSet & centerline)
{
  const SurfaceArray * const  array = FindSurfaceArray(centerline.fieldArrays, name);
  std::vector<IleocecalValve> valves;
  if (array == nullptr)
  {
    return valves;
  }
  if (array->values.cols() != valuesInArray)
  {
    throw InputError(std::string("the field array ") + name +
                     " of the centerline must have rows of 7 numbers; run ColonSegmentation again");
  }
  for (const auto & values : array->values.rowwise())
  {
    IleocecalValve valve;
    valve.position = values.head<3>().transpose();
    valve.arcLength = values[3];
    valve.length = values[4];
    valve.width = values[5];
    valve.confidence = values[6];
    valves.push_back(valve);
  }
  return valves;
}

Json
PlaceToJson(const IleocecalValve & valve)
{
  Json json = { { "position", { valve.position[0], valve.position[1], valve.position[2] } },
                { "arcLength", valve.arcLength },
                { "length", valve.length },
                { "width", valve.width },
                { "confidence", valve.confidence } };
  json["attenuation"] = std::isfinite(valve.attenuation) ? Json(valve.attenuation) : Json(nullptr);
  return json;
}

IleocecalValve
PlaceFromJson(const Json & json)
{
  IleocecalValve valve;
  const auto     position = json.at("position").get<std::array<double, 3>>();
  valve.position = { position[0], position[1], position[2] };
  valve.arcLength = json.at("arcLength").get<double>();
  valve.length = json.at("length").get<double>();
  valve.width = json.at("width").get<double>();
  valve.confidence = json.at("confidence").get<double>();
  valve.attenuation = json.at("attenuation").is_null() ? valve.attenuation : json["attenuation"].get<double>();
  return valve;
}
} // namespace

ValveSearch
FindIleocecalValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centerline)
{
  const CecalRegion           region(labels, ct, centerline);
  std::vector<IleocecalValve> candidates;
  double                      sum = 1.0; // odds that none is the valve
  for (const ValveEvidence & place : JoinLips(FindValveBulges(region)))
  {
    candidates.push_back(place.valve);
    candidates.back().arcLength = LengthOf(centerline) - place.beforeEnd;
    candidates.back().confidence = std::exp(ValveLogOdds(place));
    sum += candidates.back().confidence;
  }
  for (IleocecalValve & candidate : candidates)
  {
    candidate.confidence /= sum;
  }
  return Decided(std::move(candidates));
}

std::array<ValveSearch, 2>
FindValveInBoth(std::vector<IleocecalValve>          first,
                std::vector<IleocecalValve>          second,
                const std::vector<Eigen::Vector3d> & firstInSecond)
{
  RequireParameter(firstInSecond.size() == first.size(),
                   "each candidate of the first scan needs a place in the second");
  const std::vector<int> partners = PartnersOf(firstInSecond, second);
  std::vector<double>    ofFirst = OddsOf(first);
  std::vector<double>    ofSecond = OddsOf(second);
  constexpr double weightOfBetter = 0.8; // chosen: a scan where the lips are flat hardly counts, but decides a tie
  // The odds of all places, each counted once, and of no place.
  double sum = 1.0 + std::accumulate(ofSecond.begin(), ofSecond.end(), 0.0);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    if (partners[i] != -1)
    {
      double & other = ofSecond[partners[i]];
      sum -= other;
      const auto [worse, better] = std::minmax(ofFirst[i], other);
      const double both = std::pow(better, weightOfBetter) * std::pow(worse, 1.0 - weightOfBetter);
      ofFirst[i] = other = both;
    }
    sum += ofFirst[i];
  }
  const auto normalize = [sum](const std::vector<double> & odds, std::vector<IleocecalValve> & candidates) {
    std::transform(
      odds.begin(), odds.end(), candidates.begin(), candidates.begin(), [sum](double o, IleocecalValve one) {
        one.confidence = o / sum;
        return one;
      });
  };
  normalize(ofFirst, first);
  normalize(ofSecond, second);
  return { { Decided(std::move(first)), Decided(std::move(second)) } };
}

void
SetIleocecalValve(const ValveSearch & search, CurveSet & centerline)
{
  std::vector<SurfaceArray> & arrays = centerline.fieldArrays;
  arrays.erase(
    std::remove_if(arrays.begin(),
                   arrays.end(),
                   [](const SurfaceArray & array) { return array.name == arrayName || array.name == candidatesName; }),
    arrays.end());
  if (search.valve)
  {
    arrays.push_back(ArrayOf(arrayName, { *search.valve }));
  }
  if (!search.candidates.empty())
  {
    arrays.push_back(ArrayOf(candidatesName, search.candidates));
  }
}

std::optional<IleocecalValve>
IleocecalValveOf(const CurveSet & centerline)
{
  const auto valves = ValvesOf(arrayName, centerline);
  return valves.empty() ? std::nullopt : std::optional(valves.front());
}

std::vector<IleocecalValve>
ValveCandidatesOf(const CurveSet & centerline)
{
  return ValvesOf(candidatesName, centerline);
}

Json
ValveToJson(const ValveSearch & search)
{
  Json json = search.valve ? PlaceToJson(*search.valve) : Json{ { "reason", search.reason } };
  json["found"] = search.valve.has_value();
  json["candidates"] = Json::array();
  for (const IleocecalValve & candidate : search.candidates)
  {
    json["candidates"].push_back(PlaceToJson(candidate));
  }
  return json;
}

ValveSearch
ValveFromJson(const Json & json)
{
  ValveSearch search;
  try
  {
    if (json.at("found").get<bool>())
    {
      search.valve = PlaceFromJson(json);
    }
    else
    {
      search.reason = json.at("reason").get<std::string>();
    }
    for (const Json & candidate : json.at("candidates"))
    {
      search.candidates.push_back(PlaceFromJson(candidate));
    }
  }
  catch (const Json::exception & error)
  {
    throw InputError(std::string("the ileocecal valve is not as ColonRegistration writes it: ") + error.what());
  }
  return search;
}
} // namespace shapeton
