#include "shapetonReaderReportPage.h"

#include "shapetonColonFigures.h"
#include "shapetonColonSegments.h"
#include "shapetonColonoscopyFacts.h"
#include "shapetonHtmlReport.h"
#include "shapetonJson.h"
#include "shapetonPlaceInWords.h"
#include "shapetonPolypSearch.h"

#include <cmath>
#include <filesystem>

namespace shapeton
{
namespace
{
using ReaderFacts = std::vector<std::pair<std::string, std::string>>;

std::string
SizeCell(double size)
{
  return std::isfinite(size) ? InTenths(size) : "";
}

std::string
MorphologyCell(const ReaderLesion & lesion)
{
  const std::string name = NameOf(lesion.Morphology());
  return name.empty() || lesion.IsMorphologyByReader() ? name : name + " (program)";
}

std::string
CategoryInWords(const std::string & category)
{
  return category.empty() ? "no category entered" : category + ", as entered by the reader";
}

class ReaderReportPage
{
public:
  explicit ReaderReportPage(const ReaderReportContent & content)
    : m_Content(content), m_Positions(content.positions), m_Verdicts(content.verdicts), m_Lesions(content.lesions)
  {}

  void
  Write(const std::string & path) const
  {
    HtmlReport html("Reader's report of a virtual colonoscopy");
    html.BeginPage();
    html.AddResearchNote();
    if (const std::string why = WhyPreliminary(m_Verdicts.assessment, m_Lesions); !why.empty())
    {
      html.AddNote("Preliminary: " + why + ".");
    }
    html.AddFacts(this->Summary());
    this->AddLesions(
      html,
      "Accepted polyps",
      "Size: largest diameter. Numbers with F: findings of the reader; others: candidates of the program.",
      ReaderVerdict::Polyp);
    if (!LesionsWith(m_Lesions, ReaderVerdict::Unsure).empty())
    {
      this->AddLesions(html, "Unsure", "Not counted as polyps.", ReaderVerdict::Unsure);
    }
    this->AddExtracolonic(html);
    this->AddOthers(html);
    this->AddNotAssessable(html);
    html.EndPage();
    this->AddPictures(html);
    html.AddHeading("Sources");
    html.AddFacts(m_Content.sources);
    html.Write(path);
  }

private:
  ReaderFacts
  Summary() const
  {
    ReaderFacts facts;
    for (const ReadPosition & position : m_Positions)
    {
      facts.emplace_back("Position", position.name + (position.series.empty() ? "" : ", series " + position.series));
    }
    facts.emplace_back("Category of the colon (C-RADS)", CategoryInWords(m_Verdicts.assessment.colonic));
    facts.emplace_back("Category of extracolonic findings (C-RADS)",
                       CategoryInWords(m_Verdicts.assessment.extracolonic));
    if (!m_Verdicts.assessment.note.empty())
    {
      facts.emplace_back("Note of the reader", m_Verdicts.assessment.note);
    }
    facts.emplace_back("Accepted polyps", SizesOfAccepted(m_Lesions));
    facts.emplace_back("Candidates of the program", this->CandidatesRead());
    facts.emplace_back("Findings of the reader",
                       std::to_string(m_Verdicts.findings.size()) + " in the colon, " +
                         std::to_string(m_Verdicts.extracolonic.size()) + " extracolonic");
    return facts;
  }

  /** "8: 1 accepted, 1 unsure, 3 rejected, 3 unread". */
  std::string
  CandidatesRead() const
  {
    const auto  number = [&](ReaderVerdict verdict) { return LesionsWith(m_Lesions, verdict).size(); };
    const auto  findings = m_Verdicts.findings.size();
    std::string text = std::to_string(m_Lesions.size() - findings) + ": " +
                       std::to_string(number(ReaderVerdict::Polyp) - findings) + " accepted, " +
                       std::to_string(number(ReaderVerdict::Unsure)) + " unsure, " +
                       std::to_string(number(ReaderVerdict::NotAPolyp)) + " rejected, " +
                       std::to_string(number(ReaderVerdict::Unread)) + " unread";
    if (m_Verdicts.isSecondReader)
    {
      text += *m_Verdicts.isSecondReader ? "; shown as second reader, after a reading without them"
                                         : "; shown from the beginning";
    }
    return text;
  }

  std::string
  NumberCell(const ReaderLesion & one) const
  {
    return one.sameAs.empty() ? one.id : one.id + " (same as " + one.sameAs + ")";
  }

  void
  AddLesions(HtmlReport & html, const std::string & title, const std::string & caption, ReaderVerdict verdict) const
  {
    html.AddHeading(title);
    const std::vector<ReaderLesion> lesions = LesionsWith(m_Lesions, verdict);
    if (lesions.empty())
    {
      html.AddParagraph("None.");
      return;
    }
    std::vector<std::string> columns{ "Number",  "Segment",    "From anal verge (cm)", "Size (mm)",
                                      "Size by", "Morphology", "Note of the reader" };
    if (m_Positions.size() > 1)
    {
      columns.insert(columns.begin() + 1, "Position");
    }
    CsvTable table(columns);
    for (const ReaderLesion & one : lesions)
    {
      const std::string        size = SizeCell(one.Size());
      std::vector<std::string> row{ this->NumberCell(one),
                                    NameOfSegment(one.segment),
                                    NumberOfCentimeters(one.arcLength),
                                    size,
                                    size.empty()           ? ""
                                    : one.IsSizeByReader() ? "reader"
                                                           : "program",
                                    MorphologyCell(one),
                                    one.statement.note };
      if (m_Positions.size() > 1)
      {
        row.insert(row.begin() + 1, m_Positions[one.position].name);
      }
      table.AddRow(row);
    }
    html.AddTable(table, caption);
  }

  /** The findings outside the colon. */
  void
  AddExtracolonic(HtmlReport & html) const
  {
    CsvTable table({ "Number", "Place", "Size (mm)", "Note of the reader" });
    for (const ReaderFinding & one : m_Verdicts.extracolonic)
    {
      table.AddRow(
        { one.id, this->PlaceOf(one.position, one.place), SizeCell(one.statement.size), one.statement.note });
    }
    if (!table.GetRows().empty())
    {
      html.AddHeading("Extracolonic findings");
      html.AddTable(table, "The program does not search for them.");
    }
  }

  /** The candidates that were rejected or not read, in brief. */
  void
  AddOthers(HtmlReport & html) const
  {
    CsvTable table({ "Number",
                     "Verdict",
                     "Segment",
                     "From anal verge (cm)",
                     "Size by the program (mm)",
                     "Listed by the program as",
                     "Note of the reader" });
    for (const ReaderVerdict verdict : { ReaderVerdict::Unread, ReaderVerdict::NotAPolyp })
    {
      for (const ReaderLesion & one : LesionsWith(m_Lesions, verdict))
      {
        const PolypCandidate & candidate = *one.candidate;
        table.AddRow({ one.id,
                       NameOf(verdict),
                       NameOfSegment(one.segment),
                       NumberOfCentimeters(one.arcLength),
                       InTenths(candidate.diameter),
                       ListedAs(candidate),
                       one.statement.note });
      }
    }
    if (!table.GetRows().empty())
    {
      html.AddHeading("Unread and rejected candidates");
      html.AddTable(table, "Not part of the result.");
    }
  }

  /** The segments of the colon that the program found to be not evaluable or only partly evaluable. */
  void
  AddNotAssessable(HtmlReport & html) const
  {
    ReaderFacts facts;
    for (const ReadPosition & position : m_Positions)
    {
      if (!position.folder.Has(examination::landmarks))
      {
        facts.emplace_back(position.name, "the segments of the colon are unknown");
        continue;
      }
      const Json landmarks = position.folder.ReadLandmarks();
      for (int segment = 1; segment <= NumberOfColonSegments; ++segment)
      {
        const std::string text = EvaluableInWords(landmarks, segment);
        if (!text.empty() && text.compare(0, 3, "yes") != 0)
        {
          facts.emplace_back(position.name + ", " + NameOfSegment(segment), text);
        }
      }
    }
    if (!facts.empty())
    {
      html.AddHeading("Segments not or only partly evaluable");
      html.AddParagraph("Measured by the program: the part of the centerline where the wall is visible.");
      html.AddFacts(facts);
    }
  }

  void
  AddPictures(HtmlReport & html) const
  {
    const std::vector<ReaderLesion> accepted = LesionsWith(m_Lesions, ReaderVerdict::Polyp);
    if (accepted.empty() && m_Verdicts.bookmarks.empty())
    {
      return;
    }
    html.AddHeading("Pictures");
    for (const ReaderLesion & one : accepted)
    {
      this->AddCard(html, one);
    }
    for (const ReaderBookmark & one : m_Verdicts.bookmarks)
    {
      html.AddMarkup("<section class=\"card snapshot\">\n");
      html.AddSubheading("Bookmark " + one.id + (one.label.empty() ? "" : ": " + one.label));
      html.AddPictureBytes(one.png, "Snapshot of the reader, " + this->PlaceOf(one.position, one.place));
      html.AddMarkup("</section>\n");
    }
  }

  std::string
  PlaceOf(std::size_t position, const Eigen::Vector3d & place) const
  {
    return m_Positions[position].name + " at " + PlaceInWords(place) + " (LPS)";
  }

  /** The picture and the facts of an accepted candidate, or the position of a finding. */
  void
  AddCard(HtmlReport & html, const ReaderLesion & one) const
  {
    const std::string segment = NameOfSegment(one.segment);
    const std::string distance = NumberOfCentimeters(one.arcLength);
    html.AddMarkup("<section class=\"card\">\n");
    html.AddSubheading((one.candidate ? "Candidate " : "Finding ") + this->NumberCell(one) +
                       (segment.empty() ? "" : ": " + segment) +
                       (distance.empty() ? "" : ", " + distance + " cm from the anal verge"));
    html.AddFacts(this->FactsOf(one));
    if (one.candidate)
    {
      const std::string path = m_Positions[one.position].folder.GetFolder() + '/' + colonoscopystage::polyps +
                               "/report/polyp-candidate-" + std::to_string(one.candidate->number) + ".png";
      if (std::filesystem::exists(path))
      {
        html.AddPicture(path,
                        "Candidate " + one.id +
                          ": crops through the center of the head, endoluminal and unfolded view; the head is blue.");
      }
      else
      {
        html.AddParagraph("The run contains no picture of this candidate.");
      }
    }
    html.AddMarkup("</section>\n");
  }

  ReaderFacts
  FactsOf(const ReaderLesion & one) const
  {
    const double measured = one.candidate ? one.candidate->diameter : std::nan("");
    return KnownFacts({ { "Size by the reader", one.IsSizeByReader() ? SizeInWords(one.statement.size) : "" },
                        { "Size by the program", SizeInWords(measured) },
                        { "Morphology", MorphologyCell(one) },
                        { "Place", this->PlaceOf(one.position, one.place) },
                        { "Note of the reader", one.statement.note } });
  }

  /** "polyp candidate", or what the program recognized. */
  static std::string
  ListedAs(const PolypCandidate & candidate)
  {
    return IsListedAsPolyp(candidate) ? "polyp candidate" : RecognizedAs(candidate);
  }

  const ReaderReportContent &       m_Content;
  const std::vector<ReadPosition> & m_Positions;
  const ReaderVerdicts &            m_Verdicts;
  const std::vector<ReaderLesion> & m_Lesions;
};
} // namespace

void
WriteReaderReportPage(const ReaderReportContent & content, const std::string & path)
{
  ReaderReportPage(content).Write(path);
}
} // namespace shapeton
