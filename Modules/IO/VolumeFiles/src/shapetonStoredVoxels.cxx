#include "shapetonStoredVoxels.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonNiftiHeader.h"
#include "shapetonPrintable.h"

#include "itk_zlib.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

// Longer than any real text header.
constexpr std::size_t LongestTextHeader = 1u << 20;

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// ---- text headers ----

struct TextHeader
{
  std::vector<std::string> lines;
  /** Bytes up to the end of the last line. */
  std::uint64_t bytes{ 0 };
  bool          isComplete{ false };

  std::string
  ValueOf(const std::string & key, char separator) const
  {
    for (const std::string & line : lines)
    {
      const auto position = line.find(separator);
      if (position != std::string::npos && LowerCase(Trimmed(line.substr(0, position))) == key)
      {
        return Trimmed(line.substr(position + 1));
      }
    }
    return {};
  }
};

TextHeader
ReadTextHeader(const std::string & path, const std::function<bool(const std::string &)> & isLast)
{
  std::ifstream stream(path, std::ios::binary);
  std::string   text(LongestTextHeader, '\0');
  stream.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  TextHeader  header;
  std::size_t start = 0;
  while (start < text.size() && !header.isComplete)
  {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    header.lines.push_back(Trimmed(text.substr(start, end - start)));
    header.isComplete = isLast(header.lines.back());
    start = end + 1;
  }
  header.bytes = std::min(start, text.size());
  return header;
}

/** A single data file referenced by a header; lists and patterns of files are rejected. */
std::string
DetachedFile(const std::string & path, const std::string & name)
{
  const bool isList = LowerCase(name).compare(0, 4, "list") == 0;
  if (isList || name.find('%') != std::string::npos || name.find(' ') != std::string::npos)
  {
    ThrowUnsuitable(path, "its data are split into several files (" + name + "); store the volume in one file");
  }
  const std::string file = (fs::path(path).parent_path() / name).string();
  std::error_code   error;
  if (!fs::is_regular_file(file, error))
  {
    ThrowUnsuitable(path, "its data file " + file + " is missing");
  }
  return file;
}

TextHeader
ReadNrrdHeader(const std::string & path)
{
  return ReadTextHeader(path, [](const std::string & line) { return line.empty(); });
}

TextHeader
ReadMetaHeader(const std::string & path)
{
  constexpr std::string_view last = "ElementDataFile";
  return ReadTextHeader(path, [=](const std::string & line) { return line.compare(0, last.size(), last) == 0; });
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

StoredVoxels
LocateNrrdVoxels(const std::string & path)
{
  const TextHeader header = ReadNrrdHeader(path);
  if (header.lines.empty() || header.lines.front().compare(0, 4, "NRRD") != 0)
  {
    ThrowUnsuitable(path, "not a NRRD file");
  }
  StoredVoxels voxels{ path, header.bytes };
  std::string  detached = header.ValueOf("data file", ':');
  detached = detached.empty() ? header.ValueOf("datafile", ':') : detached;
  if (!detached.empty())
  {
    voxels = { DetachedFile(path, detached) };
  }
  const std::string encoding = LowerCase(header.ValueOf("encoding", ':'));
  if (encoding == "gzip" || encoding == "gz")
  {
    voxels.coding = StoredVoxels::Coding::deflated;
  }
  else if (encoding == "ascii" || encoding == "text" || encoding == "txt" || encoding == "hex")
  {
    voxels.coding = StoredVoxels::Coding::text;
  }
  else if (encoding != "raw")
  {
    ThrowUnsuitable(path, "NRRD encoding \"" + encoding + "\" is not supported; use raw or gzip");
  }
  const std::string endian = LowerCase(header.ValueOf("endian", ':'));
  const auto        isLeftOut = [&](const char * key) { return header.ValueOf(key, ':').empty(); };
  voxels.canBeTaken = voxels.coding == StoredVoxels::Coding::deflated && (endian.empty() || endian == "little") &&
                      isLeftOut("byte skip") && isLeftOut("byteskip") && isLeftOut("line skip") &&
                      isLeftOut("lineskip");
  return voxels;
}

StoredVoxels
LocateMetaVoxels(const std::string & path)
{
  const TextHeader header = ReadMetaHeader(path);
  if (!header.isComplete)
  {
    ThrowUnsuitable(path, "not a MetaImage file: ElementDataFile is missing");
  }
  const std::string dimensions = header.ValueOf("ndims", '=');
  if (dimensions.size() != 1 || dimensions < "1" || dimensions > "9") // MetaIO does not check the number
  {
    ThrowUnsuitable(path, "NDims must be between 1 and 9, got " + Quoted(Printable(dimensions)));
  }
  StoredVoxels      voxels{ path, header.bytes };
  const std::string detached = header.ValueOf("elementdatafile", '=');
  if (LowerCase(detached) != "local")
  {
    voxels = { DetachedFile(path, detached) };
  }
  if (LowerCase(header.ValueOf("compresseddata", '=')) == "true")
  {
    voxels.coding = StoredVoxels::Coding::deflated;
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
  StoredVoxels      voxels{ header.voxelFile };
  voxels.canBeTaken = true;
  std::ifstream file(header.voxelFile, std::ios::binary);
  if (file.get() == 0x1F && file.get() == 0x8B) // gzip, regardless of the file name
  {
    voxels.coding = StoredVoxels::Coding::deflated;
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
  std::error_code error;
  const auto      length = fs::file_size(voxels.file, error);
  return error || length < voxels.offset ? 0 : length - voxels.offset;
}

/** The inflated bytes of a stream. */
struct Stream
{
  std::uint64_t bytes{ 0 };
  TakeBytes     take; ///< if set, receives all bytes
};

/** Inflates a zlib or gzip stream of one or several members, and verifies its checksums. */
class Inflater
{
public:
  Inflater()
  {
    if (inflateInit2(&m_State, 15 + 32) != Z_OK) // automatic detection of zlib or gzip
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&m_State); }
  Inflater(const Inflater &) = delete;
  Inflater &
  operator=(const Inflater &) = delete;

  /** False after the end of the last member; trailing data is ignored. */
  bool
  Take(char * data, std::size_t size, Stream & stream)
  {
    m_State.next_in = reinterpret_cast<Bytef *>(data);
    m_State.avail_in = static_cast<uInt>(size);
    while (m_State.avail_in > 0)
    {
      if (m_HasEnded && !this->StartMember())
      {
        return false;
      }
      this->Step(stream);
    }
    return true;
  }

  bool
  HasEnded() const
  {
    return m_HasEnded;
  }

private:
  bool
  StartMember()
  {
    constexpr Bytef gzipMagic = 0x1F;
    m_HasEnded = *m_State.next_in != gzipMagic || inflateReset(&m_State) != Z_OK;
    return !m_HasEnded;
  }

  void
  Step(Stream & stream)
  {
    char buffer[1u << 16];
    m_State.next_out = reinterpret_cast<Bytef *>(buffer);
    m_State.avail_out = sizeof(buffer);
    const int status = inflate(&m_State, Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
    {
      throw std::runtime_error("damaged: its compressed voxels are corrupt after " + std::to_string(stream.bytes) +
                               " bytes");
    }
    const std::size_t produced = sizeof(buffer) - m_State.avail_out;
    if (stream.take)
    {
      stream.take(stream.bytes, buffer, produced);
    }
    stream.bytes += produced;
    m_HasEnded = status == Z_STREAM_END;
  }

  z_stream m_State{};
  bool     m_HasEnded{ false };
};

Stream
ReadDeflated(const StoredVoxels & voxels, const TakeBytes & take = {})
{
  std::ifstream file(voxels.file, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(voxels.offset));
  Inflater          inflater;
  Stream            stream{ 0, take };
  std::vector<char> buffer(1u << 18);
  bool              goesOn = true;
  while (goesOn && file)
  {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    goesOn = file.gcount() > 0 && inflater.Take(buffer.data(), static_cast<std::size_t>(file.gcount()), stream);
  }
  if (!inflater.HasEnded())
  {
    throw std::runtime_error("truncated: its compressed voxels end after " + std::to_string(stream.bytes) + " bytes");
  }
  return stream;
}

void
TakeRaw(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  std::ifstream file(voxels.file, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(voxels.offset));
  std::vector<char> buffer(1u << 18);
  for (std::uint64_t place = 0; file && place < bytes; place += static_cast<std::uint64_t>(file.gcount()))
  {
    file.read(buffer.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(buffer.size(), bytes - place)));
    take(place, buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
}

void
RequireBytes(std::uint64_t present, std::uint64_t needed)
{
  if (present < needed)
  {
    throw std::runtime_error("truncated: it contains " + std::to_string(present) + " of " + std::to_string(needed) +
                             " bytes of voxels");
  }
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
    case StoredVoxels::Coding::deflated:
      return bytes <= static_cast<double>(MaximumDeflateRatio) * length;
    case StoredVoxels::Coding::text:
      return values <= length; // at least one digit per value
    default:
      return bytes <= length;
  }
}

void
VerifyVoxels(const StoredVoxels & voxels, std::uint64_t bytes)
{
  if (voxels.coding != StoredVoxels::Coding::text) // NRRD's reader detects missing numbers
  {
    const bool isDeflated = voxels.coding == StoredVoxels::Coding::deflated;
    RequireBytes(isDeflated ? ReadDeflated(voxels).bytes : LengthOf(voxels), bytes);
  }
}

void
TakeVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  if (voxels.coding == StoredVoxels::Coding::raw)
  {
    RequireBytes(LengthOf(voxels), bytes);
    TakeRaw(voxels, bytes, take);
    return;
  }
  const std::uint64_t begin = voxels.inflatedOffset;
  const Stream        stream = ReadDeflated(voxels, [&](std::uint64_t place, const char * piece, std::size_t size) {
    const std::uint64_t first = std::clamp(begin, place, place + size);
    const std::uint64_t last = std::clamp(begin + bytes, place, place + size);
    if (first < last)
    {
      take(first - begin, piece + (first - place), static_cast<std::size_t>(last - first));
    }
  });
  RequireBytes(stream.bytes - std::min(begin, stream.bytes), bytes);
}
} // namespace shapeton
