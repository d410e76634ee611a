#include "shapetonDicomMosaic.h"

#include "shapetonDicomText.h"
#include "shapetonPrintable.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <algorithm>
#include <cstdlib>
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

bool
CountsTiles(DcmItem & dataset)
{
  DcmElement * const element = FindPrivate(dataset, 0x0019, "SIEMENS MR HEADER", 0x0A);
  const auto         bytes = element ? BytesOf(*element) : std::vector<char>();
  return bytes.size() >= 2 && (bytes[1] != 0 || static_cast<unsigned char>(bytes[0]) > 1);
}

/** The CSA header is a list of named elements, each with a list of strings. GDCM's parser is not used because it
 * terminates the process on unusual elements. */
bool
CountsTilesInCsaHeader(DcmItem & dataset)
{
  // Name, multiplicity, VR, type, number of strings, a constant; then the four lengths before the first string.
  constexpr std::size_t textOffset = 64 + 5 * 4 + 4 * 4;
  constexpr std::size_t longestNumber = 12;
  DcmElement * const    element = FindPrivate(dataset, 0x0029, "SIEMENS CSA HEADER", 0x10);
  const auto            bytes = element ? BytesOf(*element) : std::vector<char>();
  const std::string     name = "NumberOfImagesInMosaic";
  const auto            place = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  const auto            left = static_cast<std::size_t>(bytes.end() - place);
  if (left <= textOffset)
  {
    return false;
  }
  const auto        text = place + static_cast<std::ptrdiff_t>(textOffset);
  const auto        length = static_cast<std::ptrdiff_t>(std::min(longestNumber, left - textOffset));
  const std::string number(text, text + length);
  return std::strtol(number.c_str(), nullptr, 10) > 1;
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
  return SaysMosaic(dataset) || CountsTiles(dataset) || CountsTilesInCsaHeader(dataset);
}
} // namespace shapeton
