#ifndef shapetonTestSurfaces_h
#define shapetonTestSurfaces_h

#include "shapetonSurfaceMesh.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

/** Surfaces with known shape and topology. */
namespace testsurfaces
{
constexpr double Pi = 3.14159265358979323846;

inline shapeton::SurfaceMesh
FromLists(const std::vector<Eigen::Vector3d> & points, const std::vector<std::array<int, 3>> & faces)
{
  shapeton::SurfaceMesh mesh;
  mesh.V.resize(static_cast<Eigen::Index>(points.size()), 3);
  mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.V.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    mesh.F.row(static_cast<Eigen::Index>(i)) << faces[i][0], faces[i][1], faces[i][2];
  }
  return mesh;
}

inline shapeton::SurfaceMesh
Octahedron()
{
  return FromLists(
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } });
}

/** A sphere around the origin: an icosahedron, subdivided `levels` times, 20 4^levels faces. */
inline shapeton::SurfaceMesh
Icosphere(int levels, double radius)
{
  const double                    g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Eigen::Vector3d>    points{ { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
                                       { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g },
                                       { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  std::vector<std::array<int, 3>> faces{ { 0, 11, 5 }, { 0, 5, 1 },  { 0, 1, 7 },   { 0, 7, 10 }, { 0, 10, 11 },
                                         { 1, 5, 9 },  { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },
                                         { 3, 9, 4 },  { 3, 4, 2 },  { 3, 2, 6 },   { 3, 6, 8 },  { 3, 8, 9 },
                                         { 4, 9, 5 },  { 2, 4, 11 }, { 6, 2, 10 },  { 8, 6, 7 },  { 9, 8, 1 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<int, int>, int> middles;
    const auto                         middleOf = [&](int a, int b) {
      const auto [place, isNew] = middles.emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (isNew)
      {
        points.emplace_back(points[a].normalized() + points[b].normalized());
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto & f : faces)
    {
      const int a = middleOf(f[0], f[1]);
      const int b = middleOf(f[1], f[2]);
      const int c = middleOf(f[2], f[0]);
      finer.insert(finer.end(), { { f[0], a, c }, { f[1], b, a }, { f[2], c, b }, { a, b, c } });
    }
    faces = std::move(finer);
  }
  for (auto & point : points)
  {
    point = radius * point.normalized();
  }
  return FromLists(points, faces);
}

/** A grid of `around` x `along` quadrilaterals, each split in two. It wraps in one direction (Wrap::Around), both,
 * none, or one with a half twist. position(s, t) takes s, t in [0, 1]. */
enum class Wrap
{
  None,
  Around,
  Both,
  Moebius
};

inline shapeton::SurfaceMesh
Grid(int around, int along, Wrap wrap, const std::function<Eigen::Vector3d(double, double)> & position)
{
  const int                       columns = wrap == Wrap::None ? around + 1 : around;
  const int                       rows = wrap == Wrap::Both ? along : along + 1;
  std::vector<Eigen::Vector3d>    points;
  std::vector<std::array<int, 3>> faces;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      points.push_back(position(double(i) / around, double(j) / along));
    }
  }
  const auto at = [&](int i, int j) {
    const bool isTurned = wrap == Wrap::Moebius && i == around;
    return (isTurned ? along - j : j % rows) * columns + i % columns;
  };
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      faces.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      faces.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return FromLists(points, faces);
}

inline shapeton::SurfaceMesh
Torus(int around, int across, double ringRadius, double tubeRadius)
{
  return Grid(around, across, Wrap::Both, [=](double s, double t) {
    const double r = ringRadius + tubeRadius * std::cos(2 * Pi * t);
    return Eigen::Vector3d(r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), tubeRadius * std::sin(2 * Pi * t));
  });
}

/** A cylinder around the z axis from 0 to `height`, open at both ends, oriented outward. */
inline shapeton::SurfaceMesh
Cylinder(int around, int along, double radius, double height)
{
  return Grid(around, along, Wrap::Around, [=](double s, double t) {
    return Eigen::Vector3d(radius * std::cos(2 * Pi * s), radius * std::sin(2 * Pi * s), height * t);
  });
}

inline shapeton::SurfaceMesh
MoebiusStrip(int around, int across)
{
  return Grid(around, across, Wrap::Moebius, [](double s, double t) {
    const double r = 10.0 + 4.0 * (t - 0.5) * std::cos(Pi * s);
    return Eigen::Vector3d(r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), 4.0 * (t - 0.5) * std::sin(Pi * s));
  });
}

/** A square in the plane z = 0 from the origin to (side, side). */
inline shapeton::SurfaceMesh
Square(int cells, double side)
{
  return Grid(cells, cells, Wrap::None, [=](double s, double t) { return Eigen::Vector3d(side * s, side * t, 0.0); });
}

/** A cube of the given side with a corner at the origin; four separate vertices for each of its six sides. */
inline shapeton::SurfaceMesh
CubeOfSixSquares(double side)
{
  std::vector<Eigen::Vector3d>    points;
  std::vector<std::array<int, 3>> faces;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int upper = 0; upper < 2; ++upper)
    {
      Eigen::Vector3d corner = Eigen::Vector3d::Zero();
      corner[axis] = upper * side;
      const Eigen::Vector3d u = side * Eigen::Vector3d::Unit((axis + (upper ? 1 : 2)) % 3);
      const Eigen::Vector3d v = side * Eigen::Vector3d::Unit((axis + (upper ? 2 : 1)) % 3);
      const int             first = static_cast<int>(points.size());
      points.insert(points.end(), { corner, corner + u, corner + u + v, corner + v });
      faces.push_back({ first, first + 1, first + 2 });
      faces.push_back({ first, first + 2, first + 3 });
    }
  }
  return FromLists(points, faces);
}

/** Concatenates surfaces without connecting them. */
inline shapeton::SurfaceMesh
Together(const std::vector<shapeton::SurfaceMesh> & meshes)
{
  shapeton::SurfaceMesh together;
  for (const auto & mesh : meshes)
  {
    const Eigen::Index v = together.V.rows();
    const Eigen::Index f = together.F.rows();
    together.V.conservativeResize(v + mesh.V.rows(), Eigen::NoChange);
    together.V.bottomRows(mesh.V.rows()) = mesh.V;
    together.F.conservativeResize(f + mesh.F.rows(), Eigen::NoChange);
    together.F.bottomRows(mesh.F.rows()) = mesh.F.array() + static_cast<int>(v);
  }
  return together;
}

/** Adds a seam around the faces with `isBeyond`: vertices on the seam are duplicated, and these faces use the copies.
 */
inline shapeton::SurfaceMesh
WithSeam(shapeton::SurfaceMesh mesh, const std::function<bool(int)> & isBeyond)
{
  std::vector<bool> isUsedBefore(mesh.V.rows(), false);
  for (int f = 0; f < mesh.F.rows(); ++f)
  {
    for (int k = 0; k < 3 && !isBeyond(f); ++k)
    {
      isUsedBefore[mesh.F(f, k)] = true;
    }
  }
  std::map<int, int> copies;
  for (int f = 0; f < mesh.F.rows(); ++f)
  {
    for (int k = 0; k < 3 && isBeyond(f); ++k)
    {
      if (const int vertex = mesh.F(f, k); isUsedBefore[vertex])
      {
        mesh.F(f, k) = copies.emplace(vertex, static_cast<int>(mesh.V.rows() + copies.size())).first->second;
      }
    }
  }
  mesh.V.conservativeResize(mesh.V.rows() + static_cast<Eigen::Index>(copies.size()), Eigen::NoChange);
  for (const auto & [vertex, copy] : copies)
  {
    mesh.V.row(copy) = mesh.V.row(vertex).eval();
  }
  return mesh;
}

/** Platform-independent random numbers. */
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_State(seed) {}
  std::uint64_t
  Next()
  {
    std::uint64_t z = (m_State += 0x9E3779B97F4A7C15u); // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  int
  Below(int n)
  {
    return static_cast<int>(this->Next() % static_cast<std::uint64_t>(n));
  }
  /** Random number in [-1, 1). */
  double
  Signed()
  {
    return std::ldexp(static_cast<double>(this->Next() >> 11), -52) - 1.0;
  }

private:
  std::uint64_t m_State;
};

/** Moves each vertex by up to `amplitude` along each axis. */
inline shapeton::SurfaceMesh
Roughened(shapeton::SurfaceMesh mesh, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  for (Eigen::Index i = 0; i < mesh.V.size(); ++i)
  {
    mesh.V.data()[i] += amplitude * random.Signed();
  }
  return mesh;
}

/** The faces whose indices fulfill a condition. */
template <typename TCondition>
shapeton::SurfaceMesh
FacesWhere(const shapeton::SurfaceMesh & mesh, const TCondition & isKept)
{
  std::vector<int> faces;
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    if (isKept(face))
    {
      faces.push_back(face);
    }
  }
  return shapeton::FacesOfSurface(mesh, faces);
}
} // namespace testsurfaces

#endif
