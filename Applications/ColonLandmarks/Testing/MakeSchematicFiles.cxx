// Writes the inputs of the tests of ColonLandmarks to a folder: a schematic flat colon with folds between three
// taeniae, its centerline, and faulty variants.
#include "shapetonLandmarkTubes.h"

#include "shapetonSurfaceWriter.h"

#include <iostream>

namespace
{
constexpr double radius = 18.0;
using landmarktubes::TaeniaAngle;

double
Folds(double u, double angle)
{
  const double ring = std::floor(u / 20.0);
  double       height = 0.0;
  for (int t = 0; t < 3; ++t)
  {
    foldtubes::Fold fold;
    fold.u = 20.0 * ring + 5.0 + 5.0 * t;
    fold.angle = TaeniaAngle(t, fold.u) + landmarktubes::pi / 3.0;
    fold.halfLength = 14.0;
    fold.height = 5.0;
    height += foldtubes::HeightAt(fold, u, angle);
  }
  return height;
}

void
WritePoints(const std::vector<Eigen::Vector3d> & points, const std::string & path)
{
  shapeton::CurveSet set;
  set.V.resize(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    set.V.row(i) = points[i].transpose();
    set.curves.push_back({ static_cast<int>(i) });
  }
  shapeton::WriteCurves(set, path);
}

/** Points on the taeniae of the flat surface in the middle of the colon. */
std::vector<Eigen::Vector3d>
Markers(const shapeton::SurfaceMesh & flat, double u)
{
  std::vector<Eigen::Vector3d> points;
  const auto &                 uv = flat.pointArrays[0].values;
  const double                 circumference = flat.fieldArrays[0].values(0, 0);
  for (int t = 0; t < 3; ++t)
  {
    const double v = TaeniaAngle(t, u) / (2.0 * landmarktubes::pi) * circumference;
    Eigen::Index nearest = 0;
    double       least = 1e9;
    for (Eigen::Index i = 0; i < uv.rows(); ++i)
    {
      const double distance = std::hypot(uv(i, 0) - u, std::remainder(uv(i, 1) - v, circumference));
      nearest = distance < least ? i : nearest;
      least = std::min(least, distance);
    }
    points.emplace_back(flat.V.row(nearest));
  }
  return points;
}
} // namespace

int
main(int, char * argv[])
{
  const std::string     folder = argv[1];
  const SchematicColon  colon = MakeSchematicColon();
  shapeton::SurfaceMesh flat = landmarktubes::TubeAlong(colon.centerline, radius, Folds, 60, 2.0);
  flat.V = (1e6 * flat.V.array()).round() / 1e6; // versions of Eigen differ in the last bits
  shapeton::WriteSurface(flat, folder + "/flat.vtp");
  shapeton::WriteCurves(colon.centerline, folder + "/centerline.vtp");
  shapeton::WriteCurves(ReversedCurve(colon.centerline), folder + "/reversed.vtp");
  shapeton::CurveSet other = colon.centerline;
  other.V.col(0) *= 0.6;
  shapeton::WriteCurves(other, folder + "/other.vtp");
  WritePoints(Markers(flat, 900.0), folder + "/markers.vtp");
  WritePoints({ Eigen::Vector3d(0, 0, 900) }, folder + "/far.vtp");

  const shapeton::CurveSet part = RoundedCurve({ { 0, 0, 0 }, { 0, 0, 150 }, { 120, 0, 200 } });
  shapeton::WriteSurface(landmarktubes::TubeAlong(part, radius, {}, 40, 4.0), folder + "/partFlat.vtp");
  shapeton::WriteCurves(part, folder + "/partCenterline.vtp");
  return 0;
}
