#include "shapetonCutDisc.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    Rounds = 10;      // chosen: bounds the smoothing
constexpr double SoundAngle = 0.4; // radians, about 23 degrees; chosen

/** Quality of the faces around a vertex. */
struct Fan
{
  double                       smallestAngle{ 4.0 };
  std::vector<Eigen::Vector3d> normals;
};

double
SmallestAngle(const std::array<Eigen::Vector3d, 3> & p)
{
  double smallest = 4.0;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d a = p[(k + 1) % 3] - p[k];
    const Eigen::Vector3d b = p[(k + 2) % 3] - p[k];
    smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return smallest;
}

Fan
FanOf(const SurfaceMesh & mesh, const IndexRange & faces)
{
  Fan fan;
  for (const int face : faces)
  {
    const std::array<Eigen::Vector3d, 3> p{ mesh.V.row(mesh.F(face, 0)).transpose(),
                                            mesh.V.row(mesh.F(face, 1)).transpose(),
                                            mesh.V.row(mesh.F(face, 2)).transpose() };
    fan.smallestAngle = std::min(fan.smallestAngle, SmallestAngle(p));
    fan.normals.emplace_back((p[1] - p[0]).cross(p[2] - p[0]).normalized());
  }
  return fan;
}

bool
IsAsGood(const Fan & after, const Fan & before)
{
  bool isGood = after.smallestAngle >= std::min(before.smallestAngle, SoundAngle);
  for (std::size_t i = 0; i < before.normals.size(); ++i)
  {
    isGood = isGood && after.normals[i].dot(before.normals[i]) > 0.5;
  }
  return isGood;
}

void
SmoothLoop(SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::vector<int> & loop)
{
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Eigen::RowVector3d old = mesh.V.row(loop[i]);
    const IndexRange         faces = connectivity.FacesOfVertex(loop[i]);
    const Fan                before = FanOf(mesh, faces);
    mesh.V.row(loop[i]) = 0.5 * old + 0.25 * (mesh.V.row(loop[(i + 1) % n]) + mesh.V.row(loop[(i + n - 1) % n]));
    if (!IsAsGood(FanOf(mesh, faces), before))
    {
      mesh.V.row(loop[i]) = old;
    }
  }
}
} // namespace

void
SmoothRims(SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  for (int round = 0; round < Rounds; ++round)
  {
    for (const auto & loop : connectivity.BoundaryLoops())
    {
      SmoothLoop(mesh, connectivity, loop);
    }
  }
}
} // namespace shapeton
