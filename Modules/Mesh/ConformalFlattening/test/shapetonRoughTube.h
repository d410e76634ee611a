#ifndef shapetonRoughTube_h
#define shapetonRoughTube_h

#include "shapetonPhilox.h"
#include "shapetonTestSurfaces.h"

/** Tubes whose flat maps fold: noise, blind pouches, needles and ears. */
namespace testsurfaces
{
struct RoughTubeOptions
{
  std::uint64_t seed{ 1 };
  int           around{ 24 };
  int           along{ 40 };
  double        noise{ 0.0 }; ///< largest vertex displacement, in edge lengths
  int           pouches{ 0 };
  int           pouchRings{ 8 }; ///< three edges each; each scales the area by e^-4
  int           needles{ 0 };
  int           ears{ 0 };
};

namespace roughtube
{
/** Mesh under construction, and random numbers. */
struct Builder
{
  Builder(const shapeton::SurfaceMesh & mesh, std::uint64_t itsSeed) : seed(itsSeed)
  {
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      points.emplace_back(mesh.V.row(v).transpose());
    }
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      faces.push_back({ mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2) });
    }
  }

  double
  Random()
  {
    return shapeton::UnitFloat(shapeton::Philox4x32(seed, { next++, 7, 0, 0 }).a);
  }

  /** A random index below `number`. */
  int
  AnyFace(int number)
  {
    return std::min(number - 1, static_cast<int>(Random() * number));
  }

  std::vector<Eigen::Vector3d>    points;
  std::vector<std::array<int, 3>> faces;
  std::uint64_t                   seed;
  std::uint32_t                   next{ 0 };
};

/** Replaces a face by a closed pouch that points outward. */
inline void
AddPouch(Builder & tube, int face, int rings, double step)
{
  std::array<int, 3>    rim = tube.faces[face];
  const Eigen::Vector3d a = tube.points[rim[0]], b = tube.points[rim[1]], c = tube.points[rim[2]];
  const Eigen::Vector3d outwards = step * (b - a).cross(c - a).normalized();
  for (int ring = 0; ring < rings; ++ring)
  {
    std::array<int, 3> next;
    for (int k = 0; k < 3; ++k)
    {
      next[k] = static_cast<int>(tube.points.size());
      const Eigen::Vector3d jitter(tube.Random() - 0.5, tube.Random() - 0.5, tube.Random() - 0.5);
      tube.points.emplace_back(tube.points[rim[k]] + outwards + 0.2 * step * jitter);
    }
    for (int k = 0; k < 3; ++k)
    {
      const int m = (k + 1) % 3;
      tube.faces.push_back({ rim[k], rim[m], next[m] });
      tube.faces.push_back({ rim[k], next[m], next[k] });
    }
    rim = next;
  }
  tube.faces[face] = rim;
}

/** Splits a face into three at a new vertex near one of its edges. */
inline void
AddNeedle(Builder & tube, int face)
{
  const auto            corners = tube.faces[face];
  const double          height = std::pow(10.0, -1.0 - 5.0 * tube.Random());
  const double          share = 0.2 + 0.6 * tube.Random();
  const Eigen::Vector3d place =
    (1.0 - height) * (share * tube.points[corners[0]] + (1.0 - share) * tube.points[corners[1]]) +
    height * tube.points[corners[2]];
  const int middle = static_cast<int>(tube.points.size());
  tube.points.push_back(place);
  tube.faces[face] = { corners[0], corners[1], middle };
  tube.faces.push_back({ corners[1], corners[2], middle });
  tube.faces.push_back({ corners[2], corners[0], middle });
}

/** Adds a face with a new corner on the edge from vertex a to b of the first end. */
inline void
AddEar(Builder & tube, int a, int b)
{
  tube.points.emplace_back(0.5 * (tube.points[a] + tube.points[b]) - 2.0 * Eigen::Vector3d::UnitZ());
  tube.faces.push_back({ b, a, static_cast<int>(tube.points.size()) - 1 });
}
} // namespace roughtube

/** A straight tube with folds, radius 20 mm, length 200 mm. */
inline shapeton::SurfaceMesh
MakeRoughTube(const RoughTubeOptions & options)
{
  const double       radius = 20.0;
  const double       length = 200.0;
  const double       edge = std::min(2.0 * Pi * radius / options.around, length / options.along);
  roughtube::Builder tube(Grid(options.around,
                               options.along,
                               Wrap::Around,
                               [&](double s, double t) {
                                 const double r = radius * (1.0 + 0.25 * std::cos(12.0 * Pi * t));
                                 return Eigen::Vector3d(r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), length * t);
                               }),
                          options.seed);
  for (Eigen::Vector3d & point : tube.points)
  {
    const double x = tube.Random(), y = tube.Random(), z = tube.Random();
    point += 2.0 * options.noise * edge * Eigen::Vector3d(x - 0.5, y - 0.5, z - 0.5);
  }
  const int faces = static_cast<int>(tube.faces.size());
  for (int i = 0; i < options.pouches; ++i)
  {
    roughtube::AddPouch(tube, tube.AnyFace(faces), options.pouchRings, 0.7 * edge);
  }
  for (int i = 0; i < options.needles; ++i)
  {
    roughtube::AddNeedle(tube, tube.AnyFace(static_cast<int>(tube.faces.size())));
  }
  for (int i = 0; i < options.ears; ++i)
  {
    const int a = 2 * i % options.around;
    roughtube::AddEar(tube, a, a + 1);
  }
  return FromLists(tube.points, tube.faces);
}
} // namespace testsurfaces

#endif
