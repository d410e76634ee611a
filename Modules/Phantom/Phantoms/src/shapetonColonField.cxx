#include "shapetonColonField.h"

#include "shapetonColonNoise.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr double c_FoldFillet = 1.2;   // mm
constexpr double c_BetweenFolds = 3.0; // mm
constexpr double c_PolypFillet = 0.8;  // mm
constexpr double c_LipsFillet = 1.5;   // mm
constexpr double c_MouthFillet = 0.6;  // mm
constexpr double c_LipsReach = 60.0;   // mm along the colon within which the lips are evaluated
constexpr double c_TwistReach =
  250.0; // mm along the colon before the valve over which the limit of its rotation takes effect
constexpr double c_PolypMargin = 12.0; // mm added to the distance within which a polyp is evaluated
constexpr double c_PolypReach = 30.0;  // mm along the colon beyond the head within which a polyp is evaluated
constexpr double c_BumpRadius = 11.0;  // mm, of a valve without lips
constexpr double c_BumpHeight = 8.0;   // mm
constexpr double c_LeastSlope = 0.3;   // of a distance; smaller slopes are not normalized

void
Normalize(ColonDistance & distance)
{
  const double length = distance.gradient.norm();
  if (length > c_LeastSlope)
  {
    distance.value /= length;
    distance.gradient /= length;
  }
}

// An ellipsoid of revolution, first-order accurate near its surface.
ColonDistance
EllipsoidDistance(const Vector3d & point, const PolypBody & polyp)
{
  const Vector3d off = point - polyp.head;
  const double   h = off.dot(polyp.axis);
  const Vector3d side = off - h * polyp.axis;
  const Vector3d scaled = side / polyp.radius + (h / polyp.height) * polyp.axis;
  const double   k = std::max(scaled.norm(), 1e-6);
  const Vector3d slope = (side / (polyp.radius * polyp.radius) + (h / (polyp.height * polyp.height)) * polyp.axis) / k;
  const double   length = std::max(slope.norm(), 1e-9);
  return { (k - 1.0) / length, slope / length };
}

// The mesentery holds the colon: angle, about frames without twist, of the direction of the taenia libera in each step;
// empty where the colon runs along it. In front of descending and ascending colon, below the transverse colon and a
// little behind (Gray's Anatomy).
std::vector<std::optional<double>>
AnglesOfLibera(const ColonCurve & curve, const ColonPlan & plan)
{
  constexpr double                   leastSine = 0.3; // of the angle between colon and direction; chosen
  const Vector3d                     front(0.0, -1.0, 0.0);
  const Vector3d                     below = Vector3d(0.0, 0.5, -std::sqrt(0.75)); // 30 degrees backward
  std::vector<std::optional<double>> angles;
  for (int k = 0; k <= curve.GetNumberOfSteps(); ++k)
  {
    constexpr int  descending = 3;
    constexpr int  transverse = 4;
    const int      segment = plan.SegmentAt(k * curve.GetStep());
    const Vector3d tangent = curve.At(k).first.normalized();
    const Vector3d normal = curve.NormalAt(k, tangent);
    const Vector3d way = segment == transverse ? below : front;
    const Vector3d across = way - way.dot(tangent) * tangent;
    angles.emplace_back();
    if (segment >= descending && across.norm() > leastSine)
    {
      angles.back() = std::atan2(across.dot(tangent.cross(normal)), across.dot(normal));
    }
  }
  return angles;
}

// Unwrapped and constant beyond the first and last angle, then smoothed.
std::vector<double>
ContinuedAngles(const std::vector<std::optional<double>> & angles, double step)
{
  constexpr double    reach = 100.0; // mm; chosen: a taenia keeps within 15 degrees of the axis
  std::vector<double> continued;
  const auto          first = std::find_if(angles.begin(), angles.end(), [](const auto & a) { return a.has_value(); });
  double              last = first == angles.end() ? 0.0 : **first;
  for (const std::optional<double> & angle : angles)
  {
    last += angle ? WrapAngle(*angle - last) : 0.0;
    continued.push_back(last);
  }
  const int           width = std::max(1, static_cast<int>(reach / step));
  const int           size = static_cast<int>(continued.size());
  std::vector<double> smooth;
  for (int k = 0; k < size; ++k)
  {
    double sum = 0.0;
    for (int i = -width; i <= width; ++i)
    {
      sum += continued[std::clamp(k + i, 0, size - 1)];
    }
    smooth.push_back(sum / (2 * width + 1));
  }
  return smooth;
}

// Adds the twist that turns taenia 0 to where anatomy has the libera.
std::vector<double>
AnatomicalTwist(const ColonPath & path, const ColonPlan & plan, std::vector<double> twist)
{
  const ColonCurve          curve(path, std::vector<double>(twist.size(), 0.0));
  const std::vector<double> angles = ContinuedAngles(AnglesOfLibera(curve, plan), curve.GetStep());
  for (std::size_t k = 0; k < twist.size(); ++k)
  {
    twist[k] += angles[k] - plan.StartOfTaeniae();
  }
  return twist;
}

std::vector<double>
TwistOf(const ColonPath & path, const ColonPlan & plan, const ColonPhantomParameters & parameters)
{
  const std::vector<double> twist = ColonTwist(plan, parameters);
  return parameters.anatomicalTaeniae ? AnatomicalTwist(path, plan, twist) : twist;
}

// The ileum fixes the valve: at the valve, the rotation of the right colon in a position is limited to half a radian.
std::vector<double>
HeldTwist(const ColonPath & path, const ColonPlan & plan, std::vector<double> twist)
{
  constexpr double free = 0.5;
  if (!plan.valve.hasLips)
  {
    return twist;
  }
  const ColonCurve curve(path, twist);
  const double     off = WrapAngle(AngleOfIleum(curve, plan.valve) - plan.valve.angle);
  const double     back = off - std::clamp(off, -free, free);
  for (std::size_t k = 0; k < twist.size(); ++k)
  {
    twist[k] += back * SmoothStep(plan.valve.material - c_TwistReach, plan.valve.material, k * curve.GetStep());
  }
  return twist;
}
} // namespace

struct ColonField::Local
{
  double   t;
  double   angle;
  double   distance; ///< from the centerline
  double   speed;    ///< mm along the wall per unit of t, at this distance
  Vector3d tangent;
  Vector3d outwards;
  Vector3d around;
};

ColonField::ColonField(const ColonPath &              path,
                       const ColonPlan &              plan,
                       const ColonPhantomParameters & parameters,
                       double                         reach)
  : m_Curve(path, HeldTwist(path, plan, TwistOf(path, plan, parameters)))
  , m_Relief(plan, parameters, &m_Curve)
  , m_Reach(reach)
  , m_BetweenFolds(KeepsPublishedVoxels(parameters) ? 0.0 : c_BetweenFolds)
{
  std::vector<double> reaches;
  for (int k = 0; k <= m_Curve.GetNumberOfSteps(); ++k)
  {
    // A lower bound for a flat or collapsed wall: the distance to the centerline.
    reaches.push_back(std::max(0.0, m_Relief.LargestRadiusNear(k)) + reach);
  }
  m_Curve.BuildGrid(reaches);
  this->FillSepta(path, parameters.preset == "hard" ? 2.0 : 3.0);
  m_PolypsNear.resize(m_Curve.GetNumberOfSteps() + 1);
  this->PlacePolyps(plan);
  if (plan.valve.hasLips)
  {
    this->PlaceLips(plan);
  }
  m_Diverticula = PlaceDiverticula(*this, plan.diverticula);
}

void
ColonField::FillSepta(const ColonPath & path, double least)
{
  m_Septum.assign(m_Curve.GetNumberOfSteps() + 1, least);
  for (const ColonPath::Contact & contact : path.contacts)
  {
    for (int node : { contact.first, contact.second })
    {
      for (std::size_t k = 0; k < m_Septum.size(); ++k)
      {
        const double off = std::abs(k * m_Curve.GetStep() - path.material[node]);
        const double share = std::clamp((off - 30.0) / 20.0, 0.0, 1.0);
        m_Septum[k] = std::min(m_Septum[k], contact.septum + share * (least - contact.septum));
      }
    }
  }
}

void
ColonField::Locate(const Vector3d & point, double t, Local & local) const
{
  const ColonCurve::Frame frame = m_Curve.At(t);
  const double            first = frame.first.norm();
  const Vector3d          off = point - frame.position;
  local.t = t;
  local.distance = off.norm();
  local.tangent = frame.first / first;
  const double bend = std::max(0.2, 1.0 - off.dot(frame.second) / (first * first));
  local.speed = first * bend;
  const Vector3d normal = m_Curve.NormalAt(t, local.tangent);
  const Vector3d binormal = local.tangent.cross(normal);
  local.angle = std::atan2(off.dot(binormal), off.dot(normal));
  local.outwards = local.distance > 1e-9 ? Vector3d(off / local.distance) : normal;
  local.around = std::cos(local.angle) * binormal - std::sin(local.angle) * normal;
}

ColonDistance
ColonField::WallDistance(const Local & local) const
{
  const ReliefValue radius = m_Relief.RadiusAt(local.t, local.angle);
  // Near the centerline angles are unreliable.
  const double  arm = std::max(local.distance, 0.7 * std::abs(radius.value) + 0.1);
  ColonDistance wall{ radius.value - local.distance,
                      (radius.byAngle / arm) * local.around + (radius.byT / local.speed) * local.tangent -
                        local.outwards };
  Normalize(wall);
  return wall;
}

void
ColonField::AddFolds(const Local & local, ColonDistance & distance) const
{
  // Merges nearly touching folds, to avoid slits.
  ColonDistance folds{ beyondAll, local.outwards };
  for (int i : m_Relief.FoldsNear(local.t))
  {
    const FoldCourse & fold = m_Relief.GetFolds()[i];
    ReliefValue        t, crest;
    if (!fold.At(WrapAngle(local.angle - fold.angle) / fold.halfAngle, t, crest))
    {
      continue;
    }
    // Slopes are used only at and behind the crest, since angles near the centerline are unreliable.
    const double arm = std::max(local.distance, 0.8 * std::abs(crest.value) + 0.1);
    // Across the fold, and toward the lumen from the middle of the crest.
    const double   slant = t.byAngle * local.speed / arm;
    const double   slantLength = std::sqrt(1.0 + slant * slant);
    const double   across = (local.t - t.value) * local.speed / slantLength;
    const Vector3d acrossGradient = (local.tangent - slant * local.around) / slantLength;
    const double   rise = crest.byAngle / arm;
    const double   riseLength = std::sqrt(1.0 + rise * rise);
    // Far from the crest, the slope at the end of a fold is unrelated to the distance.
    const double  radial = crest.value + fold.halfThickness - local.distance;
    const double  above = std::max(radial / riseLength, radial - 3.0);
    ColonDistance body;
    if (above > 0)
    {
      const double r = std::max(std::sqrt(across * across + above * above), 1e-9);
      body.value = r - fold.halfThickness;
      body.gradient = (across * acrossGradient + above * (rise * local.around - local.outwards) / riseLength) / r;
    }
    else
    {
      body.value = std::abs(across) - fold.halfThickness;
      body.gradient = across < 0 ? Vector3d(-acrossGradient) : acrossGradient;
    }
    if (m_BetweenFolds > 0.0)
    {
      folds = JoinTissue(folds, body, m_BetweenFolds);
    }
    else
    {
      distance = JoinTissue(distance, body, c_FoldFillet);
    }
  }
  distance = JoinTissue(distance, folds, c_FoldFillet);
}

void
ColonField::AddPolyps(const Vector3d & point, double t, ColonDistance & distance) const
{
  for (int i : m_PolypsNear[static_cast<std::size_t>(t + 0.5)])
  {
    const PolypBody & polyp = m_Polyps[i];
    if ((point - polyp.head).norm() > std::max(polyp.radius, polyp.height) + polyp.height + m_Reach + c_PolypMargin)
    {
      continue;
    }
    if (polyp.isPedunculated)
    {
      const Vector3d foot = polyp.base - 2.0 * polyp.axis;
      distance = JoinTissue(distance, CapsuleDistance(point, foot, polyp.head, polyp.stalkRadius), c_PolypFillet);
      distance = JoinTissue(distance, SphereDistance(point, polyp.head, polyp.radius), c_PolypFillet);
    }
    else
    {
      distance = JoinTissue(distance, EllipsoidDistance(point, polyp), c_PolypFillet);
    }
  }
}

void
ColonField::AddLips(const Vector3d & point, double t, ColonDistance & distance) const
{
  if (m_Lips && std::abs(t - m_LipsAt) * m_Curve.GetStep() < c_LipsReach)
  {
    distance = JoinTissue(distance, m_Lips->Distance(point), c_LipsFillet);
  }
}

// Half of the septum is on each side of the surface equidistant from both walls.
void
ColonField::AddSeptum(const Local &         here,
                      const ColonDistance & own,
                      const Local &         there,
                      const ColonDistance & other,
                      ColonDistance &       distance) const
{
  const auto   step = [](double t) { return static_cast<std::size_t>(t + 0.5); };
  const double septum = std::min(m_Septum[step(here.t)], m_Septum[step(there.t)]);
  Vector3d     gradient = own.gradient - other.gradient;
  const double length = std::max(0.5, gradient.norm());
  const double value = (own.value - other.value) / length - 0.5 * septum;
  if (value < distance.value)
  {
    distance = { value, gradient / length };
  }
}

bool
ColonField::Evaluate(const Vector3d & point, Place & place) const
{
  const bool isNearTube = this->EvaluateTube(point, place);
  return m_Diverticula.empty() ? isNearTube : this->AddDiverticula(point, isNearTube, place);
}

// Joins the lumina of tube and flask with a rounded mouth.
bool
ColonField::AddDiverticula(const Vector3d & point, bool isNearTube, Place & place) const
{
  bool isNear = isNearTube;
  for (const DiverticulumBody & body : m_Diverticula)
  {
    const double tube = isNear ? -place.distance.value : beyondAll;
    const double most = body.Extent() + std::max(tube, c_MouthFillet);
    if ((point - body.sac).squaredNorm() > most * most)
    {
      continue;
    }
    const ColonDistance flask = body.Distance(point);
    ColonDistance       joined = flask;
    if (isNear)
    {
      joined = JoinTissue({ tube, -place.distance.gradient }, flask, c_MouthFillet);
      Normalize(joined);
    }
    place.distance = { -joined.value, -joined.gradient };
    if (flask.value < tube)
    {
      place.t = body.t;
      place.angle = body.angle;
    }
    isNear = true;
  }
  return isNear;
}

bool
ColonField::EvaluateTube(const Vector3d & point, Place & place) const
{
  ColonCurve::Near near;
  m_Curve.FindNear(point, near);
  if (near.count == 0)
  {
    return false;
  }
  Local         locals[ColonCurve::MostNear];
  ColonDistance walls[ColonCurve::MostNear];
  for (int i = 0; i < near.count; ++i)
  {
    this->Locate(point, near.t[i], locals[i]);
    walls[i] = this->WallDistance(locals[i]);
  }
  place.distance.value = -beyondAll;
  for (int i = 0; i < near.count; ++i)
  {
    ColonDistance distance = walls[i];
    if (distance.value > -m_Reach && distance.value > place.distance.value)
    {
      this->AddFolds(locals[i], distance);
      this->AddPolyps(point, locals[i].t, distance);
      this->AddLips(point, locals[i].t, distance);
      Normalize(distance);
      for (int k = 0; k < near.count; ++k)
      {
        if (k != i)
        {
          this->AddSeptum(locals[i], walls[i], locals[k], walls[k], distance);
        }
      }
    }
    if (distance.value > place.distance.value)
    {
      place = { distance, locals[i].t, locals[i].angle };
    }
  }
  return true;
}

Vector3d
ColonField::WallPoint(double t, double angle, double & radius) const
{
  return this->WallAlong(m_Curve.At(t).position, m_Curve.Direction(t, angle), radius);
}

Vector3d
ColonField::WallAlong(const Vector3d & from, const Vector3d & direction, double & distance) const
{
  const auto distanceAt = [&](double r) {
    Place place;
    return this->Evaluate(from + r * direction, place) ? place.distance.value : -m_Reach;
  };
  // Marches with steps shorter than any fold thickness, then bisects.
  constexpr double leastStep = 0.4; // mm
  constexpr double stepShare = 0.7; // of the distance, which is accurate only near the wall
  double           low = 0.0;
  double           high = 0.0;
  while (distanceAt(high) > 0)
  {
    low = high;
    high += std::max(leastStep, stepShare * distanceAt(high));
  }
  for (int round = 0; round < 40 && high > low; ++round)
  {
    const double middle = 0.5 * (low + high);
    (distanceAt(middle) > 0 ? low : high) = middle;
  }
  distance = 0.5 * (low + high);
  return from + distance * direction;
}

PolypBody
ColonField::MakeValve(const ColonPlan & plan) const
{
  PolypBody valve;
  double    radius;
  valve.t = plan.valve.material / m_Curve.GetStep();
  valve.angle = plan.valve.angle;
  valve.base = this->WallPoint(valve.t, valve.angle, radius);
  valve.axis = -m_Curve.Direction(valve.t, valve.angle);
  valve.isPedunculated = false;
  valve.radius = c_BumpRadius;
  valve.height = c_BumpHeight;
  valve.stalkRadius = 0.0;
  valve.head = valve.base;
  return valve;
}

// Places the lips on the wall, ignoring folds, since folds slide.
void
ColonField::PlaceLips(const ColonPlan & plan)
{
  m_LipsAt = plan.valve.material / m_Curve.GetStep();
  const Vector3d outwards = m_Curve.Direction(m_LipsAt, plan.valve.angle);
  const Vector3d back = -m_Curve.At(m_LipsAt).first.normalized();
  ValveLips      lips;
  lips.base = m_Curve.At(m_LipsAt).position + m_Relief.RadiusAt(m_LipsAt, plan.valve.angle).value * outwards;
  lips.axis = -outwards;
  lips.across = back;
  lips.slit = outwards.cross(back);
  lips.length = plan.valve.length;
  lips.height = plan.valve.height;
  lips.thickness = plan.valve.thickness;
  m_Lips = lips;
}

void
ColonField::PlacePolyps(const ColonPlan & plan)
{
  std::vector<PolypBody> bodies;
  for (const PolypPlan & polyp : plan.polyps)
  {
    PolypBody body;
    body.t = polyp.material / m_Curve.GetStep();
    body.angle = polyp.angle;
    if (polyp.fold >= 0)
    {
      const FoldCourse & fold = m_Relief.GetFolds()[polyp.fold];
      ReliefValue        t, crest;
      fold.At(WrapAngle(polyp.angle - fold.angle) / fold.halfAngle, t, crest);
      body.t = t.value;
    }
    double radius;
    body.base = this->WallPoint(body.t, body.angle, radius);
    body.axis = -m_Curve.Direction(body.t, body.angle);
    Place place;
    if (polyp.fold < 0 && polyp.stalk <= 0 && this->Evaluate(body.base, place))
    {
      body.axis = place.distance.gradient.normalized();
    }
    body.isPedunculated = polyp.stalk > 0;
    body.radius = 0.5 * polyp.diameter;
    body.height = body.isPedunculated ? body.radius : polyp.height;
    body.stalkRadius = polyp.stalkRadius;
    body.head = body.base + (body.isPedunculated ? polyp.stalk + body.radius : 0.0) * body.axis;
    bodies.push_back(body);
  }
  if (!plan.valve.hasLips)
  {
    bodies.push_back(this->MakeValve(plan));
  }
  m_Polyps = bodies;
  for (std::size_t i = 0; i < m_Polyps.size(); ++i)
  {
    for (std::size_t k = 0; k < m_PolypsNear.size(); ++k)
    {
      if (std::abs(k - m_Polyps[i].t) * m_Curve.GetStep() < m_Polyps[i].radius + c_PolypReach)
      {
        m_PolypsNear[k].push_back(static_cast<int>(i));
      }
    }
  }
}
} // namespace shapeton
