#include "shapetonColonFlexures.h"

#include "shapetonCenterlineShape.h"
#include "shapetonFlexureProgram.h"
#include "shapetonPublishedFlexures.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double leastColon = 800.0; // mm; Hounnou et al. 2002, see the header
/** Maximum mean squared feature deviation of a flexure. */
constexpr double greatestMeanDeviation = 4.0;
/** Maximum distance (mm) from the optimum to the apex. The descending colon ends where its straight part does, not at a
 * bend. */
constexpr std::array<double, 4> apexReach{ 14.0, 0.0, 16.0, 16.0 };
constexpr double                impossible = -1e30;

/** Nearby apex. Upper flexures: the highest point, with a preference for posterior ones, since the flexures are fixed
 * to the posterior wall. Rectosigmoid: the sharpest bend. */
int
SnapToApex(const CenterlineShape & shape, const Eigen::VectorXd & turning, int flexure, int place)
{
  const int reach = static_cast<int>(apexReach[flexure] / CenterlineShape::Step);
  int       best = place;
  double    most = impossible;
  for (int i = std::max(0, place - reach); i <= std::min(shape.Size() - 1, place + reach); ++i)
  {
    const double distance = std::abs(i - place) * CenterlineShape::Step;
    const double value =
      flexure >= 2 ? shape.Points()(i, 2) + 0.5 * shape.Points()(i, 1) - 0.01 * distance : turning[i] - 0.5 * distance;
    if (value > most)
    {
      most = value;
      best = i;
    }
  }
  return best;
}

void
PlaceFlexure(const CenterlineShape & shape, const VertexMatrix & tangents, int i, ColonFlexure & flexure)
{
  flexure.point = shape.Points().row(i).transpose();
  flexure.tangent = tangents.row(i).transpose();
  flexure.arcLength = shape.ArcLengthAt(i);
}

void
FindOrdered(const CenterlineShape & shape, const std::optional<Pelvis> & pelvis, ColonFlexures & result)
{
  const FlexurePlaces places = FindFlexurePlaces(shape, pelvis);
  result.isMirrored = places.isMirrored;
  result.isBackwards = places.isBackwards;
  result.isJunctionFromBones = places.isAtBrim;
  const Eigen::VectorXd turning = 0.5 * (shape.Turning(35.0, 8.0) + shape.Turning(70.0, 8.0));
  const VertexMatrix    tangents = shape.Tangents(10.0);
  for (int k = 0; k < 4; ++k)
  {
    ColonFlexure & flexure = result.flexures[k];
    PlaceFlexure(shape, tangents, SnapToApex(shape, turning, k, places.at[k]), flexure);
    flexure.isFound = places.meanDeviation[k] <= greatestMeanDeviation;
    flexure.confidence = flexure.isFound ? places.confidence[k] : 0.0;
    if (!flexure.isFound)
    {
      flexure.reason = "no bend at the anatomical position of this flexure";
    }
  }
}

void
FindPublished(const CenterlineShape & shape, ColonFlexures & result)
{
  const std::array<int, 4> places = PublishedFlexures(shape);
  const VertexMatrix       tangents = shape.Tangents(10.0);
  int                      previous = -1;
  for (int k = 0; k < 4; ++k)
  {
    ColonFlexure & flexure = result.flexures[k];
    if (places[k] < 0)
    {
      flexure.reason = "the published rule found no matching bend";
    }
    else if (places[k] <= previous)
    {
      flexure.reason = "the bend chosen by the published rule is out of anatomical order";
    }
    else
    {
      PlaceFlexure(shape, tangents, places[k], flexure);
      flexure.isFound = true;
      previous = places[k];
    }
  }
  const double confidence = result.NumberFound() == 4 ? 0.5 : 0.25;
  for (ColonFlexure & flexure : result.flexures)
  {
    flexure.confidence = flexure.isFound ? confidence : 0.0;
  }
}

void
WarnOfFlexures(ColonFlexures & result)
{
  if (result.isMirrored)
  {
    result.warnings.push_back("the descending colon is on the right side: situs inversus, or the image has left and "
                              "right swapped; check its orientation");
  }
  if (result.isBackwards)
  {
    result.warnings.push_back("the line probably runs from the cecum to the rectum: it may be "
                              "reversed, or a part of the colon is missing; the flexures are unreliable");
  }
  const std::string & reason = result.flexures[0].reason;
  const bool          isOneReason = std::all_of(
    result.flexures.begin(), result.flexures.end(), [&](const ColonFlexure & f) { return f.reason == reason; });
  if (isOneReason && !reason.empty())
  {
    result.warnings.push_back("no flexure was found: " + reason);
    return;
  }
  for (const ColonFlexure & flexure : result.flexures)
  {
    const std::string name = "the " + NameOfFlexure(flexure.number) + " flexure";
    if (!flexure.isFound)
    {
      result.warnings.push_back(name + " was not found: " + flexure.reason);
    }
    else if (flexure.confidence < 0.5 && result.rule == FlexureRule::Ordered)
    {
      result.warnings.push_back(name + " is uncertain (confidence " +
                                std::to_string(static_cast<int>(100.0 * flexure.confidence)) + " %): check it");
    }
  }
}
} // namespace

int
ColonFlexures::NumberFound() const
{
  return static_cast<int>(
    std::count_if(flexures.begin(), flexures.end(), [](const ColonFlexure & f) { return f.isFound; }));
}

std::string
NameOfFlexure(int number)
{
  static const char * const names[] = { "", "rectosigmoid", "descending-sigmoid", "splenic", "hepatic" };
  return number >= 1 && number <= 4 ? names[number] : "";
}

std::string
NameOf(FlexureRule rule)
{
  return rule == FlexureRule::Ordered ? "ordered" : "published";
}

ColonFlexures
FindColonFlexures(const CurveSet & centerline, FlexureRule rule, const std::optional<Pelvis> & pelvis)
{
  const CenterlineShape shape(centerline);
  ColonFlexures         result;
  result.rule = rule;
  for (int k = 0; k < 4; ++k)
  {
    result.flexures[k].number = k + 1;
  }
  if (shape.Length() < leastColon)
  {
    for (ColonFlexure & flexure : result.flexures)
    {
      flexure.reason = "the centerline is " + std::to_string(static_cast<int>(shape.Length() / 10)) +
                       " cm long, only a part of a colon (a whole colon is at least 80 cm long)";
    }
  }
  else
  {
    rule == FlexureRule::Ordered ? FindOrdered(shape, pelvis, result) : FindPublished(shape, result);
  }
  WarnOfFlexures(result);
  return result;
}
} // namespace shapeton
