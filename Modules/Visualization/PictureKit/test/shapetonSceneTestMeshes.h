#ifndef shapetonSceneTestMeshes_h
#define shapetonSceneTestMeshes_h

#include "itkImage.h"
#include "shapetonSurfaceMesh.h"
#include "shapetonTestImages.h"

#include <cmath>
#include <functional>

namespace shapeton
{
constexpr double testPi = 3.14159265358979323846;

/** A grid of u x v quadrangles; `at` maps [0, 1] x [0, 1] to LPS. Its faces point along the cross product of the
 * derivatives. */
inline SurfaceMesh
ParametricMesh(int u, int v, const std::function<Eigen::RowVector3d(double, double)> & at)
{
  SurfaceMesh mesh;
  mesh.V.resize((u + 1) * (v + 1), 3);
  mesh.F.resize(2 * u * v, 3);
  for (int j = 0; j <= v; ++j)
  {
    for (int i = 0; i <= u; ++i)
    {
      mesh.V.row(j * (u + 1) + i) = at(static_cast<double>(i) / u, static_cast<double>(j) / v);
    }
  }
  for (int j = 0; j < v; ++j)
  {
    for (int i = 0; i < u; ++i)
    {
      const int a = j * (u + 1) + i;
      const int d = a + u + 1;
      mesh.F.row(2 * (j * u + i)) << a, a + 1, d + 1;
      mesh.F.row(2 * (j * u + i) + 1) << a, d + 1, d;
    }
  }
  return mesh;
}

inline SurfaceMesh
SphereMesh(const Eigen::RowVector3d & center, double radius, int steps = 96)
{
  return ParametricMesh(2 * steps, steps, [&](double u, double v) {
    const double lon = 2.0 * testPi * u;
    const double lat = testPi * (v - 0.5);
    return Eigen::RowVector3d(center + radius * Eigen::RowVector3d(std::cos(lon) * std::cos(lat),
                                                                   std::sin(lon) * std::cos(lat),
                                                                   std::sin(lat)));
  });
}

/** Around the patient's long axis. */
inline SurfaceMesh
TorusMesh(double ring, double tube)
{
  return ParametricMesh(72, 36, [&](double u, double v) {
    const double lon = 2.0 * testPi * u;
    const double lat = 2.0 * testPi * v;
    const double across = ring + tube * std::cos(lat);
    return Eigen::RowVector3d(across * std::cos(lon), across * std::sin(lon), tube * std::sin(lat));
  });
}

/** A coronal rectangle, one quadrangle, facing the front. */
inline SurfaceMesh
CoronalSheet(double left, double right, double below, double above, double y)
{
  return ParametricMesh(1, 1, [&](double u, double v) {
    return Eigen::RowVector3d(left + u * (right - left), y, below + v * (above - below));
  });
}

/** Rotated about all patient axes, left-handed, with three different spacings. */
template <typename TImage>
typename TImage::Pointer
ObliqueImage(const typename TImage::SizeType & size)
{
  using basetest::Rotation;
  auto mirror = Rotation(0, 0.0);
  mirror[1][1] = -1.0;
  const itk::Matrix<double, 3, 3> turn(Rotation(0, 0.3) * Rotation(1, 0.3) * Rotation(2, 0.3) * mirror);
  return basetest::NewImage<TImage>(size, { 0.7, 1.1, 1.9 }, { 12.0, -31.0, 5.5 }, turn);
}
} // namespace shapeton

#endif
