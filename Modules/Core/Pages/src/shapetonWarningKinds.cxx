#include "shapetonWarningKinds.h"

#include <algorithm>
#include <cctype>

namespace shapeton
{
namespace
{
/** A warning split at its numbers and quoted names: words[0] values[0] words[1] etc. */
struct WarningParts
{
  std::vector<std::string> words{ "" };
  std::vector<std::string> values;
};

bool
IsDigitAt(const std::string & text, std::size_t at)
{
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

/** The end of the number or quoted name at a position, or the position itself. */
std::size_t
EndOfValue(const std::string & text, std::size_t at)
{
  if (text[at] == '"')
  {
    const std::size_t closing = text.find('"', at + 1);
    return closing == std::string::npos ? at : closing + 1;
  }
  const bool  isJoined = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1]));
  std::size_t end = text[at] == '-' && !isJoined ? at + 1 : at;
  if (!IsDigitAt(text, end))
  {
    return at;
  }
  while (IsDigitAt(text, end) || (text[end] == '.' && IsDigitAt(text, end + 1)))
  {
    ++end;
  }
  return end;
}

WarningParts
PartsOf(const std::string & warning)
{
  WarningParts parts;
  for (std::size_t at = 0; at < warning.size();)
  {
    const std::size_t end = EndOfValue(warning, at);
    if (end == at)
    {
      parts.words.back() += warning[at++];
      continue;
    }
    parts.values.push_back(warning.substr(at, end - at));
    parts.words.emplace_back();
    at = end;
  }
  return parts;
}

/** 0 for failures and missing results, 1 for doubtful results, 2 for notes. Warnings are plain text, so the class is
 * determined by the words used in the warnings of this repository. Warnings without known words are ranked last. */
int
RankOf(const std::string & warning)
{
  const std::vector<std::vector<std::string>> wordsOfRank{ { " fail",
                                                             "cannot",
                                                             "could not",
                                                             "not found",
                                                             "not made",
                                                             "not used",
                                                             "not removed",
                                                             "not split",
                                                             "missing",
                                                             "is not there",
                                                             " no ",
                                                             " none ",
                                                             " refuse",
                                                             "nothing",
                                                             "too many" },
                                                           { "doubt",
                                                             "uncertain",
                                                             " may ",
                                                             "disagree",
                                                             "contradict",
                                                             " differ",
                                                             "different",
                                                             " or ",
                                                             "look at",
                                                             "folded",
                                                             "flipped",
                                                             "not yet",
                                                             "not known",
                                                             "collapsed",
                                                             "assumed",
                                                             "depends on",
                                                             "noise",
                                                             "merged",
                                                             "instead of" } };
  std::string                                 words(" ");
  std::transform(warning.begin(), warning.end(), std::back_inserter(words), [](unsigned char c) {
    return std::isspace(c) ? ' ' : static_cast<char>(std::tolower(c));
  });
  const auto isNamed = [&](const std::string & word) { return words.find(word) != std::string::npos; };
  const auto rank = std::find_if(wordsOfRank.begin(), wordsOfRank.end(), [&](const auto & ofRank) {
    return std::any_of(ofRank.begin(), ofRank.end(), isNamed);
  });
  return static_cast<int>(rank - wordsOfRank.begin());
}

/** Merges one more warning into the common text of a kind. */
void
JoinValues(std::vector<std::string> & values, const std::vector<std::string> & more)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = values[i] == more[i] ? values[i] : "\u2026";
  }
}

std::string
TextOf(const WarningParts & parts)
{
  std::string text = parts.words.front();
  for (std::size_t i = 0; i < parts.values.size(); ++i)
  {
    text += parts.values[i] + parts.words[i + 1];
  }
  return text;
}
} // namespace

std::vector<WarningKind>
KindsOf(const std::vector<std::string> & warnings)
{
  std::vector<WarningParts> common;
  std::vector<WarningKind>  kinds;
  for (const std::string & warning : warnings)
  {
    const WarningParts parts = PartsOf(warning);
    const auto         known =
      std::find_if(common.begin(), common.end(), [&](const WarningParts & kind) { return kind.words == parts.words; });
    const std::size_t index = known - common.begin();
    if (known == common.end())
    {
      common.push_back(parts);
      kinds.emplace_back();
    }
    JoinValues(common[index].values, parts.values);
    kinds[index].text = TextOf(common[index]);
    kinds[index].warnings.push_back(warning);
  }
  std::stable_sort(kinds.begin(), kinds.end(), [](const WarningKind & a, const WarningKind & b) {
    return RankOf(a.warnings.front()) < RankOf(b.warnings.front());
  });
  return kinds;
}
} // namespace shapeton
