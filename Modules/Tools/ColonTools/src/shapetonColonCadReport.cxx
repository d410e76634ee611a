#include "shapetonColonReportsAsDicom.h"

#include "shapetonColonTerms.h"
#include "shapetonNumberText.h"

#include <cmath>

namespace shapeton
{
namespace
{
using namespace colonterms;

const DicomCode notAttempted{ "111225", "DCM", "Not Attempted" };

std::vector<DicomContent>
Algorithm(const DicomResultHeader & header, const std::string & relationship)
{
  return { TextContent(relationship, { "111001", "DCM", "Algorithm Name" }, "Shapeton ColonPolyps"),
           TextContent(relationship, { "111003", "DCM", "Algorithm Version" }, header.version) };
}

void
AddNumber(std::vector<DicomContent> & contents, const DicomCode & name, double value, const DicomCode & unit)
{
  if (std::isfinite(value))
  {
    contents.push_back(NumberContent("HAS PROPERTIES", name, NumberText(value, 6), unit));
  }
}

/** TID 4125: one candidate. */
DicomContent
Finding(const PolypCandidate &       candidate,
        const ColonSegmentsAsDicom & segments,
        const DicomSource &          source,
        const DicomResultHeader &    header)
{
  const std::array<double, 3> place{ candidate.position[0], candidate.position[1], candidate.position[2] };
  DicomContent finding = CodeContent("INFERRED FROM", { "111059", "DCM", "Single Image Finding" }, polyp);
  auto &       contents = finding.children;
  contents.push_back(CodeContent("HAS CONCEPT MOD",
                                 { "111056", "DCM", "Rendering Intent" },
                                 { "111151", "DCM", "Presentation Optional: Rendering device may present" }));
  contents.push_back(TextContent(
    "HAS OBS CONTEXT", { "112039", "DCM", "Tracking Identifier" }, "candidate " + std::to_string(candidate.number)));
  contents.push_back(UIDContent(
    "HAS OBS CONTEXT", { "112040", "DCM", "Tracking Unique Identifier" }, segments.TrackingUIDOfCandidate(candidate)));
  for (const DicomContent & content : Algorithm(header, "HAS OBS CONTEXT"))
  {
    contents.push_back(content);
  }
  AddNumber(contents, certainty, 100.0 * candidate.score, percent);
  contents.push_back(PixelPointContent("HAS PROPERTIES", { "111010", "DCM", "Center" }, place, source));
  if (candidate.segment > 0)
  {
    contents.push_back(CodeContent("HAS PROPERTIES", findingSite, CodeOfSegment(candidate.segment)));
  }
  AddNumber(contents, polypSize, candidate.diameter, mm);
  AddNumber(contents, distanceFromAnus, candidate.arcLength, mm);
  AddNumber(contents, attenuation, candidate.attenuation, hounsfield);
  contents.push_back(TextContent("HAS PROPERTIES", { "121106", "DCM", "Comment" }, CandidateNote));
  return finding;
}

/** TID 4015: the detections performed. */
DicomContent
Detections(const DicomExamination & exam, const DicomResultHeader & header)
{
  if (!exam.isSearched)
  {
    return CodeContent("CONTAINS", { "111064", "DCM", "Summary of Detections" }, notAttempted);
  }
  DicomContent performed = CodeContent("CONTAINS", { "111022", "DCM", "Detection Performed" }, polyp);
  performed.children = Algorithm(header, "HAS PROPERTIES");
  DicomContent summary =
    CodeContent("CONTAINS", { "111064", "DCM", "Summary of Detections" }, { "111222", "DCM", "Succeeded" });
  summary.children.push_back(
    ContainerContent("INFERRED FROM", { "111063", "DCM", "Successful Detections" }, { performed }));
  return summary;
}
/** Distinguishes "no findings" from "not searched". */
DicomCode
StateOf(const DicomExamination & exam)
{
  if (!exam.isSearched)
  {
    return { "111245", "DCM", "No algorithms succeeded; without findings" };
  }
  return exam.candidates.empty() ? DicomCode{ "111241", "DCM", "All algorithms succeeded; without findings" }
                                 : DicomCode{ "111242", "DCM", "All algorithms succeeded; with findings" };
}
} // namespace

DicomContent
CadReportOfColon(const DicomExamination &     exam,
                 const ColonSegmentsAsDicom & segments,
                 const DicomSource &          source,
                 const DicomResultHeader &    header)
{
  std::vector<DicomContent> contents = ContextOfReport(header);
  contents.push_back(ContainerContent(
    "CONTAINS",
    { "112224", "DCM", "Image Set Properties" },
    { UIDContent("CONTAINS", { "112227", "DCM", "Frame of Reference UID" }, source.series.frameOfReferenceUID) }));
  DicomContent summary =
    CodeContent("CONTAINS", { "111017", "DCM", "CAD Processing and Findings Summary" }, StateOf(exam));
  for (const PolypCandidate & candidate : exam.candidates)
  {
    summary.children.push_back(Finding(candidate, segments, source, header));
  }
  contents.push_back(std::move(summary));
  contents.push_back(Detections(exam, header));
  contents.push_back(CodeContent("CONTAINS", { "111065", "DCM", "Summary of Analyses" }, notAttempted));
  return ContainerContent({}, { "112220", "DCM", "Colon CAD Report" }, std::move(contents), "4120");
}
} // namespace shapeton
