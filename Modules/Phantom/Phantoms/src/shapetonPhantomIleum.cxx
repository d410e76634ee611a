#include "shapetonPhantomIleum.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonRefluxedIleum.h"
#include "shapetonTubeForest.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double thinWall = 1.5;      // mm
constexpr double behindWall = 3.0;    // mm, start of the widening of the slit
constexpr double widening = 10.0;     // mm, length of the widening
constexpr double tightestBend = 11.0; // mm, radius
constexpr double closed = -0.3;       // mm, half width of a slit without a lumen
constexpr int    mostWays = 60;       // tried; chosen
constexpr double spineRadius = 30.0;  // mm
constexpr double halfSpace = 150.0;   // mm from the middle of the abdomen along the body
constexpr double noTurn = 1e-6;       // sine of an angle too small to turn
constexpr double turnShare = 0.3;     // of the angle to the desired direction, in a step
constexpr double openShare = 0.8;     // of the valves between equal contents

constexpr DrawnRange fluidOfIleum{ 250.0, 750.0 }; // HU
constexpr DrawnRange slitOfIleum{ 1.0, 3.0 };      // mm
constexpr DrawnRange slitOfReflux{ 2.0, 4.0 };     // mm

// Fluid in an ileum filled with gas.
constexpr double wetShare = 0.15;     // of the axis
constexpr double dryBelowMouth = 8.0; // mm

// A tube with a slot-shaped cross-section: all points within `radius` of a line segment of length 2 * `half` mm along
// `wide`.
struct SlotSection
{
  Vector3d middle;
  Vector3d wide; ///< unit vector perpendicular to the axis
  double   half;
  double   radius; ///< empty if negative
};

double
DistanceToSlot(const SlotSection & a, const SlotSection & b, const Vector3d & p)
{
  const Vector3d along = b.middle - a.middle;
  const double   t = std::clamp((p - a.middle).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const Vector3d off = p - (a.middle + t * along);
  const Vector3d wide = (1.0 - t) * a.wide + t * b.wide;
  const double   half = (1.0 - t) * a.half + t * b.half;
  const double   beside = off.dot(wide);
  return (off - std::clamp(beside, -half, half) * wide).norm() - ((1.0 - t) * a.radius + t * b.radius);
}

PhantomSolid
SlotTubeSolid(const std::vector<SlotSection> & sections)
{
  Vector3d low = sections[0].middle;
  Vector3d high = low;
  double   widest = 0.0;
  for (const SlotSection & section : sections)
  {
    low = low.cwiseMin(section.middle);
    high = high.cwiseMax(section.middle);
    widest = std::max(widest, section.half + section.radius);
  }
  const Vector3d center = 0.5 * (low + high);
  const double   reach = 0.5 * (high - low).norm() + widest;
  // Where the slit widens to the tube, radius and half width change by up to 0.8 per mm.
  constexpr double slope = 2.0;
  return { [=](const PhantomBody::PointType & point) {
            const Vector3d p(point[0], point[1], point[2]);
            const double   outside = (p - center).norm() - reach;
            if (outside > ColonAnatomy::Reach)
            {
              return outside;
            }
            double least = 1e9;
            for (std::size_t i = 1; i < sections.size(); ++i)
            {
              least = std::min(least, DistanceToSlot(sections[i - 1], sections[i], p));
            }
            return least;
          },
           slope };
}

// Grows the axis toward a point in the center of the abdomen, avoiding colon, spine and body wall.
class IleumPath
{
public:
  IleumPath(const ColonAnatomy & anatomy, const ColonValve & valve, double length, double radius)
    : m_Anatomy(anatomy), m_Cavity(AbdominalCavity()), m_Valve(valve), m_Length(length), m_Radius(radius)
  {
    m_Straight = valve.direction.dot(valve.mouth - valve.base) + behindWall + 2.0;
  }

  std::vector<Vector3d>
  Grow(const Vector3d & towards) const
  {
    Vector3d              at = m_Valve.mouth + ileumIntoColon * m_Valve.direction;
    Vector3d              heading = -m_Valve.direction;
    std::vector<Vector3d> axis{ at };
    while (!this->IsLongEnough(axis))
    {
      const double from = ileumAxisStep * static_cast<double>(axis.size()) - ileumIntoColon;
      if (from > m_Straight)
      {
        heading = this->Turn(at, heading, towards);
      }
      at += ileumAxisStep * heading;
      if (from > m_Straight + widening && this->Lacking(at) > 0.0)
      {
        break;
      }
      axis.push_back(at);
    }
    return axis;
  }

  bool
  IsLongEnough(const std::vector<Vector3d> & axis) const
  {
    return ileumAxisStep * static_cast<double>(axis.size() - 1) >= m_Length + ileumIntoColon;
  }

private:
  // Amount (mm) by which the tube is too close to colon, body wall and spine; negative if the distance is sufficient.
  double
  Lacking(const Vector3d & at) const
  {
    const double margin = m_Radius + thinWall;
    return std::max(m_Anatomy.Evaluate(at).distance + m_Radius + 1.0, LackingBetweenWallAndSpine(m_Cavity, at, margin));
  }

  Vector3d
  Turn(const Vector3d & at, const Vector3d & heading, const Vector3d & towards) const
  {
    const double near = std::clamp((this->Lacking(at) + 5.0) / 5.0, 0.0, 1.0);
    Vector3d     away = Vector3d::Zero();
    for (int axis = 0; near > 0.0 && axis < 3; ++axis)
    {
      const Vector3d step = 0.5 * Vector3d::Unit(axis);
      away[axis] = this->Lacking(at - step) - this->Lacking(at + step);
    }
    const Vector3d wish = (towards + 1.5 * near * away).normalized();
    const double   angle = std::acos(std::clamp(wish.dot(heading), -1.0, 1.0));
    const Vector3d turn = heading.cross(wish);
    if (turn.norm() < noTurn)
    {
      return heading;
    }
    return Eigen::AngleAxisd(std::min(turnShare * angle, ileumAxisStep / tightestBend), turn.normalized()) * heading;
  }

  const ColonAnatomy & m_Anatomy;
  PhantomSolid         m_Cavity;
  ColonValve           m_Valve;
  double               m_Length;
  double               m_Radius;
  double               m_Straight;
};

// The longest of several attempts, or the first with the requested length.
std::vector<Vector3d>
MakeAxis(const ColonAnatomy & anatomy, const ColonValve & valve, ColonRandom & random)
{
  const auto &          parameters = anatomy.GetParameters();
  const IleumPath       path(anatomy, valve, parameters.ileumLength, 0.5 * parameters.ileumBore);
  std::vector<Vector3d> best;
  for (int i = 0; i < mostWays; ++i)
  {
    // Toward the center, or in any direction if that is blocked.
    const double   wide = static_cast<double>(i) / mostWays;
    const Vector3d medial(1.0, random.Uniform(-0.9, 0.3), random.Uniform(-1.1, 0.3));
    const Vector3d any(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    const auto     axis = path.Grow(((1.0 - wide) * medial + 2.0 * wide * any).normalized());
    if (axis.size() > best.size())
    {
      best = axis;
    }
    if (path.IsLongEnough(best))
    {
      break;
    }
  }
  return best;
}

// Cross-sections from the slit between the lips to the round or collapsed tube.
std::vector<SlotSection>
MakeSections(const PhantomIleum & ileum, const ColonValve & valve, const SmoothNoise & noise, bool outer)
{
  const double             slit = 0.3 * valve.length;
  const double             through = valve.direction.dot(valve.mouth - valve.base) + behindWall;
  const bool               isCollapsed = ileum.content == "collapsed";
  const double             mucosa = outer ? thinWall : 0.0;
  std::vector<SlotSection> sections;
  Vector3d                 wide = valve.slit;
  for (std::size_t i = 0; i < ileum.axis.size(); ++i)
  {
    const std::size_t last = std::min(i + 1, ileum.axis.size() - 1);
    const Vector3d    along = (ileum.axis[last] - ileum.axis[last - 1]).normalized();
    wide = (wide - wide.dot(along) * along).normalized();
    const double s = ileumAxisStep * static_cast<double>(i) - ileumIntoColon;
    const double share = SmoothStep(through, through + widening, s);
    const double bore = 0.5 * ileum.bore * (1.0 + 0.12 * noise(s + ileumIntoColon));
    const double half = slit + share * ((isCollapsed ? 0.5 * bore : 0.0) - slit);
    const double narrow = ileum.isOpen ? 0.5 * ileum.slitWidth : closed;
    const double radius = isCollapsed ? (outer ? mucosa + share : closed) : narrow + share * (bore - narrow) + mucosa;
    sections.push_back({ ileum.axis[i], wide, half, radius });
  }
  return sections;
}

PhantomSolid
FirstSections(const std::vector<SlotSection> & sections, double length)
{
  const auto count = static_cast<std::ptrdiff_t>(std::ceil((length + ileumIntoColon) / ileumAxisStep)) + 1;
  return SlotTubeSolid({ sections.begin(), sections.begin() + count });
}

// Slots over the first `slots` mm, then a round tube.
PhantomSolid
LongTubeSolid(const std::vector<SlotSection> & sections, double slots)
{
  std::vector<TaperedTube> tubes;
  for (auto i = static_cast<std::size_t>((slots + ileumIntoColon) / ileumAxisStep); i + 1 < sections.size(); ++i)
  {
    const Vector3d & a = sections[i].middle;
    const Vector3d & b = sections[i + 1].middle;
    tubes.push_back(
      { MakePoint(a[0], a[1], a[2]), MakePoint(b[0], b[1], b[2]), sections[i].radius, sections[i + 1].radius });
  }
  return Either(FirstSections(sections, slots), ForestSolid(tubes, ColonAnatomy::Reach + 1.0));
}

// The height above which the ileum contains gas: the fluid level of the colon if the mouth is submerged, otherwise a
// low height.
double
FluidLevel(const std::vector<Vector3d> & axis, const ColonFluid & fluid, double depthOfMouth)
{
  std::vector<double> heights;
  for (const Vector3d & point : axis)
  {
    heights.push_back(-fluid.Down().dot(point));
  }
  const double mouth = heights[0];
  const auto   low = heights.begin() + static_cast<std::ptrdiff_t>(wetShare * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), low, heights.end());
  return depthOfMouth > 0.0 ? mouth + depthOfMouth : std::min(*low, mouth - dryBelowMouth);
}

// Gas of the colon fills the ileum through the open valve.
void
FillByReflux(PhantomIleum & ileum, const ColonAnatomy & anatomy, const ColonFluid & fluid, const SmoothNoise & noise)
{
  const ColonValve valve = anatomy.Valve();
  ileum.axis = RefluxedIleumAxis(anatomy);
  const double through = valve.direction.dot(valve.mouth - valve.base) + behindWall;
  const auto   sections = MakeSections(ileum, valve, noise, false);
  ileum.lumen = Either(FirstSections(sections, through),
                       AwayFromColon(LongTubeSolid(sections, through + widening), anatomy, bowelWall));
  const PhantomSolid outer = LongTubeSolid(MakeSections(ileum, valve, noise, true), through + widening);
  ileum.wall = AwayFromColon(outer, anatomy, 0.0);
  const double depth = fluid.DepthBelowLevel(valve.mouth, valve.arcLength);
  const auto   down = MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]);
  ileum.fluid = Both(ileum.lumen, HalfSpaceSolid(-down, FluidLevel(ileum.axis, fluid, depth)));
}

double
LengthOfIleum(const std::vector<Vector3d> & axis)
{
  double length = -ileumIntoColon;
  for (std::size_t i = 1; i < axis.size(); ++i)
  {
    length += (axis[i] - axis[i - 1]).norm();
  }
  return length;
}
} // namespace

double
LackingBetweenWallAndSpine(const PhantomSolid & cavity, const Vector3d & at, double margin)
{
  return std::max({ cavity.distance(MakePoint(at[0], at[1], at[2])) + margin,
                    spineRadius + margin - (at - ColonAnatomy::SpineAxis(at[2])).norm(),
                    std::abs(at[2]) - halfSpace });
}

PhantomIleum
MakePhantomIleum(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  const auto &      parameters = anatomy.GetParameters();
  const ColonValve  valve = anatomy.Valve();
  ColonRandom       patient(parameters.seed, ColonStream::Ileum);
  ColonRandom       random(parameters.seed, ColonStream::Ileum, PositionNumber(parameters.position));
  const SmoothNoise noise(patient, 160.0, 18.0);
  PhantomIleum      ileum;
  ileum.content = parameters.ileumContent;
  ileum.bore = parameters.ileumBore;
  ileum.intensity = ileum.content == "gas" ? gasIntensity : patient.Uniform(fluidOfIleum);
  if (parameters.ileumReflux == "gas")
  {
    ileum.isOpen = true;
    ileum.slitWidth = random.Uniform(slitOfReflux);
    ileum.fluidIntensity = patient.Uniform(fluidOfIleum);
    FillByReflux(ileum, anatomy, fluid, noise);
    ileum.length = LengthOfIleum(ileum.axis);
    return ileum;
  }
  // Closes the mouth if contents differ, since they would mix.
  const bool   isWet = fluid.DepthBelowLevel(valve.mouth, valve.arcLength) > 0.0;
  const bool   isSame = ileum.content == (isWet ? "fluid" : "gas");
  const double width = random.Uniform(slitOfIleum);
  ileum.isOpen = random.Uniform() < openShare && isSame;
  ileum.slitWidth = ileum.isOpen ? width : 0.0;
  ileum.axis = MakeAxis(anatomy, valve, random);
  ileum.length = ileumAxisStep * static_cast<double>(ileum.axis.size() - 1) - ileumIntoColon;
  ileum.lumen = SlotTubeSolid(MakeSections(ileum, valve, noise, false));
  const PhantomSolid outer = SlotTubeSolid(MakeSections(ileum, valve, noise, true));
  ileum.wall = AwayFromColon(outer, anatomy, 0.0);
  return ileum;
}
} // namespace shapeton
