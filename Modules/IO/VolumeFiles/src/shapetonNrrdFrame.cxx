#include "shapetonNrrdFrame.h"

#include "shapetonFileErrors.h"
#include "shapetonPrintable.h"
#include "shapetonTextHeader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

namespace shapeton
{
namespace
{
constexpr std::size_t axes = 3;

bool
IsFiniteNumber(const std::string & word)
{
  double     value = 0.0;
  const auto first = word.data() + (word.compare(0, 1, "+") == 0 ? 1 : 0);
  const auto [end, error] = std::from_chars(first, word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

/** Checks the numbers of a field; words in `others` are allowed. */
void
RequireNumbers(const std::string &              path,
               const TextHeader &               header,
               const std::string &              field,
               const std::vector<std::string> & others)
{
  std::string text = LowerCase(header.ValueOf(field, ':'));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (!IsFiniteNumber(word) && std::find(others.begin(), others.end(), word) == others.end())
    {
      ThrowUnsuitable(path,
                      "its field \"" + field + "\" contains " + Quoted(Printable(word)) +
                        ", which is not a finite number; repair the header");
    }
  }
}

std::vector<std::string>
WordsOf(const std::string & text)
{
  std::istringstream words(text);
  return { std::istream_iterator<std::string>(words), {} };
}

/** Quoted words; unquoted text is one word. */
std::vector<std::string>
QuotedWords(const std::string & text)
{
  std::vector<std::string> words;
  for (std::size_t start = text.find('"'); start != std::string::npos; start = text.find('"', start))
  {
    const std::size_t end = text.find('"', start + 1);
    if (end == std::string::npos)
    {
      break;
    }
    words.push_back(Trimmed(text.substr(start + 1, end - start - 1)));
    start = end + 1;
  }
  return words;
}

[[noreturn]] void
ThrowUnknown(const std::string & path, const std::string & field, const std::string & value, const std::string & advice)
{
  ThrowUnsuitable(path, "its " + field + ", " + Quoted(Printable(value)) + ", is not one of NRRD; " + advice);
}

void
RequireWords(const std::string & path, const std::string & field, std::size_t words, const std::string & wanted)
{
  if (words > 0 && std::to_string(words) != wanted)
  {
    ThrowUnsuitable(path,
                    "its field \"" + field + "\" has " + std::to_string(words) + " words instead of " +
                      Printable(wanted) + "; repair the header");
  }
}

/** Voxels of more than one byte have an order of bytes. */
void
RequireEndian(const std::string & path, const TextHeader & header)
{
  static const std::regex oneByte("signed char|u?int8(_t)?|u(nsigned )?char");
  static const std::regex more("((un)?signed )?(short|long long|int|long)( int)?|ushort|uint|u?longlong|"
                               "u?int(16|32|64)(_t)?|float|double|block");
  const std::string       type = LowerCase(header.ValueOf("type", ':'));
  const std::string       encoding = LowerCase(header.ValueOf("encoding", ':'));
  const bool              isText = encoding == "ascii" || encoding == "text" || encoding == "txt";
  constexpr std::size_t   longestType = 40;
  if (type.size() < longestType && std::regex_match(type, oneByte))
  {
    return;
  }
  if (type.size() >= longestType || !std::regex_match(type, more))
  {
    ThrowUnknown(path, "type", type, "repair the header");
  }
  const std::string endian = LowerCase(header.ValueOf("endian", ':'));
  if (endian.empty() && !isText)
  {
    ThrowUnsuitable(path,
                    "its field \"endian\" is missing, which type " + type +
                      " requires; add \"endian: little\" or \"endian: big\"");
  }
  if (!endian.empty() && endian != "little" && endian != "big")
  {
    ThrowUnknown(path, "endian", endian, "use little or big");
  }
}

/** Checks the fields of a volume, because the errors of NRRD's reader often do not name the field. */
void
RequireFields(const std::string & path, const TextHeader & header)
{
  const std::string version = header.lines.empty() ? "" : header.lines.front();
  if (version != "NRRD00.01" && (version < "NRRD0001" || version > "NRRD0005"))
  {
    ThrowUnknown(path, "first line", version, "versions NRRD0001 to NRRD0005 are known");
  }
  for (const std::string field : { "type", "dimension", "sizes", "encoding" })
  {
    if (header.ValueOf(field, ':').empty())
    {
      ThrowUnsuitable(path, "its field \"" + field + "\" is missing; add it to the header");
    }
  }
  const std::string dimension = header.ValueOf("dimension", ':');
  for (const std::string field : { "sizes", "spacings", "kinds", "centerings" })
  {
    RequireWords(path, field, WordsOf(header.ValueOf(field, ':')).size(), dimension);
  }
  for (const std::string & word : WordsOf(header.ValueOf("sizes", ':')))
  {
    if (word.find_first_not_of("0123456789") != std::string::npos || std::strtoull(word.c_str(), nullptr, 10) == 0)
    {
      ThrowUnsuitable(path, "its size " + Quoted(Printable(word)) + " is not a positive integer; repair the header");
    }
  }
  RequireWords(path, "space units", QuotedWords(header.ValueOf("space units", ':')).size(), std::to_string(axes));
  RequireEndian(path, header);
  const bool hasSpace = !(header.ValueOf("space", ':') + header.ValueOf("space dimension", ':')).empty();
  for (const std::string field : { "space directions", "space origin", "measurement frame" })
  {
    if (!hasSpace && !header.ValueOf(field, ':').empty())
    {
      ThrowUnsuitable(path,
                      "its field \"" + field +
                        "\" requires a space; add \"space: left-posterior-superior\" if its numbers are LPS "
                        "coordinates");
    }
  }
}

/** Sets the signs; see the definition of the spaces in NRRD, section 4. */
void
ReadSpace(const std::string & path, const TextHeader & header, NrrdFrame & frame)
{
  std::string       space = LowerCase(header.ValueOf("space", ':'));
  const std::string time = "-time";
  const bool isLong = space.size() > time.size() && space.compare(space.size() - time.size(), time.size(), time) == 0;
  const bool isShort = space == "rast" || space == "last" || space == "lpst";
  const bool hasTime = isLong || isShort;
  space = isLong ? space.substr(0, space.size() - time.size()) : isShort ? space.substr(0, axes) : space;
  if (space == "ras" || space == "right-anterior-superior")
  {
    const double sign = hasTime ? -1.0 : 1.0; // ITK turns it without time
    frame.signs = { sign, sign, 1.0 };
  }
  else if (space == "las" || space == "left-anterior-superior")
  {
    frame.signs = { hasTime ? 1.0 : -1.0, -1.0, 1.0 }; // ITK turns x without time
  }
  else if (space == "3d-left-handed" || space == "3dlh")
  {
    ThrowUnsuitable(path, "its space is left-handed, and coordinates of a patient are right-handed; mirror an axis");
  }
  else if (space == "3d-right-handed" || space == "3drh" || space == "scanner-xyz" || space == "scannerxyz" ||
           (space.empty() && !header.ValueOf("space dimension", ':').empty()))
  {
    frame.notes.push_back("its space" + (space.empty() ? " without a name" : ", " + space + ",") +
                          " does not state the orientation of a patient: x, y and z are taken as left, posterior and "
                          "superior");
  }
  else if (!space.empty() && space != "lps" && space != "left-posterior-superior")
  {
    ThrowUnknown(path, "space", space, "use left-posterior-superior and LPS coordinates");
  }
}

/** Converts lengths to millimeters; an unknown unit is taken as millimeters, with a note. */
void
ReadUnits(const std::string & path, const TextHeader & header, NrrdFrame & frame)
{
  static const std::map<std::string, double> known{
    { "mm", 1.0 },       { "millimeter", 1.0 },  { "millimeters", 1.0 },  { "cm", 10.0 },        { "m", 1000.0 },
    { "meter", 1000.0 }, { "meters", 1000.0 },   { "um", 1e-3 },          { "\xC2\xB5m", 1e-3 }, { "micron", 1e-3 },
    { "microns", 1e-3 }, { "micrometer", 1e-3 }, { "micrometers", 1e-3 }, { "nm", 1e-6 }
  };
  std::vector<std::string> units = QuotedWords(LowerCase(header.ValueOf("space units", ':')));
  units = units.empty() ? QuotedWords(LowerCase(header.ValueOf("units", ':'))) : units;
  units.resize(std::min(units.size(), axes));
  units.erase(std::remove(units.begin(), units.end(), ""), units.end());
  if (units.empty())
  {
    return;
  }
  if (std::adjacent_find(units.begin(), units.end(), std::not_equal_to<>()) != units.end())
  {
    ThrowUnsuitable(path, "its axes have different units; convert all of them to mm");
  }
  const auto found = known.find(units.front());
  if (found == known.end())
  {
    frame.notes.push_back("its unit of length, " + Quoted(Printable(units.front())) + ", is unknown: mm is assumed");
    return;
  }
  frame.millimeters = found->second;
  if (frame.millimeters != 1.0)
  {
    frame.notes.push_back("lengths were converted from " + units.front() + " to mm");
  }
}

void
ReadExtent(const TextHeader & header, NrrdFrame & frame)
{
  std::string text = header.ValueOf("segmentation_extent", ':');
  if (text.empty() || !header.ValueOf("segmentation_referenceimageextentoffset", ':').empty())
  {
    return;
  }
  std::istringstream bounds(text.substr(text.front() == '=' ? 1 : 0));
  for (double & first : frame.first)
  {
    double last = 0.0;
    bounds >> first >> last;
  }
  if (!bounds)
  {
    frame.first = {};
  }
  else if (frame.first != std::array<double, axes>{})
  {
    frame.notes.push_back("a segmentation of 3D Slicer until 2016: placed by its Segmentation_Extent");
  }
}
} // namespace

NrrdFrame::NrrdFrame(const std::string & path)
{
  const TextHeader header = ReadNrrdHeader(path);
  RequireFields(path, header);
  const std::vector<std::string> kinds = WordsOf(header.ValueOf("kinds", ':'));
  const std::string              layers = WordsOf(header.ValueOf("sizes", ':')).front();
  if (!header.ValueOf("segment0_id", ':').empty() && !kinds.empty() && kinds.front() == "list" && layers != "1")
  {
    ThrowUnsuitable(path,
                    "its segments overlap and are stored in " + Printable(layers) +
                      " layers; export them as a label map, or segments that do not overlap");
  }
  RequireNumbers(path, header, "space directions", { "none" });
  RequireNumbers(path, header, "space origin", {});
  RequireNumbers(path, header, "spacings", { "nan" });
  ReadSpace(path, header, *this);
  ReadUnits(path, header, *this);
  ReadExtent(header, *this);
}
} // namespace shapeton
