#include "shapetonReaderLesions.h"

#include "shapetonPolypSearch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace shapeton
{
namespace
{
ReaderLesion
LesionOf(const PolypCandidate & candidate, std::size_t position, const std::vector<CandidateVerdict> & verdicts)
{
  ReaderLesion lesion;
  lesion.id = NameOfCandidate(position, candidate.number);
  lesion.position = position;
  lesion.place = candidate.position;
  lesion.segment = candidate.segment;
  lesion.arcLength = candidate.arcLength;
  lesion.candidate = candidate;
  const auto found =
    std::find_if(verdicts.begin(), verdicts.end(), [&](const CandidateVerdict & one) { return one.id == lesion.id; });
  if (found != verdicts.end())
  {
    lesion.verdict = found->verdict;
    lesion.statement = found->statement;
  }
  return lesion;
}

ReaderLesion
LesionOf(const ReaderFinding & finding)
{
  ReaderLesion lesion;
  lesion.id = finding.id;
  lesion.position = finding.position;
  lesion.verdict = ReaderVerdict::Polyp;
  lesion.place = finding.place;
  lesion.segment = finding.segment;
  lesion.arcLength = finding.arcLength;
  lesion.statement = finding.statement;
  return lesion;
}

void
Join(ReaderLesion & first, ReaderLesion & second)
{
  second.sameAs = first.id;
  first.candidate->diameter = std::max(first.candidate->diameter, second.candidate->diameter); // PolypLesion::size
  if (!first.IsSizeByReader())
  {
    first.statement.size = second.statement.size;
  }
  if (!first.IsMorphologyByReader())
  {
    first.statement.morphology = second.statement.morphology;
  }
}

/** Joins each accepted candidate of the second position with at most one of the first. */
void
JoinPositions(std::vector<ReaderLesion> & lesions)
{
  const auto isAccepted = [](const ReaderLesion & one, std::size_t position) {
    return one.candidate && one.position == position && one.verdict == ReaderVerdict::Polyp;
  };
  const auto isJoined = [&](const ReaderLesion & first) {
    return std::any_of(
      lesions.begin(), lesions.end(), [&](const ReaderLesion & one) { return one.sameAs == first.id; });
  };
  for (ReaderLesion & second : lesions)
  {
    const auto first = std::find_if(lesions.begin(), lesions.end(), [&](const ReaderLesion & one) {
      return isAccepted(one, 0) && isAccepted(second, 1) && AreSameLesion(*one.candidate, *second.candidate) &&
             !isJoined(one);
    });
    if (first != lesions.end())
    {
      Join(*first, second);
    }
  }
}

/** "1 candidate is", "3 candidates are". */
std::string
CandidatesInWords(std::size_t number)
{
  return std::to_string(number) + (number == 1 ? " candidate is" : " candidates are");
}
} // namespace

bool
ReaderLesion::IsSizeByReader() const
{
  return std::isfinite(statement.size);
}

double
ReaderLesion::Size() const
{
  return this->IsSizeByReader() || !candidate ? statement.size : candidate->diameter;
}

bool
ReaderLesion::IsMorphologyByReader() const
{
  return statement.morphology != PolypMorphology::Unknown;
}

PolypMorphology
ReaderLesion::Morphology() const
{
  return this->IsMorphologyByReader() || !candidate ? statement.morphology : candidate->morphology;
}

std::vector<ReaderLesion>
LesionsOf(const ReaderVerdicts & verdicts, const std::vector<std::vector<PolypCandidate>> & candidates)
{
  std::vector<ReaderLesion> lesions;
  for (std::size_t position = 0; position < candidates.size(); ++position)
  {
    for (const PolypCandidate & candidate : candidates[position])
    {
      lesions.push_back(LesionOf(candidate, position, verdicts.candidates));
    }
  }
  for (const ReaderFinding & finding : verdicts.findings)
  {
    lesions.push_back(LesionOf(finding));
  }
  JoinPositions(lesions);
  return lesions;
}

std::vector<ReaderLesion>
LesionsWith(const std::vector<ReaderLesion> & lesions, ReaderVerdict verdict)
{
  std::vector<ReaderLesion> chosen;
  std::copy_if(lesions.begin(), lesions.end(), std::back_inserter(chosen), [&](const ReaderLesion & one) {
    return one.verdict == verdict;
  });
  return chosen;
}

std::string
SizesOfAccepted(const std::vector<ReaderLesion> & lesions)
{
  int small = 0, medium = 0, large = 0, unknown = 0;
  for (const ReaderLesion & one : LesionsWith(lesions, ReaderVerdict::Polyp))
  {
    if (!one.sameAs.empty())
    {
      continue;
    }
    if (!std::isfinite(one.Size()))
    {
      ++unknown;
      continue;
    }
    const PolypSize size = SizeOf(one.Size());
    ++(size == PolypSize::Below6 ? small : size == PolypSize::From6To9 ? medium : large);
  }
  return std::to_string(large) + " of 10 mm and more, " + std::to_string(medium) + " of 6 to 9 mm, " +
         std::to_string(small) + " below 6 mm" +
         (unknown > 0 ? ", " + std::to_string(unknown) + " without a size" : "");
}

std::string
WhyPreliminary(const ReaderAssessment & assessment, const std::vector<ReaderLesion> & lesions)
{
  const std::vector<ReaderLesion> unread = LesionsWith(lesions, ReaderVerdict::Unread);
  const auto                      others = std::count_if(
    unread.begin(), unread.end(), [](const ReaderLesion & one) { return !IsListedAsPolyp(*one.candidate); });
  std::string why;
  if (!unread.empty())
  {
    why = CandidatesInWords(unread.size()) + " unread";
    why += others > 0 ? " (the program listed " + std::to_string(others) +
                          " of them as something else or as part of another candidate)"
                      : "";
  }
  if (assessment.colonic.empty())
  {
    why += (why.empty() ? "" : "; ") + std::string("no category of the colon was entered");
  }
  return why;
}
} // namespace shapeton
