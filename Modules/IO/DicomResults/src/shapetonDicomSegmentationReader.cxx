#include "shapetonDicomSegmentationReader.h"

#include "shapetonByteStream.h"
#include "shapetonDicomAttributes.h"
#include "shapetonDicomFramePlaces.h"
#include "shapetonDicomReading.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Largest compression ratios: that of deflate, and that of an empty 2 MB frame in JPEG 2000. */
constexpr std::uint64_t MaximumDeflateRatio = 1032;
constexpr std::uint64_t MaximumFrameRatio = 20000;

const std::vector<std::string> segmentationClasses{ UID_SegmentationStorage, LabelMapSegmentationStorageUID };

// ---- in the contained process ----

/** A functional group of a frame, or the shared one; throws if it is missing. */
DcmItem &
GroupOf(DcmItem * frame, DcmItem * shared, const DcmTagKey & group)
{
  for (DcmItem * const item : { frame, shared })
  {
    if (DcmItem * const found = item ? ItemOf(*item, group) : nullptr)
    {
      return *found;
    }
  }
  throw std::runtime_error(std::string("lacks the ") + DcmTag(group).getTagName() + " of a frame");
}

bool
Declares(const DicomSegmentationFile & file, int number)
{
  return std::any_of(
    file.segments.begin(), file.segments.end(), [&](const DicomSegmentInFile & one) { return one.number == number; });
}

void
ReadSegments(DcmItem & dataset, DicomSegmentationFile & file)
{
  for (DcmItem * const item : ItemsOf(dataset, DCM_SegmentSequence))
  {
    DicomSegmentInFile segment;
    segment.number = WordOf(*item, DCM_SegmentNumber);
    const DicomText name = DicomTextOf(*item, DCM_SegmentLabel);
    segment.name = name.text;
    segment.category = CodeOf(*item, DCM_SegmentedPropertyCategoryCodeSequence);
    segment.type = CodeOf(*item, DCM_SegmentedPropertyTypeCodeSequence);
    segment.trackingUID = TextOf(*item, DCM_TrackingUID);
    if (Declares(file, segment.number))
    {
      throw std::runtime_error("declares segment " + std::to_string(segment.number) + " twice");
    }
    segment.isNameDecoded = name.isDecoded;
    file.segments.push_back(segment);
  }
  if (file.segments.empty())
  {
    throw std::runtime_error("declares no segment");
  }
}

/** Removes the background from the segments of a label map. */
void
TakeBackground(DcmItem & dataset, DicomSegmentationFile & file)
{
  if (dataset.tagExistsWithValue(DCM_PixelPaddingValue))
  {
    file.background.push_back(WordOf(dataset, DCM_PixelPaddingValue));
  }
  const auto isBackground = [&](const DicomSegmentInFile & segment) {
    return (!file.background.empty() && segment.number == file.background.front()) ||
           (segment.type.value == "125040" && segment.type.scheme == "DCM");
  };
  const bool isZeroFree = !Declares(file, 0);
  const auto end = std::stable_partition(
    file.segments.begin(), file.segments.end(), [&](const auto & segment) { return !isBackground(segment); });
  std::for_each(end, file.segments.end(), [&](const auto & segment) { file.background.push_back(segment.number); });
  file.segments.erase(end, file.segments.end());
  if (isZeroFree)
  {
    file.background.push_back(0);
  }
  if (file.segments.empty())
  {
    throw std::runtime_error("declares only a background segment");
  }
}

/** Orientation and spacing must be common to all frames. */
void
TakePlane(DcmItem & orientation, DcmItem & measures, bool isFirst, DicomSegmentationFile & file)
{
  const auto cosines = NumbersOf(orientation, DCM_ImageOrientationPatient, 6);
  const auto spacing = NumbersOf(measures, DCM_PixelSpacing, 2);
  if (isFirst)
  {
    std::copy(cosines.begin(), cosines.end(), file.orientation);
    file.spacing[0] = spacing[1]; // row spacing first in DICOM
    file.spacing[1] = spacing[0];
  }
  constexpr double rounding = 1e-4; // of decimal strings
  const auto       isClose = [](double a, double b) { return std::abs(a - b) <= rounding; };
  if (!std::equal(cosines.begin(), cosines.end(), file.orientation, isClose) || !isClose(spacing[1], file.spacing[0]) ||
      !isClose(spacing[0], file.spacing[1]))
  {
    throw std::runtime_error("has frames of several orientations or spacings, which are not supported");
  }
}

void
ReadFrames(DcmItem & dataset, DicomSegmentationFile & file)
{
  DcmItem * const              shared = ItemOf(dataset, DCM_SharedFunctionalGroupsSequence);
  const std::vector<DcmItem *> frames = ItemsOf(dataset, DCM_PerFrameFunctionalGroupsSequence);
  const double                 claimed = NumbersOf(dataset, DCM_NumberOfFrames, 1).front();
  if (frames.empty() || claimed != static_cast<double>(frames.size()))
  {
    throw std::runtime_error("describes " + std::to_string(frames.size()) + " frames, but states another number");
  }
  for (DcmItem * const item : frames)
  {
    TakePlane(GroupOf(item, shared, DCM_PlaneOrientationSequence),
              GroupOf(item, shared, DCM_PixelMeasuresSequence),
              file.frames.empty(),
              file);
    const auto position = NumbersOf(GroupOf(item, shared, DCM_PlanePositionSequence), DCM_ImagePositionPatient, 3);
    DicomSegmentFrame frame;
    frame.position = itk::Point<double, 3>(position.data());
    if (file.bytesPerLabel == 0)
    {
      DcmItem & identification = GroupOf(item, shared, DCM_SegmentIdentificationSequence);
      frame.segment = WordOf(identification, DCM_ReferencedSegmentNumber);
    }
    if (file.bytesPerLabel == 0 && !Declares(file, frame.segment))
    {
      throw std::runtime_error("has frames of segment " + std::to_string(frame.segment) +
                               ", which it does not declare");
    }
    file.frames.push_back(frame);
  }
}

/** Whether pixels are bytes or words rather than bits. */
bool
HasWholeBytes(const DicomSegmentationFile & file)
{
  return file.wholeValue > 0 || file.bytesPerLabel > 0;
}

std::uint64_t
BytesOfPixels(const DicomSegmentationFile & file)
{
  const std::uint64_t     pixels = std::uint64_t(file.columns) * file.rows * file.frames.size();
  const std::uint64_t     bytes = file.wholeValue > 0 ? 1 : file.bytesPerLabel;
  constexpr std::uint64_t bits = 8; // of a byte
  return bytes > 0 ? bytes * pixels : (pixels + bits - 1) / bits;
}

bool
IsCompressed(DcmFileFormat & format)
{
  return DcmXfer(format.getDataset()->getOriginalXfer()).isEncapsulated();
}

/** Checks the length of the pixel data against frames and format before any allocation. */
void
RequirePixels(DcmFileFormat & format, const DicomSegmentationFile & file)
{
  DcmDataset &        dataset = *format.getDataset();
  const DcmXfer       syntax(dataset.getOriginalXfer());
  const DicomEncoding encoding = DicomEncodingOf(format);
  const bool          hasFramesOfBits = encoding.hasDeflatedFrames || encoding.isJpeg2000;
  if (!encoding.isSupported || (IsCompressed(format) && !HasWholeBytes(file) && !hasFramesOfBits))
  {
    throw std::runtime_error("is compressed as " + encoding.name + ", which is not supported; decompress it");
  }
  DcmElement * pixels = nullptr;
  dataset.findAndGetElement(DCM_PixelData, pixels);
  const bool          isDeflated = syntax.getStreamCompression() == ESC_zlib;
  const std::uint64_t ratio = IsCompressed(format) ? MaximumFrameRatio : isDeflated ? MaximumDeflateRatio : 1;
  const std::uint64_t limit = ratio * std::filesystem::file_size(file.path);
  const std::uint64_t length = !pixels                ? 0
                               : IsCompressed(format) ? limit
                                                      : pixels->getLength(dataset.getOriginalXfer());
  if (std::min(length, limit) < BytesOfPixels(file))
  {
    throw std::runtime_error("is truncated within its pixels");
  }
}

void
ReadPixelFormat(DcmItem & dataset, DicomSegmentationFile & file)
{
  const std::string type = TextOf(dataset, DCM_SegmentationType);
  const int         bits = WordOf(dataset, DCM_BitsAllocated);
  file.columns = static_cast<unsigned int>(WordOf(dataset, DCM_Columns));
  file.rows = static_cast<unsigned int>(WordOf(dataset, DCM_Rows));
  if (type == "FRACTIONAL" && bits == 8)
  {
    file.wholeValue = static_cast<unsigned int>(WordOf(dataset, DCM_MaximumFractionalValue));
  }
  if (type == "LABELMAP" && (bits == 8 || bits == 16))
  {
    file.bytesPerLabel = static_cast<unsigned int>(bits) / 8;
  }
  const bool isBinary = type == "BINARY" && bits == 1;
  if (file.columns == 0 || file.rows == 0 || (file.wholeValue == 0 && file.bytesPerLabel == 0 && !isBinary))
  {
    throw std::runtime_error("is a segmentation of the type " + type + " with " + std::to_string(bits) +
                             " bits, which is not supported");
  }
}

template <typename TStream, typename TFile>
void
TransmitSegments(TStream & stream, TFile & file)
{
  stream & file.frameOfReferenceUID & file.seriesUID & file.columns & file.rows & file.spacing & file.orientation & file
    .wholeValue & file.bytesPerLabel;
  stream.SizeOf(file.segments).SizeOf(file.frames).SizeOf(file.background);
  for (auto & segment : file.segments)
  {
    stream & segment.number & segment.name & segment.isNameDecoded & segment.trackingUID;
    for (auto * const code : { &segment.category, &segment.type })
    {
      stream & code->value & code->scheme & code->meaning;
    }
  }
  for (auto & frame : file.frames)
  {
    stream & frame.segment & frame.position[0] & frame.position[1] & frame.position[2];
  }
  for (auto & value : file.background)
  {
    stream & value;
  }
}

std::string
ParseSegmentation(const std::string & path, std::size_t, char *)
{
  DcmFileFormat format;
  LoadDicomObject(format, path, segmentationClasses);
  DcmDataset &          dataset = *format.getDataset();
  DicomSegmentationFile file;
  file.path = path;
  file.frameOfReferenceUID = TextOf(dataset, DCM_FrameOfReferenceUID);
  if (DcmItem * const series = ItemOf(dataset, DCM_ReferencedSeriesSequence))
  {
    file.seriesUID = TextOf(*series, DCM_SeriesInstanceUID);
  }
  ReadPixelFormat(dataset, file);
  ReadSegments(dataset, file);
  if (file.bytesPerLabel > 0)
  {
    TakeBackground(dataset, file);
  }
  ReadFrames(dataset, file);
  RequirePixels(format, file);
  ByteWriter                    writer;
  const DicomSegmentationFile & whole = file;
  TransmitSegments(writer, whole);
  return writer.GetBytes();
}

/** Appends the bits of a frame; frames of single bits start at a byte boundary only in a compressed segmentation. */
void
AppendBits(const std::vector<char> & frame, std::size_t first, std::size_t count, char * bits)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const int bit = (frame[i / 8] >> (i % 8)) & 1;
    bits[(first + i) / 8] = static_cast<char>(bits[(first + i) / 8] | bit << ((first + i) % 8));
  }
}

void
DecodeFrames(DcmFileFormat & format, std::size_t bytes, char * shared)
{
  DicomSegmentationFile file;
  ReadPixelFormat(*format.getDataset(), file);
  file.frames.resize(1);
  const std::size_t frameBytes = BytesOfPixels(file);
  const std::size_t pixels = std::size_t(file.columns) * file.rows;
  const auto        frames = static_cast<unsigned int>(NumbersOf(*format.getDataset(), DCM_NumberOfFrames, 1).front());
  file.frames.resize(frames);
  if (BytesOfPixels(file) > bytes) // changed since its header was read
  {
    throw std::runtime_error("is truncated within its pixels");
  }
  std::vector<char> decoded(frameBytes);
  std::fill(shared, shared + bytes, '\0');
  for (unsigned int frame = 0; frame < frames; ++frame)
  {
    DecodeDicomFrame(format, frame, frameBytes, decoded.data());
    if (HasWholeBytes(file))
    {
      std::copy(decoded.begin(), decoded.end(), shared + frame * frameBytes);
    }
    else
    {
      AppendBits(decoded, frame * pixels, pixels, shared);
    }
  }
}

std::string
CopySegmentPixels(const std::string & path, std::size_t bytes, char * shared)
{
  DcmFileFormat format;
  LoadDicomObject(format, path, segmentationClasses);
  if (IsCompressed(format))
  {
    DecodeFrames(format, bytes, shared);
    return {};
  }
  DcmDataset & dataset = *format.getDataset();
  DcmElement * pixels = nullptr;
  // Accepts any VR, because pixels of up to 8 bits are OW if the encoding does not specify a VR.
  const bool isRead = dataset.findAndGetElement(DCM_PixelData, pixels).good() && pixels &&
                      pixels->getLength(dataset.getOriginalXfer()) >= bytes &&
                      pixels->getPartialValue(shared, 0, static_cast<Uint32>(bytes)).good();
  if (!isRead)
  {
    throw std::runtime_error("is truncated within its pixels");
  }
  return {};
}

// ---- in this process ----

/** The pixels of a file. */
class FramePixels
{
public:
  FramePixels(const DicomSegmentationFile & file, const char * data)
    : m_File(file), m_Bytes(reinterpret_cast<const unsigned char *>(data))
  {}

  bool
  IsIn(std::size_t pixel, int segment) const
  {
    if (m_File.bytesPerLabel > 0)
    {
      return this->LabelOf(pixel) == segment;
    }
    return m_File.wholeValue > 0 ? 2u * m_Bytes[pixel] >= m_File.wholeValue
                                 : ((m_Bytes[pixel / 8] >> (pixel % 8)) & 1) != 0;
  }

  int
  LabelOf(std::size_t pixel) const
  {
    return m_File.bytesPerLabel == 1 ? m_Bytes[pixel] : reinterpret_cast<const std::uint16_t *>(m_Bytes)[pixel];
  }

private:
  const DicomSegmentationFile & m_File;
  const unsigned char *         m_Bytes;
};

/** Returns the number of painted voxels. */
std::size_t
PaintFrame(const DicomSegmentationFile & file,
           std::size_t                   frame,
           const char *                  data,
           int                           number,
           const DicomFramePlace &       place,
           DicomLabelImage *             labels)
{
  const FramePixels pixels(file, data);
  std::size_t       next = frame * file.columns * file.rows;
  std::size_t       painted = 0;
  itk::Index<3>     firstOfRow = place.first;
  for (std::size_t row = 0; row < file.rows; ++row, firstOfRow += place.alongColumn)
  {
    itk::Index<3> voxel = firstOfRow;
    for (std::size_t column = 0; column < file.columns; ++column, ++next, voxel += place.alongRow)
    {
      if (pixels.IsIn(next, number))
      {
        labels->SetPixel(voxel, static_cast<unsigned short>(number));
        ++painted;
      }
    }
  }
  return painted;
}

/** Each pixel of a label map is the number of a segment or background. */
void
RequireDeclaredLabels(const DicomSegmentationFile & file, const char * data)
{
  std::vector<bool> isKnown(65536, false);
  for (const int value : file.background)
  {
    isKnown[static_cast<std::uint16_t>(value)] = true;
  }
  for (const DicomSegmentInFile & segment : file.segments)
  {
    isKnown[static_cast<std::uint16_t>(segment.number)] = true;
  }
  const FramePixels pixels(file, data);
  for (std::size_t i = 0; i < std::size_t(file.columns) * file.rows * file.frames.size(); ++i)
  {
    if (!isKnown[static_cast<std::uint16_t>(pixels.LabelOf(i))])
    {
      throw InputError('"' + file.path + "\" has pixels of segment " + std::to_string(pixels.LabelOf(i)) +
                       ", which it does not declare; write it again");
    }
  }
}

void
RequireSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers)
{
  for (const int number : numbers)
  {
    RequireParameter(Declares(file, number), '"' + file.path + "\" has no segment " + std::to_string(number));
    RequireParameter(number != 0, "segment 0 of \"" + file.path + "\" is the background; choose another");
    RequireParameter(std::count(numbers.begin(), numbers.end(), number) == 1,
                     "segment " + std::to_string(number) + " is requested twice");
  }
}
} // namespace

ContainedService
MakeDicomSegmentationService()
{
  return MakeDicomService(ParseSegmentation);
}

ContainedService
MakeDicomSegmentPixelService()
{
  return MakeDicomService(CopySegmentPixels);
}

void
RequireMadeOn(const DicomSegmentationFile & file, const DicomSource & source)
{
  const DicomSeries & series = source.series;
  const bool          isSeries = file.seriesUID.empty() || file.seriesUID == series.uid;
  const bool isFrame = file.frameOfReferenceUID.empty() || file.frameOfReferenceUID == series.frameOfReferenceUID;
  const bool tells = !file.seriesUID.empty() || !file.frameOfReferenceUID.empty();
  if (!tells || !isSeries || !isFrame)
  {
    throw InputError('"' + file.path + "\" " +
                     (tells ? "was created from another series than " : "does not reference the series ") + series.uid +
                     "; use its source series");
  }
}

DicomSegmentationFile
ReadDicomSegmentation(const std::string & path)
{
  DicomSegmentationFile file;
  ReadContained(path, DicomSegmentationService, 0, [&](const std::string & response, const char *) {
    ByteReader reader(response);
    TransmitSegments(reader, file);
  });
  file.path = path;
  for (const DicomSegmentInFile & segment : file.segments)
  {
    if (!segment.isNameDecoded)
    {
      file.notes.push_back("the label of segment " + std::to_string(segment.number) +
                           " contains bytes that are invalid in its character set, shown as '?'");
    }
  }
  return file;
}

DicomSegmentVoxels
ReadDicomSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const DicomSource & source)
{
  RequireSegments(file, numbers);
  const auto         places = PlacesOfFrames(file, source);
  DicomSegmentVoxels read{ NewImageOn<DicomLabelImage>(source.grid, true),
                           std::vector<std::size_t>(numbers.size(), 0) };
  const auto         paint = [&](const std::string &, const char * data) {
    if (file.bytesPerLabel > 0)
    {
      RequireDeclaredLabels(file, data);
    }
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
      for (std::size_t i = 0; i < file.frames.size(); ++i)
      {
        if (file.frames[i].segment == numbers[k] || file.bytesPerLabel > 0)
        {
          read.voxels[k] += PaintFrame(file, i, data, numbers[k], places[i], read.labels);
        }
      }
    }
  };
  ReadContained(file.path, DicomSegmentPixelService, BytesOfPixels(file), paint);
  return read;
}
} // namespace shapeton
