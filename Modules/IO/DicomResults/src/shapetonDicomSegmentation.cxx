#include "shapetonDicomSegmentation.h"

#include "shapetonDicomFrames.h"
#include "shapetonDicomResultObject.h"
#include "shapetonDicomText.h"
#include "shapetonExceptions.h"
#include "shapetonVolume.h"

#include <algorithm>
#include <cmath>
#include <map>

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

/** Number of voxels of each label in each slice. */
class LabelCount
{
public:
  explicit LabelCount(const DicomLabelImage & labels)
  {
    const auto        size = labels.GetLargestPossibleRegion().GetSize();
    const std::size_t pixels = size[0] * size[1];
    for (std::size_t slice = 0; slice < size[2]; ++slice)
    {
      const unsigned short * const first = labels.GetBufferPointer() + slice * pixels;
      m_Slices.push_back(CountSlice(first, first + pixels));
    }
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

private:
  using Counts = std::map<unsigned short, std::size_t>;

  static Counts
  CountSlice(const unsigned short * first, const unsigned short * last)
  {
    Counts counts;
    while (first != last) // by runs, because most of a slice is empty
    {
      const auto end = std::find_if(first, last, [label = *first](unsigned short other) { return other != label; });
      counts[*first] += static_cast<std::size_t>(end - first);
      first = end;
    }
    return counts;
  }

  std::vector<Counts> m_Slices;
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

void
PutImage(DicomResultObject & object, const DicomSource & source)
{
  const Uint32 one = 1;
  object.PutFrameOfReference();
  object.PutContentQualification();
  object.PutLossiness();
  object.PutReferencedSeries();
  object.PutSharedPlane();
  object.Root()
    .Text(DCM_ImageType, "DERIVED\\PRIMARY")
    .Integers(DCM_SamplesPerPixel, { one })
    .Text(DCM_PhotometricInterpretation, "MONOCHROME2")
    .Integers(DCM_Rows, { static_cast<Uint32>(source.series.size[1]) })
    .Integers(DCM_Columns, { static_cast<Uint32>(source.series.size[0]) })
    .Integers(DCM_BitsAllocated, { one })
    .Integers(DCM_BitsStored, { one })
    .Integers(DCM_HighBit, { 0 })
    .Integers(DCM_PixelRepresentation, { 0 })
    .Text(DCM_SegmentationType, "BINARY")
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
    .Text(DCM_SegmentAlgorithmType, "AUTOMATIC")
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

void
PutFrame(DicomItem frame, const DicomSlice & slice, std::size_t place, int number)
{
  PutFramePlace(frame, slice, place, { static_cast<Uint32>(number) });
  frame.Add(DCM_SegmentIdentificationSequence).Integers(DCM_ReferencedSegmentNumber, { static_cast<Uint32>(number) });
  PutDerivation(frame, slice, { "113076", "DCM", "Segmentation" });
}

/** Returns their number. */
int
WriteFrames(DicomItem            root,
            const DicomSource &  source,
            const DicomSegment & segment,
            int                  number,
            const LabelCount &   count,
            BitWriter &          bits)
{
  const std::size_t pixels = std::size_t(source.series.size[0]) * source.series.size[1];
  int               frames = 0;
  for (std::size_t slice = 0; slice < source.series.slices.size(); ++slice)
  {
    if (count.InSlice(slice, segment.label) > 0)
    {
      PutFrame(root.Add(DCM_PerFrameFunctionalGroupsSequence), source.series.slices[slice], slice, number);
      bits.Write(segment.labels->GetBufferPointer() + slice * pixels, pixels, segment.label);
      ++frames;
    }
  }
  return frames;
}

/** Whether segments may overlap, that is if there are several label images. */
bool
DoOverlap(const std::vector<DicomSegment> & segments)
{
  return std::any_of(segments.begin(), segments.end(), [&](const DicomSegment & segment) {
    return segment.labels != segments.front().labels;
  });
}
} // namespace

DicomSegmentation
WriteDicomSegmentation(const DicomSource &               source,
                       const std::vector<DicomSegment> & segments,
                       const DicomResultHeader &         header,
                       const std::string &               path,
                       bool                              isDeflated)
{
  RequireGrid(source, segments);
  DicomResultObject object(source, UID_SegmentationStorage, "SEG", header);
  PutImage(object, source);
  PutDimensions(object.Root(),
                source.series,
                FrameDimension{ DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence, "Segment" });
  std::map<const DicomLabelImage *, LabelCount> counts;
  DicomSegmentation                             written;
  BitWriter                                     bits;
  int                                           number = 0;
  int                                           frames = 0;
  for (const DicomSegment & segment : segments)
  {
    const LabelCount & count = counts.try_emplace(segment.labels, *segment.labels).first->second;
    written.voxels.push_back(count.InAll(segment.label));
    written.numbers.push_back(written.voxels.back() > 0 ? ++number : 0);
    if (written.voxels.back() == 0)
    {
      continue;
    }
    PutSegment(object.Root().Add(DCM_SegmentSequence), segment, number, header);
    frames += WriteFrames(object.Root(), source, segment, number, count, bits);
  }
  if (frames == 0)
  {
    throw InputError("no segment has a voxel; there is nothing to write to \"" + path + '"');
  }
  object.Root()
    .Text(DCM_SegmentsOverlap, DoOverlap(segments) ? "YES" : "NO")
    .Text(DCM_NumberOfFrames, std::to_string(frames))
    .Bytes(DCM_PixelData, bits.TakeBytes());
  written.instance = object.Save(path, isDeflated);
  return written;
}
} // namespace shapeton
