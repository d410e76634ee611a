#include "shapetonEndoscope.h"

#include "shapetonParallelFor.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr double nearestEye = 15.0;   // mm
constexpr double farthestEye = 60.0;  // mm
constexpr double bestDistance = 25.0; // mm; chosen by eye

/** Whether the line between two points is unobstructed; `to` may touch the wall. Steps are no longer than the distance
 * to the wall. */
bool
IsFree(const SurfaceLocator & wall, const Vector3d & from, const Vector3d & to)
{
  constexpr double touch = 0.3; // mm
  const double     length = (to - from).norm();
  const double     last = std::min(2.0, 0.3 * length); // mm before the end
  double           way = 0.0;
  while (way < length - last)
  {
    const double distance = wall.FindClosest(from + way / length * (to - from)).distance;
    if (distance < touch)
    {
      return false;
    }
    way += distance;
  }
  return true;
}

/** Penalty relative to a perpendicular view from the best distance. */
double
CostOf(const Vector3d & eye, const PolypCandidate & candidate)
{
  constexpr double costOfSlant = 1.5; // relative to that of a distance that is wrong by a factor of e
  const Vector3d   way = eye - candidate.apex;
  const double     facing = way.normalized().dot(candidate.axis);
  return std::abs(std::log(way.norm() / bestDistance)) + costOfSlant * (1.0 - facing);
}

/** Places for the eye, best first: points of the centerline, then points above the head, farthest first. */
std::vector<Vector3d>
PlacesOfEye(const CurveSet & centerline, const PolypCandidate & candidate)
{
  std::vector<std::pair<double, Eigen::Index>> onLine;
  for (Eigen::Index i = 0; i < centerline.V.rows(); ++i)
  {
    const Vector3d eye = centerline.V.row(i).transpose();
    const double   distance = (eye - candidate.apex).norm();
    if (distance >= nearestEye && distance <= farthestEye)
    {
      onLine.emplace_back(CostOf(eye, candidate), i);
    }
  }
  std::sort(onLine.begin(), onLine.end());
  std::vector<Vector3d> places;
  for (const auto & place : onLine)
  {
    places.emplace_back(centerline.V.row(place.second).transpose());
  }
  // Pouches are visible only from within.
  constexpr int    around = 8;
  constexpr double tilt = 0.7; // tangent of 35 degrees
  const Vector3d   side = candidate.axis.unitOrthogonal();
  for (const double distance : { 25.0, 20.0, 15.0, 10.0, 6.0, 4.0, 3.0 }) // mm
  {
    places.emplace_back(candidate.apex + distance * candidate.axis);
    for (int i = 0; i < around; ++i)
    {
      const Vector3d sideways = Eigen::AngleAxisd(TwoPi * i / around, candidate.axis) * side;
      places.emplace_back(candidate.apex + distance * (candidate.axis + tilt * sideways).normalized());
    }
  }
  return places;
}

/** Field of view (degrees) in which a head takes a fifth to a half of the picture. */
double
FieldOfView(const PolypCandidate & candidate, double distance)
{
  constexpr double narrowest = 30.0, widest = 70.0;
  constexpr double timesHead = 4.0;
  const double     width = timesHead * std::max(candidate.diameter, candidate.height);
  const double     degrees = 2.0 * std::atan(0.5 * width / distance) * 180.0 / Pi;
  return std::clamp(degrees, narrowest, widest);
}
/** Fraction of the surface of a head that is visible from a point. */
double
VisibleShareOfHead(const SurfaceMesh &    wall,
                   const VertexMatrix &   inwardNormals,
                   const SurfaceLocator & locator,
                   const PolypCandidate & candidate,
                   const Vector3d &       eye)
{
  constexpr std::size_t samples = 60;
  const std::size_t     step = std::max<std::size_t>(1, candidate.vertices.size() / samples);
  int                   all = 0, visible = 0;
  for (std::size_t i = 0; i < candidate.vertices.size(); i += step)
  {
    ++all;
    const int      vertex = candidate.vertices[i];
    const Vector3d point = wall.V.row(vertex).transpose();
    const bool     isFacing = inwardNormals.row(vertex).dot(eye - point) > 0.0;
    visible += isFacing && IsFree(locator, eye, point) ? 1 : 0;
  }
  return all > 0 ? static_cast<double>(visible) / all : 0.0;
}
} // namespace

PerspectiveCamera
ChooseEye(const SurfaceMesh &    wall,
          const VertexMatrix &   inwardNormals,
          const SurfaceLocator & locator,
          const CurveSet &       centerline,
          const PolypCandidate & candidate)
{
  constexpr double  enough = 0.4;         // of the head, whose other side is never visible
  constexpr double  nearlyVertical = 0.9; // cosine of the view and the direction to the head
  PerspectiveCamera camera;
  double            greatest = -1.0;
  for (const Vector3d & place : PlacesOfEye(centerline, candidate))
  {
    const double share = VisibleShareOfHead(wall, inwardNormals, locator, candidate, place);
    if (share > greatest)
    {
      greatest = share;
      camera.eye = place;
    }
    if (share >= enough)
    {
      break;
    }
  }
  camera.focus = candidate.position;
  camera.fieldOfView = FieldOfView(candidate, (camera.focus - camera.eye).norm());
  const Vector3d look = (camera.focus - camera.eye).normalized();
  camera.up =
    std::abs(look.z()) < nearlyVertical ? Vector3d::UnitZ() : Vector3d(-Vector3d::UnitY()); // head up, or anterior up
  return camera;
}

VertexMatrix
InwardNormalsOf(const SurfaceMesh & wall)
{
  VertexMatrix normals = VertexMatrix::Zero(wall.V.rows(), 3);
  for (Eigen::Index face = 0; face < wall.F.rows(); ++face)
  {
    const Vector3d a = wall.V.row(wall.F(face, 0)), b = wall.V.row(wall.F(face, 1)), c = wall.V.row(wall.F(face, 2));
    const Vector3d outwards = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k)
    {
      normals.row(wall.F(face, k)) -= outwards;
    }
  }
  normals.rowwise().normalize();
  return normals;
}

SurfaceMesh
WallAround(const SurfaceMesh & wall, const Vector3d & point, double reach)
{
  std::vector<char> isNear(wall.V.rows());
  ParallelForBlocks(isNear.size(), [&](std::size_t i) {
    const auto vertex = static_cast<Eigen::Index>(i);
    isNear[i] = (wall.V.row(vertex).transpose() - point).squaredNorm() < reach * reach ? 1 : 0;
  });
  std::vector<int> faces;
  for (int face = 0; face < wall.NumberOfFaces(); ++face)
  {
    if (isNear[wall.F(face, 0)] != 0 || isNear[wall.F(face, 1)] != 0 || isNear[wall.F(face, 2)] != 0)
    {
      faces.push_back(face);
    }
  }
  return FacesOfSurface(wall, faces);
}
} // namespace shapeton
