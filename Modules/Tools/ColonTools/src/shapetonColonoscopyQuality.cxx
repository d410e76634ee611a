#include "shapetonColonoscopyQuality.h"

#include "shapetonColonFigures.h"
#include "shapetonReportTable.h"
#include "shapetonHiddenInBoth.h"

#include <algorithm>

namespace shapeton
{
namespace
{
std::vector<HiddenWall>
HiddenWallsOf(const Json & flatStatistics)
{
  std::vector<HiddenWall> hidden;
  for (const Json & cap : flatStatistics.is_null() ? Json::array() : flatStatistics.value("caps", Json::array()))
  {
    hidden.push_back({ PlaceInJson(cap.at("place")), cap.at("area").get<double>() });
  }
  return hidden;
}

/** Adds how much of each segment is shown by the other position, and by at least one of the positions. */
void
AddOtherPosition(const ColonoscopyPair & pair, ColonoscopyQuality & quality)
{
  const std::vector<HinderedStretch> there = FindHinderedStretches(pair.second.position.centerline);
  for (SegmentQuality & segment : quality.segments)
  {
    quality.either.push_back(Assess(quality.hiddenInBoth, segment.extent.begin, segment.extent.end));
    const auto same =
      std::find_if(pair.second.segments.begin(), pair.second.segments.end(), [&](const ColonSegmentExtent & other) {
        return other.label == segment.extent.label;
      });
    const bool isKnown = same != pair.second.segments.end();
    segment.otherShare = (isKnown ? Assess(there, same->begin, same->end) : ColonAssessability()).share;
    segment.eitherShare = quality.either.back().share;
  }
}

/** "12–43". */
std::string
CalibersOf(const ColonDistension & distension)
{
  return WholeNumber(distension.leastCaliber) + "\u2013" + WholeNumber(distension.largestCaliber);
}

} // namespace

Eigen::Vector3d
PlaceInJson(const Json & lps)
{
  return { lps.at(0).get<double>(), lps.at(1).get<double>(), lps.at(2).get<double>() };
}

bool
IsOfMask(const Json & quality)
{
  return quality.is_object() &&
         quality.value("/assessability/tagging"_json_pointer, std::string()) == "unknown: a mask";
}

ColonoscopyQuality
MeasureColonoscopyQuality(const ColonoscopyResults & results)
{
  ColonoscopyQuality quality;
  if (results.pair)
  {
    const ColonoscopyPair & pair = *results.pair;
    quality.hiddenInBoth = FindHiddenInBoth(pair.first.position, pair.second.position, pair.registration.supineToProne);
  }
  if (results.segments.empty() || !FindSurfaceArray(results.labeled.cellArrays, "segment"))
  {
    return quality;
  }
  SegmentQualityInput input{
    &results.centerline, &results.labeled, results.segments, HiddenWallsOf(results.flatStatistics), nullptr, {}
  };
  if (results.ct)
  {
    input.lumen = results.lumen;
    if (results.original)
    {
      input.attenuation = AttenuationOf(results.original);
    }
  }
  quality.segments = MeasureSegmentQuality(input);
  quality.isOfMask = IsOfMask(results.quality);
  if (results.pair)
  {
    AddOtherPosition(*results.pair, quality);
  }
  return quality;
}

CsvTable
QualityTable(const ColonoscopyQuality & quality)
{
  using Segment = SegmentQuality;
  constexpr auto                    untagged = static_cast<std::size_t>(ColonHindrance::UntaggedFluid);
  std::vector<TableColumn<Segment>> columns{
    { "Segment", [](const Segment & one) { return one.extent.name; } },
    { "From (cm)", [](const Segment & one) { return NumberOfCentimeters(one.extent.begin); } },
    { "To (cm)", [](const Segment & one) { return NumberOfCentimeters(one.extent.end); } },
    { "Distension", [](const Segment & one) { return NameOf(one.grade); } },
    { "Caliber (mm)", [](const Segment & one) { return CalibersOf(one.distension); } },
    { "Evaluable wall", [](const Segment & one) { return WholePercent(one.EvaluableShare()); } },
    { "Under tagged fluid", [](const Segment & one) { return WholePercent(one.submergedShare); } },
    { "Fluid (HU)", [](const Segment & one) { return WholeNumber(one.fluidAttenuation); } },
    { "Tagged residue (cm^2)", [](const Segment & one) { return SquareCentimeters(one.residueArea); } },
    { "Seams of cleansing (cm^2)", [](const Segment & one) { return SquareCentimeters(one.seamArea); } },
    { "Untagged fluid",
      [&quality](const Segment & one) {
        return quality.isOfMask ? "" : Centimeters(one.assessability.lengths.at(untagged));
      } },
    { "Not on flat map (cm^2)", [](const Segment & one) { return SquareCentimeters(one.hiddenArea); } }
  };
  if (!quality.either.empty())
  {
    columns.insert(
      columns.begin() + 6,
      { { "Visible length, other position", [](const Segment & one) { return WholePercent(one.otherShare); } },
        { "Visible length, either position", [](const Segment & one) { return WholePercent(one.eitherShare); } } });
  }
  return TableOf(quality.segments, columns);
}
} // namespace shapeton
