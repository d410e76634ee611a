#include "shapetonColonoscopyLimitations.h"

#include "shapetonColonFigures.h"
#include "shapetonColonSegments.h"
#include "shapetonColonoscopyFacts.h"
#include "shapetonPlaceInWords.h"
#include "shapetonReadableText.h"
#include "shapetonScanResolution.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <tuple>

namespace shapeton
{
namespace
{
Json
MissingPartsOf(const ColonoscopyResults & results)
{
  return results.quality.is_null() ? Json::array() : results.quality.value("missing", Json::array());
}

std::string
HindranceForReader(ColonHindrance hindrance)
{
  constexpr std::array<const char *, numberOfColonHindrances> words{
    { "",
      "collapsed segment, its wall is interpolated (no CT data)",
      "outside the field of view",
      "untagged fluid hides the wall below it",
      "poorly distended (caliber below 10 mm)" }
  };
  return words.at(static_cast<std::size_t>(hindrance));
}

/** Finds the slices and positions of centerline stretches. */
class StretchPlaces
{
public:
  explicit StretchPlaces(const ColonoscopyResults & results)
    : m_Line(results.centerline)
    , m_Arc(PointValues(results.centerline, "arcLength", "the centerline"))
    , m_Grid(results.lumen)
  {}

  /** ", slices 112 to 131", counted from 1 along the third axis of the image; "" if there is no image. */
  std::string
  Slices(double begin, double end) const
  {
    if (!m_Grid)
    {
      return "";
    }
    long       least = std::numeric_limits<long>::max(), greatest = std::numeric_limits<long>::min();
    const auto first = this->Nearest(begin), last = this->Nearest(end);
    for (Eigen::Index i = 0; i < m_Arc.size(); ++i)
    {
      if (i == first || i == last || (m_Arc[i] >= begin && m_Arc[i] <= end))
      {
        const long slice = SliceNumber(m_Grid, m_Line.V.row(i));
        least = std::min(least, slice);
        greatest = std::max(greatest, slice);
      }
    }
    return least == greatest ? ", slice " + std::to_string(least)
                             : ", slices " + std::to_string(least) + " to " + std::to_string(greatest);
  }

  std::string
  SliceAt(const Eigen::Vector3d & place) const
  {
    return m_Grid ? ", slice " + std::to_string(SliceNumber(m_Grid, place)) : "";
  }

  Eigen::Vector3d
  PlaceAt(double arcLength) const
  {
    return m_Line.V.row(this->Nearest(arcLength));
  }

private:
  Eigen::Index
  Nearest(double arcLength) const
  {
    Eigen::Index index = 0;
    (m_Arc.array() - arcLength).abs().minCoeff(&index);
    return index;
  }

  const CurveSet &          m_Line;
  Eigen::VectorXd           m_Arc;
  const itk::ImageBase<3> * m_Grid;
};

/** Stretches of one segment with the same hindrance. */
struct Hidden
{
  std::string    segment;
  ColonHindrance hindrance{ ColonHindrance::None };
  bool           isInOther{ false }; ///< whether the other position shows them
  int            number{ 0 };
  double         length{ 0.0 };
  double         begin{ 0.0 };
  double         end{ 0.0 };
  double         longest{ 0.0 };
  double         middleOfLongest{ 0.0 };
};

void
AddStretch(const HinderedStretch & stretch, Hidden & hidden)
{
  const double length = stretch.end - stretch.begin;
  hidden.begin = hidden.number == 0 ? stretch.begin : std::min(hidden.begin, stretch.begin);
  hidden.end = std::max(hidden.end, stretch.end);
  ++hidden.number;
  hidden.length += length;
  if (length > hidden.longest)
  {
    hidden.longest = length;
    hidden.middleOfLongest = 0.5 * (stretch.begin + stretch.end);
  }
}

/** Groups stretches by segment, hindrance and whether the other position shows them. Those hidden in both positions
 * come first, then the longest. */
std::vector<Hidden>
GroupStretches(const ColonoscopyResults & results, const ColonoscopyQuality & quality)
{
  const std::vector<HinderedStretch> &                            inBoth = quality.hiddenInBoth;
  std::map<std::tuple<bool, std::string, ColonHindrance>, Hidden> groups;
  const auto add = [&](const HinderedStretch & stretch, bool isInOther) {
    const ColonSegmentExtent * const segment = FindSegment(results.segments, 0.5 * (stretch.begin + stretch.end));
    const std::string                name = segment ? segment->name : "";
    Hidden &                         group = groups[{ isInOther, name, stretch.hindrance }];
    group.segment = name;
    group.hindrance = stretch.hindrance;
    group.isInOther = isInOther;
    AddStretch(stretch, group);
  };
  for (const HinderedStretch & stretch : inBoth)
  {
    add(stretch, false);
  }
  for (const HinderedStretch & stretch : FindHinderedStretches(results.centerline))
  {
    const double both = 1.0 - Assess(inBoth, stretch.begin, stretch.end).share;
    if (!results.pair || both < 0.5) // otherwise it is listed above
    {
      add(stretch, results.pair != nullptr);
    }
  }
  std::vector<Hidden> sorted;
  for (const auto & [key, group] : groups)
  {
    sorted.push_back(group);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const Hidden & a, const Hidden & b) {
    return a.isInOther != b.isInOther ? !a.isInOther : a.length > b.length;
  });
  return sorted;
}

/** "Sigmoid: ". */
std::string
Heading(std::string segment)
{
  segment = segment.empty() ? "unknown segment" : segment;
  segment[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(segment[0])));
  return segment + ": ";
}

void
AddHiddenStretches(const ColonoscopyResults & results,
                   const ColonoscopyQuality & quality,
                   const StretchPlaces &      places,
                   std::vector<Limitation> &  list)
{
  for (const Hidden & one : GroupStretches(results, quality))
  {
    std::string text = Heading(one.segment) + HindranceForReader(one.hindrance) + ", " + Centimeters(one.length);
    text += one.number == 1 ? "" : " in " + std::to_string(one.number) + " stretches";
    text += ", at " + NumberOfCentimeters(one.begin) + " to " + Centimeters(one.end) + " from the anal verge" +
            places.Slices(one.begin, one.end);
    text += !results.pair ? "." : one.isInOther ? "; the other position shows it." : "; hidden in both positions.";
    list.push_back({ text, places.PlaceAt(one.middleOfLongest) });
  }
}

void
AddCompleteness(const ColonoscopyResults & results, std::vector<Limitation> & list)
{
  if (IsOfMask(results.quality))
  {
    list.push_back({ "The input is a lumen mask without a CT: what lies under fluid or residue is not known, and a "
                     "candidate may be stool.",
                     {} });
  }
  for (const Json & part : MissingPartsOf(results))
  {
    list.push_back({ "Incomplete: " + part.get<std::string>() + ".", {} });
  }
  if (results.IsSinglePosition())
  {
    list.push_back(
      { "Incomplete: one position only; the other may show what is hidden here, and tells moving stool from polyps.",
        {} });
  }
}

/** "sigmoid 55 %, cecum 65 %" for the segments with a value of at least `least`; "" for none. */
template <typename TValue, typename TWords>
std::string
SegmentsWith(const ColonoscopyQuality & quality, double least, const TValue & value, const TWords & inWords)
{
  std::string list;
  for (const SegmentQuality & one : quality.segments)
  {
    if (value(one) >= least)
    {
      list += (list.empty() ? "" : ", ") + one.extent.name + ' ' + inWords(value(one));
    }
  }
  return list;
}

void
AddPreparation(const ColonoscopyQuality & quality, std::vector<Limitation> & list)
{
  constexpr double  muchFluid = 0.3;     // of the wall: our choice; a lumen that is filled to a third of its height
  constexpr double  leastResidue = 80.0; // mm^2: the base of a flat polyp of 10 mm
  const std::string wet = SegmentsWith(
    quality, muchFluid, [](const SegmentQuality & one) { return one.submergedShare; }, WholePercent);
  const std::string dirty = SegmentsWith(
    quality, leastResidue, [](const SegmentQuality & one) { return one.residueArea; }, SquareCentimeters);
  if (!wet.empty())
  {
    list.push_back(
      { "Wall under tagged fluid, where unfolded and 3-D views show polyps only after electronic cleansing; look for "
        "filling defects in the CT: " +
          wet + '.',
        {} });
  }
  if (!dirty.empty())
  {
    list.push_back({ "Wall coated by tagged residue, which may cover flat polyps (cm^2): " + dirty + '.', {} });
  }
}

void
AddHiddenOnMap(const ColonoscopyQuality & quality, const StretchPlaces & places, std::vector<Limitation> & list)
{
  HiddenWall largest;
  double     area = 0.0;
  int        parts = 0;
  for (const SegmentQuality & one : quality.segments)
  {
    largest = one.largestHidden.area > largest.area ? one.largestHidden : largest;
    area += one.hiddenArea;
    parts += one.hiddenParts;
  }
  if (parts > 0)
  {
    constexpr double  leastShown = 5.0; // mm^2: smaller areas are rounded to 0.0 cm^2
    const std::string where = SegmentsWith(
      quality, leastShown, [](const SegmentQuality & one) { return one.hiddenArea; }, SquareCentimeters);
    list.push_back({ "Wall not shown on the flat map: " + SquareCentimeters(area) + " cm^2 in " +
                       std::to_string(parts) + (parts == 1 ? " place" : " places") + " (" + where +
                       "); see slices and endoluminal views. The largest has " + SquareCentimeters(largest.area) +
                       " cm^2" + places.SliceAt(largest.place) + '.',
                     largest.place });
  }
}

void
AddLandmarks(const ColonoscopyResults & results, std::vector<Limitation> & list)
{
  constexpr double uncertain = 0.5; // probability of an error below 30 mm
  if (!results.IsDone(colonoscopystage::landmarks))
  {
    return;
  }
  for (const Json & flexure : results.landmarks.value("flexures", Json::array()))
  {
    const std::string name = Heading(flexure.at("name").get<std::string>() + " flexure");
    if (!flexure.at("found").get<bool>())
    {
      list.push_back({ name + "not found; the names of the segments beside it are unknown.", {} });
    }
    else if (const double confidence = flexure.value("confidence", 1.0); confidence < uncertain)
    {
      list.push_back({ name + "uncertain (confidence " + ProbabilityInWords(confidence) +
                         "); the border of the segments beside it may be wrong.",
                       PlaceInJson(flexure.at("position")) });
    }
  }
  if (results.quality.contains("ileocecalValve") && !results.quality["ileocecalValve"].at("found").get<bool>())
  {
    list.push_back({ "Ileocecal valve: not found; check that the line reaches the cecum.", {} });
  }
}

void
AddCatheter(const ColonoscopyResults & results, const StretchPlaces & places, std::vector<Limitation> & list)
{
  const Json catheter = results.quality.value("/lumen/catheter"_json_pointer, Json::object());
  if (!catheter.value("found", false))
  {
    return;
  }
  const double          balloon = catheter.value("balloonDiameter", 0.0);
  const Eigen::Vector3d tip = PlaceInJson(catheter.at("to"));
  list.push_back({ "Rectum: a catheter of " + WholeMillimeters(catheter.at("outerDiameter").get<double>()) +
                     (balloon > 0.0 ? " with a balloon of " + WholeMillimeters(balloon) : "") +
                     " hides wall up to its tip" + places.SliceAt(tip) + ".",
                   tip });
}

/** Statements of the series about its own values. */
void
AddSeries(const Json & series, const Json & quality, std::vector<Limitation> & list)
{
  if (series.value("derived", false))
  {
    const std::string outside = OutsideReferences(quality);
    list.push_back(
      { "The images are derived, not original (Image Type): HU, sizes, lengths and volumes on all pages may be "
        "approximate." +
          (outside.empty() ? ""
                           : " In fact, " + outside +
                               " contradict the reference ranges: if the spacing is wrong, so are all "
                               "sizes, and which polyps are evaluable. Check a length that you know."),
        {} });
  }
  if (series.value("lossy", false))
  {
    list.push_back({ "The images were compressed with loss: HU are approximate.", {} });
  }
}

/** A stretch of the line, mm. */
using LineStretch = std::pair<double, double>;

/** Joins values along the line into stretches; steps between values of up to `step` mm are bridged. */
std::vector<LineStretch>
StretchesOf(std::vector<double> values, double step)
{
  std::sort(values.begin(), values.end());
  std::vector<LineStretch> stretches;
  for (const double value : values)
  {
    if (stretches.empty() || value > stretches.back().second + step)
    {
      stretches.emplace_back(value, value);
    }
    stretches.back().second = value;
  }
  return stretches;
}

/** "sigmoid 28.4 to 29.3 cm, descending 60.0 to 61.0 cm". */
std::string
StretchesInWords(const std::vector<LineStretch> & stretches, const ColonoscopyResults & results)
{
  std::string text;
  for (const auto & [begin, end] : stretches)
  {
    const ColonSegmentExtent * const segment = FindSegment(results.segments, 0.5 * (begin + end));
    text += (text.empty() ? "" : ", ") + (segment ? segment->name + ' ' : "") + NumberOfCentimeters(begin) + " to " +
            Centimeters(end);
  }
  return text;
}

/** Adds interpolated wall where the lumen is too narrow for the centerline. Stretches without lumen are listed
 * elsewhere. */
void
AddInterpolatedWall(const ColonoscopyResults & results, const StretchPlaces & places, std::vector<Limitation> & list)
{
  constexpr double           step = 5.0; // mm, more than an edge of the flat wall
  const SurfaceArray * const bridged =
    results.flat ? FindSurfaceArray(results.flat->Surface().cellArrays, "bridged") : nullptr;
  const SurfaceArray * const arc =
    results.flat ? FindSurfaceArray(results.flat->Surface().pointArrays, "arcLength") : nullptr;
  std::vector<double> values;
  for (Eigen::Index face = 0; bridged && arc && face < bridged->values.rows(); ++face)
  {
    if (bridged->values(face, 0) != 0.0)
    {
      const auto corners = results.flat->Surface().F.row(face);
      values.push_back((arc->values(corners[0], 0) + arc->values(corners[1], 0) + arc->values(corners[2], 0)) / 3.0);
    }
  }
  std::vector<LineStretch> stretches = StretchesOf(values, step);
  for (const HinderedStretch & known : FindHinderedStretches(results.centerline))
  {
    if (known.hindrance == ColonHindrance::NoLumen)
    {
      stretches.erase(std::remove_if(stretches.begin(),
                                     stretches.end(),
                                     [&](const LineStretch & one) {
                                       return one.first < known.end + step && known.begin - step < one.second;
                                     }),
                      stretches.end());
    }
  }
  if (!stretches.empty())
  {
    list.push_back({ "Interpolated wall where the lumen is too narrow to follow: " +
                       StretchesInWords(stretches, results) + ". It is hatched in gray on the unfolded view.",
                     places.PlaceAt(0.5 * (stretches.front().first + stretches.front().second)) });
  }
}

/** Stretches that the map between the positions excludes. */
void
AddLeftOutOfMap(const ColonoscopyResults & results, std::vector<Limitation> & list)
{
  constexpr double           step = 5.0, least = 10.0; // mm
  const SurfaceMesh &        map = results.pair->registration.supineToProne;
  const SurfaceArray * const arc = FindSurfaceArray(map.pointArrays, "arcLength");
  const SurfaceArray * const excluded = FindSurfaceArray(map.pointArrays, "excluded");
  std::vector<double>        values;
  for (Eigen::Index i = 0; arc && excluded && i < arc->values.rows(); ++i)
  {
    if (excluded->values(i, 0) != 0.0)
    {
      values.push_back(arc->values(i, 0));
    }
  }
  std::vector<LineStretch> stretches = StretchesOf(values, step);
  stretches.erase(std::remove_if(stretches.begin(),
                                 stretches.end(),
                                 [](const LineStretch & one) { return one.second - one.first < least; }),
                  stretches.end());
  if (!stretches.empty())
  {
    list.push_back({ "No correspondence between the positions, because one of them is collapsed, narrow or outside of "
                     "the scan there: " +
                       StretchesInWords(stretches, results) + ". Find these places in the other position by eye.",
                     {} });
  }
}

void
AddDoubts(const ColonoscopyResults & results, const StretchPlaces & places, std::vector<Limitation> & list)
{
  if (results.pair)
  {
    AddLeftOutOfMap(results, list);
  }
  if (results.pair && results.pair->registration.document.at("confidence").at("flagged").get<bool>())
  {
    list.push_back({ "Registration of the positions: doubtful; do not rely on places in the other position.", {} });
  }
  const Json merges = results.quality.value("centerline", Json::object()).value("merges", Json::array());
  if (!merges.empty())
  {
    const Eigen::Vector3d place = PlaceInJson(merges.front().at("place"));
    list.push_back(
      { "Loops of the colon touch at " + std::to_string(merges.size()) + (merges.size() == 1 ? " place" : " places") +
          "; no wall between them is resolved there: check that the course does not jump. The widest is at " +
          PlaceInWords(place) + places.SliceAt(place) + ".",
        place });
  }
}
} // namespace

std::vector<Limitation>
LimitationsOf(const ColonoscopyResults & results, const ColonoscopyQuality & quality)
{
  std::vector<Limitation> list;
  AddCompleteness(results, list);
  AddSeries(SeriesRead(results.inspection, results.quality), results.quality, list);
  if (results.centerline.curves.empty())
  {
    return list;
  }
  const StretchPlaces places(results);
  AddHiddenStretches(results, quality, places, list);
  AddInterpolatedWall(results, places, list);
  if (const double below = NotAssessableBelow(results.centerline); below > 0.0)
  {
    list.push_back({ "The whole colon is " + NotAssessableInWords(below) + " at this resolution.", {} });
  }
  AddHiddenOnMap(quality, places, list);
  AddPreparation(quality, list);
  AddCatheter(results, places, list);
  AddLandmarks(results, list);
  AddDoubts(results, places, list);
  return list;
}

std::string
ReasonForInadequate(const ColonoscopyResults & results, const ColonoscopyQuality & quality)
{
  std::string reasons;
  const auto  add = [&](const std::string & reason) { reasons += (reasons.empty() ? "" : "; ") + reason; };
  if (results.IsSinglePosition())
  {
    add("one position only, unless another one is read elsewhere");
  }
  for (const Json & part : MissingPartsOf(results))
  {
    add(part.get<std::string>());
  }
  for (std::size_t i = 0; i < quality.segments.size(); ++i)
  {
    const SegmentQuality &     one = quality.segments[i];
    const ColonAssessability & best = quality.either.empty() ? one.assessability : quality.either[i];
    if (best.Verdict() == "notAssessable")
    {
      add("only " + WholePercent(best.share) + " of the " + one.extent.name + " is evaluable");
    }
  }
  return reasons;
}

std::string
NoteOfInadequate(const ColonoscopyResults & results, const ColonoscopyQuality & quality)
{
  const std::string reason = ReasonForInadequate(results, quality);
  return reason.empty() ? "" : "Consider category C0 (inadequate examination): " + reason + ".";
}

Json
LimitationsToJson(const ColonoscopyResults & results, const ColonoscopyQuality & quality)
{
  Json json;
  json["note"] = ReadableText(NoteOfInadequate(results, quality));
  json["limitations"] = Json::array();
  for (const Limitation & one : LimitationsOf(results, quality))
  {
    json["limitations"].push_back(ReadableText(one.text));
  }
  return json;
}
} // namespace shapeton
