#include "shapetonColonoscopyFacts.h"

#include "shapetonColonFlexures.h"
#include "shapetonColonoscopyPictures.h"
#include "shapetonCsvTable.h"
#include "shapetonJson.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Significant digits of lengths and areas, which are rounded to mm and cm^2. */
constexpr int digitsOfSize = 5;

std::string
Centimeters(double mm)
{
  constexpr double millimetersPerCm = 10.0;
  return CsvTable::Rounded(std::round(mm) / millimetersPerCm, digitsOfSize) + " cm";
}

/** A part is never rounded to all or nothing. */
std::string
WholePercent(double share)
{
  constexpr double hundred = 100.0;
  const double     whole = std::round(hundred * share);
  return share < 0.0                       ? ""
         : whole == hundred && share < 1.0 ? "> 99 %"
         : whole == 0.0 && share > 0.0     ? "< 1 %"
                                           : CsvTable::Rounded(whole, 3) + " %";
}

/** A number of a document, or NaN. */
double
NumberOrNaN(const Json & document, const char * pointer)
{
  const Json::json_pointer place(pointer);
  return document.contains(place) && document[place].is_number() ? document[place].get<double>()
                                                                 : std::numeric_limits<double>::quiet_NaN();
}

/** "at 228 cm, confidence .97", or the reason why it is missing. */
std::string
ValveInWords(const Json & valve)
{
  return valve.at("found").get<bool>()
           ? "at " + Centimeters(NumberOrNaN(valve, "/arcLength")) + " from the anal verge, confidence " +
               CsvTable::Rounded(NumberOrNaN(valve, "/confidence"), 2)
           : "not found: " + valve.at("reason").get<std::string>();
}

/** With the handles that it causes. */
std::string
ResolutionInWords(const Json & resolution)
{
  const std::string text = resolution.at("text").get<std::string>();
  return resolution.contains("handlesBeforeRepair")
           ? text + "; " + std::to_string(resolution["handlesBeforeRepair"].get<int>()) +
               " handles of the wall before the repair"
           : text;
}

void
AddModelFacts(const Json & quality, ColonoscopyFacts & facts)
{
  if (quality.contains("missing"))
  {
    std::string missing;
    for (const Json & part : quality["missing"])
    {
      missing += (missing.empty() ? "incomplete: " : "; ") + part.get<std::string>();
    }
    facts.emplace_back("Colon", missing.empty() ? "complete" : missing);
  }
  if (quality.contains("resolution"))
  {
    facts.emplace_back("Resolution", ResolutionInWords(quality["resolution"]));
  }
  const double gas = NumberOrNaN(quality, "/lumen/gasVolume");
  const double fluid = NumberOrNaN(quality, "/lumen/fluidVolume");
  if (std::isfinite(gas))
  {
    facts.emplace_back(
      "Lumen", CsvTable::Rounded(gas, 4) + " ml of gas, " + CsvTable::Rounded(fluid, 4) + " ml of tagged fluid");
  }
  const double length = NumberOrNaN(quality, "/centerline/length");
  if (std::isfinite(length))
  {
    facts.emplace_back("Length of the centerline", Centimeters(length));
    facts.emplace_back("Distended (caliber of at least 10 mm)",
                       WholePercent(NumberOrNaN(quality, "/distension/whole/share")) + " of it");
    facts.emplace_back("Bridged gaps", std::to_string(quality["centerline"]["gaps"].size()));
    if (const double share = NumberOrNaN(quality, "/assessability/whole/assessableShare"); std::isfinite(share))
    {
      facts.emplace_back("Assessable (the wall is visible)", WholePercent(share) + " of it");
    }
  }
  if (quality.contains("ileocecalValve"))
  {
    facts.emplace_back("Ileocecal valve", ValveInWords(quality["ileocecalValve"]));
  }
}

void
AddMapFacts(const Json & statistics, ColonoscopyFacts & facts)
{
  const double circumference = NumberOrNaN(statistics, "/circumference");
  if (std::isfinite(circumference))
  {
    facts.emplace_back("Flat map",
                       Centimeters(NumberOrNaN(statistics, "/length")) + " by " + Centimeters(circumference) +
                         ", gap of the conformal moduli " + WholePercent(NumberOrNaN(statistics, "/modulusGap")));
  }
}

/** Value of a curve in a cell array. */
double
CellValue(const CurveSet & curves, const char * array, std::size_t curve)
{
  const SurfaceArray * const found = FindSurfaceArray(curves.cellArrays, array);
  return found ? found->values(static_cast<Eigen::Index>(curve), 0) : std::numeric_limits<double>::quiet_NaN();
}

std::string
NumberOrNothing(double value, int digits)
{
  return std::isfinite(value) ? CsvTable::Rounded(value, digits) : "";
}

int
FoldsBetween(const ColonoscopyResults & results, double begin, double end)
{
  return static_cast<int>(std::count_if(results.folds.begin(), results.folds.end(), [&](const ColonoscopyFold & fold) {
    return fold.arcLength >= begin && fold.arcLength < end;
  }));
}

double
LengthOf(const CurveSet & curves, std::size_t curve)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curves.curves[curve].size(); ++i)
  {
    length += (curves.V.row(curves.curves[curve][i]) - curves.V.row(curves.curves[curve][i - 1])).norm();
  }
  return length;
}

double
MeanConfidence(const CurveSet & curves, std::size_t curve)
{
  const SurfaceArray * const confidence = FindSurfaceArray(curves.pointArrays, "confidence");
  double                     sum = 0.0;
  for (const int vertex : curves.curves[curve])
  {
    sum += confidence ? confidence->values(vertex, 0) : std::numeric_limits<double>::quiet_NaN();
  }
  return sum / static_cast<double>(curves.curves[curve].size());
}

/** Number of taeniae, their method, and how far the result of the other method differs. */
std::string
TaeniaeInWords(const ColonoscopyResults & results)
{
  const Json & taeniae = results.landmarks.at("taeniae");
  std::string  text = std::to_string(results.taeniae.curves.size()) + " of 3 found";
  if (taeniae.contains("kept"))
  {
    text += ", method " + taeniae["kept"].get<std::string>();
  }
  const double disagreement = NumberOrNaN(taeniae, "/meanDisagreement");
  if (std::isfinite(disagreement))
  {
    text += "; the other method differs by " + CsvTable::Rounded(disagreement, 2) +
            " mm on average, by more than 10 mm along " + WholePercent(NumberOrNaN(taeniae, "/disagreeingShare")) +
            " of the colon";
  }
  return text;
}

/** Number of folds, and their density: thick slices add false folds. */
std::string
FoldsInWords(const ColonoscopyResults & results)
{
  constexpr double  stretch = 100.0; // mm
  const double      length = NumberOrNaN(results.quality, "/centerline/length");
  const std::string number = std::to_string(results.folds.size());
  return length > 0.0
           ? number + ", " + CsvTable::Rounded(stretch * static_cast<double>(results.folds.size()) / length, 2) +
               " per " + Centimeters(stretch)
           : number;
}

long
NumberOfFlexures(const Json & landmarks)
{
  const Json & flexures = landmarks.at("flexures");
  return std::count_if(
    flexures.begin(), flexures.end(), [](const Json & flexure) { return flexure.at("found").get<bool>(); });
}
} // namespace

std::string
AssessableInWords(const Json & landmarks, int number)
{
  for (const Json & segment : landmarks.at("segments"))
  {
    if (segment.at("number").get<int>() != number || !segment.contains("verdict"))
    {
      continue;
    }
    const std::string verdict = segment["verdict"].get<std::string>();
    std::string       text = verdict == "assessable" ? "yes" : verdict == "partly" ? "in part" : "not assessable";
    text += ", " + WholePercent(NumberOrNaN(segment, "/assessableShare"));
    for (const Json & reason : segment.at("reasons"))
    {
      text += "; " + Centimeters(NumberOrNaN(reason, "/length")) + " " + reason.at("words").get<std::string>();
    }
    return text;
  }
  return "";
}

ColonoscopyFacts
SummaryOf(const ColonoscopyReportContent & content)
{
  const ColonoscopyResults & results = *content.results;
  ColonoscopyFacts facts{ { "Run", content.failure.empty() ? "all stages finished" : "partial: " + content.failure } };
  AddModelFacts(results.quality, facts);
  if (results.IsDone(colonoscopystage::landmarks))
  {
    facts.emplace_back("Flexures", std::to_string(NumberOfFlexures(results.landmarks)) + " of 4 found");
  }
  if (results.IsDone(colonoscopystage::folds))
  {
    facts.emplace_back("Haustral folds", FoldsInWords(results));
  }
  if (results.IsDone(colonoscopystage::polyps))
  {
    facts.emplace_back("Polyp candidates", std::to_string(results.polyps.size()));
  }
  return facts;
}

ColonoscopyFacts
MethodFactsOf(const ColonoscopyReportContent & content)
{
  const ColonoscopyResults & results = *content.results;
  ColonoscopyFacts           facts;
  for (const auto & [key, value] : content.provenance)
  {
    if (key == "input.inputVolume")
    {
      facts.emplace_back("Input", value);
    }
  }
  AddMapFacts(results.flatStatistics, facts);
  if (results.IsDone(colonoscopystage::landmarks))
  {
    facts.emplace_back("Taeniae", TaeniaeInWords(results));
  }
  return facts;
}

CsvTable
SegmentTable(const ColonoscopyResults & results)
{
  CsvTable table({ "segment", "from", "to", "length", "wall, cm^2", "distended", "folds", "assessable" });
  const std::vector<ColonSegment> shares = ChartSegmentsOf(results);
  for (std::size_t i = 0; i < results.segments.size(); ++i)
  {
    const ColonSegmentExtent & segment = results.segments[i];
    table.AddRow({ segment.name,
                   Centimeters(segment.begin),
                   Centimeters(segment.end),
                   Centimeters(segment.end - segment.begin),
                   CsvTable::Rounded(std::round(segment.area / 100.0), digitsOfSize),
                   WholePercent(shares[i].distendedShare),
                   results.IsDone(colonoscopystage::folds)
                     ? std::to_string(FoldsBetween(results, segment.begin, segment.end))
                     : "",
                   AssessableInWords(results.landmarks, segment.label) });
  }
  return table;
}

CsvTable
FlexureTable(const ColonoscopyResults & results)
{
  CsvTable table({ "flexure", "distance from the anal verge", "place, LPS mm", "confidence", "remark" });
  for (const Json & flexure : results.landmarks.at("flexures"))
  {
    const std::string name = flexure.at("name").get<std::string>();
    if (!flexure.at("found").get<bool>())
    {
      table.AddRow({ name, "not found: " + flexure.at("reason").get<std::string>(), "", "", "" });
      continue;
    }
    const Json & p = flexure.at("position");
    table.AddRow({ name,
                   Centimeters(NumberOrNaN(flexure, "/arcLength")),
                   CsvTable::Rounded(p[0].get<double>(), 4) + ", " + CsvTable::Rounded(p[1].get<double>(), 4) + ", " +
                     CsvTable::Rounded(p[2].get<double>(), 4),
                   NumberOrNothing(NumberOrNaN(flexure, "/confidence"), 2),
                   flexure.contains("notAssessable")
                     ? "not assessable: " + flexure["notAssessable"].at("words").get<std::string>()
                     : "" });
  }
  return table;
}

CsvTable
TaeniaTable(const ColonoscopyResults & results)
{
  CsvTable table({ "taenia", "length", "mean confidence" });
  for (std::size_t curve = 0; curve < results.taeniae.curves.size(); ++curve)
  {
    table.AddRow({ NumberOrNothing(CellValue(results.taeniae, "taenia", curve), 2),
                   Centimeters(LengthOf(results.taeniae, curve)),
                   NumberOrNothing(MeanConfidence(results.taeniae, curve), 2) });
  }
  return table;
}

CsvTable
StageTable(const ColonoscopyReportContent & content)
{
  CsvTable table({ "stage", "tool", "version", "result", "files" });
  for (const StageResult & stage : content.results->stages)
  {
    table.AddRow({ stage.name,
                   stage.program,
                   stage.version,
                   stage.status == 0 ? "done" : "failed: " + stage.message,
                   std::to_string(stage.files.size()) });
  }
  return table;
}
} // namespace shapeton
