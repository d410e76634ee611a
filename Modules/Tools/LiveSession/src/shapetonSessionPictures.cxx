#include "shapetonSessionPictures.h"

#include "shapetonColorMap.h"
#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonMappedImage.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonSessionCommands.h"
#include "shapetonVisitDensity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace shapeton
{
namespace
{
/** Number of voxels of the reduced volume that the page renders: 4 MB of bins, 10 times a second over a local
 * connection. */
constexpr std::size_t greatestReduced = std::size_t{ 1 } << 21;
/** Edge length of a brick in voxels of the reduced volume. */
constexpr std::size_t brickLength = 32;
/** The histogram and its lines require a pass over all voxels, so they are updated less often than the picture. */
constexpr std::chrono::seconds betweenHistograms{ 1 };

std::size_t
StrideFor(const std::array<std::size_t, 3> & size)
{
  std::size_t stride = 1;
  for (auto reduced = size; reduced[0] * reduced[1] * reduced[2] > greatestReduced;)
  {
    reduced = ReducedSize(size, ++stride);
  }
  return stride;
}

/** First and last voxel of the part to be drawn; by default all. */
DrawnBox
BoxOf(const Json & request)
{
  constexpr double end = 1e6; // more than a volume has voxels along an axis
  DrawnBox         box{ { { { 0.0, 0.0, 0.0 } }, { { end, end, end } } } };
  for (const auto & [key, corner] : { std::make_pair("first", &box[0]), std::make_pair("last", &box[1]) })
  {
    if (request.contains(key))
    {
      const auto point = PointOf(request, key);
      std::copy(point.Begin(), point.End(), corner->begin());
    }
  }
  return box;
}

/** The image with 0 outside a box of voxels of the volume; its voxels are blocks of factor^3 of them. */
itk::Image<float, 3>::Pointer
InBox(const itk::Image<float, 3>::Pointer & image, std::size_t factor, const DrawnBox & box)
{
  const auto                 size = image->GetLargestPossibleRegion().GetSize();
  std::array<std::size_t, 3> from{};
  std::array<std::size_t, 3> end{};
  bool                       isAll = true;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto blockOf = [&](double voxel) { return static_cast<std::size_t>(std::max(0.0, voxel)) / factor; };
    from[axis] = std::min<std::size_t>(blockOf(box[0][axis]), size[axis]);
    end[axis] = std::clamp<std::size_t>(blockOf(box[1][axis]) + 1, from[axis], size[axis]);
    isAll = isAll && from[axis] == 0 && end[axis] == size[axis];
  }
  if (isAll)
  {
    return image;
  }
  const auto cut = NewImageOn<itk::Image<float, 3>>(image, true);
  for (std::size_t row = 0; row < size[1] * size[2]; ++row)
  {
    const std::size_t y = row % size[1];
    const std::size_t z = row / size[1];
    if (y >= from[1] && y < end[1] && z >= from[2] && z < end[2])
    {
      const std::size_t first = row * size[0] + from[0];
      std::copy_n(image->GetBufferPointer() + first, end[0] - from[0], cut->GetBufferPointer() + first);
    }
  }
  return cut;
}

/** The values of a slice, in the order of the volume; `valueOf` returns that of a voxel. */
template <typename TValue, typename TFunction>
std::vector<TValue>
SliceOf(const std::array<std::size_t, 3> & size, unsigned int axis, std::size_t at, const TFunction & valueOf)
{
  const unsigned int         across = axis == 0 ? 1 : 0;
  const unsigned int         down = axis == 2 ? 1 : 2;
  std::vector<TValue>        values;
  std::array<std::size_t, 3> index{};
  index[axis] = at;
  values.reserve(size[across] * size[down]);
  for (index[down] = 0; index[down] < size[down]; ++index[down])
  {
    for (index[across] = 0; index[across] < size[across]; ++index[across])
    {
      values.push_back(valueOf((index[2] * size[1] + index[1]) * size[0] + index[0]));
    }
  }
  return values;
}

/** An image of blocks at the position of the image from which they were averaged. */
itk::Image<float, 3>::Pointer
ImageOfBlocks(const BlockValues & blocks, const itk::Image<float, 3> * original)
{
  using ImageType = itk::Image<float, 3>;
  auto                image = ImageType::New();
  ImageType::SizeType size;
  auto                spacing = original->GetSpacing();
  std::copy(blocks.size.begin(), blocks.size.end(), size.begin());
  itk::ContinuousIndex<double, 3> middle;
  middle.Fill((static_cast<double>(blocks.factor) - 1.0) / 2.0);
  ImageType::PointType origin;
  original->TransformContinuousIndexToPhysicalPoint(middle, origin);
  spacing *= static_cast<double>(blocks.factor);
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(original->GetDirection());
  image->Allocate();
  std::copy(blocks.values.begin(), blocks.values.end(), image->GetBufferPointer());
  return image;
}
} // namespace

ShownVolume
SessionScene::Values(const std::array<std::size_t, 3> & size) const
{
  return blocks ? ShownVolume(size, *blocks)
         : heat ? ShownVolume(size, heat->GetBufferPointer())
                : ShownVolume(size, visits->GetBufferPointer(), greatestVisits);
}

SessionPictures::SessionPictures(const ImageType * gray)
  : m_Gray(gray)
  , m_Size(VolumeView(gray).size)
  , m_Stride(StrideFor(m_Size))
  , m_Window(WindowOf(gray, IntensityWindow()))
{}

Json
SessionPictures::Info() const
{
  HeatExplorerContent content;
  content.title = "Shapeton session";
  content.gray = m_Gray;
  content.window = m_Window;
  Json info = InfoOf(content, std::numeric_limits<std::size_t>::max());
  info["stride"] = m_Stride;
  info["brickLength"] = brickLength;
  return info;
}

void
SessionPictures::AddParts(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame)
{
  this->AddSlices(scene, viewer, frame);
  if (viewer.version != scene.version)
  {
    this->AddBricks(scene, viewer, frame);
    this->AddHistogram(scene, viewer, frame);
  }
}

void
SessionPictures::AddWhole(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame) const
{
  if (viewer.version != scene.version)
  {
    frame.header["volume"] = this->Info()["volume"];
    const auto values = scene.Values(m_Size).Values();
    frame.Add(values.data(), values.size());
  }
}

void
SessionPictures::AddObjects(const SessionObjects & objects, SessionViewer & viewer, SessionFrame & frame) const
{
  if (objects.AreFound() && viewer.objects != objects.GetVersion())
  {
    frame.header["objects"] = objects.List();
    frame.Add(objects.GetList()->labels->GetBufferPointer(), m_Size[0] * m_Size[1] * m_Size[2]);
    viewer.objects = objects.GetVersion();
  }
}

void
SessionPictures::AddSlices(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame) const
{
  const ShownVolume values = scene.Values(m_Size);
  const bool        hasLabels = scene.labels != nullptr;
  frame.header["slices"] = Json::array();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::size_t at = std::min(viewer.place[axis], m_Size[axis] - 1);
    const HeatBins    bins = values.Slice(axis, at);
    const bool        isGrayNew = viewer.slices[axis] != static_cast<std::int64_t>(at);
    frame.header["slices"].push_back(
      { { "axis", axis }, { "index", at }, { "hasGray", isGrayNew }, { "hasLabels", hasLabels } });
    frame.Add(bins.data(), bins.size());
    if (isGrayNew)
    {
      const auto grays = this->GraySlice(axis, at);
      frame.Add(grays.data(), grays.size());
      viewer.slices[axis] = static_cast<std::int64_t>(at);
    }
    if (hasLabels)
    {
      const auto * const labels = scene.labels->GetBufferPointer();
      const auto         slice =
        SliceOf<std::uint16_t>(m_Size, axis, at, [labels](std::size_t voxel) { return labels[voxel]; });
      frame.Add(slice.data(), slice.size());
    }
  }
}

std::vector<std::uint8_t>
SessionPictures::GraySlice(unsigned int axis, std::size_t at) const
{
  constexpr double    white = 255.0;
  const float * const intensities = m_Gray->GetBufferPointer();
  return SliceOf<std::uint8_t>(m_Size, axis, at, [&](std::size_t voxel) {
    const double intensity = intensities[voxel];
    const double part = std::clamp((intensity - m_Window.lower) / (m_Window.upper - m_Window.lower), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(white * part));
  });
}

/** The bricks that have changed, with the checksums that the viewer has. */
void
SessionPictures::AddBricks(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame)
{
  if (m_ReducedVersion != scene.version)
  {
    m_Reduced = scene.Values(m_Size).Reduced(m_Stride);
    m_ReducedVersion = scene.version;
  }
  const HeatBins &           bins = m_Reduced;
  const auto                 grid = ReducedSize(m_Size, m_Stride);
  const auto                 bricks = ReducedSize(grid, brickLength);
  std::vector<std::uint16_t> brick;
  viewer.bricks.resize(bricks[0] * bricks[1] * bricks[2], 0);
  frame.header["bricks"] = Json::array();
  for (std::size_t b = 0; b < viewer.bricks.size(); ++b)
  {
    const std::array<std::size_t, 3> first{ b % bricks[0] * brickLength,
                                            b / bricks[0] % bricks[1] * brickLength,
                                            b / (bricks[0] * bricks[1]) * brickLength };
    const std::size_t                width = std::min(brickLength, grid[0] - first[0]);
    brick.clear();
    for (std::size_t z = first[2]; z < std::min(first[2] + brickLength, grid[2]); ++z)
    {
      for (std::size_t y = first[1]; y < std::min(first[1] + brickLength, grid[1]); ++y)
      {
        const std::uint16_t * const row = bins.data() + (z * grid[1] + y) * grid[0] + first[0];
        brick.insert(brick.end(), row, row + width);
      }
    }
    const std::string_view bytes(reinterpret_cast<const char *>(brick.data()), brick.size() * sizeof(brick[0]));
    const std::size_t      checksum = std::hash<std::string_view>()(bytes) | 1; // 0 stands for none
    if (checksum != viewer.bricks[b])
    {
      viewer.bricks[b] = checksum;
      frame.header["bricks"].push_back(first);
      frame.Add(brick.data(), brick.size());
    }
  }
}

void
SessionPictures::RenewHistogram(const SessionScene & scene)
{
  if (!m_IsHistogramOld)
  {
    return;
  }
  m_IsHistogramOld = false;
  m_HistogramTime = std::chrono::steady_clock::now();
  ++m_HistogramVersion;
  std::vector<HeatClass> classes;
  m_Histogram = HeatHistogram({ scene.step });
  if (!scene.blocks && !scene.heat)
  {
    AddVisitsToRow(scene.visits, 0, m_Histogram);
    classes = FindVisitClasses(m_Histogram, 0, scene.greatestVisits);
    m_Axis = BalanceClasses(m_Histogram, 0, classes);
  }
  else
  {
    const float * const values = scene.blocks ? scene.blocks->values.data() : scene.heat->GetBufferPointer();
    m_Histogram.AddToRow(0, values, scene.blocks ? scene.blocks->values.size() : m_Size[0] * m_Size[1] * m_Size[2]);
    classes = FindHeatClasses(m_Histogram, 0);
    m_Axis = m_Histogram;
  }
  m_Lines = JsonOf(ShapeTransferFunction::FromClasses(classes));
}

void
SessionPictures::AddHistogram(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame)
{
  this->RenewHistogram(scene);
  if (viewer.histogram != m_HistogramVersion)
  {
    viewer.histogram = m_HistogramVersion;
    frame.header["histogram"] = { { "step", m_Histogram.GetTimeSteps()[0] }, { "lines", m_Lines } };
    frame.Add(m_Histogram.GetRow(0), HeatHistogram::NumberOfBins);
    frame.Add(m_Axis.GetRow(0), HeatHistogram::NumberOfBins);
  }
}

std::string
SessionPictures::Draw(const SessionScene & scene, const Json & request, Device device)
{
  constexpr double least = 16.0, most = 2048.0; // pixels
  constexpr double farthest = 1e6, leastZoom = 0.1, mostZoom = 100.0;
  constexpr double half = 90.0, whole = 360.0; // degrees
  RequireKeys(request, { "azimuth", "elevation", "zoom", "width", "height", "quality", "lines", "first", "last" });
  VolumeRenderingOptions view;
  view.azimuth = std::remainder(NumberOf(request, "azimuth", -farthest, farthest), whole);
  view.elevation = NumberOf(request, "elevation", -half, half);
  view.zoom = NumberOf(request, "zoom", leastZoom, mostZoom);
  view.width = static_cast<unsigned int>(NumberOf(request, "width", least, most));
  view.height = static_cast<unsigned int>(NumberOf(request, "height", least, most));
  const int quality = static_cast<int>(CountOf(request, "quality", 1, 100));
  RequireParameter(request.contains("lines"), "the command lacks the key \"lines\"");
  const auto transferFunction = TransferFunctionOf(request["lines"], "the command");
  const auto box = BoxOf(request);
  if (!m_Renderer || m_RendererVersion != scene.version || m_RendererLines != transferFunction.ToText() ||
      m_RendererBox != box)
  {
    m_Renderer = std::make_unique<VolumeRenderer>(
      InBox(this->ImageOf(scene), scene.blocks ? scene.blocks->factor : 1, box), transferFunction, device);
    m_RendererBox = box;
    m_RendererVersion = scene.version;
    m_RendererLines = transferFunction.ToText();
  }
  const std::string jpeg = EncodeJpeg(m_Renderer->Render(view), quality);
  SessionFrame      frame;
  frame.header = { { "kind", "picture" }, { "bytes", jpeg.size() }, { "device", m_Renderer->GetDeviceUse().device } };
  frame.Add(jpeg.data(), jpeg.size());
  return frame.GetBytes();
}

SessionPictures::ImageType::Pointer
SessionPictures::ImageOf(const SessionScene & scene) const
{
  return scene.blocks ? ImageOfBlocks(*scene.blocks, m_Gray)
         : scene.heat ? ImageType::Pointer(scene.heat)
                      : NormalizeVisits(scene.visits);
}

void
SessionPictures::OutdateHistogram()
{
  m_IsHistogramOld = true;
}

void
SessionPictures::OutdateOldHistogram()
{
  m_IsHistogramOld = m_IsHistogramOld || std::chrono::steady_clock::now() - m_HistogramTime > betweenHistograms;
}
} // namespace shapeton
