#include "shapetonDicomReading.h"

#include "shapetonByteStream.h"
#include "shapetonDicomAttributes.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Longer values stay on disk until they are accessed. */
constexpr Uint32 MaximumEagerValue = 4096;
} // namespace

std::string
TextOf(DcmItem & item, const DcmTagKey & tag)
{
  return DicomTextOf(item, tag).text;
}

std::vector<double>
NumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count)
{
  std::vector<double> numbers;
  try
  {
    numbers = DicomNumbersOf(item, tag, count);
  }
  catch (const MalformedDicomValue & malformed)
  {
    throw std::runtime_error(std::string("cannot be read: its ") + malformed.what());
  }
  if (numbers.empty())
  {
    throw std::runtime_error(std::string("lacks its attribute ") + DcmTag(tag).getTagName());
  }
  return numbers;
}

int
WordOf(DcmItem & item, const DcmTagKey & tag)
{
  const double     number = NumbersOf(item, tag, 1).front();
  constexpr double greatest = 65535.0;
  if (!(number >= 0 && number <= greatest && number == std::floor(number)))
  {
    throw std::runtime_error(std::string("cannot be read: its ") + DcmTag(tag).getTagName() +
                             " is not a whole number from 0 to 65535");
  }
  return static_cast<int>(number);
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
  const std::string   fault = LoadDicomFile(file, path, MaximumEagerValue);
  const DicomEncoding encoding = DicomEncodingOf(file);
  if (encoding.isUnknown)
  {
    throw std::runtime_error("is encoded as " + encoding.name + ", which is not supported; decompress it");
  }
  if (!fault.empty())
  {
    throw std::runtime_error("is not a DICOM file or is truncated (" + fault + ")");
  }
  const std::string uid = TextOf(*file.getDataset(), DCM_SOPClassUID);
  if (std::find(sopClassUIDs.begin(), sopClassUIDs.end(), uid) == sopClassUIDs.end())
  {
    throw std::runtime_error(std::string("is of the kind ") + dcmFindNameOfUID(uid.c_str(), "unknown") + ", not " +
                             dcmFindNameOfUID(sopClassUIDs.front().c_str(), "the supported kind"));
  }
}

void
ReadContained(const std::string &                                                          path,
              const char *                                                                 service,
              std::size_t                                                                  sharedBytes,
              const std::function<void(const std::string & response, const char * data)> & take)
{
  if (!std::filesystem::is_regular_file(path))
  {
    throw InputError("\"" + path + "\" is not a file; use a DICOM file");
  }
  constexpr unsigned int         cpuSeconds = 60;
  constexpr unsigned int         wallSeconds = 600; // generous, for slow network drives
  const ContainedProcess::Limits limits{ (std::size_t(1) << 30) + 2 * sharedBytes, cpuSeconds, wallSeconds };
  ContainedProcess               process(service, sharedBytes, limits);
  ByteWriter                     request;
  request & path & static_cast<std::uint64_t>(sharedBytes);
  try
  {
    const std::string response = process.Call(request.GetBytes());
    take(response, process.GetShared());
  }
  catch (const std::runtime_error & failure)
  {
    throw InputError("\"" + path + "\" " + failure.what() + "; use another file, or export it again");
  }
}

ContainedService
MakeDicomService(std::string (*parse)(const std::string & path, std::size_t sharedBytes, char * shared))
{
  PrepareDicomParsing();
  return [parse](const std::string & bytes, char * shared) {
    std::string      path;
    std::uint64_t    sharedBytes = 0;
    ByteReader       request(bytes);
    request & path & sharedBytes;
    return parse(path, sharedBytes, shared);
  };
}
} // namespace shapeton
