#ifndef shapetonPlanarDomains_h
#define shapetonPlanarDomains_h

#include "shapetonSurfaceCut.h"
#include "shapetonTestSurfaces.h"

#include <complex>

/** Planar domains with known conformal maps. Faces are counterclockwise as seen from above. */
namespace testsurfaces
{
/** Rings of a polar grid whose radii form a geometric series from `inner` to 1, so that all triangles are similar. */
struct PolarGrid
{
  int    around{ 96 };
  int    rings{ 24 };
  double inner{ 0.3 };

  int
  At(int ring, int place) const
  {
    return ring * around + (place % around + around) % around;
  }
  /** Ring 0 is the inner circle. */
  double
  LogRadius(int ring) const
  {
    return std::log(inner) * (1.0 - static_cast<double>(ring) / rings);
  }
  shapeton::SurfaceMesh
  Mesh() const
  {
    shapeton::SurfaceMesh mesh = Grid(around, rings, Wrap::Around, [&](double s, double t) {
      return Eigen::Vector3d(std::polar(std::pow(inner, 1.0 - t), 2 * Pi * s).real(),
                             std::polar(std::pow(inner, 1.0 - t), 2 * Pi * s).imag(),
                             0.0);
    });
    mesh.F.col(1).swap(mesh.F.col(2)); // outward is up
    return mesh;
  }
};

/** The image under z -> (z + a) / (1 + a z), an automorphism of the unit disk that maps circles to circles. */
inline shapeton::SurfaceMesh
Moebius(shapeton::SurfaceMesh mesh, double a)
{
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    const std::complex<double> z(mesh.V(i, 0), mesh.V(i, 1));
    const std::complex<double> w = (z + a) / (1.0 + a * z);
    mesh.V.row(i) << w.real(), w.imag(), mesh.V(i, 2);
  }
  return mesh;
}

/** Cuts slits into the surface, along paths that start and end inside. */
inline shapeton::SurfaceMesh
WithSlits(const shapeton::SurfaceMesh & mesh, const std::vector<std::vector<int>> & paths)
{
  return shapeton::CutAlongPaths(mesh, shapeton::SurfaceConnectivity(mesh), paths).mesh;
}

/** An arc of one ring of a polar grid. */
inline std::vector<int>
Arc(const PolarGrid & grid, int ring, int first, int last)
{
  std::vector<int> path;
  for (int place = first; place <= last; ++place)
  {
    path.push_back(grid.At(ring, place));
  }
  return path;
}

/** The unit half disk above the real axis, meshed by equally spaced rings around the midpoint of its base. */
inline shapeton::SurfaceMesh
HalfDisk(int rings)
{
  std::vector<Eigen::Vector3d>    points{ { 0, 0, 0 } };
  std::vector<std::array<int, 3>> faces;
  const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) / 2 + ring - 1; };
  for (int ring = 1; ring <= rings; ++ring)
  {
    for (int i = 0; i <= 3 * ring; ++i)
    {
      const double angle = Pi * i / (3.0 * ring);
      const double r = static_cast<double>(ring) / rings;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
    // Advance along both rings, always on the one with the smaller angle.
    for (int i = 0, j = 0; i < 3 * ring || j < 3 * (ring - 1);)
    {
      const bool isOuter = j == 3 * (ring - 1) || (i + 1) * (ring - 1) <= (j + 1) * ring;
      const int  outer = first(ring) + i;
      const int  inner = first(ring - 1) + j;
      faces.push_back(isOuter ? std::array<int, 3>{ inner, outer, outer + 1 }
                              : std::array<int, 3>{ inner, outer, inner + 1 });
      (isOuter ? i : j) += 1;
    }
  }
  return FromLists(points, faces);
}

/** Width over height of the rectangle conformally equivalent to the upper half plane with four marked points on the
 * real axis; the width is the side from the second to the third point. From the cross ratio: K'/K by the
 * arithmetic-geometric mean. */
inline double
ModulusOfCrossRatio(double lambda)
{
  const auto mean = [](double a, double b) {
    for (int i = 0; i < 40; ++i)
    {
      const double next = 0.5 * (a + b);
      b = std::sqrt(a * b);
      a = next;
    }
    return a;
  };
  return mean(1.0, std::sqrt(1.0 - lambda)) / mean(1.0, std::sqrt(lambda));
}
} // namespace testsurfaces

#endif
