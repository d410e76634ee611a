#include "shapetonStoredVoxels.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonNiftiHeader.h"
#include "shapetonPrintable.h"
#include "shapetonTextHeader.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** The names that a pattern of printf with one %d stands for; empty if it is none. */
std::vector<std::string>
NamesOf(const std::string & pattern, long first, long last, long step)
{
  constexpr std::size_t    mostFiles = 100'000;     // more than slices of any volume
  constexpr long           largest = 1'000'000'000; // of the numbers
  constexpr std::size_t    longestName = 1000;      // std::regex recurses for each character
  static const std::regex  one("([^%]*)%(0?)([0-9]{0,2})[di]([^%]*)");
  std::smatch              parts;
  std::vector<std::string> names;
  if (pattern.size() > longestName || std::max({ std::abs(first), std::abs(last), std::abs(step) }) > largest ||
      step == 0 || !std::regex_match(pattern, parts, one))
  {
    return names;
  }
  const auto width = static_cast<std::size_t>(std::atoi(parts[3].str().c_str()));
  for (long i = first; (step > 0 ? i <= last : i >= last) && names.size() < mostFiles; i += step)
  {
    const std::string digits = std::to_string(i);
    const std::string padding(std::max(width, digits.size()) - digits.size(), parts[2].length() > 0 ? '0' : ' ');
    names.push_back(parts[1].str() + padding + digits + parts[4].str());
  }
  return names;
}

/** The data files that a field of a header references: one name, the lines after the word LIST, or a pattern with the
 * first and last number and the step. Throws InputError if one is missing. */
std::vector<std::string>
DetachedFiles(const std::string & path, const TextHeader & header, const std::string & key, char separator)
{
  const std::string        value = header.ValueOf(key, separator);
  std::vector<std::string> names{ value };
  std::istringstream       words(value);
  std::string              first;
  words >> first;
  if (LowerCase(first) == "list")
  {
    names = header.LinesAfter(key, separator);
  }
  else if (value.find('%') != std::string::npos)
  {
    long begin = 0, last = 0, step = 0;
    words >> begin >> last >> step;
    names = words ? NamesOf(first, begin, last, step) : std::vector<std::string>{};
  }
  if (names.empty())
  {
    ThrowUnsuitable(path,
                    "it names no data file (" + Quoted(Printable(value)) +
                      "); state one name, LIST and names in the next lines, or a pattern with %d, first and last "
                      "number, and step");
  }
  for (std::string & name : names)
  {
    name = (fs::path(path).parent_path() / name).string();
    std::error_code error;
    if (!fs::is_regular_file(name, error))
    {
      ThrowUnsuitable(path, "its data file " + name + " is missing");
    }
  }
  return names;
}

/** "nan" means that an axis has no spacing in NRRD. */
bool
NrrdStatesSpacing(const TextHeader & header)
{
  const std::string  directions = header.ValueOf("space directions", ':');
  std::istringstream spacings(LowerCase(header.ValueOf("spacings", ':')));
  std::ptrdiff_t     stated = std::count(directions.begin(), directions.end(), '(');
  for (std::string word; spacings >> word;)
  {
    stated += word != "nan" ? 1 : 0;
  }
  return stated >= 3;
}

/** 0 if the header has neither name of a field. */
long
SkipOf(const TextHeader & header, const char * name, const char * otherName)
{
  const std::string value = header.ValueOf(name, ':') + header.ValueOf(otherName, ':');
  return value.empty() ? 0 : std::strtol(value.c_str(), nullptr, 10);
}

/** Lines are skipped in each file, bytes in the file or, if it is compressed, in the inflated stream. */
void
SkipInNrrd(const std::string & path, const TextHeader & header, StoredVoxels & voxels)
{
  const long lines = SkipOf(header, "line skip", "lineskip");
  const long bytes = SkipOf(header, "byte skip", "byteskip");
  const bool isCompressed = voxels.coding == VoxelCoding::deflated || voxels.coding == VoxelCoding::bzip2;
  if (lines < 0 || (bytes < 0 && voxels.coding != VoxelCoding::raw))
  {
    ThrowUnsuitable(path,
                    lines < 0 ? "its line skip is negative; repair the header"
                              : "its byte skip is negative, which is defined for raw data only; repair the header");
  }
  std::ifstream file(voxels.files.front(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(voxels.offset));
  std::string line;
  for (long i = 0; i < lines && std::getline(file, line); ++i)
  {
    voxels.offset += line.size() + 1;
  }
  voxels.areLast = bytes < 0;
  if (bytes > 0)
  {
    (isCompressed ? voxels.inflatedOffset : voxels.offset) += static_cast<std::uint64_t>(bytes);
  }
}

VoxelCoding
CodingOfNrrd(const std::string & path, const TextHeader & header)
{
  const std::string encoding = LowerCase(header.ValueOf("encoding", ':'));
  const auto        is = [&](std::initializer_list<const char *> names) {
    return std::find(names.begin(), names.end(), encoding) != names.end();
  };
  if (!is({ "raw", "gzip", "gz", "bzip2", "bz2", "ascii", "text", "txt", "hex" }))
  {
    ThrowUnsuitable(path, "its encoding " + Quoted(Printable(encoding)) + " is not one of NRRD; use raw or gzip");
  }
  return is({ "raw" })            ? VoxelCoding::raw
         : is({ "gzip", "gz" })   ? VoxelCoding::deflated
         : is({ "bzip2", "bz2" }) ? VoxelCoding::bzip2
         : is({ "hex" })          ? VoxelCoding::hex
                                  : VoxelCoding::text;
}

StoredVoxels
LocateNrrdVoxels(const std::string & path)
{
  const TextHeader header = ReadNrrdHeader(path);
  if (header.lines.empty() || header.lines.front().compare(0, 4, "NRRD") != 0)
  {
    ThrowUnsuitable(path, "not a NRRD file");
  }
  StoredVoxels voxels{ { path }, header.bytes };
  for (const std::string key : { "data file", "datafile" })
  {
    if (!header.ValueOf(key, ':').empty())
    {
      voxels = { DetachedFiles(path, header, key, ':') };
    }
  }
  voxels.coding = CodingOfNrrd(path, header);
  SkipInNrrd(path, header, voxels);
  voxels.canBeTaken = voxels.coding == VoxelCoding::deflated || voxels.coding == VoxelCoding::bzip2;
  voxels.isBigEndian = LowerCase(header.ValueOf("endian", ':')) == "big";
  return voxels;
}

StoredVoxels
LocateMetaVoxels(const std::string & path)
{
  const TextHeader  header = ReadMetaHeader(path);
  const std::string key = "elementdatafile";
  const std::string data = LowerCase(header.ValueOf(key, '='));
  if (data.empty())
  {
    ThrowUnsuitable(path, "not a MetaImage file: ElementDataFile is missing");
  }
  const std::string dimensions = header.ValueOf("ndims", '=');
  if (dimensions.size() != 1 || dimensions < "1" || dimensions > "9") // MetaIO does not check the number
  {
    ThrowUnsuitable(path, "NDims must be between 1 and 9, got " + Quoted(Printable(dimensions)));
  }
  StoredVoxels voxels{ { path }, header.bytes };
  if (data != "local")
  {
    voxels = { DetachedFiles(path, header, key, '=') };
  }
  if (LowerCase(header.ValueOf("compresseddata", '=')) == "true")
  {
    voxels.coding = VoxelCoding::deflated;
  }
  else if (LowerCase(header.ValueOf("binarydata", '=')) == "false")
  {
    ThrowUnsuitable(path, "MetaImage with voxels as text (BinaryData = False) is not supported; store them binary");
  }
  return voxels;
}

StoredVoxels
LocateNiftiVoxels(const std::string & path)
{
  const NiftiHeader header = ReadNiftiHeader(NiftiHeaderFile(path));
  StoredVoxels      voxels{ { header.voxelFile } };
  voxels.canBeTaken = true;
  std::ifstream file(header.voxelFile, std::ios::binary);
  if (file.get() == 0x1F && file.get() == 0x8B) // gzip, regardless of the file name
  {
    voxels.coding = VoxelCoding::deflated;
    voxels.inflatedOffset = header.voxelOffset;
  }
  else
  {
    voxels.offset = header.voxelOffset;
  }
  return voxels;
}

// ---- verification ----

std::uint64_t
LengthOf(const StoredVoxels & voxels)
{
  std::uint64_t total = 0;
  for (const std::string & file : voxels.files)
  {
    std::error_code error;
    const auto      length = fs::file_size(file, error);
    total += error || length < voxels.offset ? 0 : length - voxels.offset;
  }
  return total;
}

void
TakeRaw(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  std::ifstream file(voxels.files.front(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(voxels.offset));
  std::vector<char> buffer(1u << 18);
  for (std::uint64_t place = 0; file && place < bytes; place += static_cast<std::uint64_t>(file.gcount()))
  {
    file.read(buffer.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(buffer.size(), bytes - place)));
    take(place, buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
}

/** Returns whether more bytes are present than needed. */
bool
RequireBytes(std::uint64_t present, std::uint64_t needed)
{
  if (present < needed)
  {
    throw std::runtime_error("truncated: it contains " + std::to_string(present) + " of " + std::to_string(needed) +
                             " bytes of voxels");
  }
  return present > needed;
}

/** Decodes the files one after the other. */
bool
TakeDecoded(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  std::uint64_t present = 0;
  bool          hasMore = false;
  for (const std::string & file : voxels.files)
  {
    const std::uint64_t start = present; // of this file among the voxels
    const std::uint64_t skipped = voxels.inflatedOffset;
    const auto          decoded =
      DecodeFile(file, voxels.offset, voxels.coding, [&](std::uint64_t place, const char * piece, std::size_t size) {
        const std::uint64_t first = std::clamp(skipped, place, place + size);
        const std::uint64_t last = std::clamp(skipped + bytes - std::min(start, bytes), place, place + size);
        if (take && first < last)
        {
          take(start + first - skipped, piece + (first - place), static_cast<std::size_t>(last - first));
        }
      });
    present += decoded.bytes - std::min(skipped, decoded.bytes);
    hasMore = hasMore || decoded.trailing > 0;
  }
  return RequireBytes(present, bytes) || hasMore;
}

/** Whether a file of numbers as text contains more than `values` of them. */
bool
HasMoreNumbers(const StoredVoxels & voxels, std::uint64_t values)
{
  std::ifstream file(voxels.files.front(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(voxels.offset));
  std::uint64_t count = 0;
  for (std::string word; count <= values && file >> word; ++count)
  {}
  return count > values;
}
} // namespace

ImageFormat
ImageFormatOf(const std::string & path)
{
  const std::string name = LowerCase(path);
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    return ImageFormat::nrrd;
  }
  const auto hasExtension = [&](const std::string & extension) {
    return EndsWith(name, extension) || EndsWith(name, extension + ".gz");
  };
  // An .img without a header next to it may have any format, including DICOM.
  if (hasExtension(".nii") || hasExtension(".hdr") || (hasExtension(".img") && !NiftiHeaderFile(path).empty()))
  {
    return ImageFormat::nifti;
  }
  return EndsWith(name, ".mha") || EndsWith(name, ".mhd") ? ImageFormat::meta : ImageFormat::none;
}

std::string
NameOf(ImageFormat format)
{
  return format == ImageFormat::nrrd ? "NRRD" : format == ImageFormat::nifti ? "NIfTI" : "MetaImage";
}

StoredVoxels
LocateVoxels(const std::string & path, ImageFormat format)
{
  switch (format)
  {
    case ImageFormat::nrrd:
      return LocateNrrdVoxels(path);
    case ImageFormat::meta:
      return LocateMetaVoxels(path);
    default:
      return LocateNiftiVoxels(path);
  }
}

bool
StatesSpacing(const std::string & path, ImageFormat format)
{
  if (format == ImageFormat::nrrd)
  {
    return NrrdStatesSpacing(ReadNrrdHeader(path));
  }
  const TextHeader header = ReadMetaHeader(path);
  return !(header.ValueOf("elementspacing", '=') + header.ValueOf("elementsize", '=')).empty();
}

bool
CanHold(const StoredVoxels & voxels, double bytes, double values)
{
  const auto length = static_cast<double>(LengthOf(voxels));
  switch (voxels.coding)
  {
    case VoxelCoding::deflated:
      return bytes <= static_cast<double>(MaximumDeflateRatio) * length;
    case VoxelCoding::bzip2:
      return bytes <= static_cast<double>(MaximumBzip2Ratio) * length;
    case VoxelCoding::text:
    case VoxelCoding::hex:
      return values <= length; // at least one digit per value
    default:
      return bytes <= length;
  }
}

bool
VerifyVoxels(const StoredVoxels & voxels, std::uint64_t bytes, std::uint64_t values)
{
  switch (voxels.coding)
  {
    case VoxelCoding::deflated:
    case VoxelCoding::bzip2:
      return TakeDecoded(voxels, bytes, {});
    case VoxelCoding::text: // NRRD's reader detects missing numbers
      return voxels.files.size() == 1 && HasMoreNumbers(voxels, values);
    case VoxelCoding::hex:
      return false;
    default:
      return RequireBytes(LengthOf(voxels), bytes) && !voxels.areLast;
  }
}

bool
TakeVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  if (voxels.coding != VoxelCoding::raw)
  {
    return TakeDecoded(voxels, bytes, take);
  }
  const bool hasMore = RequireBytes(LengthOf(voxels), bytes);
  TakeRaw(voxels, bytes, take);
  return hasMore;
}
} // namespace shapeton
