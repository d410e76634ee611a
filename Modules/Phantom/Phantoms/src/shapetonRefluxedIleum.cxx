#include "shapetonRefluxedIleum.h"

#include "shapetonColonCurve.h"
#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonColonPlan.h"
#include "shapetonColonRelaxation.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;
using Chain = std::vector<Vector3d>;

constexpr double     c_GrowthStep = 5.0;        // mm
constexpr int        c_NodeSteps = 2;           // growth steps between nodes of the chain in a position
constexpr int        c_HeldByValve = 2;         // nodes, straight behind the valve
constexpr double     c_BeyondRadius = 3.5;      // mm, radius of the tightest bend beyond that of the bore
constexpr double     c_LoopWall = 4.0;          // mm, both walls and fat between two loops
constexpr double     c_ColonWall = 5.0;         // mm, both walls and fat between ileum and colon
constexpr double     c_ColonBulge = 1.06;       // haustra relative to the mean radius, as in ColonRelaxation
constexpr double     c_BesideCecum = 45.0;      // mm of the ileum that the cecum does not push
constexpr int        c_CecumNodes = 4;          // nodes of the colon on each side of the valve
constexpr double     c_Tolerated = 2.0;         // mm of missing space that relaxation makes up for
constexpr double     c_ToleratedByCecum = 8.0;  // mm, where relaxation moves the ileum most
constexpr double     c_RoomBesideValve = 8.0;   // mm beside the bore, as in PositionedPath()
constexpr int        c_RoomRounds = 250;        // of relaxation
constexpr double     c_BodyHalfWidth = 140.0;   // mm, of the space at rest
constexpr double     c_BodyHalfDepth = 92.0;    // mm
constexpr double     c_LowestIleum = -118.0;    // mm
constexpr double     c_HighestIleum = 90.0;     // mm
constexpr double     c_FromSpine = 33.0;        // mm between the spine and the wall of the ileum
constexpr double     c_NewTarget = 30.0;        // mm from a target at which the next one is drawn
constexpr int        c_StepsToTarget = 40;      // at most
constexpr double     c_TargetWeight = 6.0;      // mm of missing space that outweigh the direction to the target
constexpr double     c_SmallestMargin = 3.0;    // mm of space that headings should leave
constexpr int        c_MostTrials = 24;         // ways at rest
constexpr int        c_MostRetreats = 60;       // from dead ends, in a way
constexpr int        c_Retreat = 24;            // growth steps
constexpr int        c_WidestTrial = 12;        // trial from which the ileum leaves the cecum in any direction
constexpr double     c_WidestAngle = 1.2;       // radians from the medial direction
constexpr int        c_Headings = 12;           // around the present heading, for each of two angles
constexpr int        c_MovesOfColon = 25;       // from rest to a position
constexpr int        c_RoundsOfMove = 8;        // of relaxation
constexpr int        c_LastRounds = 250;        // of relaxation
constexpr int        c_MostCandidates = 4;      // ways that are tried in supine and prone position
constexpr double     c_EnoughLength = 0.9;      // of the requested length
constexpr double     c_OfColonWall = 5.0;       // mm between the axis and the lumen of the colon, for wall and passage
constexpr double     c_BetweenLumens = 2.0;     // mm between two loops
constexpr double     c_ShortenedByBends = 0.15; // of the length at rest, measured for lengths from c_ManyBends
constexpr double     c_ManyBends = 400.0;       // mm
constexpr DrawnRange c_TargetX{ -90.0, 90.0 };  // mm, the region of the small bowel
constexpr DrawnRange c_TargetY{ -80.0, 20.0 };  // mm
constexpr DrawnRange c_TargetZ{ -100.0, 60.0 }; // mm

/** The ileum of a patient, grown step by step next to the colon at rest. */
class IleumAtRest
{
public:
  IleumAtRest(const Chain & colon, const std::vector<double> & colonRadius, int cecum, double radius)
    : m_Colon(colon), m_ColonRadius(colonRadius), m_Cecum(cecum), m_Radius(radius)
  {}

  // Retreats from dead ends, and returns the longest path.
  Chain
  Grow(const Vector3d & start, const Vector3d & outwards, double length, ColonRandom & random) const
  {
    constexpr auto first = static_cast<std::size_t>(c_HeldByValve * c_NodeSteps);
    Chain          axis;
    while (axis.size() < first)
    {
      axis.push_back(start + c_GrowthStep * static_cast<double>(axis.size()) * outwards);
    }
    Chain best = axis;
    for (int i = 0; i < c_MostRetreats && !IsLongEnough(best, length); ++i)
    {
      this->Continue(axis, length, random);
      best = axis.size() > best.size() ? axis : best;
      axis.resize(std::max(first, axis.size() - std::min<std::size_t>(axis.size(), c_Retreat)));
    }
    return best;
  }

  static bool
  IsLongEnough(const Chain & axis, double length)
  {
    return c_GrowthStep * static_cast<double>(axis.size() - 1) >= length;
  }

private:
  // Grows up to the length or a dead end.
  void
  Continue(Chain & axis, double length, ColonRandom & random) const
  {
    Vector3d target = Target(random);
    int      steps = 0;
    while (!IsLongEnough(axis, length))
    {
      if ((target - axis.back()).norm() < c_NewTarget || ++steps > c_StepsToTarget)
      {
        target = Target(random);
        steps = 0;
      }
      const Vector3d heading = (axis.back() - axis[axis.size() - 2]).normalized();
      axis.push_back(axis.back() + c_GrowthStep * this->BestHeading(axis, heading, target));
      const bool isBesideCecum = c_GrowthStep * static_cast<double>(axis.size()) < c_BesideCecum;
      if (this->Lacking(axis, axis.back()) > (isBesideCecum ? c_ToleratedByCecum : c_Tolerated))
      {
        axis.pop_back();
        break;
      }
    }
  }

  static Vector3d
  Target(ColonRandom & random)
  {
    const double x = random.Uniform(c_TargetX);
    const double y = random.Uniform(c_TargetY);
    return { x, y, random.Uniform(c_TargetZ) };
  }

  double
  TightestBend() const
  {
    return m_Radius + c_BeyondRadius;
  }

  // Missing space (mm) for a continuation of the axis at a point; negative if there is enough.
  double
  Lacking(const Chain & axis, const Vector3d & at) const
  {
    const double margin = m_Radius + 0.5 * c_LoopWall;
    const double across = std::hypot(at.x() / (c_BodyHalfWidth - margin), at.y() / (c_BodyHalfDepth - margin));
    double       lacking = (across - 1.0) * (c_BodyHalfDepth - margin);
    lacking = std::max({ lacking, c_LowestIleum + margin - at.z(), at.z() - c_HighestIleum + margin });
    lacking = std::max(lacking, c_FromSpine + margin - (at - ColonAnatomy::SpineAxis(at.z())).norm());
    const bool isBesideCecum = c_GrowthStep * static_cast<double>(axis.size()) < c_BesideCecum;
    for (std::size_t i = 0; i < m_Colon.size(); ++i)
    {
      if (isBesideCecum && std::abs(static_cast<int>(i) - m_Cecum) <= c_CecumNodes)
      {
        continue;
      }
      lacking = std::max(lacking, c_ColonBulge * m_ColonRadius[i] + m_Radius + c_ColonWall - (at - m_Colon[i]).norm());
    }
    const auto ownLoop = static_cast<std::size_t>(std::ceil(Pi * this->TightestBend() / c_GrowthStep)) + 1;
    for (std::size_t i = 0; i + ownLoop < axis.size(); ++i)
    {
      lacking = std::max(lacking, 2.0 * m_Radius + c_LoopWall - (at - axis[i]).norm());
    }
    return lacking;
  }

  // Compares headings by the space ahead and by the direction to the target.
  Vector3d
  BestHeading(const Chain & axis, const Vector3d & heading, const Vector3d & target) const
  {
    const Vector3d wish = (target - axis.back()).normalized();
    const Vector3d side = heading.unitOrthogonal();
    const double   tightest = c_GrowthStep / this->TightestBend();
    Vector3d       best = heading;
    double         least = 1e9;
    for (int i = 0; i <= 2 * c_Headings; ++i)
    {
      const double   tilt = i == 0 ? 0.0 : (i <= c_Headings ? 0.5 * tightest : tightest);
      const Vector3d axisOfTurn = Eigen::AngleAxisd(TwoPi * i / c_Headings, heading) * side;
      const Vector3d candidate = Eigen::AngleAxisd(tilt, axisOfTurn) * heading;
      double         cost = -c_TargetWeight * candidate.dot(wish);
      for (const double ahead : { 1.0, 2.0, 4.0 })
      {
        const double lacking = this->Lacking(axis, axis.back() + ahead * c_GrowthStep * candidate);
        cost += std::max(0.0, lacking + c_SmallestMargin) / ahead;
      }
      best = cost < least ? candidate : best;
      least = std::min(least, cost);
    }
    return best;
  }

  const Chain &               m_Colon;
  const std::vector<double> & m_ColonRadius;
  int                         m_Cecum;
  double                      m_Radius;
};

int
CecumNode(const ColonPath & rest)
{
  constexpr int cecum = 6; // segment
  return static_cast<int>(std::lower_bound(rest.segment.begin(), rest.segment.end(), cecum) - rest.segment.begin());
}

// The colon at rest, with room for the ileum.
Chain
ColonWithRoom(const ColonPath & rest, const std::vector<double> & radius, double bore)
{
  ColonRelaxation relaxation(rest, radius);
  relaxation.SetMobility(std::vector<double>(rest.nodes.size(), 0.0));
  relaxation.LeaveRoomAt(CecumNode(rest), bore + c_RoomBesideValve);
  relaxation.Run(c_RoomRounds);
  return relaxation.GetNodes();
}

// Direction from the cecum to the middle of the abdomen, perpendicular to the colon.
Vector3d
OutwardsAtRest(const Chain & colon, int cecum)
{
  const Vector3d middle(20.0, 0.0, 0.0);
  const Vector3d tangent = (colon[cecum + 1] - colon[cecum - 1]).normalized();
  const Vector3d off = middle - colon[cecum];
  return (off - off.dot(tangent) * tangent).normalized();
}

// The longest of several paths, or the first with the requested length.
Chain
ChainAtRest(const Chain &                  colon,
            const std::vector<double> &    radius,
            int                            cecum,
            const ColonPhantomParameters & parameters,
            ColonRandom &                  random)
{
  const Vector3d    tangent = (colon[cecum + 1] - colon[cecum - 1]).normalized();
  const Vector3d    medial = OutwardsAtRest(colon, cecum);
  const IleumAtRest ileum(colon, radius, cecum, 0.5 * parameters.ileumBore);
  const double      bent = std::min(1.0, parameters.ileumLength / c_ManyBends);
  const double      length = parameters.ileumLength * (1.0 + c_ShortenedByBends * bent);
  Chain             best;
  for (int i = 0; i < c_MostTrials; ++i)
  {
    const double   widest = c_WidestAngle * std::min(1.0, static_cast<double>(i) / c_WidestTrial);
    const Vector3d outwards = Eigen::AngleAxisd(random.Uniform(-widest, widest), tangent) * medial;
    const Vector3d start = colon[cecum] + radius[cecum] * outwards;
    const Chain    way = ileum.Grow(start, outwards, length, random);
    best = way.size() > best.size() ? way : best;
    if (IleumAtRest::IsLongEnough(best, length))
    {
      break;
    }
  }
  return best;
}

ColonPath
NodesOf(const Chain & axis)
{
  ColonPath path;
  for (std::size_t i = 0; i < axis.size(); i += c_NodeSteps)
  {
    path.material.push_back(c_GrowthStep * static_cast<double>(i));
    path.nodes.push_back(axis[i]);
  }
  return path;
}

// The colon in the position, at the nodes of the colon at rest.
std::vector<ColonRelaxation::Obstacle>
PositionedColon(const ColonAnatomy & anatomy, const ColonPath & rest)
{
  const CurveSet                         line = anatomy.Centerline();
  const SurfaceArray &                   radius = *FindSurfaceArray(line.pointArrays, "radius");
  std::vector<ColonRelaxation::Obstacle> colon;
  for (const double material : rest.material)
  {
    const auto point =
      static_cast<Eigen::Index>(std::lround(material / rest.Length() * static_cast<double>(line.V.rows() - 1)));
    colon.push_back({ line.V.row(point), c_ColonBulge * radius.values(point, 0) + c_ColonWall });
  }
  return colon;
}

// Moves the colon from rest to the position in small steps, so that loops do not pass through it.
Chain
Relaxed(const ColonPath &                              ileum,
        const std::vector<ColonRelaxation::Obstacle> & from,
        const std::vector<ColonRelaxation::Obstacle> & to,
        const Chain &                                  heldAt,
        double                                         radius)
{
  ColonRelaxation relaxation(ileum, std::vector<double>(ileum.nodes.size(), radius));
  for (int move = 1; move <= c_MovesOfColon; ++move)
  {
    const double                           share = static_cast<double>(move) / c_MovesOfColon;
    std::vector<ColonRelaxation::Obstacle> colon = from;
    for (std::size_t i = 0; i < colon.size(); ++i)
    {
      colon[i].center += share * (to[i].center - from[i].center);
      colon[i].radius += share * (to[i].radius - from[i].radius);
    }
    Chain held;
    for (std::size_t i = 0; i < heldAt.size(); ++i)
    {
      held.push_back(ileum.nodes[i] + share * (heldAt[i] - ileum.nodes[i]));
    }
    relaxation.SetObstacles(colon);
    relaxation.Hold(held);
    relaxation.Run(move == c_MovesOfColon ? c_LastRounds : c_RoundsOfMove);
  }
  return relaxation.GetNodes();
}
/** The ileum of a patient at rest, with the colon around it. */
struct RestingIleum
{
  ColonPath                              rest; ///< of the colon
  std::vector<ColonRelaxation::Obstacle> colon;
  ColonPath                              nodes; ///< of the ileum
};

// The axis in a position, with points about 2 mm apart, from just inside the mouth of the valve.
Chain
AxisIn(const ColonAnatomy & anatomy, const RestingIleum & ileum)
{
  const ColonValve valve = anatomy.Valve();
  Chain            held;
  for (int i = 0; i < c_HeldByValve; ++i)
  {
    held.push_back(valve.mouth + (ileumIntoColon - i * c_NodeSteps * c_GrowthStep) * valve.direction);
  }
  const double radius = 0.5 * anatomy.GetParameters().ileumBore;
  ColonPath    moved = ileum.nodes;
  moved.nodes = Relaxed(moved, ileum.colon, PositionedColon(anatomy, ileum.rest), held, radius);
  const ColonCurve curve(moved, std::vector<double>(ColonCurve::NumberOfSteps(moved.Length()) + 1, 0.0));
  Chain            axis;
  for (int k = 0; k <= curve.GetNumberOfSteps(); ++k)
  {
    axis.push_back(curve.At(k).position);
  }
  return axis;
}

// Number of points of an axis before the first one that lacks room next to the colon or an earlier loop.
std::size_t
PointsWithRoom(const Chain & axis, const ColonAnatomy & anatomy)
{
  const double radius = 0.5 * anatomy.GetParameters().ileumBore;
  const auto   ownLoop = static_cast<std::size_t>(Pi * (radius + c_BeyondRadius) / ileumAxisStep) + 1;
  const auto   beside = static_cast<std::size_t>(c_BesideCecum / ileumAxisStep);
  for (std::size_t i = 0; i < axis.size(); ++i)
  {
    bool hasRoom = i < beside || anatomy.Evaluate(axis[i]).distance < -c_OfColonWall;
    for (std::size_t j = 0; hasRoom && j + ownLoop < i; ++j)
    {
      hasRoom = (axis[i] - axis[j]).norm() > 2.0 * radius + c_BetweenLumens;
    }
    if (!hasRoom)
    {
      return i;
    }
  }
  return axis.size();
}

std::unique_ptr<const ColonAnatomy>
InPosition(ColonPhantomParameters parameters, const char * position)
{
  parameters.position = position;
  return std::make_unique<const ColonAnatomy>(parameters);
}
} // namespace

// The path at rest that has the most room in supine and prone position is used for all positions.
std::vector<Vector3d>
RefluxedIleumAxis(const ColonAnatomy & anatomy)
{
  const ColonPhantomParameters & parameters = anatomy.GetParameters();
  const auto                     supine = InPosition(parameters, "supine");
  const auto                     prone = InPosition(parameters, "prone");
  RestingIleum                   ileum;
  ileum.rest = RestPath(parameters);
  const std::vector<double> radius = RestRadius(ileum.rest, parameters, static_cast<int>(ileum.rest.nodes.size()));
  const Chain               colon = ColonWithRoom(ileum.rest, radius, parameters.ileumBore);
  for (std::size_t i = 0; i < colon.size(); ++i)
  {
    ileum.colon.push_back({ colon[i], c_ColonBulge * radius[i] + c_ColonWall });
  }
  ColonRandom random(parameters.seed, ColonStream::Reflux);
  ColonPath   best;
  std::size_t most = 0;
  for (int i = 0; i < c_MostCandidates && ileumAxisStep * most < c_EnoughLength * parameters.ileumLength; ++i)
  {
    ileum.nodes = NodesOf(ChainAtRest(colon, radius, CecumNode(ileum.rest), parameters, random));
    const std::size_t points =
      std::min(PointsWithRoom(AxisIn(*supine, ileum), *supine), PointsWithRoom(AxisIn(*prone, ileum), *prone));
    best = points > most ? ileum.nodes : best;
    most = std::max(most, points);
  }
  ileum.nodes = best;
  Chain axis = AxisIn(anatomy, ileum);
  axis.resize(most);
  return axis;
}
} // namespace shapeton
