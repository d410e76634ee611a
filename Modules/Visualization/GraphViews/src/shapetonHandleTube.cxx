#include "shapetonHandleTube.h"

#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
/** Maximum radius of a tube: absolute, and relative to the angle between its ends. */
constexpr double thickest = 0.06;
constexpr double thickestOfAngle = 0.15;
/** Number of heights to try for a tube, and their spacing relative to the lowest one. */
constexpr int    levels = 12;
constexpr double distanceOfLevels = 0.3;
constexpr int    mostHalvings = 12;
constexpr int    chimneySections = 5;
constexpr int    bendSections = 40;

double
AngleBetween(const Eigen::Vector3d & p, const Eigen::Vector3d & q)
{
  return std::atan2(p.cross(q).norm(), p.dot(q));
}

/** Normal of the plane of both axes; arbitrary if they are collinear. */
Eigen::Vector3d
NormalOf(const Eigen::Vector3d & p, const Eigen::Vector3d & q)
{
  const Eigen::Vector3d normal = p.cross(q);
  return normal.norm() > 1e-9 ? normal.normalized() : p.unitOrthogonal();
}

/** Height where a chimney ends. Its profile is a parabola above the sphere's tangent at the rim; a bend of this radius
 * at that height stays outside the sphere. */
double
HeightOfChimney(const SphereHole & hole, double radius)
{
  constexpr double aboveSphere = 1.5; // tube radii
  constexpr double steepness = 2.5;   // relative to the tangent; the parabola requires 2
  const double     rim = std::sin(hole.angle);
  const double     low = std::cos(hole.angle);
  return std::max(1.0 + aboveSphere * radius, low + steepness * std::max(0.0, rim - radius) * rim / low);
}

/** Sections in upward order, excluding the lowest one; `along` is the tube direction. */
std::vector<TubeSection>
Chimney(const SphereHole & hole, double radius, const Eigen::Vector3d & normal, const Eigen::Vector3d & along)
{
  const double             rim = std::sin(hole.angle);
  const double             low = std::cos(hole.angle);
  const double             high = HeightOfChimney(hole, radius);
  std::vector<TubeSection> sections;
  for (int i = 0; i <= chimneySections; ++i)
  {
    const double u = static_cast<double>(i) / chimneySections;
    sections.push_back({ (low + u * (high - low)) * hole.center,
                         normal,
                         along.cross(normal),
                         radius + (rim - radius) * (1.0 - u) * (1.0 - u) });
  }
  return sections;
}

/** Clearance between two tubes, whose sections are treated as balls; negative if they intersect. */
double
Clearance(const std::vector<TubeSection> & one, const std::vector<TubeSection> & other)
{
  double least = 1e300;
  for (const TubeSection & a : one)
  {
    for (const TubeSection & b : other)
    {
      least = std::min(least, (a.center - b.center).norm() - a.radius - b.radius);
    }
  }
  return least;
}

/** The lowest tube between two holes that keeps a clearance of one tube radius to the others. */
bool
PlaceTube(HandleTube & tube, std::vector<std::vector<TubeSection>> & placed)
{
  const double angle = AngleBetween(tube.start.center, tube.end.center);
  const double least = std::min(0.5 * angle, 0.6);
  for (int level = 0; level < levels; ++level)
  {
    tube.lift = least * (1.0 + distanceOfLevels * level);
    const std::vector<TubeSection> sections = tube.Sections();
    if (std::all_of(
          placed.begin(), placed.end(), [&](const auto & other) { return Clearance(sections, other) > tube.radius; }))
    {
      placed.push_back(sections);
      return true;
    }
  }
  return false;
}
} // namespace

std::vector<TubeSection>
HandleTube::Sections() const
{
  const Eigen::Vector3d    p = start.center;
  const Eigen::Vector3d    q = end.center;
  const Eigen::Vector3d    normal = NormalOf(p, q);
  const Eigen::Vector3d    side = normal.cross(p);
  const double             angle = AngleBetween(p, q);
  const double             low = HeightOfChimney(start, radius);
  const double             rise = HeightOfChimney(end, radius) - low;
  std::vector<TubeSection> sections = Chimney(start, radius, normal, p);
  for (int i = 1; i < bendSections; ++i)
  {
    const double t = static_cast<double>(i) / bendSections;
    // Zero angular velocity at both ends: the tube leaves the chimneys along their axes.
    const double          smooth = t * t * (3.0 - 2.0 * t);
    const double          slope = 6.0 * t * (1.0 - t);
    const double          height = low + rise * smooth + 4.0 * lift * t * (1.0 - t);
    const double          heightSlope = rise * slope + 4.0 * lift * (1.0 - 2.0 * t);
    const Eigen::Vector3d up = std::cos(angle * smooth) * p + std::sin(angle * smooth) * side;
    const Eigen::Vector3d ahead = std::cos(angle * smooth) * side - std::sin(angle * smooth) * p;
    const Eigen::Vector3d along = (heightSlope * up + height * angle * slope * ahead).normalized();
    sections.push_back({ height * up, normal, along.cross(normal), radius });
  }
  std::vector<TubeSection> down = Chimney(end, radius, normal, -q);
  sections.insert(sections.end(), down.rbegin(), down.rend());
  return sections;
}

std::vector<HandleTube>
PlaceTubes(const std::vector<std::array<SphereHole, 2>> & pairs)
{
  std::vector<HandleTube> tubes;
  for (const auto & [start, end] : pairs)
  {
    tubes.push_back({ start, end, std::min(thickest, thickestOfAngle * AngleBetween(start.center, end.center)), 0.0 });
  }
  // Short tubes pass below long ones.
  std::vector<int> order(tubes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return tubes[a].start.center.dot(tubes[a].end.center) > tubes[b].start.center.dot(tubes[b].end.center);
  });
  for (int halving = 0; halving < mostHalvings; ++halving)
  {
    std::vector<std::vector<TubeSection>> placed;
    if (std::all_of(order.begin(), order.end(), [&](int i) { return PlaceTube(tubes[i], placed); }))
    {
      return tubes;
    }
    for (HandleTube & tube : tubes)
    {
      tube.radius *= 0.5;
    }
  }
  throw InputError(
    "the " + std::to_string(tubes.size()) +
    " handles of the surface are too crowded for tubes in space; omit the parameter \"surface\" and view the tiles "
    "of the Poincare disk with the parameter \"svg\" or the parameter \"report\"");
}
} // namespace shapeton
