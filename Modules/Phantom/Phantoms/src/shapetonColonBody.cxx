#include "shapetonColonBody.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
// Distances to the colon are first-order accurate; away from the wall they may be too large by this factor.
constexpr double colonSlope = 3.0;
// In bends, the depth below a tilted level changes by up to this factor more than the distance to the level.
constexpr double tiltedSlope = 1.5;
// Maximum size (mm) of blocks in the lumen, since the levels of adjacent pools differ.
constexpr double largestBlock = 4.0;

Eigen::Vector3d
ToEigen(const itk::Point<double, 3> & p)
{
  return { p[0], p[1], p[2] };
}

class ColonBody : public PhantomBody
{
public:
  ColonBody(const ColonAnatomy & anatomy, const ColonFluid & fluid) : m_Anatomy(anatomy), m_Fluid(fluid) {}

  BodyProbe
  Probe(const PointType & p) const override
  {
    const auto   point = ToEigen(p);
    const auto   sample = m_Anatomy.Evaluate(point);
    const double outer = -(sample.distance + bowelWall) / colonSlope;
    double       clearance = std::min(std::abs(sample.distance), std::abs(sample.distance + bowelWall)) / colonSlope;
    bool         textured = false;
    if (sample.distance > 0.0)
    {
      const double depth = m_Fluid.DepthBelowLevel(point, sample.arcLength);
      const double slope = m_Fluid.GetTiltedLevel().slope > 0.0 ? tiltedSlope : 1.0;
      clearance = std::min({ clearance, std::abs(depth) / slope, largestBlock });
      textured = depth > 0.0;
    }
    return { outer, clearance, textured };
  }

  double
  Intensity(const PointType & p) const override
  {
    const auto point = ToEigen(p);
    const auto sample = m_Anatomy.Evaluate(point);
    if (sample.distance <= 0.0)
    {
      return softTissueIntensity;
    }
    return m_Fluid.DepthBelowLevel(point, sample.arcLength) > 0.0 ? m_Fluid.Intensity(point, sample.arcLength)
                                                                  : gasIntensity;
  }

  void
  Paint(const PointType & p, double width, double & value) const override
  {
    const auto   point = ToEigen(p);
    const auto   sample = m_Anatomy.Evaluate(point);
    const double wall = ShareInside(-(sample.distance + bowelWall), width);
    value += wall * (softTissueIntensity - value);
    const double lumen = ShareInside(-sample.distance, width);
    if (lumen <= 0.0)
    {
      return;
    }
    const double fluid = ShareInside(-m_Fluid.DepthBelowLevel(point, sample.arcLength), width);
    double       content = gasIntensity;
    if (fluid > 0.0)
    {
      content += fluid * (m_Fluid.Intensity(point, sample.arcLength) - gasIntensity);
    }
    value += lumen * (content - value);
  }

private:
  const ColonAnatomy & m_Anatomy;
  const ColonFluid &   m_Fluid;
};

// The part of a solid where a function of the distance to the colon is negative.
template <typename TLimit>
PhantomSolid
LimitedByColon(const PhantomSolid & solid, const ColonAnatomy & anatomy, const TLimit & limit)
{
  return { [distance = solid.distance, &anatomy, limit](const PhantomBody::PointType & p) {
            const double own = distance(p);
            return own > ColonAnatomy::Reach ? own : std::max(own, limit(anatomy.Evaluate(ToEigen(p)).distance));
          },
           std::max(solid.slope, colonSlope) };
}
} // namespace

std::shared_ptr<const PhantomBody>
MakeColonBody(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  return std::make_shared<ColonBody>(anatomy, fluid);
}

std::vector<itk::Point<double, 3>>
ToPoints(const std::vector<Eigen::Vector3d> & axis)
{
  std::vector<itk::Point<double, 3>> points;
  for (const Eigen::Vector3d & p : axis)
  {
    points.push_back(MakePoint(p[0], p[1], p[2]));
  }
  return points;
}

PhantomSolid
PolypSolid(const ColonPolyp & polyp)
{
  const Eigen::Vector3d axis = (polyp.position - polyp.base).normalized();
  const bool            isOnStalk = polyp.kind == "pedunculated";
  const Eigen::Vector3d center = isOnStalk ? polyp.position : polyp.base;
  const double          radius = 0.5 * polyp.diameter;
  const double          height = isOnStalk ? radius : polyp.height;
  // A lower bound of the distance; the surface is hidden in the wall.
  const auto head = [=](const PhantomBody::PointType & p) {
    const Eigen::Vector3d off = ToEigen(p) - center;
    const double          along = off.dot(axis);
    const double          across = (off - along * axis).norm();
    return (std::hypot(across / radius, along / height) - 1.0) * std::min(radius, height);
  };
  const auto inwards = MakeVector(-axis[0], -axis[1], -axis[2]);
  return Both({ head }, HalfSpaceSolid(inwards, bowelWall - axis.dot(polyp.base)));
}

PhantomSolid
NatalCleft(const ColonAnatomy & anatomy)
{
  constexpr double halfWidth = 3.0; // mm at the anal verge
  constexpr double widening = 0.35; // mm per mm below it
  constexpr double perineum = 20.0; // mm before the anal verge
  Eigen::Vector3d  verge;
  Eigen::Vector3d  inwards;
  anatomy.AnalVerge(verge, inwards);
  const auto below = [&](const Eigen::Vector3d & normal, double offset) {
    const double norm = normal.norm();
    const auto   unit = MakeVector(normal[0] / norm, normal[1] / norm, normal[2] / norm);
    return HalfSpaceSolid(unit, (normal.dot(verge) + offset) / norm);
  };
  const Eigen::Vector3d side = Eigen::Vector3d::UnitX();
  const PhantomSolid    wedge =
    Both(below(side + widening * inwards, halfWidth), below(widening * inwards - side, halfWidth));
  return Both(Both(wedge, below(inwards, 0.0)), below(-Eigen::Vector3d::UnitY(), perineum));
}

PhantomSolid
WithinColon(const PhantomSolid & solid, const ColonAnatomy & anatomy, double beyond)
{
  return LimitedByColon(solid, anatomy, [beyond](double toWall) { return -toWall - beyond; });
}

PhantomSolid
AwayFromColon(const PhantomSolid & solid, const ColonAnatomy & anatomy, double gap)
{
  return LimitedByColon(solid, anatomy, [gap](double toWall) { return toWall + gap; });
}
} // namespace shapeton
