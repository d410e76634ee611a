#ifndef shapetonFlatTestColon_h
#define shapetonFlatTestColon_h

#include "shapetonFlatTestTubes.h"

#include "itkImage.h"

/** A straight piece of colon with semilunar folds between three taeniae, one polyp and a bridged end. Its map is not
 * conformal, which pictures do not require. */
namespace flatcolon
{
constexpr double radius = 20.0;
constexpr double length = 240.0;
constexpr double polypU = 100.0;
constexpr double polypAngle = 2.0;
constexpr double polypRadius = 4.0;

inline flattubes::TubeForm
Form()
{
  flattubes::TubeForm form;
  form.around = 126;
  form.along = 240;
  form.circumference = 2.0 * flattubes::pi * radius;
  form.length = length;
  form.cutSway = 1.2;
  return form;
}

inline double
RadiusAt(double u, double angle)
{
  const double turn = angle / (2.0 * flattubes::pi);
  const double third = 3.0 * (turn - std::floor(turn));
  const double phase = u / 34.0 + 0.3 * std::floor(third);
  const double ridge = std::exp(-std::pow((phase - std::floor(phase) - 0.5) / 0.09, 2));
  const double between = std::pow(std::sin(flattubes::pi * third), 2);
  const double around = radius * std::remainder(angle - polypAngle, 2.0 * flattubes::pi);
  const double away = std::hypot(u - polypU, around) / polypRadius;
  const double polyp = away < 1.0 ? polypRadius * std::sqrt(1.0 - away * away) : 0.0;
  return radius - std::max(7.0 * ridge * between, polyp) + 0.8 * between;
}

/** The wall; the angle decreases with v, so u x v points outwards. */
inline shapeton::SurfaceMesh
Wall(double (*radiusAt)(double, double) = RadiusAt)
{
  shapeton::SurfaceMesh mesh = flattubes::MakeFlatTube(
    Form(), [=](double u, double angle) { return flattubes::OnCylinder(radiusAt(u, -angle), u, -angle); });
  mesh.cellArrays[0].values.bottomRows(2 * 126 * 25).setOnes();
  return mesh;
}

/** Distance of the wall from the smooth tube at this position. */
inline Eigen::Vector3d
PointAt(double u, double angle, double r)
{
  return flattubes::OnCylinder(r, u, angle);
}
} // namespace flatcolon

#endif
