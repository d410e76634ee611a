#include "shapetonColonoscopyQuality.h"

#include "shapetonColonFigures.h"
#include "shapetonHiddenInBoth.h"

#include <algorithm>
#include <cmath>

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

/** What the other position, and at least one of them, show of the segments of this one. */
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
  SegmentQualityInput input;
  input.centerline = &results.centerline;
  input.wall = &results.labeled;
  input.segments = results.segments;
  input.hidden = HiddenWallsOf(results.flatStatistics);
  if (results.ct)
  {
    input.lumen = results.lumen;
    if (results.original)
    {
      input.attenuation = AttenuationOf(results.original);
    }
  }
  quality.segments = MeasureSegmentQuality(input);
  if (results.pair)
  {
    AddOtherPosition(*results.pair, quality);
  }
  return quality;
}

CsvTable
QualityTable(const ColonoscopyQuality & quality)
{
  std::vector<std::string> columns{ "Segment",
                                    "From (cm)",
                                    "To (cm)",
                                    "Distension",
                                    "Caliber (mm)",
                                    "Evaluable wall",
                                    "Under tagged fluid",
                                    "Fluid (HU)",
                                    "Tagged residue (cm^2)",
                                    "Untagged fluid",
                                    "Not on flat map (cm^2)" };
  const bool               hasOther = !quality.either.empty();
  if (hasOther)
  {
    columns.insert(columns.begin() + 6, { "Other position", "Either position" });
  }
  CsvTable table(columns);
  for (std::size_t i = 0; i < quality.segments.size(); ++i)
  {
    const SegmentQuality &   one = quality.segments[i];
    const auto               untagged = static_cast<std::size_t>(ColonHindrance::UntaggedFluid);
    std::vector<std::string> cells{ one.extent.name,
                                    NumberOfCentimeters(one.extent.begin),
                                    NumberOfCentimeters(one.extent.end),
                                    NameOf(one.grade),
                                    CalibersOf(one.distension),
                                    WholePercent(one.EvaluableShare()),
                                    WholePercent(one.submergedShare),
                                    WholeNumber(one.fluidAttenuation),
                                    SquareCentimeters(one.residueArea),
                                    Centimeters(one.assessability.lengths.at(untagged)),
                                    SquareCentimeters(one.hiddenArea) };
    if (hasOther)
    {
      cells.insert(cells.begin() + 6, { WholePercent(one.otherShare), WholePercent(one.eitherShare) });
    }
    table.AddRow(cells);
  }
  return table;
}
} // namespace shapeton
