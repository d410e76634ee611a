#include "shapetonColonAnatomyData.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
const ColonPhantomParameters &
Checked(const ColonPhantomParameters & parameters)
{
  RequireValid(parameters);
  return parameters;
}

// The radius of the wall at each node in this position, used to separate stretches.
std::vector<double>
NodeRadii(const ColonPath & rest, const ColonPlan & plan, const ColonPhantomParameters & parameters)
{
  const int           steps = ColonCurve::NumberOfSteps(rest.Length());
  const ColonRelief   relief(plan, parameters, nullptr);
  std::vector<double> radii;
  for (double material : rest.material)
  {
    radii.push_back(std::max(3.0, relief.MeanRadiusAt(material / rest.Length() * steps)));
  }
  return radii;
}
} // namespace

ColonAnatomy::Data::Data(const ColonPhantomParameters & given)
  : parameters(Drawn(Checked(given)))
  , rest(RestPath(parameters))
  , plan(rest, parameters)
  , field(PositionedPath(rest, NodeRadii(rest, plan, parameters), parameters), plan, parameters, Reach)
{}

ColonAnatomy::ColonAnatomy(const ColonPhantomParameters & parameters) : m_Data(std::make_unique<const Data>(parameters))
{}

ColonAnatomy::~ColonAnatomy() = default;

const ColonPhantomParameters &
ColonAnatomy::GetParameters() const
{
  return m_Data->parameters;
}

ColonAnatomy::Sample
ColonAnatomy::Evaluate(const Vector3d & point) const
{
  ColonField::Place place;
  if (!m_Data->field.Evaluate(point, place) || place.distance.value <= -Reach)
  {
    return { -Reach, 0.0, 0.0, 0 };
  }
  const ColonCurve & curve = m_Data->field.GetCurve();
  return { std::min(place.distance.value, Reach),
           curve.ArcLengthAt(place.t),
           place.angle,
           m_Data->plan.SegmentAt(place.t * curve.GetStep()) };
}

ColonPlace
ColonAnatomy::PlaceAt(double share, double angle) const
{
  const ColonCurve & curve = m_Data->field.GetCurve();
  const double       t = share * curve.GetNumberOfSteps();
  ColonPlace         place;
  place.angle = WrapAngle(angle);
  place.arcLength = curve.ArcLengthAt(t);
  place.inwards = -curve.Direction(t, place.angle);
  place.point = m_Data->field.WallPoint(t, place.angle, place.radius);
  return place;
}

double
ColonAnatomy::Length() const
{
  return m_Data->field.GetCurve().Length();
}

int
ColonAnatomy::SegmentAt(double arcLength) const
{
  const ColonCurve & curve = m_Data->field.GetCurve();
  return m_Data->plan.SegmentAt(curve.ParameterAt(arcLength) * curve.GetStep());
}

std::string
ColonAnatomy::SegmentName(int segment)
{
  static const std::vector<std::string> names{ "rectum", "sigmoid", "descending", "transverse", "ascending", "cecum" };
  return segment >= 1 && segment <= 6 ? names[segment - 1] : std::string();
}

void
ColonAnatomy::BoundingBox(double margin, Vector3d & low, Vector3d & high) const
{
  const ColonField & field = m_Data->field;
  low.setConstant(beyondAll);
  high.setConstant(-beyondAll);
  for (int k = 0; k <= field.GetCurve().GetNumberOfSteps(); ++k)
  {
    const Vector3d spread = Vector3d::Constant(field.GetRelief().LargestRadiusNear(k) + margin);
    low = low.cwiseMin(field.GetCurve().At(k).position - spread);
    high = high.cwiseMax(field.GetCurve().At(k).position + spread);
  }
  for (const DiverticulumBody & body : field.GetDiverticula())
  {
    const Vector3d spread = Vector3d::Constant(body.radius + margin);
    low = low.cwiseMin(body.sac - spread);
    high = high.cwiseMax(body.sac + spread);
  }
}

void
ColonAnatomy::AnalVerge(Vector3d & point, Vector3d & inwards) const
{
  const ColonCurve::Frame frame = m_Data->field.GetCurve().At(0.0);
  point = frame.position;
  inwards = frame.first.normalized();
}
} // namespace shapeton
