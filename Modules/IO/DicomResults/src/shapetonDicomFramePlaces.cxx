#include "shapetonDicomFramePlaces.h"

#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonPi.h"

#include "itkVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace shapeton
{
namespace
{
/** Distance of a frame from its voxels, as a fraction of a voxel: some writers round positions. */
constexpr double PlaceTolerance = 0.05;

[[noreturn]] void
RefusePlanes(const DicomSegmentationFile & file, const std::string & reason)
{
  throw InputError("\"" + file.path + "\" does not match the slices of the given series: " + reason +
                   "; resample the segmentation to the series, for example in 3D Slicer");
}

/** "0.75 x 1.25". */
std::string
Pair(double first, double second)
{
  return NumberText(first) + " x " + NumberText(second);
}

/** The axis of the series, 0 to 2, along which a frame runs, and in which direction. */
struct FrameAxis
{
  unsigned int axis;
  long         sign;
};

/** Components of a vector along the axes of the series. */
itk::Vector<double, 3>
AlongSeries(const DicomSeries & series, const itk::Vector<double, 3> & vector)
{
  itk::Vector<double, 3> components;
  components.SetVnlVector(series.direction.GetTranspose() * vector.GetVnlVector());
  return components;
}

/** Throws unless rows and columns of the frames run along axes of the series. */
std::array<FrameAxis, 2>
AxesOfFrames(const DicomSegmentationFile & file, const DicomSeries & series)
{
  constexpr double         rounding = 1e-3; // of written direction cosines; chosen
  std::array<FrameAxis, 2> axes{};
  bool                     isAlong = true;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto   cosines = AlongSeries(series, itk::Vector<double, 3>(file.orientation + 3 * i));
    unsigned int greatest = 0;
    for (unsigned int axis = 1; axis < 3; ++axis)
    {
      greatest = std::abs(cosines[axis]) > std::abs(cosines[greatest]) ? axis : greatest;
    }
    axes[i] = { greatest, cosines[greatest] < 0.0 ? -1 : 1 };
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double expected = axis == greatest ? axes[i].sign : 0.0;
      isAlong = isAlong && std::abs(cosines[axis] - expected) <= rounding;
    }
  }
  if (isAlong && axes[0].axis != axes[1].axis)
  {
    return axes;
  }
  constexpr double leastDegrees = 0.5; // of an inclination; smaller ones are rotations within the plane
  const auto       normal =
    itk::CrossProduct(itk::Vector<double, 3>(file.orientation), itk::Vector<double, 3>(file.orientation + 3));
  const double degrees = DegreesPerRadian * std::acos(std::min(std::abs(AlongSeries(series, normal)[2]), 1.0));
  RefusePlanes(file,
               degrees < leastDegrees ? "rows and columns of its frames have other directions"
                                      : "its frames are inclined to them by " + NumberText(degrees, 3) + " degrees");
}

void
RequireSpacing(const DicomSegmentationFile & file, const DicomSeries & series, const std::array<FrameAxis, 2> & axes)
{
  const unsigned int counts[] = { file.columns, file.rows };
  for (unsigned int i = 0; i < 2; ++i)
  {
    const double voxel = series.spacing[axes[i].axis];
    if (!(counts[i] * std::abs(voxel - file.spacing[i]) <= PlaceTolerance * voxel))
    {
      RefusePlanes(file,
                   "its pixels have " + Pair(file.spacing[0], file.spacing[1]) + " mm, those of the slices " +
                     Pair(series.spacing[axes[0].axis], series.spacing[axes[1].axis]) + " mm");
    }
  }
}

/** The slice whose plane is nearest to a point. */
std::size_t
NearestSlice(const DicomSeries & series, const itk::Point<double, 3> & point)
{
  const auto distance = [&](const DicomSlice & slice) {
    return std::abs(AlongSeries(series, point - slice.imagePosition)[2]);
  };
  const auto & slices = series.slices;
  return static_cast<std::size_t>(
    std::min_element(slices.begin(),
                     slices.end(),
                     [&](const DicomSlice & a, const DicomSlice & b) { return distance(a) < distance(b); }) -
    slices.begin());
}

/** The voxel of the first pixel of a slice in the grid of the source, which is larger for a tilted series. */
itk::Index<3>
FirstVoxelOf(const DicomSource & source, std::size_t slice)
{
  const auto first =
    source.grid->TransformPhysicalPointToContinuousIndex<double>(source.series.slices[slice].imagePosition);
  return { { std::max(0L, std::lround(first[0])), std::max(0L, std::lround(first[1])), static_cast<long>(slice) } };
}

/** Finds the places of frames in a series. */
class FrameLocator
{
public:
  FrameLocator(const DicomSegmentationFile & file, const DicomSource & source)
    : m_Source(source)
    , m_Axes(AxesOfFrames(file, source.series))
    , m_Normal(3 - m_Axes[0].axis - m_Axes[1].axis)
    , m_Last{ static_cast<long>(file.columns) - 1, static_cast<long>(file.rows) - 1 }
  {
    RequireSpacing(file, source.series, m_Axes);
    const auto & slices = source.series.slices;
    if (m_Normal != 2 && std::any_of(slices.begin(), slices.end(), [](const DicomSlice & slice) {
          return slice.offset[0] != 0.0 || slice.offset[1] != 0.0;
        }))
    {
      RefusePlanes(file, "its frames cross the slices of a tilted series");
    }
  }

  /** Sets the place. Returns what prevents it, or an empty text. */
  const char *
  Find(const DicomSegmentFrame & frame, DicomFramePlace & place) const
  {
    const DicomSeries & series = m_Source.series;
    const bool          isInSlice = m_Normal == 2;
    const std::size_t   slice = isInSlice ? NearestSlice(series, frame.position) : 0;
    const auto          step = AlongSeries(series, frame.position - series.slices[slice].imagePosition);
    itk::Offset<3>      voxels{};
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double count = step[axis] / series.spacing[axis];
      voxels[axis] = isInSlice && axis == 2 ? 0 : std::lround(count);
      if (!(std::abs(count - static_cast<double>(voxels[axis])) <= PlaceTolerance))
      {
        return isInSlice ? "lie at no slice" : "lie between the voxels";
      }
    }
    place = { FirstVoxelOf(m_Source, slice) + voxels, {}, {} };
    place.alongRow[m_Axes[0].axis] = m_Axes[0].sign;
    place.alongColumn[m_Axes[1].axis] = m_Axes[1].sign;
    voxels[2] += static_cast<long>(slice);
    return this->IsInside(voxels) ? "" : "extend beyond the slices";
  }

  /** The axis across the frames. */
  unsigned int
  Normal() const
  {
    return m_Normal;
  }

private:
  /** Whether a frame whose first pixel has this place in the slices is inside them. */
  bool
  IsInside(const itk::Offset<3> & first) const
  {
    itk::Offset<3> last = first;
    for (int i = 0; i < 2; ++i)
    {
      last[m_Axes[i].axis] += m_Axes[i].sign * m_Last[i];
    }
    const DicomSeries & series = m_Source.series;
    const long          sizes[] = { static_cast<long>(series.size[0]),
                                    static_cast<long>(series.size[1]),
                                    static_cast<long>(series.slices.size()) };
    return std::equal(sizes, sizes + 3, first.begin(), [](long size, long i) { return i >= 0 && i < size; }) &&
           std::equal(sizes, sizes + 3, last.begin(), [](long size, long i) { return i >= 0 && i < size; });
  }

  const DicomSource &      m_Source;
  std::array<FrameAxis, 2> m_Axes;
  unsigned int             m_Normal;
  long                     m_Last[2]; ///< column and row
};
} // namespace

std::vector<DicomFramePlace>
PlacesOfFrames(const DicomSegmentationFile & file, const DicomSource & source)
{
  const FrameLocator                 locator(file, source);
  std::vector<DicomFramePlace>       places(file.frames.size());
  std::set<std::pair<int, long>>     taken;
  std::vector<itk::Point<double, 3>> outside;
  std::string                        fault;
  for (std::size_t i = 0; i < file.frames.size(); ++i)
  {
    const DicomSegmentFrame & frame = file.frames[i];
    const std::string         found = locator.Find(frame, places[i]);
    if (!found.empty())
    {
      fault = outside.empty() ? found : fault;
      outside.push_back(frame.position);
    }
    else if (!taken.insert({ frame.segment, places[i].first[locator.Normal()] }).second)
    {
      throw InputError('"' + file.path + "\" has two frames of segment " + std::to_string(frame.segment) +
                       " in one plane; write it again");
    }
  }
  if (!outside.empty())
  {
    RefusePlanes(file,
                 std::to_string(outside.size()) + " of its " + std::to_string(places.size()) + " frames " + fault +
                   ", the first at (" + NumberText(outside[0][0]) + ", " + NumberText(outside[0][1]) + ", " +
                   NumberText(outside[0][2]) + ") mm LPS");
  }
  return places;
}
} // namespace shapeton
