#include "shapetonColonoscopyFacts.h"

#include "shapetonColonAssessability.h"
#include "shapetonColonFigures.h"
#include "shapetonColonFlexures.h"
#include "shapetonColonoscopyPictures.h"
#include "shapetonCsvTable.h"
#include "shapetonJson.h"

#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** A number in a document, or NaN. */
double
NumberOrNaN(const Json & document, const char * pointer)
{
  const Json::json_pointer place(pointer);
  return document.contains(place) && document[place].is_number() ? document[place].get<double>()
                                                                 : std::numeric_limits<double>::quiet_NaN();
}

/** "at 228 cm, confidence .97", or the reason why it is missing; and the candidates that may be the valve. */
std::string
ValveInWords(const Json & valve, const std::vector<PolypCandidate> & polyps)
{
  std::string alternatives;
  for (const PolypCandidate & polyp : polyps)
  {
    if (polyp.remark.find(MayBeTheValve) != std::string::npos)
    {
      alternatives += (alternatives.empty() ? "; may be candidate " : ", ") + std::to_string(polyp.number);
    }
  }
  return (valve.at("found").get<bool>()
            ? "at " + Centimeters(NumberOrNaN(valve, "/arcLength")) + " from the anal verge, confidence " +
                ProbabilityInWords(NumberOrNaN(valve, "/confidence"))
            : "not found: " + valve.at("reason").get<std::string>()) +
         alternatives;
}

/** "prone", or "unknown". */
std::string
NameOfPosition(const Json & quality)
{
  const std::string position = quality.value("/lumen/position"_json_pointer, std::string());
  return position.empty() ? "unknown" : position;
}

std::string
PositionInWords(const ColonoscopyResults & results)
{
  const std::string position = NameOfPosition(results.quality);
  return results.isSecond ? position + "; read it with the first series (../report.html)"
         : results.pair
           ? position + " and " + NameOfPosition(results.qualityOfSecond) + ", registered; this page is on the " +
               position + " one, " + secondPositionFolder + "/report.html on the other"
           : position + "; one position only, so the examination is incomplete";
}

/** Number and description of the series. */
std::string
SeriesInWords(const ColonoscopyResults & results)
{
  const Json series = SeriesRead(results.inspection, results.quality);
  const Json number = series.value("seriesNumber", Json());
  return (number.is_number() ? std::to_string(number.get<int>()) + ": " : "") +
         series.value("description", std::string());
}

/** "complete", perhaps with a part outside the scan, or the missing parts. */
std::string
CompletenessInWords(const Json & quality)
{
  const Json  assessability = quality.value("assessability", Json::object());
  std::string missing;
  for (const Json & part : quality.value("missing", Json::array()))
  {
    missing += (missing.empty() ? "incomplete: " : "; ") + part.get<std::string>();
  }
  for (const Json & reason : assessability.value("/whole/reasons"_json_pointer, Json::array()))
  {
    if (reason.at("reason") == NameOf(ColonHindrance::CutByScan))
    {
      missing = (missing.empty() ? "followed from rectum to cecum" : missing) + ", except " +
                Centimeters(reason.at("length").get<double>()) + " outside the field of view";
    }
  }
  return missing.empty() ? "followed from rectum to cecum" : missing;
}

/** Lengths of colons at CT colonography, mm: mean - 2 SD of 150.3 +- 18.5 cm (Utano et al., Jpn J Radiol 2022, 295
 * patients) to mean + 2 SD of 189.5 +- 26.3 cm (Khashab et al., Endoscopy 2009, 505 adults). */
constexpr double leastLength = 1133.0, greatestLength = 2421.0;

/** Volumes of gas at CT colonography, ml: mean - 2 SD of prone series, 1441 +- 505 ml, to mean + 2 SD of lateral
 * series, 1901 +- 627 ml (Pickhardt et al., AJR 2014, 146 adults, carbon dioxide). */
constexpr double leastGas = 431.0, greatestGas = 3155.0;

/** ", within the reference range 113.3 to 242.1 cm". */
std::string
BesideReference(double value, double least, double greatest, const std::string & range)
{
  return std::string(value < least      ? ", below"
                     : value > greatest ? ", above"
                                        : ", within") +
         " the reference range " + range;
}

void
AddVolumes(const Json & quality, ColonoscopyFacts & facts)
{
  const double gas = NumberOrNaN(quality, "/lumen/gasVolume");
  const double fluid = NumberOrNaN(quality, "/lumen/fluidVolume");
  if (IsOfMask(quality))
  {
    facts.emplace_back("Lumen", Milliliters(gas));
  }
  else if (std::isfinite(gas))
  {
    const std::string range = WholeNumber(leastGas) + " to " + Milliliters(greatestGas) + " (Pickhardt 2014)";
    facts.emplace_back("Gas",
                       Milliliters(gas) + BesideReference(gas, leastGas, greatestGas, range) + "; tagged fluid " +
                         Milliliters(fluid));
  }
}

bool
IsOfDerived(const ColonoscopyResults & results)
{
  return SeriesRead(results.inspection, results.quality).value("derived", false);
}

void
AddModelFacts(const ColonoscopyResults & results, ColonoscopyFacts & facts)
{
  const Json & quality = results.quality;
  if (IsOfMask(quality))
  {
    facts.emplace_back("Input",
                       "a lumen mask without a CT: fluid, residue and tissue are unknown; scores are of the shape");
  }
  if (quality.contains("missing"))
  {
    facts.emplace_back("Colon", CompletenessInWords(quality));
  }
  if (results.pair && results.qualityOfSecond.contains("missing"))
  {
    facts.emplace_back("Colon, " + NameOfPosition(results.qualityOfSecond),
                       CompletenessInWords(results.qualityOfSecond));
  }
  if (quality.contains("resolution"))
  {
    const bool isThicknessKnown = std::isfinite(NumberOrNaN(quality, "/resolution/sliceThickness"));
    facts.emplace_back("Voxels",
                       quality["resolution"].at("text").get<std::string>() +
                         (isThicknessKnown ? "" : ", if the slices are not thicker (thickness unknown)") +
                         (IsOfDerived(results) ? ", if the spacing of these derived images is right" : ""));
  }
  const double length = NumberOrNaN(quality, "/centerline/length");
  if (std::isfinite(length))
  {
    facts.emplace_back("Length",
                       Centimeters(length) +
                         BesideReference(length,
                                         leastLength,
                                         greatestLength,
                                         NumberOfCentimeters(leastLength) + " to " + Centimeters(greatestLength) +
                                           " (Utano 2022, Khashab 2009)"));
  }
  AddVolumes(quality, facts);
  if (quality.contains("ileocecalValve"))
  {
    facts.emplace_back("Ileocecal valve", ValveInWords(quality["ileocecalValve"], results.polyps));
  }
}

/** Fluid and residue of the whole colon. */
void
AddPreparation(const ColonoscopyQuality & quality, ColonoscopyFacts & facts)
{
  double area = 0.0, submerged = 0.0, residue = 0.0, untagged = 0.0;
  for (const SegmentQuality & one : quality.segments)
  {
    area += one.extent.area;
    submerged += one.extent.area * one.submergedShare;
    residue += one.residueArea;
    untagged += one.assessability.lengths.at(static_cast<std::size_t>(ColonHindrance::UntaggedFluid));
  }
  if (std::isfinite(submerged) && area > 0.0)
  {
    facts.emplace_back(
      "Preparation",
      WholePercent(submerged / area) + " of the wall under tagged fluid" +
        (std::isfinite(residue) ? ", " + SquareCentimeters(residue) + " cm^2 coated by tagged residue" : "") +
        (untagged > 0.0 ? ", untagged fluid along " + Centimeters(untagged) : ""));
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

} // namespace

std::string
OutsideReferences(const Json & quality)
{
  const double gas = IsOfMask(quality) ? NAN : NumberOrNaN(quality, "/lumen/gasVolume");
  const double length = NumberOrNaN(quality, "/centerline/length");
  const bool   isGasOutside = gas < leastGas || gas > greatestGas;
  const bool   isLengthOutside = length < leastLength || length > greatestLength;
  return (isGasOutside ? Milliliters(gas) + " of gas" : "") + (isGasOutside && isLengthOutside ? " and " : "") +
         (isLengthOutside ? Centimeters(length) + " of colon" : "");
}

std::string
EvaluableInWords(const Json & landmarks, int number)
{
  for (const Json & segment : landmarks.at("segments"))
  {
    if (segment.at("number").get<int>() != number || !segment.contains("verdict"))
    {
      continue;
    }
    const std::string verdict = segment["verdict"].get<std::string>();
    std::string       text = verdict == "assessable" ? "yes" : verdict == "partly" ? "in part" : "not evaluable";
    text += ", along " + WholePercent(NumberOrNaN(segment, "/assessableShare")) + " of the length";
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
  ColonoscopyFacts           facts;
  if (!content.failure.empty())
  {
    facts.emplace_back("Run", "partial: " + content.failure);
  }
  if (results.quality.is_null())
  {
    return facts;
  }
  facts.emplace_back("Position", PositionInWords(results));
  if (const std::string series = SeriesInWords(results); !series.empty())
  {
    facts.emplace_back("Series", series);
  }
  AddModelFacts(results, facts);
  AddPreparation(content.quality, facts);
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
  if (const double handles = NumberOrNaN(results.quality, "/resolution/handlesBeforeRepair"); std::isfinite(handles))
  {
    facts.emplace_back("Handles of the wall before the repair", WholeNumber(handles));
  }
  AddMapFacts(results.flatStatistics, facts);
  if (results.IsDone(colonoscopystage::folds))
  {
    facts.emplace_back("Haustral folds", FoldsInWords(results));
  }
  if (results.IsDone(colonoscopystage::landmarks))
  {
    facts.emplace_back("Taeniae", TaeniaeInWords(results));
  }
  return facts;
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
                   WholeNumber(p[0].get<double>()) + ", " + WholeNumber(p[1].get<double>()) + ", " +
                     WholeNumber(p[2].get<double>()),
                   ProbabilityInWords(NumberOrNaN(flexure, "/confidence")),
                   flexure.contains("notAssessable")
                     ? "not evaluable: " + flexure["notAssessable"].at("words").get<std::string>()
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
                   ProbabilityInWords(MeanConfidence(results.taeniae, curve)) });
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
