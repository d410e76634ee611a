#include "shapetonDicomMosaic.h"

#include "shapetonDicomText.h"
#include "shapetonPrintable.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace shapeton
{
namespace
{
/** A private attribute identified by its block name (PS3.5 7.8.1); null if missing. */
DcmElement *
FindPrivate(DcmItem & item, Uint16 group, const std::string & creator, unsigned int number)
{
  std::set<unsigned int> blocks;
  for (DcmObject * next = item.nextInContainer(nullptr); next; next = item.nextInContainer(next)) // ascending
  {
    auto * const       element = dynamic_cast<DcmElement *>(next);
    const unsigned int tag = next->getETag();
    OFString           text;
    if (element && next->getGTag() == group && tag >= 0x10 && tag <= 0xFF && element->getOFStringArray(text).good() &&
        Trimmed(text.c_str()) == creator)
    {
      blocks.insert(tag);
    }
    else if (element && next->getGTag() == group && (tag & 0xFF) == number && blocks.count(tag >> 8) > 0)
    {
      return element;
    }
  }
  return nullptr;
}

/** The bytes of an element; private ones have the VR US, or OB or UN if the encoding does not specify it. */
std::vector<char>
BytesOf(DcmElement & element)
{
  std::vector<char> bytes(element.getLength());
  if (bytes.empty() || element.getPartialValue(bytes.data(), 0, static_cast<Uint32>(bytes.size())).bad())
  {
    bytes.clear();
  }
  return bytes;
}

/** The CSA image header is a list of named elements, each with a list of strings. GDCM's parser is not used because it
 * terminates the process on unusual elements. */
std::vector<double>
NumbersInCsaHeader(DcmItem & dataset, const std::string & name, std::size_t count)
{
  // Name, multiplicity, VR, type, number of strings, a constant. Each string follows four lengths and is padded.
  constexpr std::size_t nameLength = 64, stringsOffset = nameLength + 5 * 4, lengths = 4 * 4, padding = 4;
  constexpr std::size_t longestNumber = 32;
  DcmElement * const    element = FindPrivate(dataset, 0x0029, "SIEMENS CSA HEADER", 0x10);
  const auto            bytes = element ? BytesOf(*element) : std::vector<char>();
  const std::string     key = name + '\0';
  auto                place = static_cast<std::size_t>(std::search(bytes.begin(), bytes.end(), key.begin(), key.end()) -
                                        bytes.begin() + stringsOffset);
  std::vector<double> numbers;
  while (numbers.size() < count && place + lengths < bytes.size())
  {
    std::uint32_t length = 0;
    std::memcpy(&length, &bytes[place + sizeof(length)], sizeof(length)); // the second of the four
    const std::size_t start = place + lengths;
    if (length == 0 || length > longestNumber || start + length > bytes.size())
    {
      break;
    }
    numbers.push_back(std::strtod(std::string(&bytes[start], length).c_str(), nullptr));
    place = start + (length + padding - 1) / padding * padding;
  }
  numbers.resize(numbers.size() == count ? count : 0);
  return numbers;
}

unsigned int
TilesOf(DcmItem & dataset)
{
  constexpr double   most = 4096.0; // more than slices of any mosaic
  DcmElement * const element = FindPrivate(dataset, 0x0019, "SIEMENS MR HEADER", 0x0A);
  const auto         bytes = element ? BytesOf(*element) : std::vector<char>();
  if (bytes.size() >= 2)
  {
    return static_cast<unsigned char>(bytes[0]) | static_cast<unsigned int>(static_cast<unsigned char>(bytes[1])) << 8;
  }
  const auto numbers = NumbersInCsaHeader(dataset, "NumberOfImagesInMosaic", 1);
  return numbers.empty() || !(numbers[0] > 0) ? 0 : static_cast<unsigned int>(std::min(numbers[0], most));
}

std::vector<double>
NormalOf(DcmItem & dataset)
{
  DcmElement * const  element = FindPrivate(dataset, 0x0019, "SIEMENS MR HEADER", 0x0D); // VR FD
  const auto          bytes = element ? BytesOf(*element) : std::vector<char>();
  std::vector<double> normal(3);
  if (bytes.size() == normal.size() * sizeof(double))
  {
    std::memcpy(normal.data(), bytes.data(), bytes.size());
    return normal;
  }
  return NumbersInCsaHeader(dataset, "SliceNormalVector", normal.size());
}

bool
SaysMosaic(DcmItem & dataset)
{
  OFString text;
  dataset.findAndGetOFStringArray(DCM_ImageType, text);
  const auto types = SplitDicomValues(text.c_str());
  return std::find(types.begin(), types.end(), "MOSAIC") != types.end();
}
} // namespace

bool
IsSiemensMosaic(DcmItem & dataset)
{
  return SaysMosaic(dataset) || TilesOf(dataset) > 1;
}

std::string
ReadSiemensMosaic(DcmItem & dataset, DicomMosaic & mosaic)
{
  mosaic.tiles = TilesOf(dataset);
  if (mosaic.tiles < 2)
  {
    return "number of slices";
  }
  mosaic.tilesPerRow = static_cast<unsigned int>(std::ceil(std::sqrt(mosaic.tiles)));
  const std::vector<double> normal = NormalOf(dataset);
  const double              squared = std::inner_product(normal.begin(), normal.end(), normal.begin(), 0.0);
  constexpr double          tolerance = 0.01; // of the length of a unit vector; rounded texts are closer
  if (normal.empty() || !(std::abs(squared - 1.0) <= tolerance))
  {
    return "slice normal";
  }
  std::copy(normal.begin(), normal.end(), mosaic.normal);
  return {};
}
} // namespace shapeton
