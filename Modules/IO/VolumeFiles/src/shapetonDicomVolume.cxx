#include "shapetonDicomVolume.h"

#include "shapetonDicomFields.h"
#include "shapetonDicomPixels.h"
#include "shapetonDicomSeriesDefects.h"
#include "shapetonDicomSeriesGeometry.h"
#include "shapetonDicomText.h"
#include "shapetonOperatingSystem.h"
#include "shapetonNumberText.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"

#include "itkMetaDataObject.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using ImageType = Volume::ImageType;
using Slices = std::vector<DicomSlice>;

// Rounding error of coordinates, in pixels.
constexpr double IndexTolerance = 1e-6;

[[noreturn]] void
Refuse(const DicomSeries & series, const std::string & reason)
{
  throw InputError("series " + series.GetSelector() + " (" + series.description + "): " + reason);
}

void
CheckMemory(const DicomSeries & series, double voxels)
{
  if (voxels * sizeof(float) > PhysicalMemory())
  {
    Refuse(series, "the volume exceeds the memory of this machine; use fewer slices");
  }
}

/** A grid along the series' rows, columns and normal; `start` is its first voxel, relative to the first pixel of the
 * series. */
itk::ImageBase<3>::Pointer
MakeGrid(const DicomSeries & series, const ImageType::SizeType & size, double sliceSpacing, const double (&start)[3])
{
  const auto           grid = itk::ImageBase<3>::New();
  ImageType::PointType origin = series.slices.front().imagePosition;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      origin[i] += series.direction(i, axis) * start[axis];
    }
  }
  const double spacing[3] = { series.spacing[0], series.spacing[1], sliceSpacing };
  grid->SetRegions(size);
  grid->SetSpacing(spacing);
  grid->SetOrigin(origin);
  grid->SetDirection(series.direction);
  return grid;
}

ImageType::Pointer
MakeImage(const DicomSeries & series, const ImageType::SizeType & size, double sliceSpacing, const double (&start)[3])
{
  CheckMemory(series, static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(size[2]));
  return NewImageOn<ImageType>(MakeGrid(series, size, sliceSpacing, start));
}

/** The first slice at each position. */
Slices
DropDuplicates(const DicomSeries & series, Volume & volume)
{
  const double tolerance = std::max(PositionTolerance(series.spacing[2]), 1e-3);
  Slices       kept;
  for (const DicomSlice & slice : series.slices)
  {
    if (kept.empty() || slice.position - kept.back().position > tolerance)
    {
      kept.push_back(slice);
    }
  }
  const std::size_t dropped = series.slices.size() - kept.size();
  if (dropped > 0)
  {
    volume.repairs.push_back("dropDuplicates: " + Count(dropped, "slice") + " at positions of other slices skipped");
  }
  return kept;
}

double
UniformSpacing(const Slices & slices)
{
  if (slices.back().position > slices.front().position)
  {
    return (slices.back().position - slices.front().position) / static_cast<double>(slices.size() - 1);
  }
  return slices.front().thickness > 0 ? slices.front().thickness : 1.0;
}

/** The unchanged slices, one after another. */
ImageType::Pointer
ReadStack(const DicomSeries & series, const Slices & slices, const Progress & progress)
{
  const double                    start[3] = { 0, 0, slices.front().position };
  const ImageType::SizeType       size{ { series.size[0], series.size[1], slices.size() } };
  const auto                      image = MakeImage(series, size, UniformSpacing(slices), start);
  std::vector<const DicomSlice *> pointers;
  for (const DicomSlice & slice : slices)
  {
    pointers.push_back(&slice);
  }
  ReadDicomSlices(pointers, series.size[0], series.size[1], image->GetBufferPointer(), progress);
  return image;
}

/** Replaces NaN, which marks padding, with the lowest measured intensity. */
void
FillPadding(const DicomSeries & series, ImageType * image, Volume & volume)
{
  float * const     voxels = image->GetBufferPointer();
  const std::size_t count = image->GetLargestPossibleRegion().GetNumberOfPixels();
  float             lowest = std::numeric_limits<float>::infinity();
  std::size_t       padding = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (std::isinf(voxels[i]))
    {
      Refuse(series, "Rescale Slope and Intercept result in intensities beyond the range of float");
    }
    padding += std::isnan(voxels[i]) ? 1 : 0;
    lowest = std::isnan(voxels[i]) ? lowest : std::min(lowest, voxels[i]);
  }
  if (padding == count)
  {
    Refuse(series, "all pixels are padding");
  }
  if (padding > 0)
  {
    std::replace_if(
      voxels, voxels + count, [](float value) { return std::isnan(value); }, lowest);
    volume.notes.push_back(Count(padding, "padding pixel") + " set to the lowest intensity, " + NumberText(lowest));
  }
}

// ---- deshear ----

/** A slice shifted within its plane, by bilinear interpolation. */
class MovedSlice
{
public:
  /** The sample at index (0, 0) of the new slice is at (startX, startY) of the old one. */
  MovedSlice(const float * pixels, const ImageType::SizeType & size, double startX, double startY, float outside)
    : m_Pixels(pixels)
    , m_Columns(static_cast<std::ptrdiff_t>(size[0]))
    , m_Rows(static_cast<std::ptrdiff_t>(size[1]))
    , m_StartX(startX)
    , m_StartY(startY)
    , m_Outside(outside)
  {}

  float
  Sample(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    double               fractionX = 0;
    double               fractionY = 0;
    const std::ptrdiff_t x = Split(m_StartX + static_cast<double>(column), m_Columns, fractionX);
    const std::ptrdiff_t y = Split(m_StartY + static_cast<double>(row), m_Rows, fractionY);
    if (x < 0 || y < 0)
    {
      return m_Outside;
    }
    const std::ptrdiff_t right = fractionX > 0 ? 1 : 0;
    const std::ptrdiff_t below = fractionY > 0 ? m_Columns : 0;
    const float * const  corner = m_Pixels + y * m_Columns + x;
    const double         top = corner[0] + fractionX * (double(corner[right]) - corner[0]);
    const double         bottom = corner[below] + fractionX * (double(corner[below + right]) - corner[below]);
    return static_cast<float>(top + fractionY * (bottom - top));
  }

private:
  /** The pixel before a coordinate and the fractional distance to the next one; -1 outside the slice. */
  static std::ptrdiff_t
  Split(double coordinate, std::ptrdiff_t size, double & fraction)
  {
    if (coordinate < -IndexTolerance || coordinate > static_cast<double>(size - 1) + IndexTolerance)
    {
      return -1;
    }
    const double nearest = std::round(coordinate);
    const double lower = std::abs(coordinate - nearest) <= IndexTolerance ? nearest : std::floor(coordinate);
    fraction = lower == nearest && std::abs(coordinate - nearest) <= IndexTolerance ? 0.0 : coordinate - lower;
    return static_cast<std::ptrdiff_t>(lower);
  }

  const float *  m_Pixels;
  std::ptrdiff_t m_Columns;
  std::ptrdiff_t m_Rows;
  double         m_StartX;
  double         m_StartY;
  float          m_Outside;
};

/** The grid that covers all slices, and the slices resampled to it. */
ImageType::Pointer
Deshear(const DicomSeries & series,
        const Slices &      slices,
        const ImageType *   stack,
        const Progress &    progress,
        Volume &            volume)
{
  const ImageType::SizeType oldSize = stack->GetLargestPossibleRegion().GetSize();
  const DeshearedPlane      plane = PlaneOfSlices(series, slices);
  if (plane.growth > LargestGrowth)
  {
    Refuse(series, "the slices are displaced too far for deshear");
  }
  const double              start[3] = { plane.start[0], plane.start[1], slices.front().position };
  const ImageType::SizeType size{ { plane.size[0], plane.size[1], oldSize[2] } };
  const auto                image = MakeImage(series, size, stack->GetSpacing()[2], start);
  const float *             pixels = stack->GetBufferPointer();
  const float outside = *std::min_element(pixels, pixels + stack->GetLargestPossibleRegion().GetNumberOfPixels());
  float *     voxel = image->GetBufferPointer();
  for (const DicomSlice & slice : slices)
  {
    const MovedSlice moved(pixels,
                           oldSize,
                           (start[0] - slice.offset[0]) / series.spacing[0],
                           (start[1] - slice.offset[1]) / series.spacing[1],
                           outside);
    for (std::size_t row = 0; row < size[1]; ++row)
    {
      for (std::size_t column = 0; column < size[0]; ++column)
      {
        *voxel++ = moved.Sample(static_cast<std::ptrdiff_t>(column), static_cast<std::ptrdiff_t>(row));
      }
    }
    pixels += oldSize[0] * oldSize[1];
    progress((&slice - slices.data() + 1.0) / static_cast<double>(slices.size()));
  }
  volume.repairs.push_back("deshear: " + Count(slices.size(), "slice") +
                           " shifted within their planes by linear interpolation, uncovered voxels set to " +
                           NumberText(outside));
  return image;
}

// ---- resample ----

/** The slice before a position, and the fractional distance to the next one; 0 at a slice. */
std::size_t
FindSlice(const Slices & slices, double position, double tolerance, double & fraction)
{
  const auto        less = [](double value, const DicomSlice & slice) { return value < slice.position; };
  const auto        next = std::upper_bound(slices.begin(), slices.end(), position, less);
  const std::size_t before = next == slices.begin() ? 0 : static_cast<std::size_t>(next - slices.begin()) - 1;
  fraction = 0;
  if (before + 1 >= slices.size() || std::abs(position - slices[before].position) <= tolerance)
  {
    return before;
  }
  if (std::abs(position - slices[before + 1].position) <= tolerance)
  {
    return before + 1;
  }
  fraction = (position - slices[before].position) / (slices[before + 1].position - slices[before].position);
  return before;
}

ImageType::Pointer
ResampleGaps(const DicomSeries & series,
             const Slices &      slices,
             const ImageType *   stack,
             const Progress &    progress,
             Volume &            volume)
{
  const double length = slices.back().position - slices.front().position;
  const double steps = ResampledSteps(length, series.spacing[2]);
  if (!CanBeResampled(slices.size(), length, series.spacing[2]))
  {
    Refuse(series,
           "the gaps are too wide: " + NumberText(steps + 1) + " slices would be made from " +
             std::to_string(slices.size()));
  }
  const double        spacing = length / steps;
  const double        tolerance = PositionTolerance(spacing);
  ImageType::SizeType size = stack->GetLargestPossibleRegion().GetSize();
  size[2] = static_cast<std::size_t>(steps) + 1;
  const double start[3] = { 0, 0, 0 };
  const auto   image = MakeImage(series, size, spacing, start);
  image->SetOrigin(stack->GetOrigin());
  const std::size_t pixels = size[0] * size[1];
  std::size_t       interpolated = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
  {
    double              fraction = 0;
    const double        position = slices.front().position + static_cast<double>(k) * spacing;
    const std::size_t   before = FindSlice(slices, position, tolerance, fraction);
    const float * const a = stack->GetBufferPointer() + before * pixels;
    const float * const b = fraction > 0 ? a + pixels : a;
    float * const       voxels = image->GetBufferPointer() + k * pixels;
    for (std::size_t i = 0; i < pixels; ++i)
    {
      voxels[i] = static_cast<float>(a[i] + fraction * (double(b[i]) - a[i]));
    }
    interpolated += fraction > 0 ? 1 : 0;
    progress((k + 1.0) / static_cast<double>(size[2]));
  }
  volume.repairs.push_back("resampleGaps: " + Count(slices.size(), "slice") + " resampled to " +
                           std::to_string(size[2]) + " at " + NumberText(spacing) + " mm, " +
                           std::to_string(interpolated) + " of them by linear interpolation");
  return image;
}

/** The UID or, if it was removed, a digest of the files in slice order. */
std::string
IdentityOf(const DicomSeries & series)
{
  if (!series.uid.empty())
  {
    return IdentityOfSeries(series.GetSelector());
  }
  std::string digests;
  for (const DicomSlice & slice : series.slices)
  {
    digests += Sha256OfFile(slice.file);
  }
  return "sha256:" + Sha256OfBytes(digests);
}

void
AddNotes(const DicomSeries & series, Volume & volume)
{
  if (series.isLossy)
  {
    volume.notes.push_back("the pixels were compressed lossily");
  }
  if (series.isInverted)
  {
    volume.notes.push_back("MONOCHROME1: low intensities are displayed bright; the values are unchanged");
  }
  if (series.modality == "CT" && !series.slices.front().pixels.hasRescale)
  {
    volume.notes.push_back(
      "no Rescale Slope and Rescale Intercept: stored values are used, perhaps not Hounsfield units");
  }
  if (series.isSingleSlice)
  {
    const double thickness = series.slices.front().thickness;
    volume.notes.push_back(thickness > 0
                             ? "a single slice; its spacing is its Slice Thickness, " + NumberText(thickness) + " mm"
                             : std::string("a single slice without Slice Thickness; its spacing is set to 1 mm"));
  }
}

} // namespace

std::vector<std::pair<std::string, std::string>>
DicomMetadata(const Volume & volume)
{
  std::vector<std::pair<std::string, std::string>> metadata;
  const auto                                       add = [&metadata](const char * key, const std::string & value) {
    if (!value.empty())
    {
      metadata.emplace_back(key, value);
    }
  };
  add(DicomModality, volume.modality);
  add(DicomPatientPosition, volume.patientPosition);
  add(DicomSliceThickness, volume.sliceThickness > 0.0 ? DicomDecimal(volume.sliceThickness) : "");
  return metadata;
}

void
SetDicomFields(Volume & volume)
{
  for (const auto & [key, value] : DicomMetadata(volume))
  {
    itk::EncapsulateMetaData(volume.image->GetMetaDataDictionary(), key, value);
  }
}

DeshearedPlane
PlaneOfSlices(const DicomSeries & series, const std::vector<DicomSlice> & slices)
{
  DeshearedPlane plane{ { 0.0, 0.0 }, { series.size[0], series.size[1] }, 1.0 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto less = [axis](const DicomSlice & a, const DicomSlice & b) { return a.offset[axis] < b.offset[axis]; };
    const auto range = std::minmax_element(slices.begin(), slices.end(), less);
    plane.start[axis] = range.first->offset[axis];
    const double extra = (range.second->offset[axis] - plane.start[axis]) / series.spacing[axis];
    plane.growth *= 1 + extra / series.size[axis];
    const double largest = LargestGrowth * series.size[axis]; // a larger plane is rejected
    plane.size[axis] += static_cast<std::size_t>(std::ceil(std::min(extra, largest) - IndexTolerance));
  }
  return plane;
}

itk::ImageBase<3>::Pointer
GridOfDicomSeries(const DicomSeries & series, bool isDesheared)
{
  const DeshearedPlane plane = isDesheared ? PlaneOfSlices(series, series.slices)
                                           : DeshearedPlane{ { 0.0, 0.0 }, { series.size[0], series.size[1] }, 1.0 };
  const double         start[3] = { plane.start[0], plane.start[1], 0.0 };
  return MakeGrid(
    series, { { plane.size[0], plane.size[1], series.slices.size() } }, UniformSpacing(series.slices), start);
}

Volume
ReadDicomVolume(const DicomSeries & series, const VolumeReadOptions & options, const Progress & progress)
{
  Volume volume;
  volume.modality = series.modality;
  volume.patientPosition = series.patientPosition;
  volume.sliceThickness = series.slices.front().thickness;
  volume.seriesUID = series.uid;
  volume.identity = IdentityOf(series);
  const Slices slices = options.dropDuplicates ? DropDuplicates(series, volume) : series.slices;
  volume.image = ReadStack(series, slices, progress.Part("Reading slices", 0.3, 0.8));
  FillPadding(series, volume.image, volume);
  if (options.deshear && series.Has(DicomDefectKind::shear))
  {
    volume.image = Deshear(series, slices, volume.image, progress.Part("Moving slices", 0.8, 0.9), volume);
  }
  if (options.resampleGaps && (series.Has(DicomDefectKind::gap) || series.Has(DicomDefectKind::variableSpacing)))
  {
    volume.image = ResampleGaps(series, slices, volume.image, progress.Part("Resampling", 0.9, 1.0), volume);
  }
  SetDicomFields(volume);
  AddNotes(series, volume);
  progress("Reading slices", 1.0);
  return volume;
}
} // namespace shapeton
