#include "shapetonReaderVerdicts.h"

#include "shapetonBase64Text.h"
#include "shapetonColonSegments.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace shapeton
{
namespace
{
/** Maximum accepted size. Lesions in a colon are not larger than this, so a larger number is a mistake. */
constexpr double largestSize = 200.0; // mm

const std::vector<std::string> verdictWords{ "unread", "polyp", "not a polyp", "unsure" };
const std::vector<std::string> colonicWords{ "", "C0", "C1", "C2", "C2a", "C2b", "C3", "C4" };
const std::vector<std::string> extracolonicWords{ "", "E0", "E1", "E2", "E1/E2", "E3", "E4" };
/** In the order of PolypMorphology. */
const std::vector<std::string> morphologyWords{ "", "sessile", "pedunculated", "flat" };

/** Reads the members of an object in the file; errors name the file and the object. */
class VerdictMembers
{
public:
  VerdictMembers(const std::string & path, const Json & object, std::string name)
    : m_Path(path), m_Object(object), m_Name(std::move(name))
  {
    if (!object.is_object())
    {
      this->Refuse("is not an object");
    }
  }

  [[noreturn]] void
  Refuse(const std::string & fault) const
  {
    throw InputError("the verdicts " + Quoted(m_Path) + " were not saved by the viewer, or were changed: " + m_Name +
                     ' ' + fault + "; save them again");
  }

  /** Null if the member is missing. */
  const Json &
  At(const char * key) const
  {
    static const Json null;
    const auto        found = m_Object.find(key);
    return found == m_Object.end() ? null : *found;
  }

  std::string
  Text(const char * key) const
  {
    const Json & value = this->At(key);
    if (!value.is_null() && !value.is_string())
    {
      this->Refuse("has a " + std::string(key) + " that is not a text");
    }
    return value.is_null() ? std::string() : value.get<std::string>();
  }

  std::string
  RequiredText(const char * key) const
  {
    const std::string text = this->Text(key);
    if (text.empty())
    {
      this->Refuse("has no " + std::string(key));
    }
    return text;
  }

  /** Index of the text in `words`. */
  std::size_t
  Word(const char * key, const std::vector<std::string> & words) const
  {
    const std::string text = this->Text(key);
    const auto        found = std::find(words.begin(), words.end(), text);
    if (found == words.end())
    {
      this->Refuse("has an unknown " + std::string(key) + ' ' + Quoted(text));
    }
    return static_cast<std::size_t>(found - words.begin());
  }

  /** NaN for null or a missing member. */
  double
  Number(const char * key) const
  {
    const Json & value = this->At(key);
    if (!value.is_null() && !value.is_number())
    {
      this->Refuse("has a " + std::string(key) + " that is not a number");
    }
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  }

  std::optional<bool>
  Flag(const char * key) const
  {
    const Json & value = this->At(key);
    if (!value.is_null() && !value.is_boolean())
    {
      this->Refuse("has a " + std::string(key) + " that is neither true nor false");
    }
    return value.is_null() ? std::optional<bool>() : value.get<bool>();
  }

  /** The coordinates; may be null if they are not required. */
  std::vector<double>
  Coordinates(const char * key, std::size_t number, bool isRequired) const
  {
    const Json & value = this->At(key);
    if (value.is_null() && !isRequired)
    {
      return {};
    }
    const bool isList = value.is_array() && value.size() == number &&
                        std::all_of(value.begin(), value.end(), [](const Json & one) { return one.is_number(); });
    if (!isList)
    {
      this->Refuse("needs " + std::to_string(number) + " numbers as " + key);
    }
    return value.get<std::vector<double>>();
  }

  Eigen::Vector3d
  Place() const
  {
    return Eigen::Vector3d(this->Coordinates("lps", 3, true).data());
  }

  /** 0 if missing, as in version 1. */
  std::size_t
  Position(std::size_t positions) const
  {
    const Json & value = this->At("position");
    const bool   isValid = value.is_null() || (value.is_number_unsigned() && value.get<std::size_t>() < positions);
    if (!isValid)
    {
      this->Refuse("belongs to a position that the examination does not have");
    }
    return value.is_null() ? 0 : value.get<std::size_t>();
  }

  ReaderStatement
  Statement(const char * sizeKey) const
  {
    ReaderStatement statement;
    statement.size = this->Number(sizeKey);
    if (statement.size <= 0.0 || statement.size > largestSize)
    {
      this->Refuse("has the " + std::string(sizeKey) + ' ' + CsvTable::Number(statement.size) +
                   " instead of one above 0 and up to " + CsvTable::Number(largestSize) + " mm");
    }
    statement.morphology = static_cast<PolypMorphology>(this->Word("morphology", morphologyWords));
    statement.note = this->Text("note");
    return statement;
  }

private:
  const std::string & m_Path;
  const Json &        m_Object;
  std::string         m_Name;
};

/** Whether the bytes are a complete PNG file, that is, one whose last chunk is IEND. */
bool
IsCompletePng(const std::string & bytes)
{
  static const std::string end("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
  return IsPng(bytes) && bytes.size() > end.size() && bytes.compare(bytes.size() - end.size(), end.size(), end) == 0;
}

class VerdictFile
{
public:
  VerdictFile(const std::string & path, const ColonExamination & exam)
    : m_Path(path), m_Exam(exam), m_Document(ReadJson(path)), m_Root(path, m_Document, "the file")
  {}

  ReaderVerdicts
  Read() const
  {
    this->RequireExamination();
    ReaderVerdicts       verdicts;
    const VerdictMembers assessment(m_Path, this->ObjectOf("assessment"), "the assessment");
    verdicts.isSecondReader = m_Root.Flag("secondReader");
    verdicts.assessment = { colonicWords[assessment.Word("colonic", colonicWords)],
                            extracolonicWords[assessment.Word("extracolonic", extracolonicWords)],
                            assessment.Text("note") };
    this->ForEach("candidates", "the candidate ", true, [&](const VerdictMembers & members, const std::string & id) {
      verdicts.candidates.push_back(this->CandidateOf(members, id));
    });
    this->ForEach("findings", "the finding ", true, [&](const VerdictMembers & members, const std::string & id) {
      const bool isOutside = members.Flag("extracolonic").value_or(false);
      (isOutside ? verdicts.extracolonic : verdicts.findings).push_back(this->FindingOf(members, id));
    });
    this->ForEach("bookmarks", "the bookmark ", false, [&](const VerdictMembers & members, const std::string & id) {
      verdicts.bookmarks.push_back(this->BookmarkOf(members, id));
    });
    return verdicts;
  }

private:
  void
  RequireExamination() const
  {
    const Json & version = m_Root.At("version");
    if (version != 1 && version != 2)
    {
      m_Root.Refuse("has an unsupported version");
    }
    const VerdictMembers exam(m_Path, this->ObjectOf("exam"), "the examination");
    if (exam.RequiredText("sha256") != m_Exam.Digest())
    {
      throw InputError("the verdicts " + Quoted(m_Path) +
                       " belong to another examination; use verdicts saved for this one");
    }
  }

  /** An empty object if the member is missing. */
  const Json &
  ObjectOf(const char * key) const
  {
    static const Json empty = Json::object();
    const Json &      value = m_Root.At(key);
    return value.is_null() ? empty : value;
  }

  template <typename TTake>
  void
  ForEach(const char * key, const std::string & name, bool isRequired, TTake && take) const
  {
    const Json & list = m_Root.At(key);
    if (!list.is_array() && (isRequired || !list.is_null()))
    {
      m_Root.Refuse("has no list of " + std::string(key));
    }
    std::set<std::string> ids;
    for (const Json & object : list)
    {
      const std::string id = VerdictMembers(m_Path, object, "an entry of the " + std::string(key)).RequiredText("id");
      const VerdictMembers members(m_Path, object, name + Quoted(id));
      if (!ids.insert(id).second)
      {
        members.Refuse("is repeated");
      }
      take(members, id);
    }
  }

  CandidateVerdict
  CandidateOf(const VerdictMembers & members, const std::string & id) const
  {
    if (!FindCandidate(m_Candidates, id))
    {
      members.Refuse("is not a candidate of the examination");
    }
    return { id, static_cast<ReaderVerdict>(members.Word("verdict", verdictWords)), members.Statement("size") };
  }

  ReaderFinding
  FindingOf(const VerdictMembers & members, const std::string & id) const
  {
    members.Coordinates("uv", 2, false); // for the page only
    ReaderFinding finding;
    finding.id = id;
    finding.position = members.Position(m_Exam.GetPositions().size());
    finding.place = members.Place();
    finding.segment = SegmentOf(members);
    finding.arcLength = members.Number("arcLength");
    finding.statement = members.Statement("diameter");
    return finding;
  }

  static int
  SegmentOf(const VerdictMembers & members)
  {
    std::vector<std::string> words{ "" };
    for (int segment = 0; segment <= NumberOfColonSegments; ++segment)
    {
      words.push_back(NameOfSegment(segment));
    }
    return std::max(0, static_cast<int>(members.Word("segment", words)) - 1);
  }

  ReaderBookmark
  BookmarkOf(const VerdictMembers & members, const std::string & id) const
  {
    static const std::string prefix = "data:image/png;base64,";
    const std::string        url = members.RequiredText("picture");
    const auto bytes = url.compare(0, prefix.size(), prefix) == 0 ? BytesOfBase64(url.substr(prefix.size()))
                                                                  : std::optional<std::string>();
    if (!bytes || !IsCompletePng(*bytes))
    {
      members.Refuse("has a picture that is not a PNG file");
    }
    return { id, members.Position(m_Exam.GetPositions().size()), members.Place(), members.Text("label"), *bytes };
  }

  const std::string &                      m_Path;
  const ColonExamination &                 m_Exam;
  Json                                     m_Document;
  VerdictMembers                           m_Root;
  std::vector<std::vector<PolypCandidate>> m_Candidates = m_Exam.ReadCandidates();
};

/** Null for NaN. */
Json
JsonOf(double value)
{
  return std::isnan(value) ? Json() : Json(value);
}

void
AddStatement(const ReaderStatement & statement, const char * sizeKey, Json & object)
{
  object["note"] = statement.note;
  object[sizeKey] = JsonOf(statement.size);
  object["morphology"] = morphologyWords[static_cast<std::size_t>(statement.morphology)];
}

Json
JsonOf(const ReaderFinding & finding)
{
  Json object{ { "id", finding.id },
               { "position", finding.position },
               { "lps", { finding.place[0], finding.place[1], finding.place[2] } },
               { "uv", Json() },
               { "segment", finding.segment > 0 ? NameOfSegment(finding.segment) : "" },
               { "arcLength", JsonOf(finding.arcLength) } };
  AddStatement(finding.statement, "diameter", object);
  return object;
}

Json
JsonOf(const ReaderBookmark & bookmark)
{
  return { { "id", bookmark.id },
           { "position", bookmark.position },
           { "lps", { bookmark.place[0], bookmark.place[1], bookmark.place[2] } },
           { "label", bookmark.label },
           { "picture", "data:image/png;base64," + Base64(bookmark.png) } };
}

void
AddPoint(Markup & markup, const Eigen::Vector3d & place, const std::string & label, const std::string & note)
{
  markup.points.push_back(place);
  markup.labels.push_back(label);
  markup.descriptions.push_back(note);
}
} // namespace

std::string
NameOf(ReaderVerdict verdict)
{
  return verdictWords[static_cast<std::size_t>(verdict)];
}

ReaderVerdicts
ReadReaderVerdicts(const std::string & path, const ColonExamination & exam)
{
  return VerdictFile(path, exam).Read();
}

void
WriteReaderVerdicts(const ReaderVerdicts & verdicts, const ColonExamination & exam, const std::string & path)
{
  Json document{ { "version", 2 },
                 { "exam", { { "seriesUIDs", Json::array() }, { "sha256", exam.Digest() } } },
                 { "secondReader", verdicts.isSecondReader.value_or(false) },
                 { "candidatesRevealed", true },
                 { "assessment",
                   { { "colonic", verdicts.assessment.colonic },
                     { "extracolonic", verdicts.assessment.extracolonic },
                     { "note", verdicts.assessment.note } } },
                 { "candidates", Json::array() },
                 { "findings", Json::array() },
                 { "bookmarks", Json::array() } };
  for (const CandidateVerdict & one : verdicts.candidates)
  {
    Json object{ { "id", one.id }, { "verdict", NameOf(one.verdict) } };
    AddStatement(one.statement, "size", object);
    document["candidates"].push_back(object);
  }
  for (const ReaderFinding & finding : verdicts.findings)
  {
    document["findings"].push_back(JsonOf(finding));
  }
  for (const ReaderFinding & finding : verdicts.extracolonic)
  {
    document["findings"].push_back(JsonOf(finding));
    document["findings"].back()["extracolonic"] = true;
  }
  for (const ReaderBookmark & bookmark : verdicts.bookmarks)
  {
    document["bookmarks"].push_back(JsonOf(bookmark));
  }
  WriteJson(document, path);
}

Markup
MarkupOfVerdicts(const ReaderVerdicts & verdicts, const std::vector<std::vector<PolypCandidate>> & candidates)
{
  Markup markup;
  markup.name = "Verdicts";
  for (const CandidateVerdict & one : verdicts.candidates)
  {
    if (const PolypCandidate * const candidate = FindCandidate(candidates, one.id))
    {
      AddPoint(markup, candidate->position, "candidate " + one.id + ": " + NameOf(one.verdict), one.statement.note);
    }
  }
  for (const ReaderFinding & finding : verdicts.findings)
  {
    AddPoint(markup, finding.place, "finding " + finding.id, finding.statement.note);
  }
  for (const ReaderFinding & finding : verdicts.extracolonic)
  {
    AddPoint(markup, finding.place, "extracolonic finding " + finding.id, finding.statement.note);
  }
  return markup;
}
} // namespace shapeton
