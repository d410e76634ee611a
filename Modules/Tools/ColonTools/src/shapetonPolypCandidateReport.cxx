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
constexpr const char * slash = "\u00a0/\u00a0"; // without line break

std::string
OtherPosition(const PolypCandidate & candidate)
{
  if (!candidate.other)
  {
    return "";
  }
  const PolypInOtherPosition & other = *candidate.other;
  return other.isExcluded ? "not imaged" : other.isSeen ? "no. " + std::to_string(other.candidate) : "no candidate";
}

/** "soft tissue"; "mixed" if the range is too wide for one tissue. */
std::string
TissueInWords(const PolypCandidate & candidate)
{
  constexpr double widest = 250.0; // HU: 5 standard deviations of a noise of 50 HU
  return candidate.tissue == PolypTissue::Unknown                        ? "partial volume"
         : candidate.highAttenuation - candidate.lowAttenuation > widest ? "mixed: look at the CT"
                                                                         : NameOf(candidate.tissue);
}

/** "52 in the CT; 46 (-58 to 155) after cleansing, soft tissue". */
std::string
AttenuationInWords(const PolypCandidate & candidate)
{
  if (!std::isfinite(candidate.meanAttenuation))
  {
    return "";
  }
  const bool isKnown = std::isfinite(candidate.uncleansedAttenuation);
  return (isKnown ? WholeNumber(candidate.uncleansedAttenuation) + " in the CT; " : "") +
         WholeNumber(candidate.meanAttenuation) + " (" + WholeNumber(candidate.lowAttenuation) + " to " +
         WholeNumber(candidate.highAttenuation) + ") after cleansing, " + TissueInWords(candidate);
}

/** "180 / 46": in the CT and after cleansing, if they differ. */
std::string
AttenuationsOf(const PolypCandidate & candidate)
{
  const std::string cleansed = WholeNumber(candidate.meanAttenuation);
  const std::string before = WholeNumber(candidate.uncleansedAttenuation);
  return before.empty() || before == cleansed ? cleansed : before + slash + cleansed;
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
  return candidate.plane.empty() ? inSpace : WholeNumber(candidate.planeDiameter) + slash + inSpace;
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

/** Letters of the lesions of two positions; none for one position, whose numbers suffice. */
class LesionLetters
{
public:
  LesionLetters(const std::vector<PolypCandidate> & first, const std::vector<PolypCandidate> & second)
  {
    if (!second.empty())
    {
      m_Lesions = LesionsOfPositions(first, second);
    }
  }

  std::string
  OfFirst(int number) const
  {
    return this->Find(&PolypLesion::first, number);
  }

  std::string
  OfSecond(int number) const
  {
    return this->Find(&PolypLesion::second, number);
  }

private:
  std::string
  Find(int PolypLesion::*member, int number) const
  {
    const auto found = std::find_if(
      m_Lesions.begin(), m_Lesions.end(), [&](const PolypLesion & lesion) { return lesion.*member == number; });
    return found == m_Lesions.end() ? "" : found->letter;
  }

  std::vector<PolypLesion> m_Lesions;
};

/** "13 / 15", and the form if it differs from that of the candidate here. */
std::string
SizesAndForm(const PolypCandidate & there, const PolypCandidate & here)
{
  const std::string form = MorphologyInWords(there);
  return SizesOf(there) + (form.empty() || form == MorphologyInWords(here) ? "" : ", " + form);
}

CsvTable
TableOfCandidates(const std::vector<PolypCandidate> & candidates, const std::vector<PolypCandidate> & others)
{
  const LesionLetters letters(candidates, others);
  CsvTable            table({ "Lesion",
                              "Candidate",
                              "Score",
                              "Segment",
                              "At (cm)",
                              "Size (mm)",
                              "Morphology",
                              "Mean attenuation (HU)",
                              "Other position",
                              "There (mm)",
                              "Remark" });
  for (const PolypCandidate & one : candidates)
  {
    const PolypCandidate * const partner = PartnerOf(one, others);
    table.AddRow({ letters.OfFirst(one.number),
                   std::to_string(one.number),
                   ProbabilityInWords(one.score),
                   NameOfSegment(one.segment),
                   NumberOfCentimeters(one.arcLength),
                   SizesOf(one),
                   MorphologyInWords(one),
                   AttenuationsOf(one),
                   OtherPosition(one),
                   partner ? SizesAndForm(*partner, one) : "",
                   one.remark });
  }
  return table;
}

CsvTable
TableOfLookalikes(const std::vector<PolypCandidate> & candidates)
{
  CsvTable table({ "Candidate", "Recognized as", "Score", "Segment", "At (cm)", "Size (mm)", "Mean attenuation (HU)" });
  for (const PolypCandidate & one : candidates)
  {
    table.AddRow({ std::to_string(one.number),
                   RecognizedAs(one),
                   ProbabilityInWords(one.score),
                   NameOfSegment(one.segment),
                   NumberOfCentimeters(one.arcLength),
                   SizesOf(one),
                   AttenuationsOf(one) });
  }
  return table;
}

/** "Lesion B: candidate 5, sigmoid, 15.6 cm from the anal verge"; without letter for a single position. */
std::string
TitleOfCard(const PolypCandidate & candidate, const std::string & letter)
{
  const std::string segment = NameOfSegment(candidate.segment);
  return (letter.empty() ? "Candidate " : "Lesion " + letter + ": candidate ") + std::to_string(candidate.number) +
         ", " + (segment.empty() ? "" : segment + ", ") + Centimeters(candidate.arcLength) + " from the anal verge";
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

/** "Sessile, on a fold"; what the form of a head under fluid rests on. */
std::string
MorphologyOnCard(const PolypCandidate & candidate)
{
  constexpr double  mostlyUnder = 0.5; // fraction of the surface
  const std::string form = MorphologyInWords(candidate);
  return form.empty() || !(candidate.submergedShare > mostlyUnder)
           ? form
           : form + "; shape and attachment are those after electronic cleansing";
}

/** The rows of a card that have a value. */
std::vector<std::pair<std::string, std::string>>
FactsOfCard(const PolypCandidate & candidate, const itk::ImageBase<3> * grid)
{
  std::vector<std::pair<std::string, std::string>> facts{ { "Place", PlaceInSlices(candidate.position, grid) },
                                                          { "Score", ScoreInWords(candidate) },
                                                          { "Largest diameter", SizeInWords(candidate) },
                                                          { "Height", WholeMillimeters(candidate.height) },
                                                          { "Morphology", MorphologyOnCard(candidate) },
                                                          { "Mean attenuation, 5th to 95th percentile (HU)",
                                                            AttenuationInWords(candidate) },
                                                          { "Recognized as", RecognizedAs(candidate) },
                                                          { "Other position", OtherPositionOnCard(candidate) },
                                                          { "Remark", candidate.remark } };
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

std::string
AnchorOfCard(int number)
{
  return "candidate-" + std::to_string(number);
}

void
AddCard(HtmlReport & report, const PolypCards & cards, const PolypCandidate & candidate, const std::string & letter)
{
  report.AddMarkup("<section class=\"card\" id=\"" + AnchorOfCard(candidate.number) + "\">\n");
  report.AddSubheading(TitleOfCard(candidate, letter));
  report.AddFacts(FactsOfCard(candidate, cards.grid));
  if (!letter.empty() && !IsListedAsPolyp(candidate))
  {
    report.AddNote("The positions disagree: it is listed as a possible polyp in the other one. Review it in both.");
  }
  if (!cards.viewer.empty())
  {
    report.AddLink(cards.viewer + AnchorOfPlace(candidate.position), "Show in the viewer");
  }
  if (const PolypCandidate * const partner = PartnerOf(candidate, cards.otherPosition);
      partner && !cards.otherPage.empty())
  {
    report.AddLink(cards.otherPage + '#' + AnchorOfCard(partner->number), "Card in the other position");
  }
  if (const std::string path = cards.pictureOf(candidate.number); !path.empty())
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
    report.AddTable(
      TableOfCandidates(polyps, otherPosition).WithoutEmptyColumns(),
      "Candidates, highest score first. At: distance from the anal verge. Size: in the best plane / in 3-D. "
      "Attenuation: in the CT / after electronic cleansing");
    report.AddParagraph("Scores are probabilities, calibrated on synthetic patients. Diminutive: up to 5 mm; flat: at "
                        "most 3 mm high, lower "
                        "than half the smaller width; pedunculated: on a stalk. " +
                        SizesIfConfirmed(candidates, otherPosition) +
                        (otherPosition.empty() ? "" : "; each lesion of both positions counts once") +
                        ". The category (C-RADS) is the decision of the reader." +
                        (others.empty() ? ""
                                        : " Recognized as something else, or parts of others: " +
                                            std::to_string(others.size()) + ", after the cards."));
  }
}

void
AddPolypsOfOtherPosition(HtmlReport &                        report,
                         const std::vector<PolypCandidate> & here,
                         const std::vector<PolypCandidate> & there)
{
  const LesionLetters letters(here, there);
  CsvTable            table({ "Lesion",
                              "Candidate there",
                              "Score",
                              "Segment",
                              "At (cm)",
                              "Size (mm)",
                              "Mean attenuation (HU)",
                              "In this position" });
  for (const PolypCandidate & one : Select(there, true))
  {
    const PolypCandidate * const partner = PartnerOf(one, here);
    if (!partner || !IsListedAsPolyp(*partner))
    {
      table.AddRow({ letters.OfSecond(one.number),
                     std::to_string(one.number),
                     ProbabilityInWords(one.score),
                     NameOfSegment(one.segment),
                     NumberOfCentimeters(one.arcLength),
                     SizesOf(one),
                     AttenuationsOf(one),
                     partner ? "candidate " + std::to_string(partner->number) + ", recognized as " +
                                 RecognizedAs(*partner) + ": the positions disagree"
                             : "no candidate" });
    }
  }
  if (!table.GetRows().empty())
  {
    report.AddTable(table,
                    "Candidates of the other position only, or recognized differently in this one; places there");
  }
}

void
AddPolypCandidateCards(HtmlReport & report, const PolypCards & cards)
{
  if (const std::string flat = cards.candidates.empty() ? "" : cards.pictureOf(0); !flat.empty())
  {
    report.AddPicture(flat,
                      "Candidates on the virtual dissection (unfolded view); crosses: recognized as something else");
  }
  const LesionLetters         letters(cards.candidates, cards.otherPosition);
  std::vector<PolypCandidate> others;
  for (const PolypCandidate & one : cards.candidates)
  {
    const std::string letter = letters.OfFirst(one.number);
    if (IsListedAsPolyp(one) || !letter.empty())
    {
      AddCard(report, cards, one, letter);
    }
    else
    {
      others.push_back(one);
    }
  }
  if (!others.empty())
  {
    report.AddTable(TableOfLookalikes(others), "Recognized as something else, or parts of another candidate");
    report.BeginDetails("Pictures of these");
    for (const PolypCandidate & one : others)
    {
      AddCard(report, cards, one, "");
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
  PolypCards cards;
  cards.candidates = written;
  cards.grid = colon.lumen;
  cards.pictureOf = [&](int number) {
    const auto found = pictures.find(number);
    return found == pictures.end() ? std::string() : found->second;
  };
  AddPolypCandidateCards(report, cards);
  report.AddHeading("Provenance");
  report.AddFacts(commandLine.GetProvenance());
  report.Write(commandLine.Output(folder + "/index.html"));
}
} // namespace shapeton
