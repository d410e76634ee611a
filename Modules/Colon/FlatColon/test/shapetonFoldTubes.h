#ifndef shapetonFoldTubes_h
#define shapetonFoldTubes_h

#include "shapetonFlatTestTubes.h"

#include <vector>

/** Straight tubes with a radius of 20 mm and folds of known shape. */
namespace foldtubes
{
constexpr double radius = 20.0;

struct Fold
{
  double u{ 0.0 };          ///< mm
  double angle{ 0.0 };      ///< of the center, radians
  double halfLength{ 0.0 }; ///< mm around the tube
  double height{ 0.0 };     ///< mm
  double dip{ 0.0 };        ///< relative reduction of the height in the middle
  double slant{ 0.0 };      ///< mm of u per mm around
  double thickness{ 1.5 };  ///< standard deviation across, mm
};

inline double
HeightAt(const Fold & fold, double u, double angle)
{
  const double around = radius * std::remainder(angle - fold.angle, 2.0 * flattubes::pi);
  const double x = around / fold.halfLength;
  const double across = (u - fold.u - fold.slant * around) / fold.thickness;
  const double along = std::abs(x) < 1.0 ? 1.0 - std::abs(x * x * x) : 0.0;
  return fold.height * along * std::exp(-0.5 * across * across) * (1.0 - fold.dip * std::exp(-around * around / 8.0));
}

inline shapeton::SurfaceMesh
MakeTube(const std::vector<Fold> & folds, flattubes::TubeForm form = {})
{
  form.around = 120;
  form.along = 160;
  form.circumference = 2.0 * flattubes::pi * radius;
  form.length = 160.0;
  return flattubes::MakeFlatTube(form, [&](double u, double angle) {
    double r = radius;
    for (const Fold & fold : folds)
    {
      r -= HeightAt(fold, u, angle);
    }
    return flattubes::OnCylinder(r, u, -angle);
  });
}
} // namespace foldtubes

#endif
