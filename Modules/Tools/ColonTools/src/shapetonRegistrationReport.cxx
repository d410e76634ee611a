#include "shapetonRegistrationReport.h"

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
  const bool               hasTruth = !results.points.empty();
  std::vector<std::string> columns{ "Segment", "Confidence",   "Supine folds", "Prone folds",
                                    "Matched", "Contradicted", "Supine only",  "Prone only" };
  if (hasTruth)
  {
    columns.insert(columns.end(), { "Correct", "Wrong", "Not matched" });
  }
  CsvTable   table(columns);
  const auto add = [&](const SegmentMatches & row, const std::string & name) {
    std::vector<std::string> cells{ name, std::isfinite(row.confidence) ? CsvTable::Rounded(row.confidence, 2) : "" };
    for (const int number :
         { row.supineFolds, row.proneFolds, row.followed, row.contradicted, row.supineAlone, row.proneAlone })
    {
      cells.push_back(std::to_string(number));
    }
    if (hasTruth)
    {
      cells.insert(cells.end(),
                   { std::to_string(row.correct), std::to_string(row.wrong), std::to_string(row.unmatched) });
    }
    table.AddRow(cells);
  };
  SegmentMatches sum;
  for (const SegmentMatches & row : results.segments)
  {
    add(row, row.segment.empty() ? "not known" : row.segment);
    sum.supineFolds += row.supineFolds;
    sum.proneFolds += row.proneFolds;
    sum.followed += row.followed;
    sum.contradicted += row.contradicted;
    sum.supineAlone += row.supineAlone;
    sum.proneAlone += row.proneAlone;
    sum.correct += row.correct;
    sum.wrong += row.wrong;
    sum.unmatched += row.unmatched;
  }
  sum.confidence = std::nan("");
  add(sum, "all");
  return table;
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

RegistrationReport::RegistrationReport(CommandLine & commandLine, const std::string & folder)
  : m_CommandLine(commandLine), m_Folder(folder)
{
  if (!m_Folder.empty())
  {
    commandLine.MakeFolder(m_Folder);
  }
}

void
RegistrationReport::Write(const RegistrationParts & parts) const
{
  if (m_Folder.empty())
  {
    return;
  }
  HtmlReport html("A colon in two positions");
  html.AddHead(RegistrationFacts(parts), m_CommandLine.GetWarnings());
  html.AddHeading("Supine and prone");
  AddRegistrationSection(
    html, parts, [&](const Picture * picture, const std::string & name, const std::string & caption) {
      const std::string path = m_CommandLine.Output(m_Folder + '/' + name + ".png");
      WritePng(picture, path);
      html.AddPicture(path, caption);
    });
  html.AddHeading("Provenance");
  html.AddFacts(m_CommandLine.GetProvenance());
  html.Write(m_CommandLine.Output(m_Folder + "/index.html"));
}
} // namespace shapeton
