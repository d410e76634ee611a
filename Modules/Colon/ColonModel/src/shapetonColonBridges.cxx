#include "shapetonColonBridges.h"

#include "shapetonOccupancySampling.h"
#include "shapetonPaddedVoxels.h"
#include "shapetonParallelFor.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <sstream>

namespace shapeton
{
namespace
{
using Axis = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

double
DistanceToAxis(const Eigen::Vector3d & p, const Axis & axis)
{
  const Eigen::Vector3d way = axis.second - axis.first;
  const double          square = way.squaredNorm();
  const double          share = square > 0.0 ? std::clamp((p - axis.first).dot(way) / square, 0.0, 1.0) : 0.0;
  return (p - axis.first - share * way).norm();
}

/** Ramp from 1 to 0 over `width`, with 0.5 at the wall of the tube. */
double
TubeOccupancy(double distance, double radius, double width)
{
  return std::clamp(0.5 + (radius - distance) / width, 0.0, 1.0);
}

/** Finds the axes of the tubes; warns where the curve is outside the lumen but no gap is marked. */
void
FindAxes(const OccupancyImage * occupancy, const CurveSet & centerline, BridgedOccupancy & result)
{
  const Eigen::VectorXd  gap = PointValues(centerline, "gap", "the centerline");
  const Eigen::VectorXd  arcLength = PointValues(centerline, "arcLength", "the centerline");
  const OccupancySampler sample(occupancy);
  for (const auto & curve : centerline.curves)
  {
    double leftAt = -1.0;
    double backAt = -1.0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    {
      const int             a = curve[i];
      const int             b = curve[i + 1];
      const Eigen::Vector3d pa = centerline.V.row(a);
      const Eigen::Vector3d pb = centerline.V.row(b);
      const bool            isGap = gap[a] != 0.0 || gap[b] != 0.0;
      const bool            isOutside = !isGap && std::min({ sample(pa), sample(pb), sample(0.5 * (pa + pb)) }) < 0.5;
      if (isGap || isOutside)
      {
        result.axes.emplace_back(pa, pb);
      }
      if (isOutside)
      {
        leftAt = leftAt < 0.0 ? arcLength[a] : leftAt;
        backAt = arcLength[b];
      }
      if (leftAt >= 0.0 && (!isOutside || i + 2 == curve.size()))
      {
        constexpr int      digits = 5; // significant; 0.1 mm of a colon of up to 10 m
        std::ostringstream text;
        text.precision(digits);
        text << "the centerline is outside the lumen from " << leftAt << " to " << backAt
             << " mm, where no gap is marked; it was bridged there";
        result.warnings.push_back(text.str());
        leftAt = -1.0;
      }
    }
  }
}

/** Pieces of the lumen that do not share voxel faces, as in the topology repair. */
class PiecesOfLumen
{
public:
  explicit PiecesOfLumen(const OccupancyImage * occupancy)
    : m_Geometry(occupancy), m_Voxels(occupancy->GetBufferedRegion())
  {
    const float * values = occupancy->GetBufferPointer();
    m_Voxels.ForEachVoxel(
      [&](std::int64_t padded, std::int64_t inner) { m_Voxels.flags[padded] = values[inner] >= 0.5F ? 1 : 0; });
    m_Pieces = FindComponents(m_Voxels, 1, true, VoxelContact::Face);
  }

  /** Piece at the voxel that contains a point; 0 outside the lumen. */
  int
  At(const Eigen::Vector3d & point) const
  {
    const Eigen::Vector3d index = m_Geometry.IndexOf(point);
    std::array<int, 3>    padded;
    for (int i = 0; i < 3; ++i)
    {
      padded[i] = static_cast<int>(std::lround(index[i])) + 1;
      if (padded[i] < 0 || padded[i] >= m_Voxels.grid.size[i])
      {
        return 0;
      }
    }
    const auto run = m_Pieces.runs.Find(padded[0], padded[1], padded[2]);
    return run < 0 ? 0 : m_Pieces.labels.ofRun[run];
  }

private:
  GridGeometry    m_Geometry;
  PaddedVoxels    m_Voxels;
  VoxelComponents m_Pieces;
};

/** Adds axes where the curve passes from one piece of the bridged lumen to another. The interpolated occupancy is at
 * least 0.5 there, but the voxels touch only at edges or corners. Returns whether any was found. */
bool
AddAxesBetweenPieces(const CurveSet & centerline, BridgedOccupancy & result)
{
  const PiecesOfLumen pieces(result.occupancy);
  const std::size_t   before = result.axes.size();
  for (const auto & curve : centerline.curves)
  {
    int         last = 0;
    std::size_t lastAt = 0;
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const int piece = pieces.At(centerline.V.row(curve[i]));
      for (std::size_t k = lastAt; last > 0 && piece > 0 && piece != last && k < i; ++k)
      {
        result.axes.emplace_back(centerline.V.row(curve[k]), centerline.V.row(curve[k + 1]));
      }
      last = piece > 0 ? piece : last;
      lastAt = piece > 0 ? i : lastAt;
    }
  }
  return result.axes.size() > before;
}

/** Copies a field to a grid that contains all tubes and a margin. */
OccupancyImage::Pointer
EnlargedCopy(const OccupancyImage * occupancy, const std::vector<Axis> & axes, double reach)
{
  const GridGeometry grid(occupancy);
  const auto         size = occupancy->GetBufferedRegion().GetSize();
  long               before[3] = { 0, 0, 0 };
  itk::Size<3>       larger = size;
  for (int i = 0; i < 3; ++i)
  {
    const long margin = std::lround(std::ceil(reach / grid.spacing[i])) + 1;
    long       high = static_cast<long>(size[i]) - 1;
    for (const Axis & axis : axes)
    {
      const double a = grid.IndexOf(axis.first)[i];
      const double b = grid.IndexOf(axis.second)[i];
      before[i] = std::max(before[i], margin - std::lround(std::floor(std::min(a, b))));
      high = std::max(high, margin + std::lround(std::ceil(std::max(a, b))));
    }
    larger[i] = static_cast<itk::SizeValueType>(before[i] + high + 1);
  }
  auto                  copy = OccupancyImage::New();
  const Eigen::Vector3d origin = grid.PointOf(
    Eigen::Vector3d(-static_cast<double>(before[0]), -static_cast<double>(before[1]), -static_cast<double>(before[2])));
  copy->SetSpacing(occupancy->GetSpacing());
  copy->SetDirection(occupancy->GetDirection());
  copy->SetOrigin(origin.data());
  copy->SetRegions(larger);
  copy->Allocate(true);
  const float * values = occupancy->GetBufferPointer();
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y, values += size[0])
    {
      std::copy(values,
                values + size[0],
                copy->GetBufferPointer() + ((z + before[2]) * larger[1] + y + before[1]) * larger[0] + before[0]);
    }
  }
  return copy;
}

/** Adds the tube around one axis to the field: the maximum of both. */
void
DrawTube(OccupancyImage * image, const GridGeometry & grid, const Axis & axis, double radius)
{
  const double width = grid.spacing.maxCoeff();
  const double reach = radius + width;
  const auto   size = image->GetBufferedRegion().GetSize();
  long         low[3];
  long         high[3];
  for (int i = 0; i < 3; ++i)
  {
    const double a = grid.IndexOf(axis.first)[i];
    const double b = grid.IndexOf(axis.second)[i];
    low[i] = std::max(0L, std::lround(std::floor(std::min(a, b) - reach / grid.spacing[i])));
    high[i] =
      std::min(static_cast<long>(size[i]) - 1, std::lround(std::ceil(std::max(a, b) + reach / grid.spacing[i])));
  }
  for (long z = low[2]; z <= high[2]; ++z)
  {
    for (long y = low[1]; y <= high[1]; ++y)
    {
      float * row = image->GetBufferPointer() + (static_cast<std::size_t>(z) * size[1] + y) * size[0];
      for (long x = low[0]; x <= high[0]; ++x)
      {
        const Eigen::Vector3d index(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
        const double          distance = DistanceToAxis(grid.PointOf(index), axis);
        row[x] = std::max(row[x], static_cast<float>(TubeOccupancy(distance, radius, width)));
      }
    }
  }
}
} // namespace

BridgedOccupancy
AddBridges(const OccupancyImage * occupancy, const CurveSet & centerline, double radius)
{
  RequireParameter(radius > 0.0 && std::isfinite(radius), "the radius of bridges must be greater than 0 mm");
  RequireSound(centerline, "the centerline");
  BridgedOccupancy result;
  result.radius = radius;
  FindAxes(occupancy, centerline, result);
  result.occupancy = DrawBridges(occupancy, result);
  if (AddAxesBetweenPieces(centerline, result))
  {
    result.occupancy = DrawBridges(occupancy, result);
  }
  return result;
}

OccupancyImage::ConstPointer
DrawBridges(const OccupancyImage * occupancy, const BridgedOccupancy & bridges)
{
  if (bridges.axes.empty())
  {
    return occupancy;
  }
  const double       width = GridGeometry(occupancy).spacing.maxCoeff();
  const auto         image = EnlargedCopy(occupancy, bridges.axes, bridges.radius + width);
  const GridGeometry grid(image);
  for (const Axis & axis : bridges.axes)
  {
    DrawTube(image, grid, axis, bridges.radius);
  }
  return image.GetPointer();
}

SurfaceArray
BridgedFaces(const SurfaceMesh & mesh, const BridgedOccupancy & bridges, const OccupancyImage * lumen)
{
  SurfaceArray array{ "bridged", SurfaceArray::ValueMatrix::Zero(mesh.NumberOfFaces(), 1), true };
  if (bridges.axes.empty())
  {
    return array;
  }
  const double        width = GridGeometry(lumen).spacing.maxCoeff();
  Eigen::AlignedBox3d box;
  for (const Axis & axis : bridges.axes)
  {
    box.extend(axis.first).extend(axis.second);
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(bridges.radius + width);
  box = Eigen::AlignedBox3d(box.min() - reach, box.max() + reach);
  const OccupancySampler sample(lumen);
  ParallelForBlocks(static_cast<std::size_t>(mesh.NumberOfFaces()), [&](std::size_t i) {
    const auto            f = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d center =
      (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3.0;
    if (!box.contains(center))
    {
      return;
    }
    double distance = std::numeric_limits<double>::infinity();
    for (const Axis & axis : bridges.axes)
    {
      distance = std::min(distance, DistanceToAxis(center, axis));
    }
    const double tube = TubeOccupancy(distance, bridges.radius, width);
    array.values(f, 0) = tube > 0.0 && tube > sample(center) ? 1.0 : 0.0;
  });
  return array;
}
} // namespace shapeton
