#include "shapetonColonSegments.h"
#include "shapetonCsvFile.h"
#include "shapetonPolypSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace shapeton
{
namespace
{
/** Significant digits of lengths along the colon, coordinates, other measured values, and fractions. */
constexpr int distanceDigits = 5, coordinateDigits = 6, measureDigits = 4, shareDigits = 3;

std::string
Cell(double value, int digits = distanceDigits)
{
  return std::isfinite(value) ? CsvTable::Rounded(value, digits) : "";
}

/** Replaces a value by the one that is read back from its cell. */
void
RoundAsCell(double & value, int digits)
{
  value = std::isfinite(value) ? std::strtod(Cell(value, digits).c_str(), nullptr) : value;
}

void
AddPoint(const Eigen::Vector3d & point, std::vector<std::string> & cells)
{
  for (int k = 0; k < 3; ++k)
  {
    cells.push_back(Cell(point[k], coordinateDigits));
  }
}

void
AddOther(const std::optional<PolypInOtherPosition> & other, std::vector<std::string> & cells)
{
  if (!other)
  {
    cells.insert(cells.end(), 9, "");
    return;
  }
  cells.push_back(other->isExcluded ? "excluded" : other->isSeen ? "1" : "0");
  cells.push_back(other->candidate > 0 ? std::to_string(other->candidate) : "");
  cells.push_back(Cell(other->distance));
  AddPoint(other->point, cells);
  cells.push_back(Cell(other->confidence, shareDigits));
  cells.push_back(Cell(other->likeness, shareDigits));
  cells.push_back(Cell(other->ownScore, measureDigits));
}

/** The value of an enumeration, from 0 to `last`, that has this name; the first value if there is none. */
template <typename TEnum>
TEnum
Named(const std::string & name, TEnum last)
{
  int value = static_cast<int>(last);
  while (value > 0 && NameOf(static_cast<TEnum>(value)) != name)
  {
    --value;
  }
  return static_cast<TEnum>(value);
}

int
SegmentNamed(const std::string & name)
{
  int segment = 1;
  while (!NameOfSegment(segment).empty() && NameOfSegment(segment) != name)
  {
    ++segment;
  }
  return NameOfSegment(segment).empty() ? 0 : segment;
}

/** The row of a candidate. */
std::vector<std::string>
CellsOf(const PolypCandidate & one)
{
  std::vector<std::string> cells{ std::to_string(one.number),
                                  Cell(one.score, measureDigits),
                                  Cell(one.shapeScore, measureDigits) };
  AddPoint(one.position, cells);
  const PolypFeatures & features = one.features;
  for (const std::string & cell : { NameOfSegment(one.segment),
                                    Cell(one.arcLength),
                                    Cell(StatedSize(one.diameter), measureDigits),
                                    NameOf(SizeOf(one.diameter)),
                                    Cell(one.leastDiameter, measureDigits),
                                    Cell(one.height, measureDigits),
                                    Cell(StatedSize(one.planeDiameter), measureDigits),
                                    one.plane,
                                    NameOf(one.morphology),
                                    one.isOnFold ? std::string("1") : std::string("0"),
                                    Cell(one.attenuation, measureDigits),
                                    Cell(one.meanAttenuation, measureDigits),
                                    Cell(one.lowAttenuation, measureDigits),
                                    Cell(one.highAttenuation, measureDigits),
                                    Cell(one.uncleansedAttenuation, measureDigits),
                                    NameOf(one.tissue),
                                    Cell(one.submergedShare, shareDigits),
                                    Cell(one.filmShare, shareDigits),
                                    Cell(one.uv.x(), coordinateDigits),
                                    Cell(one.uv.y(), coordinateDigits),
                                    Cell(features.shapeIndex, measureDigits),
                                    Cell(features.roundness, measureDigits),
                                    Cell(features.hollowness, measureDigits),
                                    Cell(features.curvedness, measureDigits),
                                    Cell(features.solidAngle, measureDigits),
                                    Cell(features.prominence, measureDigits),
                                    Cell(features.heat, measureDigits),
                                    Cell(features.shapetonDensity, measureDigits) })
  {
    cells.push_back(cell);
  }
  AddOther(one.other, cells);
  cells.push_back(one.mainCandidate > 0 ? std::to_string(one.mainCandidate) : "");
  cells.push_back(NameOf(one.lookalike));
  cells.push_back(one.remark);
  return cells;
}

std::optional<PolypInOtherPosition>
ReadOther(const CsvFile & table, std::size_t row)
{
  const std::string & seen = table.Text(row, "seenInOther");
  if (seen.empty())
  {
    return std::nullopt;
  }
  PolypInOtherPosition other;
  other.isSeen = seen == "1";
  other.isExcluded = seen == "excluded";
  other.point = { table.NumberOrNothing(row, "otherX"),
                  table.NumberOrNothing(row, "otherY"),
                  table.NumberOrNothing(row, "otherZ") };
  other.confidence = table.NumberOrNothing(row, "otherConfidence");
  other.likeness = table.NumberOrNothing(row, "otherLikeness");
  other.ownScore = table.NumberOrNothing(row, "ownScore");
  if (!table.Text(row, "otherCandidate").empty())
  {
    other.candidate = static_cast<int>(table.Number(row, "otherCandidate"));
    other.distance = table.Number(row, "otherDistance");
  }
  return other;
}
/** "A" for 0, "Z" for 25, "AA" for 26. */
std::string
LetterOfLesion(std::size_t index)
{
  constexpr std::size_t letters = 26;
  const std::string     last(1, static_cast<char>('A' + index % letters));
  return index < letters ? last : LetterOfLesion(index / letters - 1) + last;
}
} // namespace

std::vector<PolypCandidate>
CandidatesAsWritten(std::vector<PolypCandidate> candidates)
{
  for (PolypCandidate & one : candidates)
  {
    one.diameter = StatedSize(one.diameter);
    one.planeDiameter = StatedSize(one.planeDiameter);
    for (double * const value : { &one.score,
                                  &one.height,
                                  &one.meanAttenuation,
                                  &one.lowAttenuation,
                                  &one.highAttenuation,
                                  &one.uncleansedAttenuation })
    {
      RoundAsCell(*value, measureDigits);
    }
    RoundAsCell(one.arcLength, distanceDigits);
    for (int k = 0; k < 3; ++k)
    {
      RoundAsCell(one.position[k], coordinateDigits);
    }
    if (one.other)
    {
      RoundAsCell(one.other->distance, distanceDigits);
      RoundAsCell(one.other->confidence, shareDigits);
      RoundAsCell(one.other->ownScore, measureDigits);
    }
  }
  return candidates;
}

CsvTable
TableOfPolypCandidates(const std::vector<PolypCandidate> & candidates)
{
  CsvTable table({ "candidate",
                   "score",
                   "shapeScore",
                   "x",
                   "y",
                   "z",
                   "segment",
                   "arcLength",
                   "diameter",
                   "size",
                   "leastDiameter",
                   "height",
                   "planeDiameter",
                   "plane",
                   "morphology",
                   "onFold",
                   "attenuation",
                   "meanAttenuation",
                   "lowAttenuation",
                   "highAttenuation",
                   "uncleansedAttenuation",
                   "tissue",
                   "submergedShare",
                   "filmShare",
                   "u",
                   "v",
                   "shapeIndex",
                   "roundness",
                   "hollowness",
                   "curvedness",
                   "solidAngle",
                   "prominence",
                   "heat",
                   "shapetonDensity",
                   "seenInOther",
                   "otherCandidate",
                   "otherDistance",
                   "otherX",
                   "otherY",
                   "otherZ",
                   "otherConfidence",
                   "otherLikeness",
                   "ownScore",
                   "mainCandidate",
                   "lookalike",
                   "remark" });
  for (const PolypCandidate & one : candidates)
  {
    table.AddRow(CellsOf(one));
  }
  return table;
}

std::vector<PolypCandidate>
ReadPolypCandidates(const std::string & path)
{
  const CsvFile               table(path, TableOfPolypCandidates({}).GetColumns());
  std::vector<PolypCandidate> candidates(table.Rows());
  for (std::size_t row = 0; row < table.Rows(); ++row)
  {
    PolypCandidate & one = candidates[row];
    one.number = static_cast<int>(table.Number(row, "candidate"));
    one.score = table.Number(row, "score");
    one.shapeScore = table.Number(row, "shapeScore");
    one.position = { table.Number(row, "x"), table.Number(row, "y"), table.Number(row, "z") };
    one.segment = SegmentNamed(table.Text(row, "segment"));
    one.arcLength = table.NumberOrNothing(row, "arcLength");
    one.diameter = table.Number(row, "diameter");
    one.leastDiameter = table.Number(row, "leastDiameter");
    one.height = table.Number(row, "height");
    one.planeDiameter = table.NumberOrNothing(row, "planeDiameter");
    one.plane = table.Text(row, "plane");
    one.morphology = Named(table.Text(row, "morphology"), PolypMorphology::Flat);
    one.isOnFold = table.Text(row, "onFold") == "1";
    one.attenuation = table.NumberOrNothing(row, "attenuation");
    one.meanAttenuation = table.NumberOrNothing(row, "meanAttenuation");
    one.lowAttenuation = table.NumberOrNothing(row, "lowAttenuation");
    one.highAttenuation = table.NumberOrNothing(row, "highAttenuation");
    one.tissue = Named(table.Text(row, "tissue"), PolypTissue::WithGas);
    one.uncleansedAttenuation = table.NumberOrNothing(row, "uncleansedAttenuation");
    one.submergedShare = table.NumberOrNothing(row, "submergedShare");
    one.filmShare = table.NumberOrNothing(row, "filmShare");
    one.uv = { table.NumberOrNothing(row, "u"), table.NumberOrNothing(row, "v") };
    one.other = ReadOther(table, row);
    one.mainCandidate =
      table.Text(row, "mainCandidate").empty() ? 0 : static_cast<int>(table.Number(row, "mainCandidate"));
    one.lookalike = Named(table.Text(row, "lookalike"), PolypLookalike::Tagged);
    one.remark = table.Text(row, "remark");
  }
  return candidates;
}

std::vector<OtherPolypCandidate>
ReadOtherPolypCandidates(const std::string & path)
{
  const CsvFile                    table(path, { "x", "y", "z" });
  const auto                       has = [&](const char * column) { return table.HasColumn(column); };
  std::vector<OtherPolypCandidate> others;
  for (std::size_t row = 0; row < table.Rows(); ++row)
  {
    OtherPolypCandidate other;
    other.number = has("candidate") ? static_cast<int>(table.Number(row, "candidate")) : static_cast<int>(row) + 1;
    other.position = { table.Number(row, "x"), table.Number(row, "y"), table.Number(row, "z") };
    other.diameter = has("diameter") ? table.NumberOrNothing(row, "diameter") : other.diameter;
    const bool isWeighed = has("ownScore") && std::isfinite(table.NumberOrNothing(row, "ownScore"));
    other.score = isWeighed ? table.Number(row, "ownScore") : has("score") ? table.Number(row, "score") : other.score;
    others.push_back(other);
  }
  return others;
}

std::vector<Markup>
MarkupsOfPolypCandidates(const std::vector<PolypCandidate> & candidates)
{
  if (candidates.empty())
  {
    return {};
  }
  constexpr std::array<double, 3> yellow{ 1.0, 0.85, 0.2 }; // red, green, blue; 0 to 1
  Markup                          markup;
  markup.name = "Polyp candidates (research use)";
  markup.color = yellow;
  for (const PolypCandidate & one : candidates)
  {
    markup.points.push_back(one.position);
    markup.labels.push_back(std::to_string(one.number));
    markup.descriptions.push_back("candidate, " + CsvTable::Rounded(one.diameter, 3) + " mm, score " +
                                  CsvTable::Rounded(one.score, 2));
  }
  return { markup };
}

bool
IsListedAsPolyp(const PolypCandidate & candidate)
{
  const bool isFragment = candidate.mainCandidate > 0 && candidate.mainCandidate != candidate.number;
  return candidate.lookalike == PolypLookalike::None && !isFragment;
}

std::string
RecognizedAs(const PolypCandidate & candidate)
{
  return IsListedAsPolyp(candidate)                    ? ""
         : candidate.lookalike == PolypLookalike::None ? "part of candidate " + std::to_string(candidate.mainCandidate)
                                                       : NameOf(candidate.lookalike);
}

bool
AreSameLesion(const PolypCandidate & first, const PolypCandidate & second)
{
  const auto isFoundAs = [](const PolypCandidate & one, const PolypCandidate & other) {
    return one.other && one.other->isSeen && one.other->candidate == other.number;
  };
  return isFoundAs(first, second) || isFoundAs(second, first);
}

std::vector<PolypLesion>
LesionsOfPositions(const std::vector<PolypCandidate> & first, const std::vector<PolypCandidate> & second)
{
  std::vector<PolypLesion> lesions;
  const auto               isFree = [&](int PolypLesion::*member, int number) {
    return std::none_of(
      lesions.begin(), lesions.end(), [&](const PolypLesion & lesion) { return lesion.*member == number; });
  };
  const auto add = [&](const PolypCandidate * one, const PolypCandidate * other) {
    PolypLesion lesion;
    lesion.letter = LetterOfLesion(lesions.size());
    lesion.first = one ? one->number : 0;
    lesion.second = other ? other->number : 0;
    lesion.size = StatedSize(std::max(one ? one->diameter : 0.0, other ? other->diameter : 0.0));
    lesion.score = std::max(one ? one->score : 0.0, other ? other->score : 0.0);
    lesion.isDisputed = one && other && IsListedAsPolyp(*one) != IsListedAsPolyp(*other);
    lesions.push_back(lesion);
  };
  for (const PolypCandidate & one : first)
  {
    if (IsListedAsPolyp(one))
    {
      const auto other = std::find_if(second.begin(), second.end(), [&](const PolypCandidate & candidate) {
        return AreSameLesion(one, candidate) && isFree(&PolypLesion::second, candidate.number);
      });
      add(&one, other == second.end() ? nullptr : &*other);
    }
  }
  for (const PolypCandidate & one : second)
  {
    if (IsListedAsPolyp(one) && isFree(&PolypLesion::second, one.number))
    {
      const auto other = std::find_if(first.begin(), first.end(), [&](const PolypCandidate & candidate) {
        return AreSameLesion(candidate, one) && isFree(&PolypLesion::first, candidate.number);
      });
      add(other == first.end() ? nullptr : &*other, &one);
    }
  }
  return lesions;
}

std::string
SizesIfConfirmed(const std::vector<PolypCandidate> & first, const std::vector<PolypCandidate> & second)
{
  constexpr double   likely = 0.5; // score
  std::array<int, 4> all{}, probable{};
  for (const PolypLesion & lesion : LesionsOfPositions(first, second))
  {
    const auto size = static_cast<std::size_t>(std::min(SizeOf(lesion.size), PolypSize::From10));
    all[size] += lesion.isDisputed ? 0 : 1;
    probable[size] += !lesion.isDisputed && lesion.score >= likely ? 1 : 0;
  }
  const auto number = [&](PolypSize size, const std::string & range) {
    const auto i = static_cast<std::size_t>(size);
    return std::to_string(all[i]) + range + " (" + std::to_string(probable[i]) + " likely)";
  };
  return "If confirmed: " + number(PolypSize::From10, " of 10 mm and more") + ", " +
         number(PolypSize::From6To9, " of 6 to 9 mm");
}
} // namespace shapeton
