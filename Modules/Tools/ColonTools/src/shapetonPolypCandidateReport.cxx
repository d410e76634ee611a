#include "shapetonPolypCandidateReport.h"

#include "shapetonColonFigures.h"
#include "shapetonColonSegments.h"
#include "shapetonCommandLine.h"
#include "shapetonPlaceInWords.h"
#include "shapetonPolypCandidatePictures.h"
#include "shapetonPolypMorphology.h"
#include "shapetonScanResolution.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace shapeton
{
namespace
{
std::string
OtherPosition(const PolypCandidate & candidate)
{
  if (!candidate.other)
  {
    return "";
  }
  const PolypInOtherPosition & other = *candidate.other;
  return other.isExcluded ? "not imaged"
         : other.isSeen   ? "no. " + std::to_string(other.candidate) + ", " + WholeMillimeters(other.distance)
                          : "no candidate";
}

/** "46 (-58 to 155), soft tissue". */
std::string
AttenuationInWords(const PolypCandidate & candidate)
{
  if (!std::isfinite(candidate.meanAttenuation))
  {
    return "";
  }
  return WholeNumber(candidate.meanAttenuation) + " (" + WholeNumber(candidate.lowAttenuation) + " to " +
         WholeNumber(candidate.highAttenuation) + "), " +
         (candidate.tissue == PolypTissue::Unknown ? "partial volume" : NameOf(candidate.tissue));
}

/** "10 mm, sagittal; 9 mm in 3-D". */
std::string
SizeInWords(const PolypCandidate & candidate)
{
  const std::string inSpace = WholeMillimeters(candidate.diameter);
  return candidate.plane.empty()
           ? inSpace
           : WholeMillimeters(candidate.planeDiameter) + ", " + candidate.plane + "; " + inSpace + " in 3-D";
}

/** "10 / 9". */
std::string
SizesOf(const PolypCandidate & candidate)
{
  const std::string inSpace = WholeNumber(candidate.diameter);
  return candidate.plane.empty() ? inSpace : WholeNumber(candidate.planeDiameter) + " / " + inSpace;
}

/** The candidate of the other position at the same place; null if there is none. */
const PolypCandidate *
PartnerOf(const PolypCandidate & candidate, const std::vector<PolypCandidate> & others)
{
  const auto found = std::find_if(others.begin(), others.end(), [&](const PolypCandidate & other) {
    return candidate.other && candidate.other->isSeen && candidate.other->candidate == other.number;
  });
  return found == others.end() ? nullptr : &*found;
}

CsvTable
TableOfCandidates(const std::vector<PolypCandidate> & candidates, const std::vector<PolypCandidate> & others)
{
  CsvTable table({ "Candidate",
                   "Score",
                   "Segment",
                   "From the anal verge (cm)",
                   "Size, best plane / 3-D (mm)",
                   "Morphology",
                   "Mean attenuation (HU)",
                   "Other position",
                   "There (mm)",
                   "Remark" });
  for (const PolypCandidate & one : candidates)
  {
    const PolypCandidate * const partner = PartnerOf(one, others);
    table.AddRow({ std::to_string(one.number),
                   ProbabilityInWords(one.score),
                   NameOfSegment(one.segment),
                   NumberOfCentimeters(one.arcLength),
                   SizesOf(one),
                   MorphologyInWords(one),
                   WholeNumber(one.meanAttenuation),
                   OtherPosition(one),
                   partner ? SizesOf(*partner) + ", " + MorphologyInWords(*partner) : "",
                   one.remark });
  }
  return table;
}

CsvTable
TableOfLookalikes(const std::vector<PolypCandidate> & candidates)
{
  CsvTable table({ "Candidate",
                   "Recognized as",
                   "Score",
                   "Segment",
                   "From the anal verge (cm)",
                   "Largest diameter (mm)",
                   "Mean attenuation (HU)" });
  for (const PolypCandidate & one : candidates)
  {
    table.AddRow({ std::to_string(one.number),
                   RecognizedAs(one),
                   ProbabilityInWords(one.score),
                   NameOfSegment(one.segment),
                   NumberOfCentimeters(one.arcLength),
                   WholeNumber(one.diameter),
                   WholeNumber(one.meanAttenuation) });
  }
  return table;
}

std::string
TitleOfCard(const PolypCandidate & candidate)
{
  const std::string segment = NameOfSegment(candidate.segment);
  return "Candidate " + std::to_string(candidate.number) + ": " + (segment.empty() ? "" : segment + ", ") +
         Centimeters(candidate.arcLength) + " from the anal verge";
}

/** "slice 126, at (-175, -125, 100) mm". */
std::string
PlaceInSlices(const Eigen::Vector3d & place, const itk::ImageBase<3> * grid)
{
  return (grid ? "slice " + std::to_string(SliceNumber(grid, place)) + ", at " : "at ") + PlaceInWords(place);
}

/** "0.98, calibrated on synthetic patients; 0.78 from this position alone". */
std::string
ScoreInWords(const PolypCandidate & candidate)
{
  const bool isWeighed = candidate.other && std::isfinite(candidate.other->ownScore);
  return ProbabilityInWords(candidate.score) + ", calibrated on synthetic patients" +
         (isWeighed ? "; " + ProbabilityInWords(candidate.other->ownScore) + " from this position alone" : "");
}

/** "candidate 7, 3 mm from the mapped place, confidence of the map 0.65". */
std::string
OtherPositionOnCard(const PolypCandidate & candidate)
{
  if (!candidate.other || !candidate.other->isSeen)
  {
    return OtherPosition(candidate);
  }
  const PolypInOtherPosition & other = *candidate.other;
  return "candidate " + std::to_string(other.candidate) + ", " + WholeMillimeters(other.distance) +
         " from the mapped place" +
         (std::isfinite(other.confidence) ? ", confidence of the map " + ProbabilityInWords(other.confidence) : "");
}

/** The rows of a card that have a value. */
std::vector<std::pair<std::string, std::string>>
FactsOfCard(const PolypCandidate & candidate, const itk::ImageBase<3> * grid)
{
  std::vector<std::pair<std::string, std::string>> facts{
    { "Place", PlaceInSlices(candidate.position, grid) },
    { "Score", ScoreInWords(candidate) },
    { "Largest diameter", SizeInWords(candidate) },
    { "Height", WholeMillimeters(candidate.height) },
    { "Morphology", MorphologyInWords(candidate) },
    { "Mean attenuation after cleansing, 5th to 95th percentile (HU)", AttenuationInWords(candidate) },
    { "Other position", OtherPositionOnCard(candidate) },
    { "Remark", candidate.remark }
  };
  facts.erase(std::remove_if(facts.begin(), facts.end(), [](const auto & fact) { return fact.second.empty(); }),
              facts.end());
  return facts;
}

/** The possible polyps, or all others. */
std::vector<PolypCandidate>
Select(const std::vector<PolypCandidate> & candidates, bool arePolyps)
{
  std::vector<PolypCandidate> selected;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(selected), [=](const PolypCandidate & one) {
    return IsListedAsPolyp(one) == arePolyps;
  });
  return selected;
}

void
AddCard(HtmlReport &              report,
        const PolypCandidate &    candidate,
        const itk::ImageBase<3> * grid,
        const std::string &       viewer,
        const PolypPictureFile &  pictureOf)
{
  report.AddMarkup("<section class=\"card\" id=\"candidate-" + std::to_string(candidate.number) + "\">\n");
  report.AddSubheading(TitleOfCard(candidate));
  report.AddFacts(FactsOfCard(candidate, grid));
  if (!viewer.empty())
  {
    report.AddLink(viewer + AnchorOfPlace(candidate.position), "Show in the viewer");
  }
  if (const std::string path = pictureOf(candidate.number); !path.empty())
  {
    const std::string crops =
      std::isfinite(candidate.attenuation) ? "Crops through the center of the head, marked at the borders. " : "";
    report.AddPicture(
      path, crops + "The head is blue in the endoluminal view and, unless it was left out, in the unfolded view.");
  }
  report.AddMarkup("</section>\n");
}
} // namespace

void
AddPolypCandidateTable(HtmlReport &                        report,
                       const CurveSet &                    centerline,
                       const std::vector<PolypCandidate> & candidates,
                       const std::vector<PolypCandidate> & otherPosition)
{
  report.AddHeading("Polyp candidates");
  report.AddParagraph(
    "A candidate is a location shaped like a polyp. It may be stool, the ileocecal valve or the end of "
    "a fold, and the list may miss polyps.");
  if (const double below = NotAssessableBelow(centerline); below > 0.0)
  {
    report.AddParagraph("At the resolution of this scan, the colon is " + NotAssessableInWords(below) +
                        ": such polyps are often missing.");
  }
  const std::vector<PolypCandidate> polyps = Select(candidates, true), others = Select(candidates, false);
  if (polyps.empty())
  {
    report.AddParagraph("No candidates at this sensitivity.");
  }
  else
  {
    report.AddTable(TableOfCandidates(polyps, otherPosition).WithoutEmptyColumns(),
                    "Candidates, highest score first; attenuation after electronic cleansing");
    report.AddParagraph("Scores are probabilities, calibrated on synthetic patients. " + SizesIfConfirmed(candidates) +
                        ", by the larger size. The category (C-RADS) is the decision of the reader." +
                        (others.empty() ? ""
                                        : " More are recognized as something else, or belong to another candidate (" +
                                            std::to_string(others.size()) + ", listed below)."));
  }
}

void
AddPolypsOfOtherPosition(HtmlReport &                        report,
                         const std::vector<PolypCandidate> & here,
                         const std::vector<PolypCandidate> & there)
{
  CsvTable table({ "Candidate there",
                   "Score",
                   "Segment",
                   "From the anal verge there (cm)",
                   "Size, best plane / 3-D (mm)",
                   "Mean attenuation (HU)",
                   "In this position" });
  for (const PolypCandidate & one : Select(there, true))
  {
    const PolypCandidate * const partner = PartnerOf(one, here);
    if (!partner || !IsListedAsPolyp(*partner))
    {
      table.AddRow(
        { std::to_string(one.number),
          ProbabilityInWords(one.score),
          NameOfSegment(one.segment),
          NumberOfCentimeters(one.arcLength),
          SizesOf(one),
          WholeNumber(one.meanAttenuation),
          partner ? "candidate " + std::to_string(partner->number) + ", " + RecognizedAs(*partner) : "no candidate" });
    }
  }
  if (!table.GetRows().empty())
  {
    report.AddTable(table, "Candidates of the other position only, or recognized differently in this one");
  }
}

void
AddPolypCandidateCards(HtmlReport &                        report,
                       const std::vector<PolypCandidate> & candidates,
                       const itk::ImageBase<3> *           grid,
                       const std::string &                 viewer,
                       const PolypPictureFile &            pictureOf)
{
  const std::vector<PolypCandidate> polyps = Select(candidates, true), others = Select(candidates, false);
  if (const std::string flat = candidates.empty() ? "" : pictureOf(0); !flat.empty())
  {
    report.AddPicture(flat, "Candidates on the virtual dissection (unfolded view)");
  }
  for (const PolypCandidate & one : polyps)
  {
    AddCard(report, one, grid, viewer, pictureOf);
  }
  if (!others.empty())
  {
    report.AddTable(TableOfLookalikes(others), "Recognized as something else, or parts of another candidate");
    report.BeginDetails("Pictures of these");
    for (const PolypCandidate & one : others)
    {
      AddCard(report, one, grid, viewer, pictureOf);
    }
    report.EndDetails();
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
  std::map<int, std::string> pictures; // by number; 0 is the flat colon
  if (!candidates.empty() && colon.flat)
  {
    const PolypCandidatePictures drawn(colon, candidates);
    std::vector<PictureFile>     files{ { commandLine.Output(folder + "/polyp-candidates-flat.png"),
                                          [&] { return drawn.DrawFlatColon(); } } };
    pictures[0] = files[0].path;
    for (const PolypCandidate & one : candidates)
    {
      files.push_back({ commandLine.Output(folder + "/polyp-candidate-" + std::to_string(one.number) + ".png"),
                        [&drawn, &one] { return drawn.DrawCard(one); } });
      pictures[one.number] = files.back().path;
    }
    WritePngs(files);
  }
  HtmlReport report("Polyp candidates of a colon");
  report.AddHead({ { "Candidates", std::to_string(candidates.size()) } }, commandLine.GetWarnings());
  const std::vector<PolypCandidate> written = CandidatesAsWritten(candidates);
  AddPolypCandidateTable(report, colon.centerline, written);
  AddPolypCandidateCards(report, written, colon.lumen, "", [&](int number) {
    const auto found = pictures.find(number);
    return found == pictures.end() ? std::string() : found->second;
  });
  report.AddHeading("Provenance");
  report.AddFacts(commandLine.GetProvenance());
  report.Write(commandLine.Output(folder + "/index.html"));
}
} // namespace shapeton
