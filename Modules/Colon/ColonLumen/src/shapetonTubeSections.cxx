#include "shapetonTubeSections.h"

#include "shapetonGaussianWeights.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace shapeton
{
namespace
{
constexpr double RayStep = 0.2;                          // mm; chosen finer than a voxel
constexpr int    CentringTurns = 2;                      // the second uses the direction from the first
constexpr double CentringSmooth = 2.0;                   // sections, standard deviation
constexpr double LeastClosedRays = 0.9;                  // minimum fraction of the rays for locating the center
constexpr double LargestReach = LargestBoreRadius + 1.0; // mm, of rays within a bore

/** Interpolated position of the gas boundary between two samples, 0 to 1. */
double
Passed(double before, double after, double boundary)
{
  return std::clamp((boundary - before) / (after - before), 0.0, 1.0);
}

/** End of the gas along a ray from `start`; 0 if `start` is not in gas or the gas does not end within `reach`. */
double
EndOfGas(const CatheterRegion & region, const OutwardRay & ray, double start, double reach)
{
  double before = region.ValueAt(ray.from + start * ray.direction);
  for (double r = start + RayStep; before < ray.boundary && r <= reach; r += RayStep)
  {
    const double value = region.ValueAt(ray.from + r * ray.direction);
    if (value >= ray.boundary)
    {
      return r - RayStep + RayStep * Passed(before, value, ray.boundary);
    }
    before = value;
  }
  return 0.0;
}

/** Kind of the gas behind a layer; the voxel at the entry may still be wall. */
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

/** Sections without ray results. */
std::vector<TubeSection>
SectionsAcross(const BoreAxis & axis)
{
  std::vector<TubeSection> sections(axis.size());
  for (std::size_t n = 0; n < axis.size(); ++n)
  {
    const auto    before = n > 0 ? n - 1 : 0;
    const auto    after = std::min(n + 1, axis.size() - 1);
    TubeSection & section = sections[n];
    section.center = axis[n];
    section.along = (axis[after] - axis[before]).normalized();
    section.across[0] = section.along.unitOrthogonal();
    section.across[1] = section.along.cross(section.across[0]);
  }
  return sections;
}

/** Offset from a point in a bore to its center: the first harmonic of the radius over the angle, exact for a circle.
 * Empty where the bore is open. */
std::optional<Eigen::Vector3d>
ToMiddle(const CatheterRegion & region, const TubeSection & section)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d directions = Eigen::Vector3d::Zero(); // sum over the rays that end at the wall
  double          radii = 0.0;
  int             closed = 0;
  for (int n = 0; n < TubeSection::NumberOfRays; ++n)
  {
    const OutwardRay ray = section.RayAlong(n, region.thresholds.gasBoundary);
    const double     radius = EndOfGas(region, ray, 0.0, LargestReach);
    if (radius > 0.0)
    {
      sum += radius * ray.direction;
      directions += ray.direction;
      radii += radius;
      ++closed;
    }
  }
  if (closed < LeastClosedRays * TubeSection::NumberOfRays)
  {
    return std::nullopt;
  }
  // Open rays are assigned the mean radius; the directions of all rays sum to zero.
  return Eigen::Vector3d(2.0 / TubeSection::NumberOfRays * (sum - radii / closed * directions));
}

/** The shift of the nearest section with a known center, preferring earlier ones; zero if there is none. */
Eigen::Vector3d
NearestShift(const std::vector<std::optional<Eigen::Vector3d>> & shifts, std::ptrdiff_t n)
{
  const auto number = static_cast<std::ptrdiff_t>(shifts.size());
  for (std::ptrdiff_t apart = 0; apart < number; ++apart)
  {
    for (const std::ptrdiff_t m : { n - apart, n + apart })
    {
      if (m >= 0 && m < number && shifts[m])
      {
        return *shifts[m];
      }
    }
  }
  return Eigen::Vector3d::Zero();
}

/** Centers an axis in its bore by smooth shifts; open sections use adjacent shifts. */
void
MoveToMiddle(const CatheterRegion & region, BoreAxis & axis)
{
  const std::vector<TubeSection>              sections = SectionsAcross(axis);
  std::vector<std::optional<Eigen::Vector3d>> known(axis.size());
  std::vector<Eigen::Vector3d>                shifts(axis.size());
  ParallelFor(axis.size(), [&](std::size_t n) { known[n] = ToMiddle(region, sections[n]); });
  ParallelFor(axis.size(), [&](std::size_t n) { shifts[n] = NearestShift(known, static_cast<std::ptrdiff_t>(n)); });
  const std::vector<double> weights = GaussianWeights(CentringSmooth, 3.0);
  const auto                reach = static_cast<std::ptrdiff_t>(weights.size() / 2);
  const auto                number = static_cast<std::ptrdiff_t>(axis.size());
  for (std::ptrdiff_t n = 0; n < number; ++n)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double          weight = 0.0;
    for (std::ptrdiff_t m = std::max<std::ptrdiff_t>(0, n - reach); m < std::min(number, n + reach + 1); ++m)
    {
      sum += weights[m - n + reach] * shifts[m];
      weight += weights[m - n + reach];
    }
    axis[n] += sum / weight;
  }
}
} // namespace

TubeRay
FirstLayer(const CatheterRegion & region, const OutwardRay & ray, double start, double reach)
{
  const double inner = EndOfGas(region, ray, start, reach);
  return inner > 0.0 ? CrossLayer(region, ray, inner, inner + ThickestTubeWall) : TubeRay{};
}

TubeRay
CrossLayer(const CatheterRegion & region, const OutwardRay & ray, double inner, double reach)
{
  double  before = ray.boundary;
  TubeRay layer;
  layer.inner = inner;
  layer.wallHU = ray.boundary;
  for (double r = inner + RayStep; r <= reach; r += RayStep)
  {
    const Eigen::Vector3d place = ray.from + r * ray.direction;
    const double          value = region.ValueAt(place);
    const bool            isGas = value < ray.boundary;
    if (isGas || region.ClassAt(place) == ColonFluid)
    {
      layer.behind = isGas ? KindOfGas(region, place, ray.direction) : BehindLayer::Fluid;
      layer.outer = r - RayStep * (isGas ? 1.0 - Passed(before, value, ray.boundary) : 0.5);
      return layer;
    }
    layer.wallHU = std::max(layer.wallHU, value);
    before = value;
  }
  return layer;
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
TubeRay::IsLeft() const
{
  return behind == BehindLayer::Gas || behind == BehindLayer::Fluid;
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

OutwardRay
TubeSection::RayAlong(int ray, double boundary) const
{
  return { center, this->DirectionOf(ray), boundary };
}

int
TubeSection::RayTo(const Eigen::Vector3d & position, double & distance) const
{
  const Eigen::Vector3d d = position - center;
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
  return UpperMedian(std::move(radii));
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
MeasureSections(const CatheterRegion & region, BoreAxis axis)
{
  for (int turn = 0; turn < CentringTurns; ++turn)
  {
    MoveToMiddle(region, axis);
  }
  std::vector<TubeSection> sections = SectionsAcross(axis);
  ParallelFor(axis.size(), [&](std::size_t n) {
    TubeSection & section = sections[n];
    for (int ray = 0; ray < TubeSection::NumberOfRays; ++ray)
    {
      section.rays[ray] = FirstLayer(region, section.RayAlong(ray, region.thresholds.gasBoundary), 0.0, LargestReach);
    }
  });
  return sections;
}
} // namespace shapeton
