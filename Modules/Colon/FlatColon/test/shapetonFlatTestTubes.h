#ifndef shapetonFlatTestTubes_h
#define shapetonFlatTestTubes_h

#include "shapetonSurfaceMesh.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>

/** Tubes with flat maps as returned by FlattenTube(), with duplicate vertices along the cut. */
namespace flattubes
{
constexpr double pi = 3.14159265358979323846;

struct TubeForm
{
  int    around{ 48 };
  int    along{ 60 };
  double circumference{ 120.0 };
  double length{ 150.0 };
  /** Maximum deviation of the cut from v = 0, in steps between vertices. */
  double cutSway{ 0.0 };
  /** Whether faces are oriented into the lumen, and whether the map is reversed. */
  bool isInsideOut{ false };
  bool isMirrored{ false };
};

/** Calls `body` with column and row of each pixel of a grid. */
template <typename TGrid, typename TBody>
void
ForPixels(const TGrid & grid, const TBody & body)
{
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      body(column, row);
    }
  }
}

inline void
AddArray(std::vector<shapeton::SurfaceArray> & arrays,
         const std::string &                   name,
         Eigen::Index                          rows,
         Eigen::Index                          columns)
{
  arrays.push_back({ name, shapeton::SurfaceArray::ValueMatrix::Zero(rows, columns) });
}

/** A tube with position(u, angle) in space and map coordinates (u, angle / (2 pi) * circumference); conformal only if
 * `position` is. */
inline shapeton::SurfaceMesh
MakeFlatTube(const TubeForm & form, const std::function<Eigen::Vector3d(double, double)> & position)
{
  const int             columns = form.around + 1;
  shapeton::SurfaceMesh mesh;
  mesh.V.resize(columns * (form.along + 1), 3);
  mesh.F.resize(2 * form.around * form.along, 3);
  AddArray(mesh.pointArrays, "uv", mesh.V.rows(), 2);
  AddArray(mesh.pointArrays, "sourcePointId", mesh.V.rows(), 1);
  AddArray(mesh.pointArrays, "arcLength", mesh.V.rows(), 1);
  AddArray(mesh.cellArrays, "bridged", mesh.F.rows(), 1);
  AddArray(mesh.fieldArrays, "circumference", 1, 1);
  AddArray(mesh.fieldArrays, "length", 1, 1);
  mesh.fieldArrays[0].values(0, 0) = form.circumference;
  mesh.fieldArrays[1].values(0, 0) = form.length;
  for (int j = 0; j <= form.along; ++j)
  {
    const double u = form.length * j / form.along;
    const double sway = form.cutSway * std::sin(2.0 * pi * j / 7.0) * form.circumference / form.around;
    for (int i = 0; i <= form.around; ++i)
    {
      const int    vertex = j * columns + i;
      const double v = form.circumference * i / form.around + sway;
      mesh.V.row(vertex) = position(u, 2.0 * pi * v / form.circumference);
      if (i == form.around)
      {
        mesh.V.row(vertex) = mesh.V.row(j * columns);
      }
      mesh.pointArrays[0].values.row(vertex) << u, form.isMirrored ? form.circumference - v : v;
      mesh.pointArrays[1].values(vertex, 0) = 5 + j * form.around + i % form.around;
      mesh.pointArrays[2].values(vertex, 0) = 10.0 + u;
    }
  }
  int face = 0;
  for (int j = 0; j < form.along; ++j)
  {
    for (int i = 0; i < form.around; ++i)
    {
      const int a = j * columns + i;
      const int b = a + columns; // next in u
      for (const Eigen::Vector3i & corners : { Eigen::Vector3i(a, b, b + 1), Eigen::Vector3i(a, b + 1, a + 1) })
      {
        mesh.F.row(face++) = form.isInsideOut ? Eigen::Vector3i(corners[0], corners[2], corners[1]) : corners;
      }
    }
  }
  return mesh;
}

/** A straight cylinder along z; u x v points outward. */
inline Eigen::Vector3d
OnCylinder(double radius, double u, double angle)
{
  return { radius * std::cos(angle), radius * std::sin(angle), u };
}

inline shapeton::SurfaceMesh
MakeCylinder(const TubeForm & form)
{
  const double radius = form.circumference / (2.0 * pi);
  return MakeFlatTube(form, [radius](double u, double angle) { return OnCylinder(radius, u, -angle); });
}

/** A tube along a circular arc in the xz plane; not conformal. */
inline shapeton::SurfaceMesh
MakeBentTube(const TubeForm & form, double bendRadius, const std::function<double(double, double)> & radius)
{
  return MakeFlatTube(form, [=](double u, double angle) {
    const double turn = u / bendRadius;
    const double r = bendRadius - radius(u, angle) * std::cos(angle);
    return Eigen::Vector3d(r * std::cos(turn), radius(u, angle) * std::sin(angle), r * std::sin(turn));
  });
}
} // namespace flattubes

#endif
