#include "shapetonCatheterTube.h"

#include "shapetonColonBody.h"
#include "shapetonColonNoise.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double outside = 40.0;     // mm below the anal verge
constexpr double canal = 32.0;       // mm, length of the tube that follows the centerline
constexpr double pointApart = 6.0;   // mm
constexpr double rubber = 100.0;     // HU, of a balloon
constexpr double balloonWall = 1.0;  // mm
constexpr double water = 8.0;        // HU
constexpr double sleeve = 1.2;       // mm, thickness of a deflated balloon around the tube
constexpr double leastBalloon = 3.0; // mm of gas or fluid around the tube
constexpr double clearance = 0.5;    // mm between tube or balloon and wall of the rectum
constexpr double pastBalloon = 4.0;  // mm, minimum length of the tube beyond the balloon
constexpr double holeRadius = 1.6;   // mm

/** Computes the axis of a tube through the rectum. */
class TubeCourse
{
public:
  TubeCourse(const ColonAnatomy & anatomy, const Vector3d & down, double radius)
    : m_Anatomy(anatomy), m_Down(down), m_Radius(radius), m_Line(anatomy.Centerline())
  {
    m_ArcLength = PointValues(m_Line, "arcLength", "the centerline of the phantom");
  }

  /** Follows the centerline. */
  std::vector<Vector3d>
  Middle(double depth) const
  {
    std::vector<Vector3d> axis{ this->Outside() };
    double                next = 0.0;
    for (const int vertex : m_Line.curves[0])
    {
      if (m_ArcLength[vertex] >= next && m_ArcLength[vertex] <= depth)
      {
        axis.push_back(m_Line.V.row(vertex));
        next = m_ArcLength[vertex] + pointApart;
      }
    }
    return axis;
  }

  /** Continues straight beyond the canal, up to the wall. */
  std::vector<Vector3d>
  Straight(double depth) const
  {
    std::vector<Vector3d> axis = this->Middle(canal);
    const Vector3d        heading = (axis.back() - axis[axis.size() - 3]).normalized();
    for (double s = canal; s < depth; s += pointApart)
    {
      const Vector3d next = axis.back() + std::min(pointApart, depth - s) * heading;
      if (m_Anatomy.Evaluate(next).distance < m_Radius + clearance)
      {
        break;
      }
      axis.push_back(next);
    }
    return axis;
  }

  /** Rests on the wall beyond `free` mm, with limited bending. */
  std::vector<Vector3d>
  Sinking(double depth, double free) const
  {
    constexpr double      steepest = 0.35 * pointApart;
    std::vector<Vector3d> axis = this->Middle(depth);
    std::vector<Vector3d> sides(axis.size(), Vector3d::Zero());
    std::vector<double>   offsets(axis.size(), 0.0);
    for (std::size_t i = 1; i + 1 < axis.size(); ++i)
    {
      const Vector3d along = (axis[i + 1] - axis[i]).normalized();
      sides[i] = (m_Down - m_Down.dot(along) * along).normalized();
      const bool isFree = pointApart * static_cast<double>(i) > free;
      offsets[i] = isFree ? std::min(offsets[i - 1] + steepest, this->RoomAlong(axis[i], sides[i])) : 0.0;
    }
    axis.pop_back();
    for (std::size_t i = axis.size() - 1; i-- > 1;)
    {
      offsets[i] = std::min(offsets[i], offsets[i + 1] + steepest);
    }
    for (std::size_t i = 0; i < axis.size(); ++i)
    {
      axis[i] += offsets[i] * sides[i];
    }
    return axis;
  }

private:
  Vector3d
  Outside() const
  {
    Vector3d verge;
    Vector3d inwards;
    m_Anatomy.AnalVerge(verge, inwards);
    return verge - outside * inwards;
  }

  double
  RoomAlong(const Vector3d & from, const Vector3d & direction) const
  {
    constexpr double enough = 40.0; // mm; more room is not measured
    double           room = 0.0;
    while (room < enough && m_Anatomy.Evaluate(from + room * direction).distance > m_Radius + clearance)
    {
      room += 0.5;
    }
    return room;
  }

  const ColonAnatomy & m_Anatomy;
  Vector3d             m_Down;
  double               m_Radius;
  CurveSet             m_Line;
  Eigen::VectorXd      m_ArcLength;
};

/** Uniform directions on a golden-angle spiral. */
std::vector<Vector3d>
EvenDirections(int number)
{
  std::vector<Vector3d> directions;
  for (int n = 0; n < number; ++n)
  {
    const double z = 1.0 - (2.0 * n + 1.0) / number;
    const double angle = Pi * (3.0 - std::sqrt(5.0)) * n;
    const double across = std::sqrt(1.0 - z * z);
    directions.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return directions;
}

/** Radius of the largest ball around a point that fits into the rectum, at most `largest`. */
double
RoomAround(const ColonAnatomy & anatomy, const Vector3d & center, double largest)
{
  constexpr double step = 0.5;
  constexpr double apart = 0.5 * ColonAnatomy::Reach; // between the test points on the surface of the ball
  static const std::vector<Vector3d> directions = EvenDirections(400);
  const double                       distance = anatomy.Evaluate(center).distance;
  double                             room = distance - clearance;
  const auto                         isFree = [&](double radius) {
    return std::all_of(directions.begin(), directions.end(), [&](const Vector3d & direction) {
      return anatomy.Evaluate(center + (radius - apart) * direction).distance >= apart + clearance;
    });
  };
  while (distance == ColonAnatomy::Reach && room < largest && isFree(room + step))
  {
    room += step;
  }
  return std::min(room, largest);
}

PhantomSolid
BallSolid(const Vector3d & center, double radius)
{
  return EllipsoidSolid(MakePoint(center[0], center[1], center[2]), MakeVector(radius, radius, radius));
}

/** Adds the parts of a catheter in painting order. */
class CatheterBuilder
{
public:
  CatheterBuilder(const ColonAnatomy & anatomy, const ColonFluid & fluid, CatheterTube & catheter)
    : m_Anatomy(anatomy), m_Fluid(fluid), m_Catheter(catheter)
  {}

  // Just inside the canal, with the requested diameter or less if limited by rectum and tip; deflated if too narrow.
  void
  AddBalloon(double wanted)
  {
    ColonCatheter & truth = m_Catheter.truth;
    double          best = 0.0;
    for (std::size_t i = 6; i + 3 < m_Catheter.axis.size(); ++i)
    {
      const double toTip = (m_Catheter.axis[i] - truth.tip).norm();
      const double radius = RoomAround(m_Anatomy, m_Catheter.axis[i], std::min(0.5 * wanted, toTip - pastBalloon));
      if (radius > best)
      {
        best = radius;
        truth.balloonCenter = m_Catheter.axis[i];
      }
    }
    if (truth.balloon == "deflated" || best < 0.5 * truth.bore + truth.wall + leastBalloon)
    {
      this->AddSleeve();
      return;
    }
    truth.balloonDiameter = 2.0 * best;
    m_BalloonReach = best;
    this->Add(ColonStructure::Balloon, BallSolid(truth.balloonCenter, best), rubber);
    this->Add(ColonStructure::Balloon,
              BallSolid(truth.balloonCenter, best - balloonWall),
              truth.balloon == "gas" ? gasIntensity : water);
  }

  void
  AddTube()
  {
    ColonCatheter &                truth = m_Catheter.truth;
    const double                   outer = 0.5 * truth.bore + truth.wall;
    const std::vector<std::size_t> holes = this->PlacesOfHoles();
    truth.sideHoles = static_cast<int>(holes.size());
    this->Add(ColonStructure::Catheter, TubeSolid(ToPoints(m_Catheter.axis), outer), truth.intensity);
    std::vector<Vector3d> bore = m_Catheter.axis;
    if (truth.kind != "central" && truth.sideHoles == 0)
    {
      bore.push_back(bore.back() + (outer + 1.0) * (bore.back() - bore[bore.size() - 2]).normalized());
    }
    this->Add(ColonStructure::None, TubeSolid(ToPoints(bore), 0.5 * truth.bore), gasIntensity);
    for (const std::size_t place : holes)
    {
      this->AddHole(place, outer);
    }
  }

private:
  // Every 6 mm from the tip up to the balloon, which must not have a hole.
  std::vector<std::size_t>
  PlacesOfHoles() const
  {
    const ColonCatheter &    truth = m_Catheter.truth;
    const auto &             axis = m_Catheter.axis;
    std::vector<std::size_t> places;
    for (int hole = 0; hole < truth.sideHoles; ++hole)
    {
      const std::size_t place = axis.size() - 2 - hole;
      if (truth.balloon == "none" || (axis[place] - truth.balloonCenter).norm() > m_BalloonReach + holeRadius)
      {
        places.push_back(place);
      }
    }
    return places;
  }

  void
  AddSleeve()
  {
    ColonCatheter & truth = m_Catheter.truth;
    const double    radius = 0.5 * truth.bore + truth.wall + sleeve;
    const auto      first = m_Catheter.axis.begin() + std::min<std::ptrdiff_t>(7, m_Catheter.axis.size() - 4);
    const std::vector<Vector3d> part(first, first + 4);
    truth.balloon = "deflated";
    truth.balloonCenter = 0.5 * (part.front() + part.back());
    truth.balloonDiameter = 2.0 * radius;
    m_BalloonReach = 0.5 * (part.back() - part.front()).norm() + radius;
    this->Add(ColonStructure::Balloon, TubeSolid(ToPoints(part), radius), rubber);
  }

  void
  Add(ColonStructure label, const PhantomSolid & solid, double intensity)
  {
    m_Catheter.parts.push_back({ label, solid, MakeSolidBody(solid, intensity), false });
  }

  // Holes alternate between four sides and are filled like the lumen outside.
  void
  AddHole(std::size_t place, double outer)
  {
    const auto &   axis = m_Catheter.axis;
    const auto     hole = static_cast<double>(axis.size() - 2 - place);
    const Vector3d at = axis[place];
    const Vector3d along = (axis[place + 1] - at).normalized();
    const Vector3d side = Eigen::AngleAxisd(0.5 * Pi * hole, along) * along.unitOrthogonal();
    const Vector3d end = at + (outer + 0.5) * side;
    const auto     sample = m_Anatomy.Evaluate(end);
    const bool     isWet = m_Fluid.DepthBelowLevel(end, sample.arcLength) > 0.0;
    this->Add(ColonStructure::None,
              CapsuleSolid(MakePoint(at[0], at[1], at[2]), MakePoint(end[0], end[1], end[2]), holeRadius),
              isWet ? m_Fluid.Intensity(end, sample.arcLength) : gasIntensity);
  }

  const ColonAnatomy & m_Anatomy;
  const ColonFluid &   m_Fluid;
  CatheterTube &       m_Catheter;
  double               m_BalloonReach{ 0.0 }; ///< mm along the tube from the center of the balloon
};
} // namespace

CatheterTube
MakeCatheterTube(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  const ColonPhantomParameters & p = anatomy.GetParameters();
  CatheterTube                   catheter;
  ColonCatheter &                truth = catheter.truth;
  truth.kind = p.catheter;
  truth.bore = p.catheterBore;
  truth.wall = p.catheterWall;
  truth.intensity = p.catheterIntensity;
  truth.sideHoles = p.catheterHoles;
  truth.balloon = p.balloon;
  const TubeCourse course(anatomy, fluid.Down(), 0.5 * truth.bore + truth.wall);
  const double     held = truth.balloon == "none" ? canal : canal + 40.0;
  catheter.axis = truth.kind == "rigid"  ? course.Straight(p.catheterDepth)
                  : truth.kind == "soft" ? course.Sinking(p.catheterDepth, held)
                                         : course.Middle(p.catheterDepth);
  truth.tip = catheter.axis.back();
  CatheterBuilder builder(anatomy, fluid, catheter);
  if (truth.balloon != "none")
  {
    builder.AddBalloon(p.balloonDiameter);
  }
  builder.AddTube();
  return catheter;
}
} // namespace shapeton
