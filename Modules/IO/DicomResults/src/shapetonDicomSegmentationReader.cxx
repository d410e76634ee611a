#include "shapetonDicomSegmentationReader.h"

#include "shapetonByteStream.h"
#include "shapetonDicomReading.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

namespace shapeton
{
namespace
{
constexpr std::uint64_t MaximumDeflateRatio = 1032;

// ---- in the contained process ----

/** A functional group of a frame, or of all; throws where it is missing. */
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
    segment.number = static_cast<int>(NumbersOf(*item, DCM_SegmentNumber, 1).front());
    segment.name = TextOf(*item, DCM_SegmentLabel);
    segment.category = CodeOf(*item, DCM_SegmentedPropertyCategoryCodeSequence);
    segment.type = CodeOf(*item, DCM_SegmentedPropertyTypeCodeSequence);
    segment.trackingUID = TextOf(*item, DCM_TrackingUID);
    if (Declares(file, segment.number))
    {
      throw std::runtime_error("declares segment " + std::to_string(segment.number) + " twice");
    }
    file.segments.push_back(segment);
  }
  if (file.segments.empty())
  {
    throw std::runtime_error("declares no segment");
  }
}

/** Orientation and spacing must be those of all frames. */
void
TakePlane(DcmItem & orientation, DcmItem & measures, bool isFirst, DicomSegmentationFile & file)
{
  const auto cosines = NumbersOf(orientation, DCM_ImageOrientationPatient, 6);
  const auto spacing = NumbersOf(measures, DCM_PixelSpacing, 2);
  if (isFirst)
  {
    std::copy(cosines.begin(), cosines.end(), file.orientation);
    file.spacing[0] = spacing[1]; // DICOM has that of rows first
    file.spacing[1] = spacing[0];
  }
  const auto isClose = [](double a, double b) { return std::abs(a - b) <= 1e-4; };
  if (!std::equal(cosines.begin(), cosines.end(), file.orientation, isClose) || !isClose(spacing[1], file.spacing[0]) ||
      !isClose(spacing[0], file.spacing[1]))
  {
    throw std::runtime_error("has frames of several orientations or spacings, which are not read");
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
    throw std::runtime_error("describes " + std::to_string(frames.size()) + " frames of those that it claims to have");
  }
  for (DcmItem * const item : frames)
  {
    TakePlane(GroupOf(item, shared, DCM_PlaneOrientationSequence),
              GroupOf(item, shared, DCM_PixelMeasuresSequence),
              file.frames.empty(),
              file);
    DcmItem &  identification = GroupOf(item, shared, DCM_SegmentIdentificationSequence);
    const auto position = NumbersOf(GroupOf(item, shared, DCM_PlanePositionSequence), DCM_ImagePositionPatient, 3);
    DicomSegmentFrame frame;
    frame.segment = static_cast<int>(NumbersOf(identification, DCM_ReferencedSegmentNumber, 1).front());
    frame.position = itk::Point<double, 3>(position.data());
    if (!Declares(file, frame.segment))
    {
      throw std::runtime_error("has frames of segment " + std::to_string(frame.segment) +
                               ", which it does not declare");
    }
    file.frames.push_back(frame);
  }
}

std::uint64_t
BytesOfPixels(const DicomSegmentationFile & file)
{
  const std::uint64_t pixels = std::uint64_t(file.columns) * file.rows * file.frames.size();
  return file.wholeValue > 0 ? pixels : (pixels + 7) / 8;
}

/** The pixel data are as long as frames and format ask for: checked before memory is asked for. */
void
RequirePixels(DcmDataset & dataset, const DicomSegmentationFile & file)
{
  const DcmXfer syntax(dataset.getOriginalXfer());
  if (syntax.isEncapsulated())
  {
    throw std::runtime_error(std::string("is compressed as ") + syntax.getXferName() +
                             ", which is not read; decompress it");
  }
  DcmElement * pixels = nullptr;
  dataset.findAndGetElement(DCM_PixelData, pixels);
  const bool          isDeflated = syntax.getStreamCompression() == ESC_zlib;
  const std::uint64_t limit = std::filesystem::file_size(file.path) * (isDeflated ? MaximumDeflateRatio : 1);
  if (!pixels || std::min<std::uint64_t>(pixels->getLength(dataset.getOriginalXfer()), limit) < BytesOfPixels(file))
  {
    throw std::runtime_error("ends within its pixels");
  }
}

void
ReadPixelFormat(DcmItem & dataset, DicomSegmentationFile & file)
{
  const std::string type = TextOf(dataset, DCM_SegmentationType);
  const double      bits = NumbersOf(dataset, DCM_BitsAllocated, 1).front();
  file.columns = static_cast<unsigned int>(NumbersOf(dataset, DCM_Columns, 1).front());
  file.rows = static_cast<unsigned int>(NumbersOf(dataset, DCM_Rows, 1).front());
  if (type == "FRACTIONAL" && bits == 8)
  {
    file.wholeValue = static_cast<unsigned int>(NumbersOf(dataset, DCM_MaximumFractionalValue, 1).front());
  }
  if (file.columns == 0 || file.rows == 0 || (file.wholeValue == 0 && !(type == "BINARY" && bits == 1)))
  {
    throw std::runtime_error("is a segmentation of the type " + type + " with " +
                             std::to_string(static_cast<int>(bits)) + " bits, which is not read");
  }
}

template <typename TStream, typename TFile>
void
Transmit(TStream & stream, TFile & file)
{
  auto     segments = static_cast<std::uint64_t>(file.segments.size());
  auto     frames = static_cast<std::uint64_t>(file.frames.size());
  stream & file.frameOfReferenceUID & file.seriesUID & file.columns & file.rows & file.spacing & file.orientation & file
    .wholeValue & segments & frames;
  if constexpr (!std::is_const<TFile>::value)
  {
    if (segments + frames > stream.GetLeft())
    {
      throw std::runtime_error("cannot be read: incomplete message");
    }
    file.segments.resize(segments);
    file.frames.resize(frames);
  }
  for (auto & segment : file.segments)
  {
    stream & segment.number & segment.name & segment.trackingUID;
    for (auto * const code : { &segment.category, &segment.type })
    {
      stream & code->value & code->scheme & code->meaning;
    }
  }
  for (auto & frame : file.frames)
  {
    stream & frame.segment & frame.position[0] & frame.position[1] & frame.position[2];
  }
}

std::string
ParseHeader(const std::string & path)
{
  DcmFileFormat format;
  LoadDicomObject(format, path, { UID_SegmentationStorage });
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
  ReadFrames(dataset, file);
  RequirePixels(dataset, file);
  ByteWriter                    writer;
  const DicomSegmentationFile & whole = file;
  Transmit(writer, whole);
  return writer.GetBytes();
}

std::string
CopyPixels(const std::string & path, std::size_t bytes, char * shared)
{
  DcmFileFormat format;
  LoadDicomObject(format, path, { UID_SegmentationStorage });
  const Uint8 * pixels = nullptr;
  unsigned long count = 0;
  DcmDataset &  dataset = *format.getDataset();
  if (dataset.findAndGetUint8Array(DCM_PixelData, pixels, &count).bad() || !pixels || count < bytes)
  {
    throw std::runtime_error("ends within its pixels");
  }
  std::copy(pixels, pixels + bytes, shared);
  return {};
}

// ---- in this process ----

/** Where frames lie on a grid. */
class GridPlanes
{
public:
  GridPlanes(const DicomSegmentationFile & file, const itk::ImageBase<3> * grid) : m_File(file), m_Grid(grid)
  {
    const auto size = grid->GetLargestPossibleRegion().GetSize();
    bool       isSame = file.columns == size[0] && file.rows == size[1];
    for (unsigned int k = 0; k < 3; ++k)
    {
      isSame = isSame && std::abs(grid->GetDirection()(k, 0) - file.orientation[k]) <= 1e-3 &&
               std::abs(grid->GetDirection()(k, 1) - file.orientation[3 + k]) <= 1e-3;
    }
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      const double extent = static_cast<double>(size[axis]) * std::abs(grid->GetSpacing()[axis] - file.spacing[axis]);
      isSame = isSame && extent <= Tolerance * grid->GetSpacing()[axis];
    }
    if (!isSame)
    {
      this->Refuse();
    }
  }

  std::size_t
  SliceOf(const DicomSegmentFrame & frame) const
  {
    const auto index = m_Grid->TransformPhysicalPointToContinuousIndex<double>(frame.position);
    const auto slice = std::lround(index[2]);
    const auto slices = static_cast<long>(m_Grid->GetLargestPossibleRegion().GetSize(2));
    if (!(std::abs(index[0]) <= Tolerance && std::abs(index[1]) <= Tolerance &&
          std::abs(index[2] - static_cast<double>(slice)) <= Tolerance && slice >= 0 && slice < slices))
    {
      this->Refuse();
    }
    return static_cast<std::size_t>(slice);
  }

private:
  static constexpr double Tolerance = 0.05; // of a voxel: positions are rounded by some writers

  [[noreturn]] void
  Refuse() const
  {
    throw InputError("\"" + m_File.path +
                     "\" has frames that are no slices of the given series with its pixels; resample the segmentation "
                     "to the series, for example in 3D Slicer");
  }

  const DicomSegmentationFile & m_File;
  const itk::ImageBase<3> *     m_Grid;
};

DicomLabelImage::Pointer
EmptyLabels(const itk::ImageBase<3> * grid)
{
  const auto labels = DicomLabelImage::New();
  labels->CopyInformation(grid);
  labels->SetRegions(grid->GetLargestPossibleRegion().GetSize());
  labels->Allocate(true);
  return labels;
}

/** Returns how many voxels it has painted. */
std::size_t
PaintFrame(const DicomSegmentationFile & file, std::size_t frame, const char * data, int number, unsigned short * slice)
{
  const auto * const bytes = reinterpret_cast<const unsigned char *>(data);
  const std::size_t  pixels = std::size_t(file.columns) * file.rows;
  const std::size_t  first = frame * pixels;
  std::size_t        painted = 0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const std::size_t at = first + i;
    const bool isIn = file.wholeValue > 0 ? 2u * bytes[at] >= file.wholeValue : ((bytes[at / 8] >> (at % 8)) & 1) != 0;
    if (isIn)
    {
      slice[i] = static_cast<unsigned short>(number);
      ++painted;
    }
  }
  return painted;
}

void
RequireSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers)
{
  for (const int number : numbers)
  {
    RequireParameter(Declares(file, number), '"' + file.path + "\" has no segment " + std::to_string(number));
    RequireParameter(std::count(numbers.begin(), numbers.end(), number) == 1,
                     "segment " + std::to_string(number) + " is asked for twice");
  }
}

/** The slice of each frame. */
std::vector<std::size_t>
SlicesOf(const DicomSegmentationFile & file, const itk::ImageBase<3> * grid)
{
  const GridPlanes                      planes(file, grid);
  std::vector<std::size_t>              slices;
  std::set<std::pair<int, std::size_t>> taken;
  for (const DicomSegmentFrame & frame : file.frames)
  {
    slices.push_back(planes.SliceOf(frame));
    if (!taken.insert({ frame.segment, slices.back() }).second)
    {
      throw InputError('"' + file.path + "\" has two frames of segment " + std::to_string(frame.segment) +
                       " in one plane; write it again");
    }
  }
  return slices;
}
} // namespace

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
                     (tells ? "was made on another series than " : "does not tell whether it was made on the series ") +
                     series.uid + "; give the series that it was made on");
  }
}

DicomSegmentationFile
ReadDicomSegmentation(const std::string & path)
{
  DicomSegmentationFile file;
  ReadContained(
    path,
    path,
    0,
    [](const std::string & request, char *) { return ParseHeader(request); },
    [&](const std::string & response, const char *) {
      ByteReader reader(response);
      Transmit(reader, file);
    });
  file.path = path;
  return file;
}

DicomSegmentVoxels
ReadDicomSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const itk::ImageBase<3> * grid)
{
  RequireSegments(file, numbers);
  const auto         slices = SlicesOf(file, grid);
  DicomSegmentVoxels read{ EmptyLabels(grid), std::vector<std::size_t>(numbers.size(), 0) };
  const std::size_t  pixels = std::size_t(file.columns) * file.rows;
  const std::size_t  bytes = BytesOfPixels(file);
  const auto         paint = [&](const std::string &, const char * data) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
      for (std::size_t i = 0; i < file.frames.size(); ++i)
      {
        if (file.frames[i].segment == numbers[k])
        {
          auto * const slice = read.labels->GetBufferPointer() + slices[i] * pixels;
          read.voxels[k] += PaintFrame(file, i, data, numbers[k], slice);
        }
      }
    }
  };
  ReadContained(
    file.path,
    file.path,
    bytes,
    [bytes](const std::string & request, char * shared) { return CopyPixels(request, bytes, shared); },
    paint);
  return read;
}
} // namespace shapeton
