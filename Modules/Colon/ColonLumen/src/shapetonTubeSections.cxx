#include "shapetonTubeSections.h"

#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace shapeton
{
namespace
{
constexpr double RayStep = 0.2; // mm

/** Where between two samples the value passes the boundary of gas. */
double
Passed(double before, double after, double boundary)
{
  return std::clamp((boundary - before) / (after - before), 0.0, 1.0);
}

/** The end of the gas at `start`; 0 where it does not end within `reach`, or there is none. */
double
EndOfGas(const CatheterRegion &  region,
         const Eigen::Vector3d & from,
         const Eigen::Vector3d & direction,
         double                  start,
         double                  reach)
{
  const double boundary = region.thresholds.gasBoundary;
  double       before = region.ValueAt(from + start * direction);
  for (double r = start + RayStep; before < boundary && r <= reach; r += RayStep)
  {
    const double value = region.ValueAt(from + r * direction);
    if (value >= boundary)
    {
      return r - RayStep + RayStep * Passed(before, value, boundary);
    }
    before = value;
  }
  return 0.0;
}

/** What the gas is that a ray enters; the voxel at the entry itself may still be one of the wall. */
BehindLayer
KindOfGas(const CatheterRegion & region, const Eigen::Vector3d & entry, const Eigen::Vector3d & direction)
{
  switch (region.ClassAt(entry + region.grid.spacing.maxCoeff() * direction))
  {
    case ColonGas:
    case ColonFluid:
    case PocketGas:
      return BehindLayer::Gas;
    case OtherGas:
      return BehindLayer::Outside;
    default:
      return BehindLayer::Tissue; // a speck
  }
}

/** Follows a layer from its inner end. */
void
CrossLayer(const CatheterRegion &  region,
           const Eigen::Vector3d & from,
           const Eigen::Vector3d & direction,
           TubeRay &               ray)
{
  const double boundary = region.thresholds.gasBoundary;
  double       before = boundary;
  ray.wallHU = boundary;
  for (double r = ray.inner + RayStep; r <= ray.inner + ThickestTubeWall; r += RayStep)
  {
    const Eigen::Vector3d place = from + r * direction;
    const double          value = region.ValueAt(place);
    const bool            isGas = value < boundary;
    if (isGas || region.ClassAt(place) == ColonFluid)
    {
      ray.behind = isGas ? KindOfGas(region, place, direction) : BehindLayer::Fluid;
      ray.outer = r - RayStep * (isGas ? 1.0 - Passed(before, value, boundary) : 1.0);
      return;
    }
    ray.wallHU = std::max(ray.wallHU, value);
    before = value;
  }
}

TubeSection
MeasureSection(const CatheterRegion & region, const Eigen::Vector3d & centre, const Eigen::Vector3d & along)
{
  TubeSection section;
  section.centre = centre;
  section.along = along;
  section.across[0] = along.unitOrthogonal();
  section.across[1] = along.cross(section.across[0]);
  for (int n = 0; n < TubeSection::NumberOfRays; ++n)
  {
    section.rays[n] = FirstLayer(region, centre, section.DirectionOf(n), 0.0, LargestBoreRadius + 1.0);
  }
  return section;
}
} // namespace

TubeRay
FirstLayer(const CatheterRegion &  region,
           const Eigen::Vector3d & from,
           const Eigen::Vector3d & direction,
           double                  start,
           double                  reach)
{
  TubeRay ray;
  ray.inner = EndOfGas(region, from, direction, start, reach);
  if (ray.inner > 0.0)
  {
    CrossLayer(region, from, direction, ray);
  }
  return ray;
}

double
MedianOf(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double
CatheterRegion::ValueAt(const Eigen::Vector3d & position) const
{
  const Eigen::Vector3d voxel = grid.VoxelOf(position);
  std::array<int, 3>    low;
  std::array<double, 3> part;
  for (int a = 0; a < 3; ++a)
  {
    const double x = std::clamp(voxel[a], 0.0, grid.size[a] - 1.0);
    low[a] = std::min(static_cast<int>(x), grid.size[a] - 2);
    part[a] = x - low[a];
  }
  const auto p = grid.Index(low[0], low[1], low[2]);
  double     sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double      weight = 1.0;
    std::size_t q = p;
    for (int a = 0; a < 3; ++a)
    {
      const bool isUpper = (corner >> a) & 1;
      weight *= isUpper ? part[a] : 1.0 - part[a];
      q += isUpper ? grid.stride[a] : 0;
    }
    sum += weight * hu[q];
  }
  return sum;
}

unsigned char
CatheterRegion::ClassAt(const Eigen::Vector3d & position) const
{
  const Eigen::Vector3d voxel = grid.VoxelOf(position);
  const int             i = static_cast<int>(std::lround(voxel[0]));
  const int             j = static_cast<int>(std::lround(voxel[1]));
  const int             k = static_cast<int>(std::lround(voxel[2]));
  return grid.Holds(i, j, k) ? classes[grid.Index(i, j, k)] : static_cast<unsigned char>(Nothing);
}

bool
TubeRay::IsEnclosed() const
{
  return (behind == BehindLayer::Gas && outer - inner >= ThinnestTubeWall) ||
         (behind == BehindLayer::Fluid && outer - inner >= ThinnestWallInFluid);
}

Eigen::Vector3d
TubeSection::DirectionOf(int ray) const
{
  const double angle = TwoPi * ray / NumberOfRays;
  return std::cos(angle) * across[0] + std::sin(angle) * across[1];
}

int
TubeSection::RayTo(const Eigen::Vector3d & position, double & distance) const
{
  const Eigen::Vector3d d = position - centre;
  const double          x = d.dot(across[0]);
  const double          y = d.dot(across[1]);
  distance = std::hypot(x, y);
  const int ray = static_cast<int>(std::lround(std::atan2(y, x) / TwoPi * NumberOfRays));
  return (ray + NumberOfRays) % NumberOfRays;
}

double
TubeSection::ClosedShare() const
{
  const auto number = std::count_if(rays.begin(), rays.end(), [](const TubeRay & r) { return r.inner > 0.0; });
  return static_cast<double>(number) / NumberOfRays;
}

double
TubeSection::ShareOf(BehindLayer behind) const
{
  const auto number =
    std::count_if(rays.begin(), rays.end(), [=](const TubeRay & r) { return r.inner > 0.0 && r.behind == behind; });
  return static_cast<double>(number) / NumberOfRays;
}

double
TubeSection::EnclosedShare() const
{
  const auto number = std::count_if(rays.begin(), rays.end(), [](const TubeRay & r) { return r.IsEnclosed(); });
  return static_cast<double>(number) / NumberOfRays;
}

double
TubeSection::BoreRadius() const
{
  std::vector<double> radii;
  for (const auto & ray : rays)
  {
    if (ray.inner > 0.0)
    {
      radii.push_back(ray.inner);
    }
  }
  return MedianOf(std::move(radii));
}

double
TubeSection::Ovality() const
{
  const double median = this->BoreRadius();
  double       mean = 0.0;
  double       squares = 0.0;
  for (const auto & ray : rays)
  {
    mean += (ray.inner > 0.0 ? ray.inner : median) / NumberOfRays;
  }
  for (const int harmonic : { 2, 3 })
  {
    std::complex<double> sum;
    for (int n = 0; n < NumberOfRays; ++n)
    {
      const double radius = rays[n].inner > 0.0 ? rays[n].inner : median;
      sum += std::polar(radius, TwoPi * harmonic * n / NumberOfRays);
    }
    squares += 2.0 * std::norm(sum / static_cast<double>(NumberOfRays));
  }
  return mean > 0.0 ? std::sqrt(squares) / mean : 0.0;
}

std::vector<TubeSection>
MeasureSections(const CatheterRegion & region, const BoreAxis & axis)
{
  std::vector<TubeSection> sections(axis.size());
  ParallelFor(axis.size(), [&](std::size_t n) {
    const auto before = n > 0 ? n - 1 : 0;
    const auto after = std::min(n + 1, axis.size() - 1);
    sections[n] = MeasureSection(region, axis[n], (axis[after] - axis[before]).normalized());
  });
  return sections;
}
} // namespace shapeton
