#include "shapetonStoredVoxels.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonPrintable.h"

#include "itk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

// The limit of the deflate format.
constexpr double MaximumDeflateRatio = 1032;

// Any real text header is shorter.
constexpr std::size_t LongestTextHeader = 1u << 20;

constexpr std::size_t NiftiHeaderBytes = 348;

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

/** A data file named by a header: one plain file. Lists and patterns of files are refused. */
std::string
DetachedFile(const std::string & path, const std::string & name)
{
  const bool isList = LowerCase(name).compare(0, 4, "list") == 0;
  if (isList || name.find('%') != std::string::npos || name.find(' ') != std::string::npos)
  {
    ThrowUnsuitable(path, "its data lie in several files (" + name + "); store the volume in one file");
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
  return ReadTextHeader(path, [](const std::string & line) { return line.compare(0, 15, "ElementDataFile") == 0; });
}

/** "nan" is how NRRD says that an axis has none. */
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
    ThrowUnsuitable(path, "this is no NRRD file");
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
  voxels.areAsInMemory = voxels.coding == StoredVoxels::Coding::deflated && (endian.empty() || endian == "little") &&
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
    ThrowUnsuitable(path, "this is no MetaImage file: it has no ElementDataFile");
  }
  const std::string dimensions = header.ValueOf("ndims", '=');
  if (dimensions.size() != 1 || dimensions < "1" || dimensions > "9") // MetaIO would loop over any number
  {
    ThrowUnsuitable(path, "this is no MetaImage file: its NDims is no number of dimensions");
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

// ---- verification ----

std::uint64_t
LengthOf(const StoredVoxels & voxels)
{
  std::error_code error;
  const auto      length = fs::file_size(voxels.file, error);
  return error || length < voxels.offset ? 0 : length - voxels.offset;
}

std::string
Missing(std::uint64_t present, std::uint64_t needed)
{
  return "truncated: it holds " + std::to_string(present) + " of " + std::to_string(needed) + " bytes of voxels";
}

/** The first bytes of a stream of stored voxels, and its length. */
struct Stream
{
  std::string   head;
  std::uint64_t bytes{ 0 };
  TakeBytes     take; ///< if any, gets all of them
};

/** Inflates a zlib or gzip stream, of one member or several, and checks its checksums. */
class Inflater
{
public:
  Inflater()
  {
    if (inflateInit2(&m_State, 15 + 32) != Z_OK) // zlib or gzip, whichever it is
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&m_State); }
  Inflater(const Inflater &) = delete;
  Inflater &
  operator=(const Inflater &) = delete;

  /** False after the end of the last member; what follows it is not looked at. */
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
    if (stream.head.size() < NiftiHeaderBytes)
    {
      stream.head.append(buffer, std::min(produced, NiftiHeaderBytes - stream.head.size()));
    }
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
  Stream            stream{ {}, 0, take };
  std::vector<char> buffer(1u << 18);
  bool              goesOn = true;
  while (goesOn && file)
  {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    goesOn = file.gcount() > 0 && inflater.Take(buffer.data(), static_cast<std::size_t>(file.gcount()), stream);
  }
  if (!inflater.HasEnded())
  {
    throw std::runtime_error("truncated: its compressed voxels break off after " + std::to_string(stream.bytes) +
                             " bytes");
  }
  return stream;
}

Stream
ReadRaw(const StoredVoxels & voxels)
{
  Stream stream;
  stream.bytes = LengthOf(voxels);
  std::ifstream file(voxels.file, std::ios::binary);
  stream.head.resize(NiftiHeaderBytes);
  file.read(&stream.head[0], NiftiHeaderBytes);
  stream.head.resize(static_cast<std::size_t>(file.gcount()));
  return stream;
}

void
TakeRaw(const StoredVoxels & voxels, const TakeBytes & take)
{
  std::ifstream     file(voxels.file, std::ios::binary);
  std::vector<char> buffer(1u << 18);
  for (std::uint64_t place = 0; file; place += static_cast<std::uint64_t>(file.gcount()))
  {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    take(place, buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
}

/** A number of the NIfTI-1 header, in the byte order of the file. */
template <typename TNumber>
TNumber
NiftiNumber(const std::string & header, std::size_t offset, bool isSwapped)
{
  char bytes[sizeof(TNumber)];
  std::memcpy(bytes, &header[offset], sizeof(TNumber));
  if (isSwapped)
  {
    std::reverse(bytes, bytes + sizeof(TNumber));
  }
  TNumber number;
  std::memcpy(&number, bytes, sizeof(TNumber));
  return number;
}

/** Whether numbers of a NIfTI-1 file have the other byte order. Throws std::runtime_error where it is none. */
bool
IsSwapped(const std::string & header)
{
  if (header.size() < NiftiHeaderBytes)
  {
    throw std::runtime_error("truncated: it ends within its header");
  }
  const bool isSwapped = NiftiNumber<std::int32_t>(header, 0, false) != static_cast<int>(NiftiHeaderBytes);
  if (isSwapped && NiftiNumber<std::int32_t>(header, 0, true) != static_cast<int>(NiftiHeaderBytes))
  {
    throw std::runtime_error("this is no NIfTI-1 file");
  }
  return isSwapped;
}

/** The bytes up to the end of the voxels that a NIfTI-1 header announces. */
std::uint64_t
NiftiBytes(const std::string & header)
{
  const bool isSwapped = IsSwapped(header);
  const int  dimensions = NiftiNumber<std::int16_t>(header, 40, isSwapped);
  double     bytes = NiftiNumber<std::int16_t>(header, 72, isSwapped) / 8.0;
  for (int i = 1; i <= std::min(dimensions, 7); ++i)
  {
    bytes *= std::max<int>(1, NiftiNumber<std::int16_t>(header, 40 + 2 * static_cast<std::size_t>(i), isSwapped));
  }
  bytes += NiftiNumber<float>(header, 108, isSwapped);
  if (!(bytes >= 0 && bytes < 1e18))
  {
    throw std::runtime_error("its header is malformed");
  }
  return static_cast<std::uint64_t>(bytes);
}

/** The header of a NIfTI-1 file, compressed or not; as much of it as there is. */
std::string
ReadNiftiHeader(const std::string & path)
{
  std::string  header(NiftiHeaderBytes, '\0');
  const gzFile file = gzopen(path.c_str(), "rb");
  const int    read = file ? gzread(file, &header[0], static_cast<unsigned int>(header.size())) : 0;
  if (file)
  {
    gzclose(file);
  }
  header.resize(static_cast<std::size_t>(std::max(0, read)));
  return header;
}

bool
NiftiStatesSpacing(const std::string & header)
{
  const bool isSwapped = IsSwapped(header);
  const auto isStated = [&](std::size_t offset) {
    return std::abs(NiftiNumber<float>(header, offset, isSwapped)) > 0.0F;
  };
  return isStated(80) && isStated(84) && isStated(88); // pixdim[1] to [3]
}

/** Whether ITK's reader takes some voxels for 0: real numbers that are not finite. */
class NiftiNonFiniteCounter
{
public:
  /** \param header of the file; where its voxels are integers there is nothing to count. */
  explicit NiftiNonFiniteCounter(const std::string & header)
    : m_IsSwapped(IsSwapped(header))
    , m_Type(NiftiNumber<std::int16_t>(header, 70, m_IsSwapped))
    , m_Begin(static_cast<std::uint64_t>(std::max(0.0F, NiftiNumber<float>(header, 108, m_IsSwapped))))
    , m_End(NiftiBytes(header))
  {}

  bool
  HasToCount() const
  {
    return m_Type == Float32 || m_Type == Float64;
  }

  /** Bytes of the file, in their order. */
  void
  operator()(std::uint64_t place, const char * piece, std::size_t size)
  {
    const std::uint64_t begin = std::clamp(m_Begin, place, place + size);
    const std::uint64_t end = std::clamp(m_End, begin, place + size);
    m_Pending.append(piece + (begin - place), end - begin);
    m_Type == Float32 ? this->TakeNumbers<float>() : this->TakeNumbers<double>();
  }

  std::uint64_t
  GetCount() const
  {
    return m_Count;
  }

private:
  static constexpr int Float32 = 16;
  static constexpr int Float64 = 64;

  template <typename TNumber>
  void
  TakeNumbers()
  {
    const std::size_t whole = m_Pending.size() / sizeof(TNumber) * sizeof(TNumber);
    for (std::size_t place = 0; place < whole; place += sizeof(TNumber))
    {
      m_Count += std::isfinite(NiftiNumber<TNumber>(m_Pending, place, m_IsSwapped)) ? 0 : 1;
    }
    m_Pending.erase(0, whole);
  }

  bool          m_IsSwapped;
  int           m_Type;
  std::uint64_t m_Begin; ///< of the voxels; behind their end there may be anything
  std::uint64_t m_End;
  std::string   m_Pending; ///< less than a number
  std::uint64_t m_Count{ 0 };
};

/** Reads the file again: only what has real numbers, which few files of patients do. */
void
RequireFiniteNifti(const StoredVoxels & voxels, const std::string & header)
{
  NiftiNonFiniteCounter counter(header);
  if (!counter.HasToCount())
  {
    return;
  }
  if (voxels.coding == StoredVoxels::Coding::deflated)
  {
    ReadDeflated(voxels, std::ref(counter));
  }
  else
  {
    TakeRaw(voxels, std::ref(counter));
  }
  if (counter.GetCount() > 0)
  {
    throw std::runtime_error(std::to_string(counter.GetCount()) +
                             " of its voxels are not finite numbers; replace NaN and infinity by numbers");
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
  if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
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
      return { path, 0, EndsWith(LowerCase(path), ".gz") ? StoredVoxels::Coding::deflated : StoredVoxels::Coding::raw };
  }
}

bool
StatesSpacing(const std::string & path, ImageFormat format)
{
  if (format == ImageFormat::nrrd)
  {
    return NrrdStatesSpacing(ReadNrrdHeader(path));
  }
  if (format == ImageFormat::meta)
  {
    const TextHeader header = ReadMetaHeader(path);
    return !(header.ValueOf("elementspacing", '=') + header.ValueOf("elementsize", '=')).empty();
  }
  return NiftiStatesSpacing(ReadNiftiHeader(path));
}

bool
CanHold(const StoredVoxels & voxels, double bytes, double values)
{
  const auto length = static_cast<double>(LengthOf(voxels));
  switch (voxels.coding)
  {
    case StoredVoxels::Coding::deflated:
      return bytes <= MaximumDeflateRatio * length;
    case StoredVoxels::Coding::text:
      return values <= length; // a digit for each
    default:
      return bytes <= length;
  }
}

void
VerifyVoxels(const StoredVoxels & voxels, ImageFormat format, std::uint64_t bytes)
{
  if (voxels.coding == StoredVoxels::Coding::text)
  {
    return; // NRRD: its reader notices when the numbers end
  }
  const bool          isDeflated = voxels.coding == StoredVoxels::Coding::deflated;
  const bool          isNifti = format == ImageFormat::nifti;
  const Stream        stream = isDeflated ? ReadDeflated(voxels) : ReadRaw(voxels);
  const std::uint64_t needed = isNifti ? NiftiBytes(stream.head) : bytes;
  if (stream.bytes < needed)
  {
    throw std::runtime_error(Missing(stream.bytes, needed));
  }
  if (isNifti)
  {
    RequireFiniteNifti(voxels, stream.head);
  }
}

void
InflateVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take)
{
  const Stream stream = ReadDeflated(voxels, [&](std::uint64_t place, const char * piece, std::size_t size) {
    if (place < bytes)
    {
      take(place, piece, static_cast<std::size_t>(std::min<std::uint64_t>(size, bytes - place)));
    }
  });
  if (stream.bytes < bytes)
  {
    throw std::runtime_error(Missing(stream.bytes, bytes));
  }
}
} // namespace shapeton
