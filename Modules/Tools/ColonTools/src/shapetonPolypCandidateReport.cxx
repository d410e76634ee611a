#include "shapetonPolypCandidateReport.h"

#include "shapetonColonSegments.h"
#include "shapetonCommandLine.h"
#include "shapetonPolypCandidatePictures.h"
#include "shapetonScanResolution.h"

#include <cmath>

namespace shapeton
{
namespace
{
std::string
Cell(double value, int digits)
{
  return std::isfinite(value) ? CsvTable::Rounded(value, digits) : "";
}

std::string
OtherPosition(const PolypCandidate & candidate)
{
  if (!candidate.other)
  {
    return "";
  }
  const PolypInOtherPosition & other = *candidate.other;
  return other.isExcluded ? "not imaged"
         : other.isSeen   ? "candidate " + std::to_string(other.candidate) + ", " + Cell(other.distance, 2) + " mm away"
                          : "no candidate";
}

CsvTable
TableForReaders(const std::vector<PolypCandidate> & candidates)
{
  CsvTable         table({ "Candidate",
                           "Score",
                           "Segment",
                           "From the anal verge (cm)",
                           "Largest diameter (mm)",
                           "Size",
                           "Height (mm)",
                           "HU inside",
                           "Inside",
                           "Other position",
                           "Remark" });
  constexpr double millimetersPerCm = 10.0;
  for (const PolypCandidate & one : candidates)
  {
    table.AddRow({ std::to_string(one.number),
                   CsvTable::Rounded(one.score, 2),
                   NameOfSegment(one.segment),
                   Cell(one.arcLength / millimetersPerCm, 4),
                   Cell(one.diameter, 3),
                   NameOf(SizeOf(one.diameter)),
                   Cell(one.height, 2),
                   Cell(one.attenuation, 3),
                   NameOf(one.tissue),
                   OtherPosition(one),
                   one.remark });
  }
  return table;
}

} // namespace

void
AddPolypCandidateTable(HtmlReport & report, const CurveSet & centerline, const std::vector<PolypCandidate> & candidates)
{
  report.AddHeading("Polyp candidates");
  report.AddNote("For research use; not a diagnosis. A candidate is a location shaped like a polyp. It may be "
                 "stool, the ileocecal valve or the end of a fold, and the list may miss polyps.");
  if (const double below = NotAssessableBelow(centerline); below > 0.0)
  {
    report.AddParagraph("At the resolution of this scan, the colon is " + NotAssessableInWords(below) +
                        ": such polyps are often missing.");
  }
  if (candidates.empty())
  {
    report.AddParagraph("No candidates at this sensitivity.");
    return;
  }
  report.AddTable(TableForReaders(candidates), "Candidates by decreasing score");
  report.AddParagraph("Category implied by the candidates: " + CategoryImplied(candidates) + ".");
}

std::string
CaptionOfPolypPicture(int candidate)
{
  return candidate == 0 ? "Candidates on the flat colon"
                        : "Candidate " + std::to_string(candidate) +
                            ": on the flat map at four times the resolution, and from the centerline";
}

void
AddPolypCandidateSection(HtmlReport &                        report,
                         const PolypColon &                  colon,
                         const std::vector<PolypCandidate> & candidates,
                         const std::string &                 folder,
                         const OutputPath &                  outputPath)
{
  AddPolypCandidateTable(report, colon.centerline, candidates);
  if (candidates.empty() || !colon.flat)
  {
    return;
  }
  const PolypCandidatePictures pictures(colon, candidates);
  std::vector<PictureFile>     files{ { outputPath(folder + "/polyp-candidates-flat.png"),
                                        [&] { return pictures.DrawFlatColon(); } } };
  for (const PolypCandidate & one : candidates)
  {
    files.push_back({ outputPath(folder + "/polyp-candidate-" + std::to_string(one.number) + ".png"),
                      [&pictures, &one] { return pictures.DrawCandidate(one); } });
  }
  WritePngs(files);
  report.AddPicture(files[0].path, CaptionOfPolypPicture(0));
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    report.AddPicture(files[i + 1].path, CaptionOfPolypPicture(candidates[i].number));
  }
}

void
WritePolypCandidateReport(CommandLine &                       commandLine,
                          const PolypColon &                  colon,
                          const std::vector<PolypCandidate> & candidates,
                          const std::string &                 folder)
{
  if (folder.empty())
  {
    return;
  }
  HtmlReport report("Polyp candidates of a colon");
  report.AddHead({ { "Candidates", std::to_string(candidates.size()) } }, commandLine.GetWarnings());
  AddPolypCandidateSection(
    report, colon, candidates, folder, [&](const std::string & path) { return commandLine.Output(path); });
  report.AddHeading("Provenance");
  report.AddFacts(commandLine.GetProvenance());
  report.Write(commandLine.Output(folder + "/index.html"));
}
} // namespace shapeton
