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
  OFCondition status = file.loadFile(path.c_str(), EXS_Unknown, EGL_noChange, maximumEagerValue, ERM_autoDetect);
  if (DicomEncodingOf(file).hasDeflatedFrames)
  {
    constexpr offile_off_t preamble = 132, groupLength = 12; // bytes; the second is the first attribute
    Uint32                 length = 0;
    file.getMetaInfo()->findAndGetUint32(DCM_FileMetaInformationGroupLength, length);
    DcmInputFileStream stream(path.c_str(), preamble + groupLength + static_cast<offile_off_t>(length));
    DcmDataset &       dataset = *file.getDataset();
    dataset.clear();
    dataset.transferInit();
    status = dataset.read(stream, EXS_RLELossless, EGL_noChange, maximumEagerValue); // encapsulated in the same way
    dataset.transferEnd();
  }
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
