#include "shapetonRegistrationReport.h"

#include "shapetonReportTable.h"
#include "shapetonColonFigures.h"
#include "shapetonCommandLine.h"
#include "shapetonHtmlReport.h"
#include "shapetonJson.h"

#include <cmath>

namespace shapeton
{
namespace
{
using Facts = std::vector<std::pair<std::string, std::string>>;

/** Empty text for an unknown value. */
std::string
Rounded(const Json & value, int digits = 3)
{
  return value.is_number() ? CsvTable::Rounded(value.get<double>(), digits) : "";
}

std::string
Percent(const Json & share)
{
  return share.is_number() ? WholePercent(share.get<double>()) : "";
}

CsvTable
MatchTable(const RegistrationResults & results)
{
  std::vector<std::pair<std::string, int SegmentMatches::*>> counts{
    { "Supine folds", &SegmentMatches::supineFolds }, { "Prone folds", &SegmentMatches::proneFolds },
    { "Matched", &SegmentMatches::followed },         { "Contradicted", &SegmentMatches::contradicted },
    { "Supine only", &SegmentMatches::supineAlone },  { "Prone only", &SegmentMatches::proneAlone }
  };
  if (!results.points.empty()) // known points
  {
    counts.insert(counts.end(),
                  { { "Correct", &SegmentMatches::correct },
                    { "Wrong", &SegmentMatches::wrong },
                    { "Not matched", &SegmentMatches::unmatched } });
  }
  std::vector<TableColumn<SegmentMatches>> columns{
    { "Segment", [](const SegmentMatches & row) { return row.segment.empty() ? "not known" : row.segment; } },
    { "Confidence",
      [](const SegmentMatches & row) {
        return std::isfinite(row.confidence) ? CsvTable::Rounded(row.confidence, 2) : "";
      } }
  };
  SegmentMatches all;
  all.segment = "all";
  all.confidence = std::nan("");
  for (const auto & [heading, count] : counts)
  {
    columns.push_back(
      { heading, [number = count](const SegmentMatches & row) { return std::to_string(row.*number); } });
    for (const SegmentMatches & row : results.segments)
    {
      all.*count += row.*count;
    }
  }
  std::vector<SegmentMatches> rows = results.segments;
  rows.push_back(all);
  return TableOf(rows, columns);
}

Facts
ErrorFacts(const Json & errors, const Json & document)
{
  return { { "Counted points",
             Rounded(errors["counted"], 9) + " (excluded: " + Rounded(errors["excluded"], 9) +
               " in excluded sections, " + Rounded(errors["offSurface"], 9) + " off the wall)" },
           { "Mean error in space (mm)",
             Rounded(errors["mean"]) + " +- " + Rounded(errors["halfInterval"], 2) + " (95 % interval)" },
           { "Median, 95th percentile (mm)", Rounded(errors["median"]) + ", " + Rounded(errors["percentile95"]) },
           { "Below 10 mm", Percent(errors["shareWithin10"]) },
           { "Mean error on the map (its width is 1)", Rounded(errors["meanOnMap"]) },
           { "Mean error of the initial frame, from flexures and taeniae only (mm)",
             Rounded(document["errorsOfFrame"]["mean"]) + ", " + Rounded(document["frameOverMap"], 2) +
               " times that of the map" } };
}

std::string
TaeniaeInWords(const Json & taeniae)
{
  const Json & numbers = taeniae["proneOfSupine"];
  if (!numbers.is_array())
  {
    return "not known which are the same in both positions";
  }
  return "1, 2, 3 of the supine position are " + Rounded(numbers[0], 9) + ", " + Rounded(numbers[1], 9) + ", " +
         Rounded(numbers[2], 9) + " of the prone position (along " + Percent(taeniae["probability"]) +
         " of the visible colon)";
}
} // namespace

Facts
RegistrationFacts(const RegistrationParts & parts)
{
  const Json & document = parts.results->document;
  const Json & matches = document["matches"];
  const Json & map = document["map"];
  Facts        facts{
    { "Confidence of the registration as a whole",
             Rounded(document["confidence"]["whole"], 2) +
               (document["confidence"]["flagged"].get<bool>() ? ", flagged as doubtful" : "") },
    { "Pairs of folds",
             Rounded(matches["followed"], 9) + " matched, " + Rounded(matches["contradicted"], 9) + " contradicted, of " +
               Rounded(matches["supineFolds"], 9) + " supine and " + Rounded(matches["proneFolds"], 9) + " prone folds" },
    { "Left out of the map (collapsed or narrow in a position)",
             Percent(map["excludedShareOfSupine"]) + " supine, " + Percent(map["excludedShareOfProne"]) + " prone" },
    { "Triangles turned over in the map", Rounded(map["flips"], 9) }
  };
  if (document.contains("taeniae"))
  {
    facts.emplace_back("Taeniae", TaeniaeInWords(document["taeniae"]));
  }
  if (document.contains("errors"))
  {
    facts.emplace_back("Mean error of known points (mm)", Rounded(document["errors"]["mean"]));
  }
  return facts;
}

void
AddRegistrationSection(HtmlReport &                 html,
                       const RegistrationParts &    parts,
                       const AddPictureToPage &     addPicture,
                       const AlignedColonsOptions & options)
{
  const Json & document = parts.results->document;
  for (const Json & reason : document["confidence"]["reasons"])
  {
    html.AddNote("The registration is doubtful: " + reason.get<std::string>() +
                 ". All of it may be wrong; do not rely on it.");
  }
  addPicture(DrawAlignedColons(parts, options),
             "aligned",
             "Both flat walls in paired rows, the prone one in the supine frame. Matched folds share a color.");
  html.AddTable(
    MatchTable(*parts.results),
    "Fold matches by segment. Matched: the map agrees; contradicted: the map disagrees. Prone folds are counted "
    "in the segment given by the prone landmarks." +
      std::string(
        parts.results->points.empty() ? "" : " Correct, wrong and not matched are determined by known points nearby."));
  addPicture(DrawConfidenceChart(parts),
             "confidence",
             "Confidence along the colon: mean (dark) and minimum (pale) around the tube; values below the dashed line "
             "are doubtful. "
             "Gray: excluded.");
  addPicture(DrawCurvatureCheckerboard(parts, options),
             "checkerboard",
             "The curvature of both walls in alternating squares; red bulges into the lumen.");
  if (document.contains("errors"))
  {
    html.AddFacts(ErrorFacts(document["errors"], document));
    addPicture(
      DrawErrorChart(parts), "errors", "Errors of the known points along the colon. The dashed line marks 10 mm.");
  }
}

void
WriteRegistrationReport(CommandLine & commandLine, const std::string & folder, const RegistrationParts & parts)
{
  if (folder.empty())
  {
    return;
  }
  HtmlReport html("A colon in two positions");
  html.AddHead(RegistrationFacts(parts), commandLine.GetWarnings());
  html.AddHeading("Supine and prone");
  AddRegistrationSection(
    html, parts, [&](const Picture * picture, const std::string & name, const std::string & caption) {
      const std::string path = commandLine.Output(folder + '/' + name + ".png");
      WritePng(picture, path);
      html.AddPicture(path, caption);
    });
  html.AddHeading("Provenance");
  html.AddFacts(commandLine.GetProvenance());
  html.Write(commandLine.Output(folder + "/index.html"));
}
} // namespace shapeton
