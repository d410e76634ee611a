#include "shapetonDicomAttributes.h"

#include "shapetonDicomCharacterSets.h"
#include "shapetonDicomText.h"
#include "shapetonDicomTransferSyntax.h"
#include "shapetonPrintable.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dcistrmf.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/oflog/oflog.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>

namespace shapeton
{
namespace
{
// Longer texts are truncated because they are used in tables and messages.
constexpr std::size_t LongestText = 256;

std::string
BytesOf(DcmItem & item, const DcmTagKey & tag)
{
  OFString bytes;
  return item.findAndGetOFStringArray(tag, bytes).good() ? std::string(bytes.c_str(), bytes.size()) : std::string();
}

[[noreturn]] void
ThrowMalformed(const DcmTagKey & tag, const std::string & value, const std::string & rule)
{
  throw MalformedDicomValue(std::string(DcmTag(tag).getTagName()) + " " + tag.toString().c_str() + " is " +
                            Quoted(Printable(value)) + ", " + rule);
}

double
NumberIn(const DcmTagKey & tag, const std::string & value, const std::string & text)
{
  const char * const first = text.data() + (!text.empty() && text.front() == '+' ? 1 : 0);
  const char * const end = text.data() + text.size();
  double             number = 0;
  const auto         result = std::from_chars(first, end, number);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(number))
  {
    ThrowMalformed(tag,
                   value,
                   text.find(',') != std::string::npos ? "with a comma instead of a decimal point"
                                                       : "which is not a decimal number");
  }
  return number;
}

constexpr Uint16 MetaGroup = 0x0002;

/** The file meta information, in explicit little endian. */
struct FileMeta
{
  std::size_t end{ 0 }; ///< byte after its last attribute; 0 if the file has none
  /** Its group length does not end there. GDCM and pydicom read such files. */
  bool isLengthWrong{ false };
  /** The attributes with VR UI, by element number. */
  std::map<Uint16, std::string> identifiers;

  std::string
  TransferSyntax() const
  {
    const auto found = identifiers.find(DCM_TransferSyntaxUID.getElement());
    return found == identifiers.end() ? std::string() : found->second;
  }
};

constexpr std::size_t Preamble = 132;       // bytes, with the letters DICM
constexpr std::size_t GroupLengthSize = 12; // bytes of the first attribute, whose last four are its value

std::uint32_t
LittleEndian(const std::string & bytes, std::size_t place, std::size_t count)
{
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place + i])) << (8 * i);
  }
  return number;
}

/** Reads the attributes from `place` on (PS3.5 7.1.2). */
FileMeta
ReadFileMeta(const std::string & bytes, std::size_t place)
{
  constexpr std::size_t shortHeader = 8, longHeader = 12;
  FileMeta              meta;
  while (place + longHeader <= bytes.size() && LittleEndian(bytes, place, 2) == MetaGroup)
  {
    const auto        element = static_cast<Uint16>(LittleEndian(bytes, place + 2, 2));
    const std::string vr = bytes.substr(place + 4, 2);
    const bool        isLong = vr == "OB" || vr == "OW" || vr == "UN" || vr == "UT" || vr == "SQ";
    const std::size_t length = isLong ? LittleEndian(bytes, place + shortHeader, 4) : LittleEndian(bytes, place + 6, 2);
    place += isLong ? longHeader : shortHeader;
    if (vr == "UI" && place < bytes.size())
    {
      meta.identifiers[element] = Trimmed(bytes.substr(place, length));
    }
    place += length;
  }
  meta.end = place;
  return meta;
}

FileMeta
FindFileMeta(const std::string & path)
{
  constexpr std::size_t longest = 1u << 16; // bytes; real ones have less than 1,000
  std::ifstream         file(path, std::ios::binary);
  std::string           bytes(longest, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(longest));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t first = Preamble + GroupLengthSize;
  if (bytes.size() < first || bytes.substr(Preamble, 8) != std::string("\2\0\0\0UL\4\0", 8))
  {
    return {};
  }
  FileMeta meta = ReadFileMeta(bytes, first);
  meta.isLengthWrong = meta.end != first + LittleEndian(bytes, first - 4, 4) && meta.end < bytes.size();
  return meta;
}

/** Reads the data set that starts at byte `start`. */
OFCondition
ReadDataset(DcmFileFormat &     file,
            const std::string & path,
            std::size_t         start,
            E_TransferSyntax    syntax,
            unsigned int        maximumEagerValue)
{
  DcmInputFileStream stream(path.c_str(), static_cast<offile_off_t>(start));
  DcmDataset &       dataset = *file.getDataset();
  dataset.clear();
  dataset.transferInit();
  const OFCondition status = dataset.read(stream, syntax, EGL_noChange, maximumEagerValue);
  dataset.transferEnd();
  return status;
}

/** Printable words separated by the original blanks. */
std::string
PrintableWords(const std::string & text)
{
  std::string printable;
  for (std::size_t start = 0; start <= text.size();)
  {
    const std::size_t stop = std::min(text.find(' ', start), text.size());
    printable += (start > 0 ? " " : "") + Printable(text.substr(start, stop - start));
    start = stop + 1;
  }
  return Trimmed(printable);
}

} // namespace

void
PrepareDicomParsing()
{
  if (!dcmDataDict.isDictionaryLoaded())
  {
    throw std::runtime_error("DCMTK's data dictionary is missing; install dcmtk or set DCMDICTPATH");
  }
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  dcmEnableUnknownVRConversion.set(OFTrue);
}

std::vector<double>
DicomNumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count)
{
  const std::string   value = Trimmed(BytesOf(item, tag));
  std::vector<double> numbers;
  for (const std::string & text : SplitDicomValues(value))
  {
    numbers.push_back(NumberIn(tag, value, text));
  }
  if (!numbers.empty() && numbers.size() != count)
  {
    ThrowMalformed(tag, value, "which is not " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
  }
  return numbers;
}

DicomEncoding
DicomEncodingOf(DcmFileFormat & file)
{
  const std::string stated = Trimmed(BytesOf(*file.getMetaInfo(), DCM_TransferSyntaxUID));
  DicomEncoding     encoding;
  if (stated == DeflatedFramesUID)
  {
    return { "Deflated Image Frame Compression", true, false, true, false };
  }
  if (SyntaxOfHighThroughput(stated) != EXS_Unknown)
  {
    return { NameOfNewTransferSyntax(stated), true, false, false, true };
  }
  encoding.isUnknown = !stated.empty() && DcmXfer(stated.c_str()).getXfer() == EXS_Unknown;
  const DcmXfer syntax(file.getDataset()->getOriginalXfer());
  encoding.name = encoding.isUnknown ? NameOfNewTransferSyntax(stated) : std::string(syntax.getXferName());
  encoding.isSupported = !encoding.isUnknown && IsSupported(syntax.getXfer());
  encoding.isJpeg2000 = syntax.getXfer() == EXS_JPEG2000 || syntax.getXfer() == EXS_JPEG2000LosslessOnly;
  return encoding;
}

std::string
LoadDicomFile(DcmFileFormat & file, const std::string & path, unsigned int maximumEagerValue)
{
  const FileMeta meta = FindFileMeta(path);
  if (!meta.isLengthWrong)
  {
    OFCondition status = file.loadFile(path.c_str(), EXS_Unknown, EGL_noChange, maximumEagerValue, ERM_autoDetect);
    const E_TransferSyntax highThroughput =
      SyntaxOfHighThroughput(Trimmed(BytesOf(*file.getMetaInfo(), DCM_TransferSyntaxUID)));
    if (DicomEncodingOf(file).hasDeflatedFrames)
    {
      status = ReadDataset(file, path, meta.end, EXS_RLELossless, maximumEagerValue); // encapsulated in the same way
    }
    else if (highThroughput != EXS_Unknown)
    {
      status = ReadDataset(file, path, meta.end, highThroughput, maximumEagerValue);
    }
    return status.bad() ? status.text() : std::string();
  }
  for (const auto & [element, value] : meta.identifiers)
  {
    file.getMetaInfo()->putAndInsertString(DcmTagKey(MetaGroup, element), value.c_str());
  }
  const DcmXfer     syntax(meta.TransferSyntax().c_str());
  const OFCondition status = ReadDataset(file, path, meta.end, syntax.getXfer(), maximumEagerValue);
  return status.bad() ? status.text() : std::string();
}

DicomText
DicomTextOf(DcmItem & item, const DcmTagKey & tag)
{
  const std::string bytes = BytesOf(item, tag);
  std::string       text = bytes;
  DicomText         result;
  result.isDecoded = DecodeDicomText(CharacterSetsOf(item), text);
  const std::string printable = PrintableWords(text);
  const bool isUtf8 = std::count(printable.begin(), printable.end(), '?') == std::count(text.begin(), text.end(), '?');
  result.isDecoded = result.isDecoded && isUtf8;
  result.text = PrintableWords(printable.substr(0, LongestText));
  return result;
}
} // namespace shapeton
