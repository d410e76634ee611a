#include "shapetonPi.h"
#include "shapetonQuantiles.h"
#include "shapetonValveBulges.h"

#include "shapetonPrincipalAxes.h"
#include "shapetonSmoothedField.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Standard deviation (mm) of the smoothing, which removes structures thinner than 4 mm, such as folds. */
constexpr double smoothing = 3.0;
/** Minimum of the smaller principal curvature of a bulge, 1/mm. */
constexpr double leastCurvature = 0.01;
/** Minimum solid angle (sr), to exclude ripples. */
constexpr double leastSolidAngle = 0.3;

/** A voxel on the surface, with its surface element. */
struct SurfaceVoxel
{
  std::size_t     voxel;
  Eigen::Vector3d point;
  Eigen::Vector3d inward; // normal into the lumen
  double          area;
  double          lesser;
  double          greater;
};

/** Central differences of a field, in units of voxels. */
class FieldShape
{
public:
  FieldShape(const VoxelGrid & grid, const std::vector<float> & field) : m_Grid(grid), m_Field(field) {}

  Eigen::Vector3d
  Gradient(std::size_t voxel) const
  {
    Eigen::Vector3d gradient;
    for (int a = 0; a < 3; ++a)
    {
      gradient[a] = 0.5 * (m_Field[voxel + m_Grid.stride[a]] - m_Field[voxel - m_Grid.stride[a]]);
    }
    return gradient;
  }

  Eigen::Matrix3d
  Hessian(std::size_t voxel) const
  {
    Eigen::Matrix3d hessian;
    for (int a = 0; a < 3; ++a)
    {
      const std::size_t s = m_Grid.stride[a];
      hessian(a, a) = m_Field[voxel + s] - 2.0 * m_Field[voxel] + m_Field[voxel - s];
      for (int b = 0; b < a; ++b)
      {
        const std::size_t t = m_Grid.stride[b];
        hessian(a, b) = hessian(b, a) =
          0.25 * (m_Field[voxel + s + t] - m_Field[voxel + s - t] - m_Field[voxel - s + t] + m_Field[voxel - s - t]);
      }
    }
    return hessian;
  }

private:
  const VoxelGrid &          m_Grid;
  const std::vector<float> & m_Field;
};

/** Computes the surface element of the 0.5 level in a voxel; returns false if the level is at least 1.5 voxels away. */
bool
MeasureSurface(const CecalRegion & region, const FieldShape & shape, double value, SurfaceVoxel & one)
{
  constexpr double      reach = 1.5; // voxels; support of the bump function that distributes the surface over voxels
  const Eigen::Vector3d gradient = shape.Gradient(one.voxel);
  const double          steepness = gradient.norm();
  const double          distance = (value - 0.5) / std::max(steepness, 1e-6);
  if (std::abs(distance) >= reach)
  {
    return false;
  }
  one.inward = gradient / steepness;
  const Eigen::Vector3d       right = one.inward.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << right, one.inward.cross(right);
  // The field decreases from lumen to tissue, so it increases outward over a ball of tissue.
  const Eigen::Matrix2d curvature = tangents.transpose() * shape.Hessian(one.voxel) * tangents / steepness;
  const Eigen::Vector2d curvatures = PrincipalAxes(curvature).values;
  one.lesser = curvatures[0] / CecalRegion::Step;
  one.greater = curvatures[1] / CecalRegion::Step;
  one.area = CecalRegion::Step * CecalRegion::Step * (1.0 + std::cos(Pi * distance / reach)) / (2.0 * reach);
  one.point = region.PointOf(one.voxel) - CecalRegion::Step * distance * one.inward;
  return true;
}

std::vector<SurfaceVoxel>
BulgingSurface(const CecalRegion & region)
{
  constexpr float           margin = 0.05F; // of the smoothed lumen fraction; voxels beyond are not near the surface
  const VoxelGrid &         grid = region.Grid();
  const std::vector<float>  field = SmoothedField(grid, region.Lumen(), smoothing / CecalRegion::Step);
  const FieldShape          shape(grid, field);
  std::vector<SurfaceVoxel> surface;
  for (std::size_t voxel = 0; voxel < field.size(); ++voxel)
  {
    if (region.BeforeEnd(voxel) > CecalRegion::Reach || field[voxel] < margin || field[voxel] > 1.0F - margin)
    {
      continue;
    }
    const auto   v = grid.Voxel(voxel);
    SurfaceVoxel one{ voxel, {}, {}, 0.0, 0.0, 0.0 };
    if (grid.Holds(v[0] - 1, v[1] - 1, v[2] - 1) && grid.Holds(v[0] + 1, v[1] + 1, v[2] + 1) &&
        MeasureSurface(region, shape, field[voxel], one) && one.lesser > leastCurvature)
    {
      surface.push_back(one);
    }
  }
  return surface;
}

/** 26-connected components, each with ascending indices. */
std::vector<std::vector<SurfaceVoxel>>
ConnectedParts(const VoxelGrid & grid, const std::vector<SurfaceVoxel> & surface)
{
  std::vector<int> numberAt(grid.NumberOfVoxels(), -1);
  for (std::size_t i = 0; i < surface.size(); ++i)
  {
    numberAt[surface[i].voxel] = static_cast<int>(i);
  }
  std::vector<std::vector<SurfaceVoxel>> parts;
  for (const SurfaceVoxel & seed : surface)
  {
    if (numberAt[seed.voxel] < 0)
    {
      continue;
    }
    std::vector<SurfaceVoxel> part{ seed };
    numberAt[seed.voxel] = -1;
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      for (int neighbor = 0; neighbor < 27; ++neighbor)
      {
        const std::size_t voxel =
          part[next].voxel + grid.Offset(neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
        if (numberAt[voxel] >= 0)
        {
          part.push_back(surface[numberAt[voxel]]);
          numberAt[voxel] = -1;
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

void
MeasureWidths(const std::vector<SurfaceVoxel> & part, ValveBulge & bulge)
{
  constexpr int         directions = 36; // chosen: one per 5 degrees
  const Eigen::Vector3d right = bulge.axis.unitOrthogonal();
  const Eigen::Vector3d up = bulge.axis.cross(right);
  bulge.width = std::numeric_limits<double>::infinity();
  for (int i = 0; i < directions; ++i)
  {
    const double          angle = Pi * i / directions;
    const Eigen::Vector3d direction = std::cos(angle) * right + std::sin(angle) * up;
    double                low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SurfaceVoxel & one : part)
    {
      low = std::min(low, one.point.dot(direction));
      high = std::max(high, one.point.dot(direction));
    }
    bulge.length = std::max(bulge.length, high - low);
    bulge.width = std::min(bulge.width, high - low);
  }
}

/** Median intensity below the surface, away from the lumen. */
double
AttenuationOf(const CecalRegion & region, const std::vector<SurfaceVoxel> & part, const ValveBulge & bulge)
{
  constexpr double   fromLumen = 2.0; // mm; chosen: beyond partial volume
  const double       deepest = std::max(fromLumen, 0.5 * bulge.width);
  std::vector<float> values;
  for (const SurfaceVoxel & one : part)
  {
    for (double depth = fromLumen; depth <= deepest; depth += CecalRegion::Step)
    {
      const std::ptrdiff_t voxel = region.VoxelAt(one.point - depth * bulge.axis);
      if (voxel >= 0 && region.FromLumen(voxel) >= fromLumen)
      {
        values.push_back(region.Hounsfield(voxel));
      }
    }
  }
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : UpperMedian(std::move(values));
}

ValveBulge
BulgeOf(const CecalRegion & region, const std::vector<SurfaceVoxel> & part)
{
  ValveBulge      bulge;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  for (const SurfaceVoxel & one : part)
  {
    bulge.area += one.area;
    bulge.solidAngle += one.area * one.lesser * one.greater;
    bulge.place += one.area * one.point;
    bulge.beforeEnd += one.area * region.BeforeEnd(one.voxel);
    axis += one.area * one.inward;
  }
  bulge.place /= bulge.area;
  bulge.beforeEnd /= bulge.area;
  bulge.axis = axis.normalized();
  MeasureWidths(part, bulge);
  bulge.attenuation = region.HasIntensities() ? AttenuationOf(region, part, bulge) : bulge.attenuation;
  return bulge;
}
} // namespace

std::vector<ValveBulge>
FindValveBulges(const CecalRegion & region)
{
  std::vector<ValveBulge> bulges;
  for (const std::vector<SurfaceVoxel> & part : ConnectedParts(region.Grid(), BulgingSurface(region)))
  {
    ValveBulge bulge = BulgeOf(region, part);
    if (bulge.solidAngle >= leastSolidAngle)
    {
      bulges.push_back(bulge);
    }
  }
  return bulges;
}
} // namespace shapeton
