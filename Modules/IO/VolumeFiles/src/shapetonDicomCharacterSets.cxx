#include "shapetonDicomCharacterSets.h"

#include "shapetonDicomText.h"
#include "shapetonPrintable.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dcspchrs.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/ofstd/ofchrenc.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace shapeton
{
namespace
{
constexpr char Escape = '\x1b'; // starts the escape sequences of ISO 2022

/** "100" for "ISO_IR 100", "ISO 2022 IR 100" and misspellings like "ISO_IR_100"; other terms are unchanged. */
std::string
ShortTerm(const std::string & term)
{
  const auto number =
    std::find_if_not(term.rbegin(), term.rend(), [](unsigned char c) { return std::isdigit(c) != 0; });
  const bool isISO = LowerCase(term.substr(0, 3)) == "iso" && number != term.rbegin();
  return isISO ? std::string(number.base(), term.end()) : term;
}

bool
IsNumberOfSet(const std::string & term)
{
  return !term.empty() && std::isdigit(static_cast<unsigned char>(term.front())) != 0;
}

bool
Holds(const std::vector<std::string> & sets, const std::string & term)
{
  return std::find(sets.begin(), sets.end(), term) != sets.end();
}

/** The terms expected by DcmSpecificCharacterSet. Multi-byte sets exist only with code extensions. */
std::string
TermsOf(const std::vector<std::string> & sets)
{
  const bool  isExtended = sets.size() > 1 || (sets.size() == 1 && (sets[0] == "58" || sets[0] == "149"));
  std::string terms = sets.size() == 1 && isExtended ? "\\" : "";
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    terms += i > 0 ? "\\" : "";
    terms += IsNumberOfSet(sets[i]) ? (isExtended ? "ISO 2022 IR " : "ISO_IR ") + sets[i] : sets[i];
  }
  return terms;
}

bool
ConvertByTerms(const std::string & terms, std::string & text)
{
  DcmSpecificCharacterSet set;
  OFString                converted;
  const bool              isConverted = set.selectCharacterSet(OFString(terms.c_str())).good() &&
                           set.convertString(text.data(), text.size(), converted).good();
  text = isConverted ? std::string(converted.c_str(), converted.size()) : text;
  return isConverted;
}

/** `encoding` is an iconv name. */
bool
ConvertByName(const std::string & encoding, std::string & text)
{
  OFCharacterEncoding converter;
  OFString            converted;
  const bool          isConverted = converter.selectEncoding(encoding.c_str(), "UTF-8").good() &&
                           converter.convertString(text.data(), text.size(), converted).good();
  text = isConverted ? std::string(converted.c_str(), converted.size()) : text;
  return isConverted;
}

/** Converts text with the Japanese escape sequences (PS3.3 C.12.1.1.2) to EUC-JP, which encodes the same sets without
 * escape sequences; returns false for other sequences. */
bool
RewriteAsEucJp(const std::string & text, std::string & rewritten)
{
  const std::map<std::string, std::string> sequences{
    { "(B", "" }, { "(J", "" }, { "$B", "87" }, { "$@", "87" }, { "$(D", "159" }
  };
  std::string set;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isWide = !set.empty() && text[i] > ' ';
    if (text.compare(i, 3, "\x1b)I") == 0) // katakana are always the upper bytes
    {
      i += 2;
    }
    else if (text[i] == Escape)
    {
      const std::size_t length = text.compare(i + 1, 2, "$(") == 0 ? 3 : 2;
      const auto        sequence = sequences.find(text.substr(i + 1, length));
      if (sequence == sequences.end())
      {
        return false;
      }
      set = sequence->second;
      i += length;
    }
    else if (isWide && i + 1 < text.size())
    {
      rewritten += set == "159" ? "\x8f" : "";
      rewritten += static_cast<char>(text[i] | '\x80');
      rewritten += static_cast<char>(text[++i] | '\x80');
    }
    else
    {
      rewritten += (text[i] & '\x80') != 0 ? "\x8e" : "";
      rewritten += text[i];
    }
  }
  return true;
}

bool
ConvertJapanese(std::string & text)
{
  std::string rewritten;
  if (!RewriteAsEucJp(text, rewritten) || !ConvertByName("EUC-JP", rewritten))
  {
    return false;
  }
  text = rewritten;
  return true;
}

/** For writers that omit the escape sequence; the bytes are in one of the declared sets. */
bool
ConvertWithoutEscapes(const std::vector<std::string> & sets, std::string & text)
{
  if (text.find(Escape) != std::string::npos)
  {
    return false;
  }
  const std::map<std::string, std::string> names{ { "58", "GB2312" }, { "149", "EUC-KR" }, { "203", "ISO-8859-15" } };
  return std::any_of(sets.begin(), sets.end(), [&](const std::string & set) {
    const auto name = names.find(set);
    return name != names.end() ? ConvertByName(name->second, text) : ConvertByTerms(TermsOf({ set }), text);
  });
}
} // namespace

std::vector<std::string>
CharacterSetsOf(DcmItem & item)
{
  std::vector<std::string> sets;
  for (DcmItem * around = &item; around; around = around->getParentItem())
  {
    OFString value;
    if (around->findAndGetOFStringArray(DCM_SpecificCharacterSet, value).bad())
    {
      continue;
    }
    for (const std::string & term : SplitDicomValues(std::string(value.c_str(), value.size())))
    {
      sets.push_back(term.empty() ? "6" : ShortTerm(term));
    }
    break;
  }
  return sets;
}

bool
DecodeDicomText(const std::vector<std::string> & sets, std::string & text)
{
  const bool isAscii = std::all_of(text.begin(), text.end(), [](char c) { return (c & '\x80') == 0 && c != Escape; });
  if (isAscii)
  {
    return true;
  }
  const bool isJapanese = Holds(sets, "87") || Holds(sets, "159") || (Holds(sets, "13") && sets.size() > 1);
  return (isJapanese && ConvertJapanese(text)) || ConvertByTerms(TermsOf(sets), text) ||
         ConvertWithoutEscapes(sets, text);
}
} // namespace shapeton
