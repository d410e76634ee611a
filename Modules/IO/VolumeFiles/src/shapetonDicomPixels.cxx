#include "shapetonDicomPixels.h"

#include "shapetonByteStream.h"
#include "shapetonDicomAttributes.h"
#include "shapetonDicomTransferSyntax.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonParsingServices.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"

#include "gdcmFragment.h"
#include "gdcmImage.h"
#include "gdcmSequenceOfFragments.h"
#include "gdcmTrace.h"
#include "itk_zlib.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>

namespace shapeton
{
namespace
{
// Beyond this, memory bandwidth limits decoding.
constexpr std::size_t MaximumProcesses = 16;

// ---- in the contained process ----

/** The most recently requested file, kept open because frames of a multi-frame file are read consecutively. */
struct OpenFile
{
  std::string                    path;
  std::unique_ptr<DcmFileFormat> format;
};

DcmFileFormat &
Open(const std::string & path, OpenFile & file)
{
  if (file.path != path || !file.format)
  {
    file.format = std::make_unique<DcmFileFormat>();
    file.path = path;
    const std::string fault = LoadDicomFile(*file.format, path, DCM_MaxReadLength);
    if (!fault.empty())
    {
      file.format.reset();
      throw std::runtime_error("it is truncated or malformed (" + fault + ")");
    }
  }
  return *file.format;
}

void
ReadNativeFrame(DcmDataset & dataset, DcmPixelData & pixelData, unsigned int frame, std::size_t bytes, char * pixels)
{
  Uint32            fragment = 0;
  OFString          colorModel;
  std::vector<char> even(bytes % 2 == 0 ? 0 : bytes + 1); // DCMTK requires a buffer of whole words
  char * const      target = even.empty() ? pixels : even.data();
  const auto        size = static_cast<Uint32>(bytes + bytes % 2);
  const OFCondition status = pixelData.getUncompressedFrame(&dataset, frame, fragment, target, size, colorModel);
  if (status.bad())
  {
    throw std::runtime_error(std::string("its pixels cannot be read (") + status.text() + ")");
  }
  std::copy_n(even.begin(), even.empty() ? 0 : bytes, pixels);
}

struct Fragment
{
  const char * data;
  std::size_t  size;
};

std::vector<Fragment>
ListFragments(DcmPixelSequence & sequence)
{
  std::vector<Fragment> fragments;
  for (unsigned long i = 1; i < sequence.card(); ++i)
  {
    DcmPixelItem * item = nullptr;
    Uint8 *        bytes = nullptr;
    if (sequence.getItem(item, i).bad() || !item || (item->getLength() > 0 && item->getUint8Array(bytes).bad()))
    {
      throw std::runtime_error("its compressed pixels cannot be read");
    }
    fragments.push_back({ reinterpret_cast<const char *>(bytes), bytes ? item->getLength() : 0 });
  }
  return fragments;
}

/** Offsets of the frames from the first fragment's item tag; empty if the file has no table. */
std::vector<std::size_t>
ReadOffsetTable(DcmPixelSequence & sequence)
{
  DcmPixelItem *           table = nullptr;
  Uint8 *                  bytes = nullptr;
  std::vector<std::size_t> offsets;
  if (sequence.getItem(table, 0).bad() || !table || table->getLength() < 4 || table->getUint8Array(bytes).bad())
  {
    return offsets;
  }
  for (Uint32 i = 0; i + 4 <= table->getLength(); i += 4)
  {
    offsets.push_back(bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 | std::size_t(bytes[i + 3]) << 24);
  }
  return offsets;
}

/** The first fragment of each frame, from the offset table. */
std::vector<std::size_t>
FindFrameStarts(const std::vector<Fragment> & fragments, const std::vector<std::size_t> & offsets)
{
  constexpr std::size_t    itemHeader = 8;
  std::vector<std::size_t> starts;
  std::size_t              position = 0;
  for (std::size_t i = 0; i < fragments.size() && starts.size() < offsets.size(); ++i)
  {
    if (position == offsets[starts.size()])
    {
      starts.push_back(i);
    }
    position += itemHeader + fragments[i].size;
  }
  return starts;
}

/** The first fragment of each frame, from the start marker of each JPEG (-LS, 2000) image. */
std::vector<std::size_t>
FindFrameStarts(const std::vector<Fragment> & fragments)
{
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    const auto * const data = reinterpret_cast<const unsigned char *>(fragments[i].data);
    const bool         isStart =
      fragments[i].size >= 3 && data[0] == 0xFF && ((data[1] == 0xD8 && data[2] == 0xFF) || data[1] == 0x4F);
    if (isStart)
    {
      starts.push_back(i);
    }
  }
  return starts;
}

/** The fragments of one frame. */
std::vector<Fragment>
SelectFragments(DcmPixelSequence & sequence, std::size_t frames, unsigned int frame)
{
  const auto fragments = ListFragments(sequence);
  if (frames == 1)
  {
    return fragments;
  }
  if (fragments.size() == frames)
  {
    return { fragments[frame] };
  }
  auto starts = FindFrameStarts(fragments, ReadOffsetTable(sequence));
  if (starts.size() != frames)
  {
    starts = FindFrameStarts(fragments);
  }
  if (starts.size() != frames)
  {
    throw std::runtime_error("its " + std::to_string(fragments.size()) +
                             " compressed fragments cannot be assigned to " + std::to_string(frames) + " frames");
  }
  const std::size_t end = frame + 1 < frames ? starts[frame + 1] : fragments.size();
  return { fragments.begin() + static_cast<std::ptrdiff_t>(starts[frame]),
           fragments.begin() + static_cast<std::ptrdiff_t>(end) };
}

gdcm::PixelFormat
ReadGdcmPixelFormat(DcmDataset & dataset)
{
  Uint16 allocated = 16;
  Uint16 stored = 16;
  Uint16 high = 15;
  Uint16 representation = 0;
  dataset.findAndGetUint16(DCM_BitsAllocated, allocated);
  dataset.findAndGetUint16(DCM_BitsStored, stored);
  high = static_cast<Uint16>(stored - 1);
  dataset.findAndGetUint16(DCM_HighBit, high);
  dataset.findAndGetUint16(DCM_PixelRepresentation, representation);
  if (allocated == 1)
  {
    return gdcm::PixelFormat(1, 8, 1, 0, 0); // decoded to bytes
  }
  return gdcm::PixelFormat(1, allocated, stored, high, representation);
}

std::string
JoinedFragments(const std::vector<Fragment> & fragments)
{
  std::string joined;
  for (const Fragment & fragment : fragments)
  {
    joined.append(fragment.data, fragment.size);
  }
  return joined;
}

/** Returns the precision given in the compressed stream. The fragments of a frame are joined, because GDCM does not
 * read JPEG 2000 in several. */
std::uint16_t
DecodeFragments(DcmDataset & dataset, const std::vector<Fragment> & fragments, std::size_t bytes, char * pixels)
{
  gdcm::Fragment frame;
  if (fragments.size() == 1)
  {
    frame.SetByteValue(fragments.front().data, static_cast<std::uint32_t>(fragments.front().size));
  }
  else
  {
    const std::string joined = JoinedFragments(fragments);
    frame.SetByteValue(joined.data(), static_cast<std::uint32_t>(joined.size()));
  }
  auto sequence = gdcm::SequenceOfFragments::New();
  sequence->AddFragment(frame);
  gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010), 0, gdcm::VR::OB);
  element.SetValue(*sequence);

  Uint16 rows = 0;
  Uint16 columns = 0;
  dataset.findAndGetUint16(DCM_Rows, rows);
  dataset.findAndGetUint16(DCM_Columns, columns);
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, columns);
  image.SetDimension(1, rows);
  image.SetPixelFormat(ReadGdcmPixelFormat(dataset));
  image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(gdcm::TransferSyntax::GetTSType(DcmXfer(dataset.getOriginalXfer()).getXferID()));
  image.SetDataElement(element);
  if (image.GetBufferLength() != bytes)
  {
    throw std::runtime_error("its header is inconsistent about the frame size");
  }
  std::vector<char> decoded(bytes);
  if (!image.GetBuffer(decoded.data()))
  {
    throw std::runtime_error("its compressed pixels cannot be decoded");
  }
  // The codec corrects the format if the number of bits differs between the compressed stream and the header.
  if (image.GetBufferLength() != bytes)
  {
    throw std::runtime_error("its compressed pixels differ in size from the header");
  }
  std::copy(decoded.begin(), decoded.end(), pixels);
  return image.GetPixelFormat().GetBitsStored();
}

/** Checks that a JPEG 2000 stream has this size and one component of single bits, because GDCM does not check it. The
 * first segment of the stream (ISO/IEC 15444-1, A.5.1) has big-endian numbers. */
void
RequireStreamOfBits(const Fragment & start, std::size_t columns, std::size_t rows)
{
  constexpr std::size_t width = 8, height = 12, left = 16, top = 20, components = 40, depth = 42, length = 43; // bytes
  const auto            numberAt = [&](std::size_t place) {
    std::size_t number = 0;
    for (std::size_t i = place; i < place + 4; ++i)
    {
      number = number << 8 | static_cast<unsigned char>(start.data[i]);
    }
    return number;
  };
  const bool isStream = start.size >= length && numberAt(0) == 0xFF4FFF51; // start of the stream, size
  if (!isStream || numberAt(width) != columns + numberAt(left) || numberAt(height) != rows + numberAt(top) ||
      start.data[components] != 0 || start.data[components + 1] != 1 || start.data[depth] != 0)
  {
    throw std::runtime_error("its compressed pixels are not the single bits of its header");
  }
}

/** Decodes a frame of single bits into packed bits, the first pixel in the lowest bit. */
void
DecodeFragmentsOfBits(DcmDataset & dataset, const std::vector<Fragment> & fragments, std::size_t bytes, char * packed)
{
  constexpr std::size_t bitsOfByte = 8;
  Uint16                rows = 0;
  Uint16                columns = 0;
  dataset.findAndGetUint16(DCM_Rows, rows);
  dataset.findAndGetUint16(DCM_Columns, columns);
  const std::size_t count = std::size_t(rows) * columns;
  if (fragments.empty() || (count + bitsOfByte - 1) / bitsOfByte != bytes)
  {
    throw std::runtime_error("its header is inconsistent about the frame size");
  }
  RequireStreamOfBits(fragments.front(), columns, rows);
  std::vector<char> pixels(count);
  DecodeFragments(dataset, fragments, count, pixels.data());
  std::fill(packed, packed + bytes, '\0');
  for (std::size_t i = 0; i < count; ++i)
  {
    char & byte = packed[i / bitsOfByte];
    byte = static_cast<char>(byte | (pixels[i] & 1) << (i % bitsOfByte));
  }
}

/** Inflates a frame (RFC 1951) into exactly this number of bytes, so a wrong header cannot cause a larger allocation.
 */
void
InflateFragments(const std::vector<Fragment> & fragments, std::size_t bytes, char * pixels)
{
  std::string deflated = JoinedFragments(fragments);
  z_stream    stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) // negative: without a header
  {
    throw std::runtime_error("its compressed pixels cannot be decoded");
  }
  stream.next_in = reinterpret_cast<Bytef *>(&deflated[0]);
  stream.avail_in = static_cast<uInt>(deflated.size());
  stream.next_out = reinterpret_cast<Bytef *>(pixels);
  stream.avail_out = static_cast<uInt>(bytes);
  const int status = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (status != Z_STREAM_END || stream.avail_out != 0)
  {
    throw std::runtime_error("its compressed pixels differ in size from the header, or cannot be decoded");
  }
}

/** The compressed pixels of a file. */
DcmPixelSequence &
SequenceOf(DcmPixelData & pixelData)
{
  DcmPixelSequence *                 sequence = nullptr;
  E_TransferSyntax                   storedSyntax = EXS_Unknown;
  const DcmRepresentationParameter * parameters = nullptr;
  pixelData.getOriginalRepresentationKey(storedSyntax, parameters);
  if (pixelData.getEncapsulatedRepresentation(storedSyntax, parameters, sequence).bad() || !sequence)
  {
    throw std::runtime_error("its compressed pixels are missing");
  }
  return *sequence;
}

// ---- in this process ----

template <typename TWord>
void
Convert(const char * stored, const DicomPixelFormat & format, std::size_t count, float * intensities)
{
  const auto * const  words = reinterpret_cast<const TWord *>(stored);
  const unsigned int  shift = format.highBit + 1u - format.bitsStored;
  const std::uint64_t mask = (std::uint64_t(1) << format.bitsStored) - 1;
  const std::int64_t  sign = format.isSigned ? std::int64_t(1) << (format.bitsStored - 1) : 0;
  const std::int64_t  lowest = format.isSigned ? -sign : 0;
  const std::int64_t  highest = lowest + static_cast<std::int64_t>(mask);
  // Some scanners write a padding value that does not fit into Bits Stored; then the full word is compared.
  const bool isWordPadding = format.hasPadding && (format.paddingLow < lowest || format.paddingHigh > highest);
  const auto paddingWord = static_cast<TWord>(format.paddingLow);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto         bits = static_cast<std::int64_t>((std::uint64_t(words[i]) >> shift) & mask);
    const std::int64_t value = (bits ^ sign) - sign;
    const bool         isPadding =
      format.hasPadding &&
      (isWordPadding ? words[i] == paddingWord : value >= format.paddingLow && value <= format.paddingHigh);
    intensities[i] = isPadding ? std::numeric_limits<float>::quiet_NaN()
                               : static_cast<float>(format.slope * static_cast<double>(value) + format.intercept);
  }
}

std::size_t
BytesOf(const DicomSlice & slice, std::size_t pixels)
{
  return pixels * (slice.pixels.bitsAllocated / 8);
}

/** Bytes of the image that contains the slice. */
std::size_t
StoredBytesOf(const DicomSlice & slice, std::size_t pixels)
{
  return BytesOf(slice, pixels) * slice.tilesPerRow * slice.tilesPerRow;
}

/** The first failure, in slice order, of worker threads. */
class FirstFailure
{
public:
  void
  Record(std::size_t slice, const std::exception_ptr & error)
  {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    if (slice < m_Slice)
    {
      m_Slice = slice;
      m_Error = error;
    }
    m_IsSet = true;
  }
  bool
  IsSet() const
  {
    return m_IsSet;
  }
  void
  Rethrow() const
  {
    if (m_Error)
    {
      std::rethrow_exception(m_Error);
    }
  }

private:
  std::mutex         m_Mutex;
  std::size_t        m_Slice{ std::numeric_limits<std::size_t>::max() };
  std::exception_ptr m_Error;
  std::atomic<bool>  m_IsSet{ false };
};

/** The stored pixels of a tile of a mosaic. */
std::vector<char>
TileOf(const char * mosaic, const DicomSlice & slice, std::size_t columns, std::size_t rows)
{
  const std::size_t bytes = BytesOf(slice, columns); // of a row of the tile
  const std::size_t left = slice.frame % slice.tilesPerRow;
  const std::size_t top = slice.frame / slice.tilesPerRow * rows;
  std::vector<char> tile(rows * bytes);
  for (std::size_t row = 0; row < rows; ++row)
  {
    std::copy_n(mosaic + ((top + row) * slice.tilesPerRow + left) * bytes, bytes, &tile[row * bytes]);
  }
  return tile;
}

void
ReadSlice(ContainedProcess & process,
          const DicomSlice & slice,
          std::size_t        columns,
          std::size_t        rows,
          float *            intensities)
{
  const std::size_t pixels = columns * rows;
  const bool        isTile = slice.tilesPerRow > 1;
  ByteWriter        request;
  request &         slice.file &(isTile ? 0U : slice.frame) & StoredBytesOf(slice, pixels);
  DicomPixelFormat  format = slice.pixels;
  std::uint16_t     bits = 0;
  try
  {
    const std::string response = process.Call(request.GetBytes());
    ByteReader(response) & bits;
  }
  catch (const ContainedProcess::Failure & failure)
  {
    throw InputError(slice.file + ": " + failure.what());
  }
  if (bits > format.bitsStored && bits <= format.bitsAllocated)
  {
    format.bitsStored = bits;
    format.highBit = static_cast<std::uint16_t>(bits - 1);
  }
  const auto tile = isTile ? TileOf(process.GetShared(), slice, columns, rows) : std::vector<char>();
  ConvertDicomPixels(isTile ? tile.data() : process.GetShared(), format, pixels, intensities);
}
} // namespace

std::uint16_t
DecodeDicomFrame(DcmFileFormat & file, unsigned int frame, std::size_t bytes, char * pixels)
{
  DcmDataset & dataset = *file.getDataset();
  DcmElement * element = nullptr;
  dataset.findAndGetElement(DCM_PixelData, element);
  auto * const pixelData = dynamic_cast<DcmPixelData *>(element);
  if (!pixelData)
  {
    throw std::runtime_error("it has no pixel data");
  }
  const DcmXfer syntax(dataset.getOriginalXfer());
  if (!syntax.isEncapsulated())
  {
    ReadNativeFrame(dataset, *pixelData, frame, bytes, pixels);
    return 0;
  }
  Sint32 frames = 1;
  dataset.findAndGetSint32(DCM_NumberOfFrames, frames);
  const auto count = static_cast<std::size_t>(std::max<Sint32>(frames, 1));
  if (frame >= count)
  {
    throw std::runtime_error("it has no frame " + std::to_string(frame + 1));
  }
  const auto          fragments = SelectFragments(SequenceOf(*pixelData), count, frame);
  const DicomEncoding encoding = DicomEncodingOf(file);
  if (encoding.hasDeflatedFrames)
  {
    InflateFragments(fragments, bytes, pixels);
    return 0;
  }
  Uint16 allocated = 0;
  dataset.findAndGetUint16(DCM_BitsAllocated, allocated);
  if (allocated == 1 && encoding.isJpeg2000)
  {
    DecodeFragmentsOfBits(dataset, fragments, bytes, pixels);
    return 0;
  }
  const std::uint16_t bits = DecodeFragments(dataset, fragments, bytes, pixels);
  return encoding.isJpeg2000 ? bits : std::uint16_t(0);
}

ContainedService
MakeDicomPixelService()
{
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  PrepareDicomParsing();
  const auto file = std::make_shared<OpenFile>();
  return [file](const std::string & request, char * shared) {
    std::string             path;
    unsigned int            frame = 0;
    std::size_t             bytes = 0;
    ByteReader              reader(request);
    reader & path & frame & bytes;
    ByteWriter              response;
    response &              DecodeDicomFrame(Open(path, *file), frame, bytes, shared);
    return response.GetBytes();
  };
}

void
ConvertDicomPixels(const char * stored, const DicomPixelFormat & format, std::size_t count, float * intensities)
{
  switch (format.bitsAllocated)
  {
    case 8:
      return Convert<std::uint8_t>(stored, format, count, intensities);
    default:
      return Convert<std::uint16_t>(stored, format, count, intensities);
  }
}

void
ReadDicomSlices(const std::vector<const DicomSlice *> & slices,
                unsigned int                            columns,
                unsigned int                            rows,
                float *                                 intensities,
                const Progress &                        progress)
{
  if (slices.empty())
  {
    return;
  }
  const std::size_t pixels = std::size_t(columns) * rows;
  std::size_t       bytes = 0;
  for (const DicomSlice * slice : slices)
  {
    bytes = std::max(bytes, StoredBytesOf(*slice, pixels));
  }
  // JPEG 2000 takes about a second for 10 MB.
  const auto                     seconds = static_cast<unsigned int>(20 + bytes / 1000000);
  const ContainedProcess::Limits limits{ (std::size_t(512) << 20) + 16 * bytes, seconds, 600 + seconds };
  const auto                     count =
    static_cast<unsigned int>(std::min<std::size_t>({ slices.size(), NumberOfThreads(), MaximumProcesses }));
  std::atomic<std::size_t> next{ 0 };
  FirstFailure             failure;
  const ProgressOfWorkers  report(progress);
  ParallelWorkers(count, [&](unsigned int) {
    std::unique_ptr<ContainedProcess> process;
    for (std::size_t i = next++; i < slices.size() && !failure.IsSet(); i = next++)
    {
      try
      {
        if (!process)
        {
          process = std::make_unique<ContainedProcess>(DicomPixelService, bytes, limits);
        }
        ReadSlice(*process, *slices[i], columns, rows, intensities + i * pixels);
        report(static_cast<double>(i + 1) / static_cast<double>(slices.size()));
      }
      catch (...)
      {
        failure.Record(i, std::current_exception());
      }
    }
  });
  failure.Rethrow();
}
} // namespace shapeton
