#ifndef shapetonSceneTestMeshes_h
#define shapetonSceneTestMeshes_h

#include "itkImage.h"
#include "shapetonSurfaceMesh.h"

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
  auto                           image = TImage::New();
  typename TImage::DirectionType turn;
  typename TImage::DirectionType mirror;
  typename TImage::SpacingType   spacing;
  typename TImage::PointType     origin;
  const double                   c = std::cos(0.3);
  const double                   s = std::sin(0.3);
  turn.SetIdentity();
  mirror.SetIdentity();
  mirror[1][1] = -1.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    typename TImage::DirectionType one;
    one.SetIdentity();
    const unsigned int a = (axis + 1) % 3;
    const unsigned int b = (axis + 2) % 3;
    one[a][a] = c;
    one[b][b] = c;
    one[a][b] = -s;
    one[b][a] = s;
    turn = typename TImage::DirectionType(turn * one);
  }
  spacing[0] = 0.7;
  spacing[1] = 1.1;
  spacing[2] = 1.9;
  origin[0] = 12.0;
  origin[1] = -31.0;
  origin[2] = 5.5;
  image->SetRegions(size);
  image->SetDirection(typename TImage::DirectionType(turn * mirror));
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->Allocate();
  image->FillBuffer(typename TImage::PixelType{});
  return image;
}
} // namespace shapeton

#endif
