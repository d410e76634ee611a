#ifndef shapetonGenusSurfaces_h
#define shapetonGenusSurfaces_h

#include "shapetonLevelSurface.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonTestSurfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace testsurfaces
{
/** A tube around a chain of `genus` touching circles of radius 1, with the needles that marching cubes produce;
 * coordinates are in cells of a grid with `cells` cells per unit. */
inline shapeton::SurfaceMesh
ChainOfRings(int genus, int cells)
{
  constexpr double            tube = 0.35, margin = 0.6;
  const std::array<double, 3> corner{ -1.0 - margin, -1.0 - margin, -margin - 0.013 };
  const std::array<int, 3>    size{ static_cast<int>(cells * (2.0 * genus + 2.0 * margin)) + 2,
                                 static_cast<int>(cells * (2.0 + 2.0 * margin)) + 2,
                                 static_cast<int>(cells * 2.0 * margin) + 2 };
  std::vector<float>          values;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double x = corner[0] + double(i) / cells, y = corner[1] + double(j) / cells,
                     z = corner[2] + double(k) / cells;
        double nearest = 1e9;
        for (int ring = 0; ring < genus; ++ring)
        {
          nearest = std::min(nearest, std::hypot(std::hypot(x - 2.0 * ring, y) - 1.0, z));
        }
        values.push_back(static_cast<float>(nearest - tube));
      }
    }
  }
  return shapeton::OuterShell(shapeton::LevelSurface(values, size, 0.0));
}

/** Angle defects of the final triangulation by the law of cosines, independent of the library. */
inline Eigen::VectorXd
DefectsOfResult(const shapeton::SurfaceRicciFlow & flow, int vertices)
{
  using shapeton::RicciGeometry;
  Eigen::VectorXd defects = Eigen::VectorXd::Constant(vertices, 2 * Pi);
  for (Eigen::Index f = 0; f < flow.triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double a = flow.sides(f, (k + 1) % 3), b = flow.sides(f, k), c = flow.sides(f, (k + 2) % 3);
      double       cosine = (b * b + c * c - a * a) / (2 * b * c);
      if (flow.geometry == RicciGeometry::Hyperbolic)
      {
        cosine = (std::cosh(b) * std::cosh(c) - std::cosh(a)) / (std::sinh(b) * std::sinh(c));
      }
      else if (flow.geometry == RicciGeometry::Spherical)
      {
        cosine = (std::cos(a) - std::cos(b) * std::cos(c)) / (std::sin(b) * std::sin(c));
      }
      defects[flow.triangles(f, k)] -= std::acos(std::clamp(cosine, -1.0, 1.0));
    }
  }
  return defects;
}
} // namespace testsurfaces

#endif
