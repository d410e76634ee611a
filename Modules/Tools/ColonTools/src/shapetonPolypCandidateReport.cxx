#include "shapetonPolypCandidateReport.h"

#include "shapetonColonFigures.h"
#include "shapetonColonSegments.h"
#include "shapetonCommandLine.h"
#include "shapetonHtmlReport.h"
#include "shapetonPlaceInWords.h"
#include "shapetonPolypCandidatePictures.h"
#include "shapetonPolypMorphology.h"
#include "shapetonReportTable.h"
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
  return other.isExcluded ? "not comparable" : other.isSeen ? "no. " + std::to_string(other.candidate) : "no candidate";
}

/** "soft tissue"; "mixed" if parts of the head are something else. */
std::string
TissueInWords(const PolypCandidate & candidate)
{
  constexpr double least = -100.0, greatest = 200.0; // HU: -30 to 150 of soft tissue, with a noise of 50 HU
  const bool       isMixed = candidate.lowAttenuation < least || candidate.highAttenuation > greatest;
  return candidate.tissue == PolypTissue::Unknown           ? "partial volume"
         : candidate.tissue == PolypTissue::Soft && isMixed ? "mixed: look at the CT"
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

/** "9.1 mm; 9.6 mm in the other position counts; greatest in the sagittal plane". */
std::string
SizeOnCard(const PolypCandidate & candidate, const PolypLesion & lesion)
{
  return SizeInWords(candidate.diameter) +
         (lesion.size > candidate.diameter ? "; " + SizeInWords(lesion.size) + " in the other position counts" : "") +
         (candidate.plane.empty() ? "" : "; greatest in the " + candidate.plane + " plane");
}

/** Number of mm. */
std::string
SizeCell(const PolypCandidate & candidate)
{
  return InTenths(candidate.diameter);
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

/** The lesions of two positions; none for a single position, for which candidate numbers suffice. */
class LesionsOfPage
{
public:
  explicit LesionsOfPage(const PolypsOfPage & polyps) : m_IsSecond(polyps.isSecond)
  {
    if (!polyps.there.empty())
    {
      m_Lesions =
        m_IsSecond ? LesionsOfPositions(polyps.there, polyps.here) : LesionsOfPositions(polyps.here, polyps.there);
    }
  }

  /** The lesion of a candidate of this or the other position; without a letter if there is none. */
  PolypLesion
  Find(int number, bool isHere = true) const
  {
    const auto member = isHere != m_IsSecond ? &PolypLesion::first : &PolypLesion::second;
    const auto found = std::find_if(
      m_Lesions.begin(), m_Lesions.end(), [&](const PolypLesion & lesion) { return lesion.*member == number; });
    return found == m_Lesions.end() ? PolypLesion() : *found;
  }

  /** "J, K": letters of the lesions that one position recognizes as something else; "" for none. */
  std::string
  Disputed() const
  {
    std::string letters;
    for (const PolypLesion & lesion : m_Lesions)
    {
      letters += !lesion.isDisputed ? "" : (letters.empty() ? "" : ", ") + lesion.letter;
    }
    return letters;
  }

private:
  bool                     m_IsSecond;
  std::vector<PolypLesion> m_Lesions;
};

/** "13.4", and the form if it differs from that of the candidate here, or what it is recognized as. */
std::string
SizeAndForm(const PolypCandidate & there, const PolypCandidate & here)
{
  const std::string form = IsListedAsPolyp(there) ? MorphologyInWords(there) : RecognizedAs(there);
  return SizeCell(there) + (form.empty() || form == MorphologyInWords(here) ? "" : ", " + form);
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

using CandidateColumn = TableColumn<PolypCandidate>;

/** What all tables show about a candidate. */
const CandidateColumn scoreColumn{ "Score", [](const PolypCandidate & one) { return ProbabilityInWords(one.score); } };
const CandidateColumn segmentColumn{ "Segment", [](const PolypCandidate & one) { return NameOfSegment(one.segment); } };
const CandidateColumn placeColumn{ "At (cm)",
                                   [](const PolypCandidate & one) { return NumberOfCentimeters(one.arcLength); } };
const CandidateColumn sizeColumn{ "Size (mm)", SizeCell };
const CandidateColumn attenuationColumn{ "Mean attenuation (HU)", AttenuationsOf };

CandidateColumn
NumberColumn(const char * heading)
{
  return { heading, [](const PolypCandidate & one) { return std::to_string(one.number); } };
}

CsvTable
TableOfCandidates(const PolypsOfPage & polyps)
{
  const LesionsOfPage lesions(polyps);
  const auto          sizesThere = [&](const PolypCandidate & one) {
    const PolypCandidate * const partner = PartnerOf(one, polyps.there);
    return partner ? SizeAndForm(*partner, one) : "";
  };
  return TableOf<PolypCandidate>(
    Select(polyps.here, true),
    { { "Lesion", [&](const PolypCandidate & one) { return lesions.Find(one.number).letter; } },
      NumberColumn("Candidate"),
      scoreColumn,
      segmentColumn,
      placeColumn,
      sizeColumn,
      { "Morphology", MorphologyInWords },
      attenuationColumn,
      { "Other position", OtherPosition },
      { "Size there (mm)", sizesThere },
      { "Remark", [](const PolypCandidate & one) { return one.remark; } } });
}

CsvTable
TableOfLookalikes(const std::vector<PolypCandidate> & candidates)
{
  return TableOf<PolypCandidate>(candidates,
                                 { NumberColumn("Candidate"),
                                   { "Recognized as", RecognizedAs },
                                   scoreColumn,
                                   segmentColumn,
                                   placeColumn,
                                   sizeColumn,
                                   attenuationColumn });
}

/** "Lesion B: candidate 5, sigmoid, 15.6 cm from the anal verge"; without a letter for a single position. */
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
  constexpr double notable = 0.05;
  const bool       isWeighed = candidate.other && std::isfinite(candidate.other->ownScore);
  std::string      words = ProbabilityInWords(candidate.score) + ", calibrated on synthetic patients";
  words += isWeighed ? "; " + ProbabilityInWords(candidate.other->ownScore) + " from this position alone" : "";
  const bool isLowered = isWeighed && candidate.other->isSeen && candidate.score < candidate.other->ownScore - notable;
  return words + (isLowered ? ", lowered because the candidate in the other position agrees only by " +
                                ProbabilityInWords(candidate.other->likeness) + " in place, size and score"
                            : "");
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

/** "Sessile, on a fold", with a note if the head is mostly under fluid. */
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
FactsOfCard(const PolypCandidate & candidate, const PolypLesion & lesion, const itk::ImageBase<3> * grid)
{
  return KnownFacts(
    { { "Place", PlaceInSlices(candidate.position, grid) },
      { "Score", ScoreInWords(candidate) },
      { "Largest diameter", SizeOnCard(candidate, lesion) },
      { "Height", WholeMillimeters(candidate.height) },
      { "Morphology", MorphologyOnCard(candidate) },
      { "Mean attenuation inside the head, 5th to 95th percentile (HU)", AttenuationInWords(candidate) },
      { "Recognized as", RecognizedAs(candidate) },
      { "Other position", OtherPositionOnCard(candidate) },
      { "Remark", candidate.remark } });
}

std::string
AnchorOfCard(int number)
{
  return "candidate-" + std::to_string(number);
}

void
AddCard(HtmlReport & report, const PolypCards & cards, const PolypCandidate & candidate, const PolypLesion & lesion)
{
  const PolypCandidate * const partner = PartnerOf(candidate, cards.polyps.there);
  report.AddMarkup("<section class=\"card\" id=\"" + AnchorOfCard(candidate.number) + "\">\n");
  report.AddSubheading(TitleOfCard(candidate, lesion.letter));
  report.AddFacts(FactsOfCard(candidate, lesion, cards.grid));
  if (lesion.isDisputed)
  {
    report.AddNote("The positions disagree: in the other one, it is " +
                   (IsListedAsPolyp(candidate) && partner ? "recognized as " + RecognizedAs(*partner)
                                                          : "listed as a possible polyp") +
                   ". Review it in both.");
  }
  if (!cards.viewer.empty())
  {
    report.AddLink(cards.viewer + "#candidate=" + std::to_string(candidate.number), "Show in the viewer");
  }
  if (partner && !cards.otherPage.empty())
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
AddPolypCandidateTable(HtmlReport & report, const CurveSet & centerline, const PolypsOfPage & polyps)
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
  const std::size_t others = Select(polyps.here, false).size();
  if (others == polyps.here.size())
  {
    report.AddParagraph("No candidates at this sensitivity.");
  }
  else
  {
    report.AddTable(
      TableOfCandidates(polyps).WithoutEmptyColumns(),
      "Candidates, highest score first. At: distance from the anal verge. Size: largest diameter of the head. "
      "Attenuation: in the CT / after electronic cleansing");
    const std::string disputed = LesionsOfPage(polyps).Disputed();
    report.AddParagraph(
      "Scores are probabilities, calibrated on synthetic patients. Diminutive: below 6 mm; flat: at most 3 mm high, "
      "lower than half the smaller width; pedunculated: on a stalk. " +
      SizesIfConfirmed(polyps.here, polyps.there) +
      (polyps.there.empty() ? "" : "; each lesion of both positions counts once") +
      (disputed.empty() ? "" : "; not counted, because the positions disagree: " + disputed) +
      ". The category (C-RADS) is the decision of the reader." +
      (others == 0
         ? ""
         : " Recognized as something else, or parts of others: " + std::to_string(others) + ", after the cards."));
  }
}

void
AddPolypsOfOtherPosition(HtmlReport & report, const PolypsOfPage & polyps)
{
  const LesionsOfPage         lesions(polyps);
  std::vector<PolypCandidate> others = Select(polyps.there, true);
  const auto                  partnerOf = [&](const PolypCandidate & one) { return PartnerOf(one, polyps.here); };
  const auto                  isListedHere = [&](const PolypCandidate & one) {
    return partnerOf(one) && IsListedAsPolyp(*partnerOf(one));
  };
  others.erase(std::remove_if(others.begin(), others.end(), isListedHere), others.end());
  const auto here = [&](const PolypCandidate & one) {
    const PolypCandidate * const partner = partnerOf(one);
    return partner ? "candidate " + std::to_string(partner->number) + ", recognized as " + RecognizedAs(*partner) +
                       ": the positions disagree"
                   : "no candidate";
  };
  const CsvTable table = TableOf<PolypCandidate>(
    others,
    { { "Lesion", [&](const PolypCandidate & one) { return lesions.Find(one.number, false).letter; } },
      NumberColumn("Candidate there"),
      scoreColumn,
      segmentColumn,
      placeColumn,
      sizeColumn,
      attenuationColumn,
      { "In this position", here } });
  if (!others.empty())
  {
    report.AddTable(table,
                    "Candidates of the other position only, or recognized differently in this one; places there");
  }
}

void
AddPolypCandidateCards(HtmlReport & report, const PolypCards & cards)
{
  const std::vector<PolypCandidate> & candidates = cards.polyps.here;
  if (const std::string flat = candidates.empty() ? "" : cards.pictureOf(0); !flat.empty())
  {
    report.AddPicture(
      flat,
      "Candidates on the virtual dissection (unfolded view); crosses: recognized as something else. The "
      "pale margins repeat the opposite edge.");
  }
  const LesionsOfPage         lesions(cards.polyps);
  std::vector<PolypCandidate> others;
  for (const PolypCandidate & one : candidates)
  {
    const PolypLesion lesion = lesions.Find(one.number);
    if (IsListedAsPolyp(one) || !lesion.letter.empty())
    {
      AddCard(report, cards, one, lesion);
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
      AddCard(report, cards, one, {});
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
  PolypCards cards;
  cards.polyps.here = CandidatesAsWritten(candidates);
  AddPolypCandidateTable(report, colon.centerline, cards.polyps);
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
