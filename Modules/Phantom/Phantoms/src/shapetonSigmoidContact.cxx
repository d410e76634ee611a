#include "shapetonSigmoidContact.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonPhantomIleum.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double contactWall = 1.5;      // mm, of the loop
constexpr double contactSeptum = 3.5;    // mm between the lumens: both walls
constexpr double contactStep = 4.0;      // mm between points of the axis
constexpr double contactIndent = 1.5;    // mm by which the sigmoid flattens the loop
constexpr double shortestContact = 30.0; // mm
constexpr double shorterContact = 10.0;  // mm, if there is not enough room
constexpr int    contactSides = 12;      // directions around the sigmoid
constexpr double tightestFold = 0.5;     // of the step, on the inner side of a bend
constexpr double sufficient = 0.6;       // of the points of the axis in contact

constexpr DrawnRange contactRadius{ 6.0, 9.0 };        // mm
constexpr DrawnRange contactIntensity{ 350.0, 750.0 }; // HU

/** A possible position of the loop. */
struct ContactPlace
{
  std::vector<Vector3d> axis;
  std::vector<Vector3d> near; ///< points of the lumen beside the axis, next to the sigmoid
  std::array<double, 2> arcLength{ { 0.0, 0.0 } };
  double                share{ 0.0 }; ///< of the axis, with contact
};

/** Points of the centerline of the sigmoid at equal steps. */
struct SigmoidLine
{
  std::vector<Vector3d> points;
  std::vector<double>   radius;
  std::vector<double>   arcLength;
};

SigmoidLine
SigmoidLineOf(const ColonAnatomy & anatomy)
{
  const CurveSet        line = anatomy.Centerline();
  const Eigen::VectorXd arcLength = PointValues(line, "arcLength", "centerline");
  const Eigen::VectorXd radius = PointValues(line, "radius", "centerline");
  SigmoidLine           sigmoid;
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    const bool isFar = sigmoid.points.empty() ||
                       arcLength[i] >= sigmoid.arcLength[0] + contactStep * static_cast<double>(sigmoid.points.size());
    if (isFar && anatomy.SegmentAt(arcLength[i]) == 2)
    {
      sigmoid.points.push_back(line.V.row(i));
      sigmoid.radius.push_back(radius[i]);
      sigmoid.arcLength.push_back(arcLength[i]);
    }
  }
  return sigmoid;
}

class ContactFinder
{
public:
  ContactFinder(const ColonAnatomy & anatomy, const std::vector<Vector3d> & ileum, double radius)
    : m_Anatomy(anatomy)
    , m_Ileum(ileum)
    , m_Sigmoid(SigmoidLineOf(anatomy))
    , m_Cavity(AbdominalCavity())
    , m_Organs(PelvicOrgans())
    , m_Radius(radius)
  {}

  // The position with the most contact among those with enough room; empty if none has sufficient contact.
  ContactPlace
  Best(double length) const
  {
    const auto   count = static_cast<std::size_t>(std::lround(length / contactStep)) + 1;
    ContactPlace best;
    best.share = sufficient;
    for (std::size_t first = 1; first + count < m_Sigmoid.points.size(); ++first)
    {
      for (int side = 0; side < contactSides; ++side)
      {
        const auto place = this->Beside(first, count, TwoPi * side / contactSides);
        best = place.share > best.share && this->HasRoom(place.axis) ? place : best;
      }
    }
    return best;
  }

private:
  // A loop parallel to the sigmoid, starting at one of its points, on one side.
  ContactPlace
  Beside(std::size_t first, std::size_t count, double angle) const
  {
    const double distance = contactSeptum + m_Radius - contactIndent;
    ContactPlace place;
    Vector3d     outwards = Vector3d::Zero();
    for (std::size_t i = first; i < first + count; ++i)
    {
      const Vector3d tangent = (m_Sigmoid.points[i + 1] - m_Sigmoid.points[i - 1]).normalized();
      outwards = i == first ? Eigen::AngleAxisd(angle, tangent) * tangent.unitOrthogonal()
                            : (outwards - outwards.dot(tangent) * tangent).normalized();
      place.axis.push_back(m_Sigmoid.points[i] + (m_Sigmoid.radius[i] + distance) * outwards);
      place.near.push_back(place.axis.back() - m_Radius * outwards);
    }
    place.arcLength = { { m_Sigmoid.arcLength[first], m_Sigmoid.arcLength[first + count - 1] } };
    const auto touches = [this](const Vector3d & at) { return m_Anatomy.Evaluate(at).distance > -contactSeptum; };
    const auto contacts = std::count_if(place.near.begin(), place.near.end(), touches);
    place.share = static_cast<double>(contacts) / static_cast<double>(count);
    return place;
  }

  bool
  HasRoom(const std::vector<Vector3d> & axis) const
  {
    const double margin = m_Radius + contactWall;
    for (std::size_t i = 0; i < axis.size(); ++i)
    {
      const Vector3d & at = axis[i];
      const bool       isTight = i > 0 && (at - axis[i - 1]).norm() < tightestFold * contactStep;
      if (isTight || m_Anatomy.Evaluate(at).distance > -m_Radius ||
          LackingBetweenWallAndSpine(m_Cavity, at, margin) > 0.0 ||
          m_Organs.distance(MakePoint(at[0], at[1], at[2])) < margin || this->IsNearIleum(at))
      {
        return false;
      }
    }
    return true;
  }

  bool
  IsNearIleum(const Vector3d & at) const
  {
    const double distance = 0.5 * m_Anatomy.GetParameters().ileumBore + m_Radius + 2.0 * contactWall + contactIndent;
    return std::any_of(
      m_Ileum.begin(), m_Ileum.end(), [&](const Vector3d & point) { return (at - point).norm() < distance; });
  }

  const ColonAnatomy &          m_Anatomy;
  const std::vector<Vector3d> & m_Ileum;
  SigmoidLine                   m_Sigmoid;
  PhantomSolid                  m_Cavity;
  PhantomSolid                  m_Organs;
  double                        m_Radius;
};
} // namespace

SigmoidContactLoop
MakeSigmoidContact(const ColonAnatomy & anatomy, const std::vector<Vector3d> & ileum)
{
  const auto &        parameters = anatomy.GetParameters();
  ColonRandom         random(parameters.seed, ColonStream::Contact, PositionNumber(parameters.position));
  const double        radius = random.Uniform(contactRadius);
  SigmoidContactLoop  loop;
  const ContactFinder finder(anatomy, ileum, radius);
  ContactPlace        place;
  for (double length = parameters.sigmoidContact; place.axis.empty() && length >= shortestContact;
       length -= shorterContact)
  {
    place = finder.Best(length);
  }
  if (place.axis.empty())
  {
    return loop;
  }
  const PhantomSolid tube = TubeSolid(ToPoints(place.axis), radius);
  loop.axis = place.axis;
  loop.lumen = AwayFromColon(tube, anatomy, contactSeptum);
  loop.outer = Grown(tube, contactWall);
  loop.truth = { place.arcLength,
                 2.0 * radius,
                 place.share * (place.arcLength[1] - place.arcLength[0]),
                 random.Uniform(contactIntensity) };
  return loop;
}
} // namespace shapeton
