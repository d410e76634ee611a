#include "shapetonIleocecalValve.h"

#include "shapetonCecalRegion.h"
#include "shapetonExceptions.h"
#include "shapetonPlaceInWords.h"
#include "shapetonValveLogOdds.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Field array of the centerline: position (3 numbers), arc length, length and width in mm; confidence from 0 to 1. */
constexpr const char * arrayName = "ileocecalValve";
constexpr int          valuesInArray = 7;
constexpr double       leastConfidence = 0.5; // chosen: more likely the valve than not

/** Rounded down, so that a value below the limit is not printed as the limit. */
std::string
PerCent(double share)
{
  return std::to_string(static_cast<int>(std::floor(100.0 * share))) + " %";
}

/** Probability that the valve is this candidate or an adjacent one on the same fold; at most one candidate is the
 * valve. */
double
ProbabilityNear(const ValveEvidence & best, const std::vector<ValveEvidence> & places, const std::vector<double> & odds)
{
  constexpr double next = 25.0; // mm; chosen: candidates on one fold
  double           all = 1.0;
  double           near = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    all += odds[i];
    near += (places[i].valve.position - best.valve.position).norm() <= next ? odds[i] : 0.0;
  }
  return near / all;
}
} // namespace

ValveSearch
FindIleocecalValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centerline)
{
  const CecalRegion                region(labels, ct, centerline);
  const std::vector<ValveEvidence> places = JoinLips(FindValveBulges(region));
  ValveSearch                      search;
  if (places.empty())
  {
    search.reason = "no bulge of the wall was found near the end of the centerline";
    return search;
  }
  std::vector<double> odds;
  for (const ValveEvidence & place : places)
  {
    odds.push_back(std::exp(ValveLogOdds(place)));
  }
  const auto            most = std::max_element(odds.begin(), odds.end()) - odds.begin();
  const ValveEvidence & best = places[most];
  IleocecalValve        valve = best.valve;
  valve.arcLength = PointValues(centerline, "arcLength", "the centerline").maxCoeff() - best.beforeEnd;
  valve.confidence = ProbabilityNear(best, places, odds);
  if (valve.confidence < leastConfidence)
  {
    search.reason = "no candidate is likely enough: the best one is at " + PlaceInWords(valve.position) + " with " +
                    PerCent(valve.confidence);
    return search;
  }
  search.valve = valve;
  return search;
}

void
SetIleocecalValve(const std::optional<IleocecalValve> & valve, CurveSet & centerline)
{
  std::vector<SurfaceArray> & arrays = centerline.fieldArrays;
  arrays.erase(
    std::remove_if(arrays.begin(), arrays.end(), [](const SurfaceArray & array) { return array.name == arrayName; }),
    arrays.end());
  if (valve)
  {
    SurfaceArray array{ arrayName, SurfaceArray::ValueMatrix(1, valuesInArray), false };
    array.values << valve->position.transpose(), valve->arcLength, valve->length, valve->width, valve->confidence;
    arrays.push_back(array);
  }
}

std::optional<IleocecalValve>
IleocecalValveOf(const CurveSet & centerline)
{
  const SurfaceArray * const array = FindSurfaceArray(centerline.fieldArrays, arrayName);
  if (array == nullptr)
  {
    return std::nullopt;
  }
  if (array->values.rows() != 1 || array->values.cols() != valuesInArray)
  {
    throw InputError("the field array ileocecalValve of the centerline must have 1 x 7 numbers; run "
                     "ColonSegmentation again");
  }
  const auto     values = array->values.row(0);
  IleocecalValve valve;
  valve.position = values.head<3>().transpose();
  valve.arcLength = values[3];
  valve.length = values[4];
  valve.width = values[5];
  valve.confidence = values[6];
  return valve;
}
} // namespace shapeton
