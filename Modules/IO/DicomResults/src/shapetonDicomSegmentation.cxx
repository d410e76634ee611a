#include "shapetonDicomSegmentation.h"

#include "shapetonDicomAttributes.h"
#include "shapetonDicomFrames.h"
#include "shapetonDicomResultObject.h"
#include "shapetonDicomText.h"
#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Packs bits consecutively, lowest bit of a byte first; frames are not padded (DICOM PS3.5 8.1.1). */
class BitWriter
{
public:
  void
  Write(const unsigned short * labels, std::size_t count, unsigned short label)
  {
    constexpr std::size_t bits = 8; // of a byte
    m_Bytes.resize((m_Bits + count + bits - 1) / bits);
    for (std::size_t i = 0; i < count; ++i, ++m_Bits)
    {
      m_Bytes[m_Bits / 8] |= static_cast<Uint8>(labels[i] == label) << (m_Bits % 8);
    }
  }
  std::vector<Uint8>
  TakeBytes()
  {
    return std::move(m_Bytes);
  }

private:
  std::vector<Uint8> m_Bytes;
  std::size_t        m_Bits{ 0 };
};

/** Calls visit(label, x, y, z, length) for each run of equal labels in a row. */
template <typename TVisit>
void
ForEachRun(const DicomLabelImage & labels, const TVisit & visit)
{
  const auto             size = labels.GetLargestPossibleRegion().GetSize();
  const unsigned short * row = labels.GetBufferPointer();
  for (std::size_t i = 0; i < size[1] * size[2]; ++i, row += size[0])
  {
    for (const unsigned short * first = row; first != row + size[0];)
    {
      const auto end =
        std::find_if(first, row + size[0], [label = *first](unsigned short other) { return other != label; });
      visit(
        *first, static_cast<std::size_t>(first - row), i % size[1], i / size[1], static_cast<std::size_t>(end - first));
      first = end;
    }
  }
}

/** Number of voxels of each label in each slice, and a voxel in the middle of each label. */
class LabelCount
{
public:
  explicit LabelCount(const DicomLabelImage & labels) : m_Slices(labels.GetLargestPossibleRegion().GetSize()[2])
  {
    ForEachRun(labels, [&](unsigned short label, std::size_t x, std::size_t y, std::size_t z, std::size_t length) {
      m_Slices[z][label] += length;
      Middle &   middle = m_Middles[label];
      const auto count = static_cast<double>(length);
      middle.sum +=
        count *
        Eigen::Vector3d(static_cast<double>(x) + 0.5 * (count - 1.0), static_cast<double>(y), static_cast<double>(z));
    });
    this->FindMiddles(labels);
  }
  std::size_t
  InSlice(std::size_t slice, unsigned short label) const
  {
    const auto found = m_Slices[slice].find(label);
    return found == m_Slices[slice].end() ? 0 : found->second;
  }
  std::size_t
  InAll(unsigned short label) const
  {
    std::size_t sum = 0;
    for (std::size_t slice = 0; slice < m_Slices.size(); ++slice)
    {
      sum += this->InSlice(slice, label);
    }
    return sum;
  }
  /** The voxel of the label nearest to its centroid; zero for a label without voxels. */
  itk::Index<3>
  MiddleOf(unsigned short label) const
  {
    const auto found = m_Middles.find(label);
    return found == m_Middles.end() ? itk::Index<3>{} : found->second.voxel;
  }

private:
  struct Middle
  {
    Eigen::Vector3d sum{ 0.0, 0.0, 0.0 };
    double          distance{ std::numeric_limits<double>::infinity() };
    itk::Index<3>   voxel{};
  };

  void
  FindMiddles(const DicomLabelImage & labels)
  {
    const Eigen::Vector3d spacing(labels.GetSpacing().GetDataPointer());
    for (auto & [label, middle] : m_Middles)
    {
      middle.sum /= static_cast<double>(this->InAll(label)); // the centroid
    }
    ForEachRun(labels, [&](unsigned short label, std::size_t x, std::size_t y, std::size_t z, std::size_t length) {
      Middle &     middle = m_Middles[label];
      const auto   first = static_cast<double>(x);
      const double nearest = std::clamp(std::round(middle.sum[0]), first, first + static_cast<double>(length - 1));
      const Eigen::Vector3d voxel(nearest, static_cast<double>(y), static_cast<double>(z));
      const double          distance = (voxel - middle.sum).cwiseProduct(spacing).squaredNorm();
      if (distance < middle.distance)
      {
        middle.distance = distance;
        middle.voxel = { std::lround(nearest), static_cast<long>(y), static_cast<long>(z) };
      }
    });
  }

  std::vector<std::map<unsigned short, std::size_t>> m_Slices;
  std::map<unsigned short, Middle>                   m_Middles;
};

/** CIELab, D50, in DICOM encoding (PS3.3 C.10.7.1.1). */
std::vector<Uint32>
LabOf(const std::array<unsigned char, 3> & color)
{
  // Transfer function of sRGB (IEC 61966-2-1).
  constexpr double      linearEnd = 0.04045, linearSlope = 12.92, offset = 0.055, gamma = 2.4;
  std::array<double, 3> linear{};
  for (int i = 0; i < 3; ++i)
  {
    const double value = color[i] / 255.0;
    linear[i] = value > linearEnd ? std::pow((value + offset) / (1.0 + offset), gamma) : value / linearSlope;
  }
  // Lightness of CIE 15.
  constexpr double epsilon = 216.0 / 24389.0, kappa = 24389.0 / 27.0, shift = 16.0, scale = 116.0;
  const auto       weigh = [&](double r, double g, double b) {
    const double share = r * linear[0] + g * linear[1] + b * linear[2];
    return share > epsilon ? std::cbrt(share) : (kappa * share + shift) / scale;
  };
  const double     x = weigh(0.4361 / 0.9642, 0.3851 / 0.9642, 0.1431 / 0.9642);
  const double     y = weigh(0.2225, 0.7169, 0.0606);
  const double     z = weigh(0.0139 / 0.8249, 0.0971 / 0.8249, 0.7141 / 0.8249);
  constexpr double ofA = 500.0, ofB = 200.0;
  // 16 bits for L* from 0 to 100, a* and b* from -128 to 127.
  constexpr double greatest = 65535.0, perLightness = 655.35, perColor = 257.0, zero = 128.0;
  const auto word = [=](double value) { return static_cast<Uint32>(std::lround(std::clamp(value, 0.0, greatest))); };
  return { word((scale * y - shift) * perLightness),
           word((ofA * (x - y) + zero) * perColor),
           word((ofB * (y - z) + zero) * perColor) };
}

void
RequireGrid(const DicomSource & source, const std::vector<DicomSegment> & segments)
{
  for (const DicomSegment & segment : segments)
  {
    if (!HaveSameGrid(segment.labels, source.grid))
    {
      throw InputError("the segment " + segment.name + " is not on the grid of the series " + source.series.uid +
                       "; only results of this series without a repair can be written");
    }
  }
}

bool
IsLabelMap(DicomSegmentationFormat format)
{
  return format == DicomSegmentationFormat::LabelMap || format == DicomSegmentationFormat::DeflatedLabelMap;
}

E_TransferSyntax
SyntaxOf(DicomSegmentationFormat format)
{
  return format == DicomSegmentationFormat::Binary     ? EXS_LittleEndianExplicit
         : format == DicomSegmentationFormat::LabelMap ? EXS_RLELossless
                                                       : EXS_DeflatedLittleEndianExplicit;
}

/** `bits` per pixel: 1, or 8 or 16 in a label map. */
void
PutImage(DicomResultObject & object, const DicomSource & source, unsigned int bits)
{
  object.PutFrameOfReference();
  object.PutContentQualification();
  object.PutLossiness();
  object.PutReferencedSeries();
  object.PutSharedPlane();
  object.Root()
    .Text(DCM_ImageType, "DERIVED\\PRIMARY")
    .Integers(DCM_SamplesPerPixel, { 1 })
    .Text(DCM_PhotometricInterpretation, "MONOCHROME2")
    .Integers(DCM_Rows, { static_cast<Uint32>(source.series.size[1]) })
    .Integers(DCM_Columns, { static_cast<Uint32>(source.series.size[0]) })
    .Integers(DCM_BitsAllocated, { bits })
    .Integers(DCM_BitsStored, { bits })
    .Integers(DCM_HighBit, { bits - 1 })
    .Integers(DCM_PixelRepresentation, { 0 })
    .Text(DCM_SegmentationType, bits == 1 ? "BINARY" : "LABELMAP")
    .Text(DCM_ContentLabel, "SEGMENTS")
    .Text(DCM_ContentDescription, DicomResearchNote)
    .Text(DCM_ContentCreatorName, "");
}

void
PutSegment(DicomItem item, const DicomSegment & segment, int number, const DicomResultHeader & header)
{
  item.Integers(DCM_SegmentNumber, { static_cast<Uint32>(number) })
    .Text(DCM_SegmentLabel, segment.name)
    .Text(DCM_SegmentDescription, segment.description)
    .Text(DCM_SegmentAlgorithmType, segment.isSemiautomatic ? "SEMIAUTOMATIC" : "AUTOMATIC")
    .Text(DCM_SegmentAlgorithmName, "Shapeton " + header.tool + ' ' + header.version)
    .Code(DCM_SegmentedPropertyCategoryCodeSequence, segment.category)
    .Code(DCM_SegmentedPropertyTypeCodeSequence, segment.type)
    .Integers(DCM_RecommendedDisplayCIELabValue, LabOf(segment.color))
    .Text(DCM_TrackingID, segment.trackingID)
    .Text(DCM_TrackingUID, segment.trackingUID);
  if (segment.region)
  {
    item.Code(DCM_AnatomicRegionSequence, *segment.region);
  }
}

bool
AreAscii(const std::vector<DicomSegment> & segments)
{
  return std::all_of(segments.begin(), segments.end(), [](const DicomSegment & segment) {
    return IsAscii(segment.name + segment.description + segment.trackingID + segment.category.meaning +
                   segment.type.meaning + (segment.region ? segment.region->meaning : ""));
  });
}

/** Whether segments may overlap, that is, whether there are several label images. */
bool
DoOverlap(const std::vector<DicomSegment> & segments)
{
  return std::any_of(segments.begin(), segments.end(), [&](const DicomSegment & segment) {
    return segment.labels != segments.front().labels;
  });
}

/** Writes the frames of a segment. Returns their number. */
int
WriteFrames(DicomItem            root,
            const DicomSource &  source,
            const DicomSegment & segment,
            Uint32               number,
            const LabelCount &   count,
            BitWriter &          bits)
{
  const std::size_t pixels = std::size_t(source.series.size[0]) * source.series.size[1];
  int               frames = 0;
  for (std::size_t slice = 0; slice < source.series.slices.size(); ++slice)
  {
    if (count.InSlice(slice, segment.label) > 0)
    {
      DicomItem frame = root.Add(DCM_PerFrameFunctionalGroupsSequence);
      PutFramePlace(frame, source.series.slices[slice], slice, { number });
      frame.Add(DCM_SegmentIdentificationSequence).Integers(DCM_ReferencedSegmentNumber, { number });
      PutDerivation(frame, source.series.slices[slice], { "113076", "DCM", "Segmentation" });
      bits.Write(segment.labels->GetBufferPointer() + slice * pixels, pixels, segment.label);
      ++frames;
    }
  }
  return frames;
}

void
WriteBinaryFrames(DicomItem                               root,
                  const DicomSource &                     source,
                  const std::vector<DicomSegment> &       segments,
                  const std::vector<int> &                numbers,
                  const std::vector<const LabelCount *> & counts)
{
  PutDimensions(
    root, source.series, FrameDimension{ DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence, "Segment" });
  BitWriter bits;
  int       frames = 0;
  for (std::size_t k = 0; k < segments.size(); ++k)
  {
    if (numbers[k] > 0)
    {
      frames += WriteFrames(root, source, segments[k], static_cast<Uint32>(numbers[k]), *counts[k], bits);
    }
  }
  root.Text(DCM_SegmentsOverlap, DoOverlap(segments) ? "YES" : "NO")
    .Text(DCM_NumberOfFrames, std::to_string(frames))
    .Bytes(DCM_PixelData, bits.TakeBytes());
}

/** The segment number of each voxel, little endian. */
std::vector<Uint8>
BytesOfMap(const std::vector<DicomSegment> & segments, const std::vector<int> & numbers, std::size_t bytesPerVoxel)
{
  std::vector<Uint16> numberOf(std::size_t{ std::numeric_limits<unsigned short>::max() } + 1, 0);
  for (std::size_t k = 0; k < segments.size(); ++k)
  {
    numberOf[segments[k].label] = static_cast<Uint16>(numbers[k]);
  }
  const DicomLabelImage & labels = *segments.front().labels;
  const std::size_t       voxels = labels.GetBufferedRegion().GetNumberOfPixels();
  std::vector<Uint8>      bytes(voxels * bytesPerVoxel);
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const Uint16 number = numberOf[labels.GetBufferPointer()[i]];
    bytes[i * bytesPerVoxel] = static_cast<Uint8>(number & 0xFF);
    if (bytesPerVoxel > 1)
    {
      bytes[i * bytesPerVoxel + 1] = static_cast<Uint8>(number >> 8);
    }
  }
  return bytes;
}

void
WriteMapFrames(DicomItem                         root,
               const DicomSource &               source,
               const std::vector<DicomSegment> & segments,
               const std::vector<int> &          numbers,
               std::size_t                       bytesPerVoxel)
{
  PutDimensions(root, source.series, {});
  for (std::size_t slice = 0; slice < source.series.slices.size(); ++slice)
  {
    DicomItem frame = root.Add(DCM_PerFrameFunctionalGroupsSequence);
    PutFramePlace(frame, source.series.slices[slice], slice, {});
    PutDerivation(frame, source.series.slices[slice], { "113076", "DCM", "Segmentation" });
  }
  root.Word(DCM_PixelPaddingValue, 0)
    .Text(DCM_NumberOfFrames, std::to_string(source.series.slices.size()))
    .Bytes(DCM_PixelData, BytesOfMap(segments, numbers, bytesPerVoxel));
}

} // namespace

DicomSegmentation
WriteDicomSegmentation(const DicomSource &               source,
                       const std::vector<DicomSegment> & segments,
                       const DicomResultHeader &         header,
                       const std::string &               path,
                       DicomSegmentationFormat           format)
{
  RequireGrid(source, segments);
  if (IsLabelMap(format) && DoOverlap(segments))
  {
    throw std::invalid_argument("segments of a label map must be in one label image");
  }
  std::map<const DicomLabelImage *, LabelCount> countOf;
  std::vector<const LabelCount *>               counts;
  DicomSegmentation                             written;
  int                                           number = 0;
  for (const DicomSegment & segment : segments)
  {
    counts.push_back(&countOf.try_emplace(segment.labels, *segment.labels).first->second);
    written.voxels.push_back(counts.back()->InAll(segment.label));
    written.numbers.push_back(written.voxels.back() > 0 ? ++number : 0);
    const auto center = segment.labels->TransformIndexToPhysicalPoint<double>(counts.back()->MiddleOf(segment.label));
    written.centers.push_back({ center[0], center[1], center[2] });
  }
  if (number == 0)
  {
    throw InputError("no segment has a voxel; there is nothing to write to \"" + path + '"');
  }
  constexpr int     greatestByte = 255;
  const std::size_t bytesPerVoxel = number > greatestByte ? 2 : 1;
  DicomResultObject object(
    source, IsLabelMap(format) ? LabelMapSegmentationStorageUID : UID_SegmentationStorage, "SEG", header);
  if (!AreAscii(segments))
  {
    object.ConvertToUtf8();
  }
  PutImage(object, source, IsLabelMap(format) ? static_cast<unsigned int>(8 * bytesPerVoxel) : 1U);
  for (std::size_t k = 0; k < segments.size(); ++k)
  {
    if (written.numbers[k] > 0)
    {
      PutSegment(object.Root().Add(DCM_SegmentSequence), segments[k], written.numbers[k], header);
    }
  }
  if (IsLabelMap(format))
  {
    WriteMapFrames(object.Root(), source, segments, written.numbers, bytesPerVoxel);
  }
  else
  {
    WriteBinaryFrames(object.Root(), source, segments, written.numbers, counts);
  }
  written.instance = object.Save(path, SyntaxOf(format));
  return written;
}
} // namespace shapeton
