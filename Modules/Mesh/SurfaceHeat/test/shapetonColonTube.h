#ifndef shapetonColonTube_h
#define shapetonColonTube_h

#include "shapetonPhilox.h"
#include "shapetonSurfaceMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

/** Colon-like surfaces with known topology and handles at known positions. */
namespace testsurfaces
{
/** Tests give these in this order, such as { 12000, 10, seed }. */
struct ColonTubeOptions
{
  int           faces{ 12000 };
  int           handles{ 0 };
  std::uint64_t seed{ 1 };
  double        length{ 1500.0 };    ///< mm
  double        radius{ 22.0 };      ///< mean, mm
  double        haustrum{ 32.0 };    ///< from fold to fold, mm
  double        foldDepth{ 0.3 };    ///< relative to the radius
  double        irregularity{ 0.2 }; ///< relative to the edge
  int           handleSpan{ 4 };     ///< edges between the two faces that a handle joins
};

struct ColonTube
{
  shapeton::SurfaceMesh mesh;
  /** The vertices of the two triangles that each handle joins. */
  std::vector<std::array<int, 6>> handles;
  double                          narrowestRadius{ 0.0 };
};

namespace colontube
{
constexpr double pi = 3.14159265358979323846;

/** Random number in [0, 1), by seed and counter. */
inline double
Uniform(std::uint64_t seed, std::uint32_t stream, std::uint32_t number)
{
  return shapeton::UnitFloat(shapeton::Philox4x32(seed, { number, stream, 0, 0 }).a);
}

/** Rectum, sigmoid, descending, transverse, ascending, cecum; dimensionless. */
inline Eigen::Vector3d
ControlPoint(int i)
{
  static const double points[][3] = { { 0, 60, -190 },    { 0, 70, -150 },   { 10, 40, -110 }, { 60, 0, -110 },
                                      { 100, -10, -140 }, { 130, 20, -100 }, { 130, 40, -20 }, { 135, 50, 80 },
                                      { 125, 30, 160 },   { 80, -20, 140 },  { 20, -60, 90 },  { -40, -60, 90 },
                                      { -90, -20, 120 },  { -120, 30, 130 }, { -130, 40, 60 }, { -130, 30, -30 },
                                      { -120, 10, -100 }, { -110, 0, -130 } };
  constexpr int       number = sizeof(points) / sizeof(points[0]);
  const auto &        p = points[std::clamp(i, 0, number - 1)];
  return { p[0], p[1], p[2] };
}

/** The Catmull-Rom spline of the control points. */
inline Eigen::Vector3d
PathPoint(double u)
{
  const int             i = std::clamp(static_cast<int>(u), 0, 16);
  const double          t = u - i;
  const Eigen::Vector3d a = ControlPoint(i - 1), b = ControlPoint(i), c = ControlPoint(i + 1), d = ControlPoint(i + 2);
  return 0.5 *
         (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t + (3.0 * (b - c) + d - a) * t * t * t);
}

/** Averages neighboring points three times to keep bends wider than the tube and avoid self-intersections. */
inline std::vector<Eigen::Vector3d>
Smoothed(std::vector<Eigen::Vector3d> path, int reach)
{
  const int last = static_cast<int>(path.size()) - 1;
  for (int pass = 0; pass < 3; ++pass)
  {
    std::vector<Eigen::Vector3d> sums{ Eigen::Vector3d::Zero() };
    for (int i = -reach; i <= last + reach; ++i)
    {
      sums.push_back(sums.back() + path[std::clamp(i, 0, last)]);
    }
    for (int i = 0; i <= last; ++i)
    {
      path[i] = (sums[i + 2 * reach + 1] - sums[i]) / (2.0 * reach + 1.0);
    }
  }
  return path;
}

/** A centerline with twist-free frames. */
class Centerline
{
public:
  explicit Centerline(double length)
  {
    constexpr int                samples = 4000;
    std::vector<Eigen::Vector3d> path;
    for (int i = 0; i <= samples; ++i)
    {
      path.push_back(PathPoint(17.0 * i / samples));
    }
    path = Smoothed(path, 180);
    std::vector<double> arc{ 0.0 };
    for (int i = 1; i <= samples; ++i)
    {
      arc.push_back(arc.back() + (path[i] - path[i - 1]).norm());
    }
    // A colon of 1.5 m, or its first part.
    const double    wholeLength = std::max(length, 1500.0);
    const double    scale = wholeLength / arc.back();
    const double    part = length / wholeLength;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
    int             segment = 0;
    for (int i = 0; i <= samples; ++i)
    {
      const double s = part * arc.back() * i / samples;
      while (segment < samples - 1 && arc[segment + 1] < s)
      {
        ++segment;
      }
      const double          t = (s - arc[segment]) / (arc[segment + 1] - arc[segment]);
      const Eigen::Vector3d tangent = (path[segment + 1] - path[segment]).normalized();
      normal = (normal - normal.dot(tangent) * tangent).normalized();
      m_Points.push_back(scale * (path[segment] + t * (path[segment + 1] - path[segment])));
      m_Normals.push_back(normal);
      m_Binormals.push_back(tangent.cross(normal));
    }
  }

  /** \param s in [0, 1]. */
  Eigen::Vector3d
  Place(double s, double angle, double radius) const
  {
    const double x = std::clamp(s, 0.0, 1.0) * (m_Points.size() - 1);
    const int    i = std::min(static_cast<int>(x), static_cast<int>(m_Points.size()) - 2);
    const double t = x - i;
    const auto   mix = [&](const std::vector<Eigen::Vector3d> & of) -> Eigen::Vector3d {
      return of[i] + t * (of[i + 1] - of[i]);
    };
    return mix(m_Points) + radius * (std::cos(angle) * mix(m_Normals) + std::sin(angle) * mix(m_Binormals));
  }

private:
  std::vector<Eigen::Vector3d> m_Points, m_Normals, m_Binormals;
};

/** Semilunar folds between three taeniae, staggered between the thirds of the circumference; a wider cecum. */
inline double
Radius(const ColonTubeOptions & options, double s, double angle)
{
  const double turn = angle / (2.0 * pi) - std::floor(angle / (2.0 * pi));
  const int    third = std::min(2, static_cast<int>(3.0 * turn));
  const double phase = s * options.length / options.haustrum + 0.31 * third + 0.15 * Uniform(options.seed, 3, third);
  const double fromFold = phase - std::floor(phase) - 0.5;
  const double ridge = std::exp(-std::pow(fromFold / 0.25, 2));
  const double between = std::pow(std::sin(3.0 * pi * turn), 2);
  const double width = 1.0 + 0.15 * std::sin(9.0 * s) + 0.25 * s * s;
  return options.radius * width * (1.0 - options.foldDepth * ridge * between);
}

/** Replaces two faces by a tube of six triangles that joins them. */
inline std::array<int, 6>
JoinFaces(std::vector<std::array<int, 3>> & faces, int first, int second)
{
  const std::array<int, 3>        a = faces[first];
  const std::array<int, 3>        b = faces[second];
  const std::array<int, 3>        turned{ b[0], b[2], b[1] }; // the other rim is traversed in reverse
  std::vector<std::array<int, 3>> tube;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    tube.push_back({ a[k], a[next], turned[next] });
    tube.push_back({ a[k], turned[next], turned[k] });
  }
  faces[first] = tube[0];
  faces[second] = tube[1];
  faces.insert(faces.end(), tube.begin() + 2, tube.end());
  return { a[0], a[1], a[2], b[0], b[1], b[2] };
}

/** Grid of a tube: rows of `around` vertices, each shifted by half a step from the previous row. */
struct Grid
{
  int around;
  int along;
  int
  At(int row, int column) const
  {
    return row * around + (column + around) % around;
  }
  /** The even face between a row and the next one; the odd face follows. */
  int
  Face(int row, int column) const
  {
    return 2 * At(row, column);
  }
};

inline std::vector<std::array<int, 3>>
Faces(const Grid & grid)
{
  std::vector<std::array<int, 3>> faces;
  for (int row = 0; row < grid.along; ++row)
  {
    for (int i = 0; i < grid.around; ++i)
    {
      const int                               a = grid.At(row, i), b = grid.At(row, i + 1);
      const int                               c = grid.At(row + 1, i), d = grid.At(row + 1, i + 1);
      const std::array<std::array<int, 3>, 2> even{ { { a, b, c }, { b, d, c } } };
      const std::array<std::array<int, 3>, 2> odd{ { { a, b, d }, { a, d, c } } };
      const auto &                            both = row % 2 == 0 ? even : odd;
      faces.insert(faces.end(), both.begin(), both.end());
    }
  }
  return faces;
}

/** Handles between faces of one row, with at least 3 rings of free vertices around each. */
inline std::vector<std::array<int, 6>>
AddHandles(const ColonTubeOptions & options, const Grid & grid, std::vector<std::array<int, 3>> & faces)
{
  constexpr int                   ends = 14; // rows
  constexpr int                   rowsApart = 8;
  constexpr int                   columnsApart = 12;
  std::vector<std::array<int, 2>> places;
  std::vector<std::array<int, 6>> handles;
  for (std::uint32_t attempt = 0; static_cast<int>(handles.size()) < options.handles; ++attempt)
  {
    if (attempt > 10000)
    {
      throw std::runtime_error("so many handles do not fit this tube");
    }
    const int  row = ends + static_cast<int>((grid.along - 2 * ends) * Uniform(options.seed, 1, attempt));
    const int  column = static_cast<int>(grid.around * Uniform(options.seed, 2, attempt));
    const bool isFree = std::all_of(places.begin(), places.end(), [&](const std::array<int, 2> & other) {
      const int across = std::abs(column - other[1]);
      return std::abs(row - other[0]) > rowsApart || std::min(across, grid.around - across) > columnsApart;
    });
    if (row >= ends && isFree)
    {
      places.push_back({ row, column });
      handles.push_back(
        JoinFaces(faces, grid.Face(row, column), grid.Face(row, (column + options.handleSpan) % grid.around)));
    }
  }
  return handles;
}
} // namespace colontube

/** A tube along a colon-like path from the rectum to the cecum, open at both ends. It has about `faces` faces, oriented
 * outward and nearly equilateral except at folds. Each handle adds one to the genus and 4 faces. */
inline ColonTube
MakeColonTube(const ColonTubeOptions & options)
{
  using namespace colontube;
  const double          circumference = 2.0 * pi * options.radius;
  const double          rowsPerEdge = 2.0 / std::sqrt(3.0);
  const double          edge = std::sqrt(2.0 * rowsPerEdge * circumference * options.length / options.faces);
  const colontube::Grid grid{ std::max(3, static_cast<int>(std::lround(circumference / edge))),
                              std::max(1, static_cast<int>(std::lround(options.length * rowsPerEdge / edge))) };
  const Centerline      centerline(options.length);
  ColonTube             tube;
  tube.mesh.V.resize(static_cast<Eigen::Index>(grid.around) * (grid.along + 1), 3);
  tube.narrowestRadius = options.radius;
  for (int row = 0; row <= grid.along; ++row)
  {
    const bool isEnd = row == 0 || row == grid.along;
    for (int i = 0; i < grid.around; ++i)
    {
      const int    vertex = grid.At(row, i);
      const double shiftAlong = isEnd ? 0.0 : options.irregularity * (2.0 * Uniform(options.seed, 4, vertex) - 1.0);
      const double shiftAround = options.irregularity * (2.0 * Uniform(options.seed, 5, vertex) - 1.0);
      const double s = (row + shiftAlong) / grid.along;
      const double angle = 2.0 * pi * (i + 0.5 * (row % 2) + shiftAround) / grid.around;
      const double radius = Radius(options, s, angle);
      tube.mesh.V.row(vertex) = centerline.Place(s, angle, radius);
      tube.narrowestRadius = std::min(tube.narrowestRadius, radius);
    }
  }
  std::vector<std::array<int, 3>> faces = Faces(grid);
  tube.handles = AddHandles(options, grid, faces);
  tube.mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    tube.mesh.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
  }
  return tube;
}
} // namespace testsurfaces

#endif
