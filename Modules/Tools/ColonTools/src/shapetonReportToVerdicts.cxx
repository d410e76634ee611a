#include "shapetonColonReportsAsDicom.h"
#include "shapetonDicomToColon.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

namespace shapeton
{
namespace
{
/** OHIF repeats the size of a candidate with this precision unless the reader moved an end of its line. */
constexpr double leastChange = 0.05; // mm

std::size_t
PositionOf(const ColonExamination & exam, const DicomSource & source)
{
  for (std::size_t position = 0; position < exam.GetPositions().size(); ++position)
  {
    if (SeriesOfQuality(exam.GetPositions()[position].ReadQuality()) == source.series.GetSelector())
    {
      return position;
    }
  }
  throw InputError("the examination \"" + exam.GetFolder() + "\" was not computed from the series " +
                   source.series.uid + "; use the series of the report and its examination");
}

/** The parts of a label such as "candidate 3: not a polyp, fold". */
struct Label
{
  /** 0 if none is named. */
  int           candidate{ 0 };
  ReaderVerdict verdict{ ReaderVerdict::Unread };
  std::string   note;
};

Label
ParseLabel(const std::string & text)
{
  static const std::regex pattern(
    R"(^\s*(?:candidate\s+([0-9]{1,6})\b[\s:,;.-]*)?(?:(not a polyp|polyp|unsure)\b[\s:,;.-]*)?([\s\S]*)$)",
    std::regex::icase);
  Label       label;
  std::smatch parts;
  if (!std::regex_match(text, parts, pattern))
  {
    label.note = text;
    return label;
  }
  std::string word = parts[2];
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const ReaderVerdict verdict : { ReaderVerdict::Polyp, ReaderVerdict::NotAPolyp, ReaderVerdict::Unsure })
  {
    label.verdict = word == NameOf(verdict) ? verdict : label.verdict;
  }
  label.candidate = parts[1].matched ? std::stoi(parts[1]) : 0;
  label.note = parts[3];
  return label;
}

/** The candidate that a measurement names as finding site or in its label; 0 for none. */
int
NumberOfCandidate(const DicomReportPoints & points, const Label & label)
{
  static const std::regex pattern(std::string(CandidateCodePrefix) + "([0-9]{1,6})");
  for (const DicomCode & site : points.sites)
  {
    std::smatch parts;
    if (site.scheme == "99SHAPETON" && std::regex_match(site.value, parts, pattern))
    {
      return std::stoi(parts[1]);
    }
  }
  return label.candidate;
}

Eigen::Vector3d
MiddleOf(const DicomReportPoints & points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto & place : points.places)
  {
    sum += Eigen::Vector3d(place.GetDataPointer());
  }
  return sum / static_cast<double>(points.places.size());
}

CandidateVerdict
VerdictOn(const PolypCandidate &    candidate,
          const std::string &       id,
          const DicomReportPoints & points,
          const Label &             label)
{
  CandidateVerdict verdict;
  verdict.id = id;
  verdict.verdict = label.verdict;
  verdict.statement.note = label.note;
  if (std::abs(points.length - candidate.diameter) > leastChange)
  {
    verdict.statement.size = points.length;
  }
  return verdict;
}

ReaderFinding
FindingOf(const DicomReportPoints & points, const Label & label, std::size_t position, std::size_t number)
{
  ReaderFinding finding;
  finding.id = "F" + std::to_string(number);
  finding.position = position;
  finding.place = MiddleOf(points);
  finding.statement.size = points.length;
  finding.statement.note = label.note;
  return finding;
}
} // namespace

ReaderVerdicts
VerdictsOfReport(const std::vector<DicomReportPoints> & points,
                 const ColonExamination &               exam,
                 const DicomSource &                    source,
                 Remarks &                              remarks)
{
  const std::size_t                       position = PositionOf(exam, source);
  const auto                              candidates = exam.ReadCandidates();
  ReaderVerdicts                          verdicts;
  std::map<std::string, CandidateVerdict> verdictOf;
  for (const DicomReportPoints & one : points)
  {
    const Label                  label = ParseLabel(one.comment);
    const std::string            id = NameOfCandidate(position, NumberOfCandidate(one, label));
    const PolypCandidate * const candidate = FindCandidate(candidates, id);
    if (candidate && !verdictOf.try_emplace(id, VerdictOn(*candidate, id, one, label)).second)
    {
      throw InputError("the report measures candidate " + id +
                       " twice; use a report that the reader saved, with one measurement of each candidate");
    }
    if (!candidate && label.verdict == ReaderVerdict::Polyp)
    {
      verdicts.findings.push_back(FindingOf(one, label, position, verdicts.findings.size() + 1));
    }
    if (!candidate && label.verdict != ReaderVerdict::Polyp)
    {
      remarks.push_back("a measurement labeled " + Quoted(Printable(one.comment)) +
                        " is not a candidate, and its label does not begin with polyp; it was skipped");
    }
  }
  for (const PolypCandidate & candidate : candidates[position])
  {
    const std::string id = NameOfCandidate(position, candidate.number);
    const auto        found = verdictOf.find(id);
    if (found != verdictOf.end())
    {
      verdicts.candidates.push_back(found->second);
    }
    else
    {
      remarks.push_back("the report does not contain candidate " + id + ", which remains unread");
    }
  }
  return verdicts;
}
} // namespace shapeton
