#include "shapetonRegistrationFolder.h"

#include "shapetonCsvFile.h"
#include "shapetonExaminationFiles.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonPolypSearch.h"
#include "shapetonSurfaceReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace shapeton
{
namespace
{
const std::vector<std::string> matchColumns{
  "supineFold",      "proneFold",      "sx",      "sy",   "sz",       "px",     "py",       "pz",
  "supineArcLength", "proneArcLength", "segment", "cost", "residual", "weight", "followed", "verdict"
};
const std::vector<std::string> pointColumns{ "sx", "sy", "sz", "px", "py", "pz" };
const std::vector<std::string> errorColumns{ "sx", "sy", "sz", "px", "py", "pz", "kind", "inSpace", "onMap" };

Eigen::Vector3d
PointOf(const CsvFile & file, std::size_t row, const std::string & prefix)
{
  return { file.Number(row, prefix + "x"), file.Number(row, prefix + "y"), file.Number(row, prefix + "z") };
}

/** Rounded to 0.001 (mm or fraction), the meaningful precision. Empty for NaN. */
std::string
Cell(double value)
{
  constexpr double parts = 1000.0; // per mm or fraction
  constexpr int    digits = 9;     // significant; keeps 0.001 of all values below 10^6
  return std::isfinite(value) ? CsvTable::Rounded(std::round(parts * value) / parts + 0.0, digits) : "";
}

std::vector<std::string>
CellsOf(const Eigen::Vector3d & supine, const Eigen::Vector3d & prone)
{
  std::vector<std::string> cells;
  for (const Eigen::Vector3d & point : { supine, prone })
  {
    for (int k = 0; k < 3; ++k)
    {
      cells.push_back(Cell(point[k]));
    }
  }
  return cells;
}

FoldVerdict
VerdictOf(const std::string & name)
{
  return name == "correct" ? FoldVerdict::Correct : name == "wrong" ? FoldVerdict::Wrong : FoldVerdict::Unknown;
}

std::vector<MatchedFolds>
ReadMatches(const std::string & path)
{
  const CsvFile             file(path, matchColumns);
  std::vector<MatchedFolds> matches;
  for (std::size_t row = 0; row < file.Rows(); ++row)
  {
    MatchedFolds match;
    match.supineFold = static_cast<int>(file.Number(row, "supineFold"));
    match.proneFold = static_cast<int>(file.Number(row, "proneFold"));
    match.supinePoint = PointOf(file, row, "s");
    match.pronePoint = PointOf(file, row, "p");
    match.supineArcLength = file.Number(row, "supineArcLength");
    match.proneArcLength = file.Number(row, "proneArcLength");
    match.segment = file.Text(row, "segment");
    match.cost = file.Number(row, "cost");
    match.residual = file.Number(row, "residual");
    match.weight = file.Number(row, "weight");
    match.verdict = VerdictOf(file.Text(row, "verdict"));
    matches.push_back(match);
  }
  return matches;
}

SurfaceMesh
ReadMap(const std::string & path)
{
  SurfaceMesh surface = ReadSurface(path).mesh;
  for (const auto & [name, columns] :
       { std::pair<const char *, int>("mapped", 3), { "mappedUv", 2 }, { "confidence", 1 }, { "excluded", 1 } })
  {
    const SurfaceArray * const array = FindSurfaceArray(surface.pointArrays, name);
    if (!array || array->values.cols() != columns)
    {
      throw InputError('"' + path + "\" has no point array " + name + "; use a file written by ColonRegistration");
    }
  }
  return surface;
}

void
ReadErrors(const std::string & path, RegistrationResults & results)
{
  const CsvFile file(path, errorColumns);
  for (std::size_t row = 0; row < file.Rows(); ++row)
  {
    const std::string & kind = file.Text(row, "kind");
    results.points.push_back({ PointOf(file, row, "s"), PointOf(file, row, "p") });
    results.errors.push_back({ kind == "counted"    ? PointError::Kind::Counted
                               : kind == "excluded" ? PointError::Kind::Excluded
                                                    : PointError::Kind::OffSurface,
                               file.NumberOrNothing(row, "inSpace"),
                               file.NumberOrNothing(row, "onMap") });
  }
}

/** NaN if the document lacks it. */
double
NumberAt(const Json & json, const char * key)
{
  return json.at(key).is_null() ? std::numeric_limits<double>::quiet_NaN() : json.at(key).get<double>();
}

std::vector<SegmentMatches>
SegmentsOfDocument(const Json & document, const std::string & path)
{
  std::vector<SegmentMatches> segments;
  try
  {
    for (const Json & one : document.at("segments"))
    {
      SegmentMatches row;
      row.segment = one.at("segment").is_null() ? "" : one["segment"].get<std::string>();
      row.confidence = NumberAt(one, "confidence");
      row.supineFolds = one.at("supineFolds").get<int>();
      row.proneFolds = one.at("proneFolds").get<int>();
      row.followed = one.at("followed").get<int>();
      row.contradicted = one.at("contradicted").get<int>();
      row.supineAlone = one.at("supineAlone").get<int>();
      row.proneAlone = one.at("proneAlone").get<int>();
      row.correct = one.value("correct", 0);
      row.wrong = one.value("wrong", 0);
      row.unmatched = one.value("unmatched", 0);
      segments.push_back(row);
    }
  }
  catch (const Json::exception & error)
  {
    throw InputError('"' + path + "\" is not a file written by ColonRegistration (" + error.what() + "); run it again");
  }
  return segments;
}
std::string
PathIn(const std::string & folder, const ExaminationFile & file)
{
  return folder + '/' + file.name;
}

double
ConfidenceIn(const Json & document, const std::string & path)
{
  const Json confidence = document.value("confidence", Json::object());
  if (!confidence.contains("whole") || !confidence["whole"].is_number() || !confidence.contains("flagged"))
  {
    throw InputError('"' + path + "\" contains no confidence; use a file written by ColonRegistration");
  }
  return confidence["flagged"] == true ? 0.0 : std::clamp(confidence["whole"].get<double>(), 0.0, 1.0);
}
} // namespace

CsvTable
TableOfMatches(const RegistrationResults & results)
{
  CsvTable table(matchColumns);
  for (const MatchedFolds & match : results.matches)
  {
    std::vector<std::string> cells{ std::to_string(match.supineFold), std::to_string(match.proneFold) };
    for (const std::string & cell : CellsOf(match.supinePoint, match.pronePoint))
    {
      cells.push_back(cell);
    }
    cells.push_back(Cell(match.supineArcLength));
    cells.push_back(Cell(match.proneArcLength));
    cells.push_back(match.segment);
    for (const double value : { match.cost, match.residual, match.weight })
    {
      cells.push_back(Cell(value));
    }
    cells.push_back(match.IsFollowed() ? "1" : "0");
    cells.push_back(NameOf(match.verdict));
    table.AddRow(cells);
  }
  return table;
}

CsvTable
TableOfErrors(const RegistrationResults & results)
{
  CsvTable table(errorColumns);
  for (std::size_t i = 0; i < results.points.size(); ++i)
  {
    const PointError &       error = results.errors[i];
    std::vector<std::string> cells = CellsOf(results.points[i].source, results.points[i].target);
    cells.push_back(error.kind == PointError::Kind::Counted    ? "counted"
                    : error.kind == PointError::Kind::Excluded ? "excluded"
                                                               : "offSurface");
    cells.push_back(Cell(error.inSpace));
    cells.push_back(std::isfinite(error.onMap) ? CsvTable::Rounded(error.onMap, 4) : "");
    table.AddRow(cells);
  }
  return table;
}

std::vector<PointPair>
ReadPointPairs(const std::string & path)
{
  const CsvFile          file(path, pointColumns);
  std::vector<PointPair> points;
  for (std::size_t row = 0; row < file.Rows(); ++row)
  {
    points.push_back({ PointOf(file, row, "s"), PointOf(file, row, "p") });
  }
  if (points.empty())
  {
    throw InputError('"' + path + "\" contains no points; each row must contain sx,sy,sz,px,py,pz (LPS, mm)");
  }
  return points;
}

RegistrationResults
ReadRegistrationResults(const std::string & folder)
{
  const std::string   document = PathIn(folder, examination::registration);
  const std::string   errors = PathIn(folder, examination::errors);
  RegistrationResults results;
  results.document = ReadJson(document);
  results.segments = SegmentsOfDocument(results.document, document);
  results.supineToProne = ReadMap(PathIn(folder, examination::supineToProne));
  results.proneToSupine = ReadMap(PathIn(folder, examination::proneToSupine));
  results.matches = ReadMatches(PathIn(folder, examination::matches));
  if (std::filesystem::exists(errors))
  {
    ReadErrors(errors, results);
  }
  return results;
}

double
ConfidenceOfRegistration(const std::string & folder)
{
  const std::string path = PathIn(folder, examination::registration);
  return ConfidenceIn(ReadJson(path), path);
}

std::optional<std::array<int, 3>>
TaeniaNumbersOfRegistration(const std::string & path)
{
  const Json document = ReadJson(path);
  if (ConfidenceIn(document, path) < LeastRegistrationConfidence || !document.contains("taeniae") ||
      !document["taeniae"]["proneOfSupine"].is_array())
  {
    return std::nullopt;
  }
  return document["taeniae"]["proneOfSupine"].get<std::array<int, 3>>();
}

std::optional<ValveSearch>
ValveOfRegistration(const std::string & folder, int position)
{
  const std::string path = PathIn(folder, examination::registration);
  const Json        document = ReadJson(path);
  if (ConfidenceIn(document, path) < LeastRegistrationConfidence || !document.contains("ileocecalValve"))
  {
    return std::nullopt;
  }
  return ValveFromJson(document["ileocecalValve"].value(position == 0 ? "supine" : "prone", Json()));
}
} // namespace shapeton
