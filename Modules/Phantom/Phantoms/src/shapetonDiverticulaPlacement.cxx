#include "shapetonColonField.h"

#include "shapetonAbdomenParts.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double c_OwnSeptum = 1.6;   // mm of tissue between a sac and the stretch it is attached to
constexpr double c_OtherSeptum = 3.0; // mm between a sac and other structures
constexpr double c_Stretch = 40.0;    // mm, half the length of a stretch along the colon
constexpr double c_SmallestSac = 3.0; // mm
constexpr double c_Plain = 0.7;       // mm; maximum distance between wall and relief without folds
constexpr int    c_Around = 8;        // points tried around the neck; chosen
constexpr double c_Upright = 0.7; // least cosine between the normal of the wall and the direction from the centerline
constexpr double c_BeforeMouth = 1.5; // mm into the lumen, where the lumen around the mouth must be open
constexpr double c_HalfSpace = 150.0; // mm; sacs are closer to the middle of the abdomen along the body
constexpr double c_AroundNeck = 0.3;  // mm beside the neck, where tissue is required
constexpr double c_NeckTissue = 0.2;  // mm, least distance of that place from a lumen

// Uniform directions on the sphere.
std::vector<Vector3d>
SphereDirections()
{
  constexpr int         count = 96;
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * Pi * (3.0 - std::sqrt(5.0));
    directions.emplace_back(std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
  }
  return directions;
}

class DiverticulaPlacement
{
public:
  explicit DiverticulaPlacement(const ColonField & field)
    : m_Field(field), m_Directions(SphereDirections()), m_Cavity(AbdominalCavity())
  {}

  std::vector<DiverticulumBody>
  Place(const std::vector<DiverticulumPlan> & plans)
  {
    for (std::size_t i = 0; i < plans.size(); ++i)
    {
      DiverticulumBody body;
      Vector3d         outwards;
      body.plan = static_cast<int>(i);
      if (this->FindMouth(plans[i], body, outwards) && this->FindRoom(plans[i], outwards, body))
      {
        m_Bodies.push_back(body);
      }
    }
    return m_Bodies;
  }

private:
  // Distance (mm) to the wall, positive in the lumen; a large negative value if no wall is near.
  double
  DistanceAt(const Vector3d & point) const
  {
    ColonField::Place place;
    return m_Field.Evaluate(point, place) ? place.distance.value : -1e3;
  }

  // Finds a mouth; false if a fold or another stretch covers the wall, or the lumen is closed.
  bool
  FindMouth(const DiverticulumPlan & plan, DiverticulumBody & body, Vector3d & outwards) const
  {
    const ColonCurve &  curve = m_Field.GetCurve();
    const ColonRelief & relief = m_Field.GetRelief();
    body.t = plan.material / curve.GetStep();
    body.angle = plan.angle;
    body.neckRadius = 0.5 * plan.neck;
    double radius;
    body.mouth = m_Field.WallPoint(body.t, body.angle, radius);
    ColonField::Place place;
    if (relief.CollapseAt(body.t) > 0.0 || std::abs(radius - relief.RadiusAt(body.t, body.angle).value) > c_Plain ||
        !m_Field.Evaluate(body.mouth, place))
    {
      return false;
    }
    outwards = -place.distance.gradient.normalized();
    return outwards.dot(curve.Direction(body.t, body.angle)) > c_Upright && this->IsOpenBefore(body, outwards);
  }

  bool
  IsOpenBefore(const DiverticulumBody & body, const Vector3d & outwards) const
  {
    const Vector3d side = outwards.unitOrthogonal();
    for (int i = 0; i < c_Around; ++i)
    {
      const Vector3d off = Eigen::AngleAxisd(TwoPi * i / c_Around, outwards) * side;
      if (this->DistanceAt(body.mouth + (body.neckRadius + 1.0) * off - c_BeforeMouth * outwards) < 0.5 ||
          this->DistanceAt(body.mouth - 3.0 * outwards + off) < 1.0)
      {
        return false;
      }
    }
    return true;
  }

  // Tries an upright sac, then tilted sacs, then smaller ones.
  bool
  FindRoom(const DiverticulumPlan & plan, const Vector3d & outwards, DiverticulumBody & body) const
  {
    for (const double share : { 1.0, 0.8, 0.6 })
    {
      body.radius = 0.5 * std::max(share * plan.diameter, c_SmallestSac);
      for (const double tilt : { 0.0, 0.35, 0.6 })
      {
        // Preserves the gap between sac and wall.
        const double length = (plan.neckLength + body.radius) / std::cos(tilt);
        for (int i = 0; i < (tilt > 0.0 ? c_Around : 1); ++i)
        {
          const Vector3d side = Eigen::AngleAxisd(TwoPi * i / c_Around, outwards) * outwards.unitOrthogonal();
          body.sac = body.mouth + length * (std::cos(tilt) * outwards + std::sin(tilt) * side);
          if (this->HasRoom(body))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  bool
  HasRoom(const DiverticulumBody & body) const
  {
    return this->IsWithinAbdomen(body) && this->IsClearOfSacs(body) && this->IsClearOfColon(body) &&
           this->LeavesOnce(body);
  }

  bool
  IsWithinAbdomen(const DiverticulumBody & body) const
  {
    const Vector3d & at = body.sac;
    const double     spine = at.z() > -50.0 ? 30.0 : 17.0;
    return (at - ColonAnatomy::SpineAxis(at.z())).norm() > spine + body.radius + c_OtherSeptum &&
           m_Cavity.distance(MakePoint(at[0], at[1], at[2])) < -(body.radius + c_OtherSeptum) &&
           std::abs(at.z()) < c_HalfSpace;
  }

  bool
  IsClearOfSacs(const DiverticulumBody & body) const
  {
    return std::all_of(m_Bodies.begin(), m_Bodies.end(), [&body](const DiverticulumBody & other) {
      return other.Distance(body.sac).value > body.radius + c_OtherSeptum &&
             body.Distance(other.sac).value > other.radius + c_OtherSeptum;
    });
  }

  bool
  IsClearOfColon(const DiverticulumBody & body) const
  {
    return std::all_of(m_Directions.begin(), m_Directions.end(), [&](const Vector3d & direction) {
      ColonField::Place place;
      if (!m_Field.Evaluate(body.sac + body.radius * direction, place))
      {
        return true;
      }
      const bool isOwn = std::abs(place.t - body.t) * m_Field.GetCurve().GetStep() < c_Stretch;
      return place.distance.value < -(isOwn ? c_OwnSeptum : c_OtherSeptum);
    });
  }

  // The upper half of the neck must be in tissue.
  bool
  LeavesOnce(const DiverticulumBody & body) const
  {
    const Vector3d axis = (body.sac - body.mouth).normalized();
    const double   length = (body.sac - body.mouth).norm() - body.radius;
    for (const double share : { 0.5, 0.75, 1.0 })
    {
      for (int i = 0; i < c_Around; ++i)
      {
        const Vector3d side = Eigen::AngleAxisd(TwoPi * i / c_Around, axis) * axis.unitOrthogonal();
        if (this->DistanceAt(body.mouth + share * length * axis + (body.neckRadius + c_AroundNeck) * side) >
            -c_NeckTissue)
        {
          return false;
        }
      }
    }
    return true;
  }

  const ColonField &            m_Field;
  std::vector<Vector3d>         m_Directions;
  PhantomSolid                  m_Cavity;
  std::vector<DiverticulumBody> m_Bodies;
};
} // namespace

std::vector<DiverticulumBody>
PlaceDiverticula(const ColonField & field, const std::vector<DiverticulumPlan> & plans)
{
  return DiverticulaPlacement(field).Place(plans);
}
} // namespace shapeton
