#include "shapetonColonWall.h"
#include "shapetonCutDisc.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <sstream>

namespace shapeton
{
namespace
{
/** Length of the centerline used for the outward direction at an end, mm. */
constexpr double TangentLength = 10.0;

/** Difference of successive radii of discs, mm. */
constexpr double RadiusStep = 1.0;

struct Ray
{
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
};

Ray
RayAtEnd(const CurveSet & centerline, bool isRectum)
{
  std::vector<int> curve = centerline.curves.front();
  if (!isRectum)
  {
    std::reverse(curve.begin(), curve.end());
  }
  const Eigen::Vector3d end = centerline.V.row(curve.front());
  Eigen::Vector3d       way = Eigen::Vector3d::Zero();
  for (const int vertex : curve)
  {
    way = end - centerline.V.row(vertex).transpose();
    if (way.norm() >= TangentLength)
    {
      break;
    }
  }
  if (way.norm() == 0.0)
  {
    throw InputError("the centerline has zero length: all its points coincide");
  }
  return { end, way.normalized() };
}

/** Ray parameter of the intersection with a triangle; infinity if there is none (Moeller, Trumbore 1997). */
double
HitOfRay(const Ray & ray, const Eigen::Vector3d & a, const Eigen::Vector3d & b, const Eigen::Vector3d & c)
{
  const double          none = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d p = ray.direction.cross(c - a);
  const double          determinant = (b - a).dot(p);
  if (determinant == 0.0)
  {
    return none;
  }
  const Eigen::Vector3d s = ray.origin - a;
  const Eigen::Vector3d q = s.cross(b - a);
  const double          u = s.dot(p) / determinant;
  const double          v = ray.direction.dot(q) / determinant;
  const double          t = (c - a).dot(q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 ? t : none;
}

int
ClosestVertex(const SurfaceMesh & mesh, const Eigen::Vector3d & point)
{
  Eigen::Index closest = 0;
  (mesh.V.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&closest);
  return static_cast<int>(closest);
}

/** The vertex closest to the first intersection of the ray with the surface, or to its origin if there is none. */
int
PoleVertex(const SurfaceMesh & mesh, const Ray & ray)
{
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    best = std::min(best, HitOfRay(ray, mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)), mesh.V.row(mesh.F(f, 2))));
  }
  return ClosestVertex(mesh, std::isfinite(best) ? ray.origin + best * ray.direction : ray.origin);
}

double
LongestEdgeAt(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, int vertex)
{
  double longest = 0.0;
  for (const int other : connectivity.NeighborsOfVertex(vertex))
  {
    longest = std::max(longest, (mesh.V.row(other) - mesh.V.row(vertex)).norm());
  }
  return longest;
}

/** Radii to try, in this order: down to the minimum, then, on a surface with long edges, up to those of two rings. */
std::vector<double>
RadiiToTry(const OpenEndsOptions & options, double longestEdge)
{
  std::vector<double> radii;
  for (double radius = options.radius; radius >= options.leastRadius; radius -= RadiusStep)
  {
    radii.push_back(radius);
  }
  for (double radius = options.radius + RadiusStep; radius <= 2.0 * longestEdge; radius += RadiusStep)
  {
    radii.push_back(radius);
  }
  return radii;
}

/** The first valid disc around the pole. */
std::vector<int>
DiscAtEnd(const DiscCutter &          cutter,
          int                         pole,
          int                         otherPole,
          const std::vector<double> & radii,
          const char *                end,
          double &                    found)
{
  for (const double radius : radii)
  {
    std::vector<int> faces = cutter.FindDisc(pole, radius, otherPole);
    if (!faces.empty())
    {
      found = radius;
      return faces;
    }
  }
  std::ostringstream text;
  text << "the wall cannot be opened at the " << end << ": no geodesic disc of "
       << *std::min_element(radii.begin(), radii.end()) << " to " << *std::max_element(radii.begin(), radii.end())
       << " mm has one simple boundary";
  throw InputError(text.str());
}

SurfaceMesh
WithoutFaces(const SurfaceMesh & mesh, const std::vector<char> & isRemoved)
{
  std::vector<int> kept;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (isRemoved[f] == 0)
    {
      kept.push_back(f);
    }
  }
  return FacesOfSurface(mesh, kept);
}

double
DistanceOfLoop(const SurfaceMesh & mesh, const std::vector<int> & loop, const Eigen::Vector3d & point)
{
  double sum = 0.0;
  for (const int vertex : loop)
  {
    sum += (mesh.V.row(vertex).transpose() - point).norm();
  }
  return sum / static_cast<double>(loop.size());
}

void
RequireClosed(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  if (!connectivity.IsClosed() || connectivity.Components().size() != 1)
  {
    std::ostringstream text;
    text << "the wall cannot be opened: it must be one closed manifold surface, but has "
         << connectivity.Components().size() << " components and " << connectivity.BoundaryLoops().size()
         << " boundary loops among " << mesh.NumberOfFaces() << " faces";
    throw InputError(text.str());
  }
}
} // namespace

int
SetLoops(SurfaceMesh &               mesh,
         const SurfaceConnectivity & connectivity,
         const Eigen::Vector3d &     rectum,
         const Eigen::Vector3d &     cecum)
{
  const auto & loops = connectivity.BoundaryLoops();
  const auto & components = connectivity.Components();
  if (loops.size() != 2 || components.size() != 1 || !connectivity.IsManifold() || !components.front().genus)
  {
    std::ostringstream text;
    text << "the opened wall is not one manifold surface with two boundary loops: " << loops.size() << " loops, "
         << components.size() << " components";
    throw InputError(text.str());
  }
  const double straight = DistanceOfLoop(mesh, loops[0], rectum) + DistanceOfLoop(mesh, loops[1], cecum);
  const double crossed = DistanceOfLoop(mesh, loops[1], rectum) + DistanceOfLoop(mesh, loops[0], cecum);
  mesh.fieldArrays.erase(
    std::remove_if(mesh.fieldArrays.begin(),
                   mesh.fieldArrays.end(),
                   [](const SurfaceArray & array) { return array.name == "rectumLoop" || array.name == "cecumLoop"; }),
    mesh.fieldArrays.end());
  for (const bool isRectum : { true, false })
  {
    const auto & loop = loops[(straight <= crossed) == isRectum ? 0 : 1];
    SurfaceArray array{ isRectum ? "rectumLoop" : "cecumLoop", {}, true };
    array.values =
      Eigen::Map<const Eigen::VectorXi>(loop.data(), static_cast<Eigen::Index>(loop.size())).cast<double>();
    mesh.fieldArrays.push_back(array);
  }
  return *components.front().genus;
}

OpenWall
OpenColonEnds(const SurfaceMesh & closed, const CurveSet & centerline, const OpenEndsOptions & options)
{
  RequireParameter(options.leastRadius > 0.0 && options.radius >= options.leastRadius,
                   "the radius of open ends must be at least the minimum radius, which must be greater than 0 mm");
  RequireSound(centerline, "the centerline");
  RequireSound(closed, "the wall");
  const Ray rectum = RayAtEnd(centerline, true);
  const Ray cecum = RayAtEnd(centerline, false);

  DiscCutter cutter(closed);
  RequireClosed(closed, cutter.Connectivity());
  std::vector<char> isRemoved(static_cast<std::size_t>(closed.NumberOfFaces()), 0);
  OpenWall          result;
  const auto        remove = [&](const std::vector<int> & faces) {
    for (const int face : faces)
    {
      isRemoved[face] = 1;
    }
    cutter.Forbid(faces);
  };
  const int  rectumPole = PoleVertex(closed, rectum);
  const int  cecumPole = PoleVertex(closed, cecum);
  const auto radiiAt = [&](int pole) {
    return RadiiToTry(options, LongestEdgeAt(closed, cutter.Connectivity(), pole));
  };
  remove(DiscAtEnd(cutter, rectumPole, cecumPole, radiiAt(rectumPole), "rectum", result.rectumRadius));
  remove(DiscAtEnd(cutter, cecumPole, rectumPole, radiiAt(cecumPole), "cecum", result.cecumRadius));
  result.mesh = WithoutFaces(closed, isRemoved);
  const SurfaceConnectivity connectivity(result.mesh);
  result.genus = SetLoops(result.mesh, connectivity, rectum.origin, cecum.origin);
  if (options.smoothRims)
  {
    SmoothRims(result.mesh, connectivity);
  }
  return result;
}
} // namespace shapeton
