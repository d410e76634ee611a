#ifndef shapetonLandmarkTubes_h
#define shapetonLandmarkTubes_h

#include "shapetonFoldTubes.h"
#include "shapetonSchematicColon.h"

/** Flat tubes with known landmarks, and their centerlines. */
namespace landmarktubes
{
using flattubes::pi;

/** Inward height of the wall (mm) at (mm along the tube, angle). */
using Relief = std::function<double(double, double)>;

/** A tube along a curve with points every millimeter. */
inline shapeton::SurfaceMesh
TubeAlong(const shapeton::CurveSet & curve,
          double                     radius,
          const Relief &             relief = {},
          int                        around = 24,
          double                     step = 5.0)
{
  const Eigen::Index           last = curve.V.rows() - 1;
  std::vector<Eigen::Vector3d> frame(last + 1);
  frame[0] = Eigen::Vector3d::UnitX();
  const auto tangentAt = [&](Eigen::Index i) {
    const Eigen::RowVector3d chord =
      curve.V.row(std::min<Eigen::Index>(i + 1, last)) - curve.V.row(std::max<Eigen::Index>(i - 1, 0));
    return Eigen::Vector3d(chord.transpose().normalized());
  };
  for (Eigen::Index i = 0; i <= last; ++i)
  {
    const Eigen::Vector3d t = tangentAt(i);
    const Eigen::Vector3d before = frame[std::max<Eigen::Index>(i - 1, 0)];
    frame[i] = (before - t * t.dot(before)).normalized();
  }
  const auto along = static_cast<int>(last / step);
  return flattubes::MakeFlatTube({ around, along, 2.0 * pi * radius, along * step }, [&](double u, double angle) {
    const auto            i = std::min(static_cast<Eigen::Index>(u + 0.5), last);
    const Eigen::Vector3d a = frame[i];
    const Eigen::Vector3d b = tangentAt(i).cross(a);
    const double          r = radius - (relief ? relief(u, angle) : 0.0);
    return Eigen::Vector3d(curve.V.row(i).transpose() + r * (std::cos(angle) * a - std::sin(angle) * b));
  });
}

/** The centerline of a straight tube along z. */
inline shapeton::CurveSet
StraightLine(double length)
{
  return RoundedCurve({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, length } });
}

/** Angle (radians) of a taenia of TubeWithTaeniae(). In the middle, the second and third taenia are shifted by `nearer`
 * toward the first. */
inline double
TaeniaAngle(int taenia, double u, double nearer = 0.0)
{
  const double shares[] = { 0.0, 1.0, 1.4 };
  const double middle = (u - 240.0) / 80.0;
  return 0.4 + 2.0 * pi * taenia / 3.0 + 0.5 * std::sin(u / 90.0) -
         nearer * shares[taenia % 3] * std::exp(-0.5 * middle * middle);
}

/** A straight tube, 480 mm long, with folds between three winding taeniae. There are folds up to `foldsEnd` mm; the
 * wall bulges outward by up to `bulge` mm between taeniae along the whole tube. `nearer` as above. */
inline shapeton::SurfaceMesh
TubeWithTaeniae(double foldsEnd = 480.0, double bulge = 0.0, double nearer = 0.0)
{
  std::vector<foldtubes::Fold> folds;
  for (int ring = 0; ring < 28; ++ring)
  {
    for (int t = 0; t < 3; ++t)
    {
      const double u = 20.0 + 16.0 * ring + 5.0 * t;
      const double begin = TaeniaAngle(t, u, nearer);
      const double end = TaeniaAngle(t + 1, u, nearer);
      if (u < foldsEnd)
      {
        folds.push_back({ u, 0.5 * (begin + end), 15.0 * (end - begin) / (2.0 * pi / 3.0), 6.0 });
      }
    }
  }
  return flattubes::MakeFlatTube({ 90, 360, 2.0 * pi * foldtubes::radius, 480.0 }, [&](double u, double angle) {
    double r = foldtubes::radius + 0.5 * bulge * (1.0 - std::cos(3.0 * (angle - TaeniaAngle(0, u))));
    for (const foldtubes::Fold & fold : folds)
    {
      r -= std::abs(u - fold.u) < 12.0 ? foldtubes::HeightAt(fold, u, angle) : 0.0;
    }
    return flattubes::OnCylinder(r, u, -angle);
  });
}

/** A point on a taenia of TubeWithTaeniae(). */
inline Eigen::Vector3d
PointOfTaenia(int taenia, double u, double aside = 0.0)
{
  return flattubes::OnCylinder(foldtubes::radius, u, -TaeniaAngle(taenia, u) - aside / foldtubes::radius);
}
} // namespace landmarktubes

#endif
