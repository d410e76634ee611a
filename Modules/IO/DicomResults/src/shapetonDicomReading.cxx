#include "shapetonDicomReading.h"

#include "shapetonContainedProcess.h"
#include "shapetonExceptions.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Longer values stay on disk until they are asked for. */
constexpr Uint32 MaximumEagerValue = 4096;

/** Not a number for what is none. */
double
NumberIn(const std::string & text)
{
  const auto first = text.find_first_not_of(" +");
  const auto last = text.find_last_not_of(std::string(" \0", 2));
  double     number = std::nan("");
  if (first != std::string::npos)
  {
    const char * const end = text.data() + last + 1;
    const auto         result = std::from_chars(text.data() + first, end, number);
    number = result.ec == std::errc() && result.ptr == end ? number : std::nan("");
  }
  return number;
}
} // namespace

std::string
TextOf(DcmItem & item, const DcmTagKey & tag)
{
  OFString text;
  item.findAndGetOFStringArray(tag, text);
  return Printable(std::string(text.c_str(), std::min<std::size_t>(text.size(), 256)));
}

std::vector<double>
NumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count)
{
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i)
  {
    OFString text;
    item.findAndGetOFString(tag, text, i);
    numbers.push_back(NumberIn(text.c_str()));
    if (!std::isfinite(numbers.back()))
    {
      throw std::runtime_error(std::string("its attribute ") + DcmTag(tag).getTagName() + " has not the " +
                               std::to_string(count) + " numbers that it must have");
    }
  }
  return numbers;
}

DcmItem *
ItemOf(DcmItem & item, const DcmTagKey & sequence, signed long number)
{
  DcmItem * found = nullptr;
  return item.findAndGetSequenceItem(sequence, found, number).good() ? found : nullptr;
}

std::vector<DcmItem *>
ItemsOf(DcmItem & item, const DcmTagKey & sequence)
{
  std::vector<DcmItem *> items;
  DcmSequenceOfItems *   all = nullptr;
  if (item.findAndGetSequence(sequence, all).good() && all)
  {
    DcmObject * next = nullptr;
    while ((next = all->nextInContainer(next)) != nullptr)
    {
      items.push_back(static_cast<DcmItem *>(next));
    }
  }
  return items;
}

DicomCode
CodeOf(DcmItem & item, const DcmTagKey & sequence)
{
  DcmItem * const code = ItemOf(item, sequence);
  return code ? DicomCode{ TextOf(*code, DCM_CodeValue),
                           TextOf(*code, DCM_CodingSchemeDesignator),
                           TextOf(*code, DCM_CodeMeaning) }
              : DicomCode{};
}

void
LoadDicomObject(DcmFileFormat & file, const std::string & path, const std::vector<std::string> & sopClassUIDs)
{
  const OFCondition status = file.loadFile(path.c_str(), EXS_Unknown, EGL_noChange, MaximumEagerValue, ERM_autoDetect);
  if (status.bad())
  {
    throw std::runtime_error(std::string("is no DICOM file, or ends too early (") + status.text() + ")");
  }
  const std::string uid = TextOf(*file.getDataset(), DCM_SOPClassUID);
  if (std::find(sopClassUIDs.begin(), sopClassUIDs.end(), uid) == sopClassUIDs.end())
  {
    throw std::runtime_error(std::string("is of the kind ") + dcmFindNameOfUID(uid.c_str(), "unknown") + ", not " +
                             dcmFindNameOfUID(sopClassUIDs.front().c_str(), "the one that is read here"));
  }
  file.getDataset()->convertToUTF8(); // what cannot be converted is printed as '?'
}

void
ReadContained(const std::string &                                                          path,
              const std::string &                                                          request,
              std::size_t                                                                  sharedBytes,
              const std::function<std::string(const std::string &, char *)> &              service,
              const std::function<void(const std::string & response, const char * data)> & take)
{
  if (!std::filesystem::is_regular_file(path))
  {
    throw InputError("\"" + path + "\" is no file; give a DICOM file");
  }
  if (!dcmDataDict.isDictionaryLoaded()) // here, so that the child inherits it
  {
    throw std::runtime_error("DCMTK's data dictionary is missing; install dcmtk or set DCMDICTPATH");
  }
  const ContainedProcess::Limits limits{ (std::size_t(1) << 30) + 2 * sharedBytes, 60, 600 };
  ContainedProcess               process(
    [&service](const std::string & bytes, char * shared) {
      OFLog::configure(OFLogger::OFF_LOG_LEVEL);
      return service(bytes, shared);
    },
    sharedBytes,
    limits);
  try
  {
    const std::string response = process.Call(request);
    take(response, process.GetShared());
  }
  catch (const std::runtime_error & failure)
  {
    throw InputError("\"" + path + "\" " + failure.what() + "; give another file, or write it again");
  }
}
} // namespace shapeton
