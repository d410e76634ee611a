#include "shapetonFlatColonStrip.h"

#include "shapetonCsvTable.h"
#include "shapetonDeviceWallRays.h"
#include "shapetonExceptions.h"
#include "shapetonStripPainter.h"

#include "itkImage.h"

#include <Eigen/LU>

#include <memory>
#include <vector>

namespace shapeton
{
namespace
{
constexpr std::size_t raysInBatch = std::size_t{ 1 } << 18; ///< on a GPU

/** Color of tissue by its Hounsfield units: fat, soft tissue, contrast medium and bone. Linear red, green and blue,
 * starting at `darkest`. */
std::vector<float>
ColorsOfTissue(double darkest, double colorStep)
{
  struct Stop
  {
    double   hu;
    RGBColor color;
  };
  static const Stop  stops[] = { { -700.0, MakeColor(238, 176, 160) }, { -250.0, MakeColor(234, 160, 144) },
                                 { -100.0, MakeColor(236, 170, 150) }, { 20.0, MakeColor(234, 164, 148) },
                                 { 120.0, MakeColor(222, 128, 116) },  { 250.0, MakeColor(240, 236, 214) },
                                 { 600.0, MakeColor(255, 255, 246) } };
  constexpr int      last = sizeof(stops) / sizeof(stops[0]) - 1;
  std::vector<float> colors;
  for (int i = 0; i < WallLook::numberOfColors; ++i)
  {
    const double hu = darkest + i * colorStep;
    int          k = 0;
    while (k < last - 1 && stops[k + 1].hu < hu)
    {
      ++k;
    }
    const double      share = std::clamp((hu - stops[k].hu) / (stops[k + 1].hu - stops[k].hu), 0.0, 1.0);
    const LinearColor color = ToLinear(MixColors(stops[k].color, stops[k + 1].color, share));
    colors.insert(colors.end(), color.data(), color.data() + 3);
  }
  return colors;
}

/** Opacities of a ray segment of this length, from gas to tissue; the last one is repeated. */
std::vector<float>
OpacitiesOf(double extinction, double length)
{
  std::vector<float> opacities;
  for (int i = 0; i <= WallLook::numberOfOpacities; ++i)
  {
    const double share = std::min(1.0, i / (WallLook::numberOfOpacities - 1.0));
    const double smooth = share * share * (3.0 - 2.0 * share);
    opacities.push_back(static_cast<float>(1.0 - std::exp(-smooth * extinction * length)));
  }
  return opacities;
}

WallVolume
VolumeOf(const itk::Image<float, 3> * ct)
{
  const auto &    size = ct->GetLargestPossibleRegion().GetSize();
  const auto &    spacing = ct->GetSpacing();
  WallVolume      volume{};
  Eigen::Matrix3d axes; // columns: the step of each index in space
  volume.voxels = ct->GetBufferPointer();
  for (int k = 0; k < 3; ++k)
  {
    volume.size[k] = static_cast<int>(size[k]);
    volume.stride[k] = k == 0 ? 1 : volume.stride[k - 1] * volume.size[k - 1];
    for (int row = 0; row < 3; ++row)
    {
      axes(row, k) = ct->GetDirection()[row][k] * spacing[k];
    }
  }
  const Eigen::Matrix3d toIndex = axes.inverse();
  for (int k = 0; k < 3; ++k)
  {
    Eigen::Map<Eigen::RowVector3d>(volume.toIndex[k]) = toIndex.row(k);
    volume.indexPerMm[k] = toIndex.row(k).norm();
  }
  itk::Point<double, 3> first;
  ct->TransformIndexToPhysicalPoint(ct->GetLargestPossibleRegion().GetIndex(), first);
  std::copy(first.Begin(), first.End(), volume.first);
  volume.smallestSpacing = std::min({ spacing[0], spacing[1], spacing[2] });
  return volume;
}

/** Rays through the wall. */
class WallRays
{
public:
  WallRays(const itk::Image<float, 3> * ct, const FlatVolumeOptions & options) : m_Volume(VolumeOf(ct))
  {
    static const RGBColor nothing = MakeColor(64, 64, 70);
    constexpr double      stepInVoxels = 0.4;
    // On the boundary, the partial volume of gas and contrast medium looks like tissue; 1.5 voxels farther out it does
    // not.
    constexpr double voxelsBehind = 1.5;
    constexpr float  darkest = -900.0F; // HU
    constexpr float  colorStep = 4.0F;  // HU
    m_Look.gas = options.gas;
    m_Look.tissue = options.tissue;
    m_Look.step = stepInVoxels * m_Volume.smallestSpacing;
    m_Look.reach = std::max(options.depthOfLumen, options.depthOfWall) + 3.0 * m_Volume.smallestSpacing;
    m_Look.inside = static_cast<int>(std::ceil(options.depthOfLumen / m_Look.step));
    m_Look.outside = static_cast<int>(std::ceil(options.depthOfWall / m_Look.step));
    m_Look.stepsBehind = voxelsBehind / stepInVoxels;
    m_Opacities = OpacitiesOf(options.extinction, m_Look.step);
    m_Look.opacities = m_Opacities.data();
    m_Look.darkest = darkest;
    m_Look.colorStep = colorStep;
    m_Colors = ColorsOfTissue(m_Look.darkest, m_Look.colorStep);
    m_Look.colors = m_Colors.data();
    Eigen::Map<LinearColor>(m_Look.nothing) = ToLinear(nothing);
  }

  Picture::Pointer
  Paint(const FlatColonGrid & grid, const FlatColonAxis & axis) const
  {
    return PaintStrip(grid, [&](const FlatSample & sample, int column) {
      LinearColor color;
      WallRayArithmetic::ColorOfRay(m_Volume, m_Look, RayOf(sample, axis, column), color.data());
      return FromLinear(color);
    });
  }

  /** Renders as many rows at a time as fit into one batch of rays of the GPU. */
  Picture::Pointer
  PaintOnGpu(const FlatColonGrid & grid, const FlatColonAxis & axis) const
  {
    const auto make = reinterpret_cast<MakeDeviceWallRaysFunction *>(FindDeviceFunction("ShapetonMakeWallRays"));
    const std::unique_ptr<DeviceWallRays> device(make(m_Volume, m_Look));
    const auto                            picture = NewStrip(grid);
    const int                             rowsAtATime = std::max(1, static_cast<int>(raysInBatch / grid.Columns()));
    for (int first = 0; first < grid.Rows(); first += rowsAtATime)
    {
      PaintRows(grid, axis, first, std::min(grid.Rows(), first + rowsAtATime), *device, picture);
    }
    return picture;
  }

private:
  static WallRay
  RayOf(const FlatSample & sample, const FlatColonAxis & axis, int column)
  {
    WallRay ray;
    Eigen::Map<Eigen::Vector3d>(ray.point) = sample.point;
    Eigen::Map<Eigen::Vector3d>(ray.normal) = sample.inwardNormal;
    ray.axes = AxesOf(FrameAt(axis, column, sample.point));
    ray.isCovered = 1;
    return ray;
  }

  static void
  PaintRows(const FlatColonGrid & grid,
            const FlatColonAxis & axis,
            int                   first,
            int                   last,
            DeviceWallRays &      device,
            Picture *             picture)
  {
    const auto               columns = static_cast<std::size_t>(grid.Columns());
    const std::size_t        number = (last - first) * columns;
    std::vector<WallRay>     rays(number);
    std::vector<LinearColor> colors(number);
    ParallelForBlocks(number, [&](std::size_t i) {
      const int        column = static_cast<int>(i % columns);
      const FlatSample sample = grid.SampleOfPixel(column, first + static_cast<int>(i / columns));
      rays[i] = sample.face >= 0 ? RayOf(sample, axis, column) : WallRay{};
    });
    device.Cast(rays.data(), number, colors.front().data());
    RGBColor * const pixels = picture->GetBufferPointer() + first * columns;
    ParallelForBlocks(number,
                      [&](std::size_t i) { pixels[i] = rays[i].isCovered != 0 ? FromLinear(colors[i]) : pixels[i]; });
  }

  WallVolume         m_Volume;
  WallLook           m_Look{};
  std::vector<float> m_Opacities;
  std::vector<float> m_Colors;
};

void
RequireCover(const FlatColonGrid & grid, const itk::Image<float, 3> * ct)
{
  constexpr double greatestShare = 0.05;
  constexpr double voxelsBeyond = 1.5; // where the scan border cuts the colon, the wall is closed outside
  const WallVolume volume = VolumeOf(ct);
  const auto &     points = grid.Points();
  int              outside = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::Vector3d point = points.row(i);
    outside += !WallRayArithmetic::Holds(volume, WallRayArithmetic::IndexOf(volume, point.data()), voxelsBeyond);
  }
  const double share = static_cast<double>(outside) / points.rows();
  if (share > greatestShare)
  {
    throw InputError("the volume does not contain the surface: " + CsvTable::Rounded(100.0 * share, 3) +
                     " % of it is outside; use the CT from which the surface was computed");
  }
}
} // namespace

DeviceUse
ChooseFlatVolumeDevice(const itk::Image<float, 3> * ct, Device wanted)
{
  constexpr std::size_t tables = std::size_t{ 1 } << 20;
  return ChooseDevice(wanted,
                      ct->GetBufferedRegion().GetNumberOfPixels() * sizeof(float) +
                        raysInBatch * (sizeof(WallRay) + 3 * sizeof(float)) + tables);
}

Picture::Pointer
PaintFlatVolume(const FlatColonGrid &        grid,
                const FlatColonAxis &        axis,
                const itk::Image<float, 3> * ct,
                const FlatVolumeOptions &    options,
                const DeviceUse &            use)
{
  RequireParameter(options.gas < options.tissue, "the intensity of gas must be below that of tissue");
  RequireParameter(options.depthOfLumen >= 0.0 && options.depthOfWall > 0.0 && options.extinction > 0.0,
                   "depths and extinction of a volume picture must be positive");
  RequireCover(grid, ct);
  const WallRays rays(ct, options);
  return use.gpu ? rays.PaintOnGpu(grid, axis) : rays.Paint(grid, axis);
}
} // namespace shapeton
