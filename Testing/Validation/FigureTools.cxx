#include "FigureTools.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <queue>

using namespace shapeton;
using Eigen::Vector3d;

namespace
{
/** Arrival distance at c of a plane wave that reaches a and b of a triangle at the given distances; infinite if the
 * wave arrives from outside the triangle. */
double
WaveThrough(const Vector3d & a, const Vector3d & b, const Vector3d & c, double atA, double atB)
{
  // The source unfolded into the plane of the triangle: on the other side of ab, at these distances from a and b.
  const double base = (b - a).norm();
  const double x = (atA * atA - atB * atB + base * base) / (2.0 * base);
  const double square = atA * atA - x * x;
  if (square < 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Vector3d along = (b - a) / base;
  const double   cx = (c - a).dot(along);
  const double   cy = ((c - a) - cx * along).norm();
  const double   crossing = x + (cx - x) * std::sqrt(square) / (std::sqrt(square) + cy);
  return crossing < 0.0 || crossing > base ? std::numeric_limits<double>::infinity()
                                           : std::hypot(cx - x, cy + std::sqrt(square));
}
} // namespace

SurfaceRenderingOptions
ViewOf(const PictureSheet::Layout & layout)
{
  SurfaceRenderingOptions options;
  options.width = layout.width;
  options.height = layout.height;
  options.annotations = false;
  options.depthShading = 0.0;
  return options;
}

Eigen::VectorXd
GeodesicDistances(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, int source)
{
  using Front = std::pair<double, int>;
  const double      infinity = std::numeric_limits<double>::infinity();
  Eigen::VectorXd   distances = Eigen::VectorXd::Constant(mesh.NumberOfVertices(), infinity);
  std::vector<char> isDone(mesh.NumberOfVertices(), 0);
  std::priority_queue<Front, std::vector<Front>, std::greater<Front>> open;
  const auto at = [&](int vertex) -> Vector3d { return mesh.V.row(vertex); };
  const auto offer = [&](int vertex, double distance) {
    if (distance < distances[vertex])
    {
      distances[vertex] = distance;
      open.emplace(distance, vertex);
    }
  };
  offer(source, 0.0);
  while (!open.empty())
  {
    const int vertex = open.top().second;
    open.pop();
    if (isDone[vertex])
    {
      continue;
    }
    isDone[vertex] = 1;
    for (const int face : connectivity.FacesOfVertex(vertex))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int next = mesh.F(face, k);
        const int other = mesh.F(face, 0) + mesh.F(face, 1) + mesh.F(face, 2) - vertex - next;
        if (next != vertex && !isDone[next])
        {
          offer(next, distances[vertex] + (at(next) - at(vertex)).norm());
          if (isDone[other])
          {
            offer(next, WaveThrough(at(vertex), at(other), at(next), distances[vertex], distances[other]));
          }
        }
      }
    }
  }
  return distances;
}

CurveSet
WayDown(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const Eigen::VectorXd & distances, int from)
{
  std::vector<int> way{ from };
  for (bool goesOn = true; goesOn;)
  {
    int    next = way.back();
    double steepest = 0.0;
    for (const int vertex : connectivity.NeighborsOfVertex(way.back()))
    {
      const double slope =
        (distances[way.back()] - distances[vertex]) / (mesh.V.row(way.back()) - mesh.V.row(vertex)).norm();
      if (slope > steepest)
      {
        steepest = slope;
        next = vertex;
      }
    }
    goesOn = next != way.back();
    if (goesOn)
    {
      way.push_back(next);
    }
  }
  CurveSet curve;
  curve.V.resize(static_cast<Eigen::Index>(way.size()), 3);
  curve.curves.emplace_back();
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    curve.V.row(static_cast<Eigen::Index>(i)) = mesh.V.row(way[i]);
    curve.curves[0].push_back(static_cast<int>(i));
  }
  return curve;
}

Picture::Pointer
DrawValues(const SurfaceMesh &             mesh,
           const Eigen::VectorXd &         values,
           double                          lower,
           double                          upper,
           const SurfaceRenderingOptions & options,
           const CurveSet *                white)
{
  const ColorScale scale{ "", lower, upper, HeatColor };
  SurfaceScene     scene;
  SurfaceActor     actor;
  actor.surface = &mesh;
  actor.vertexColors = ColorsOf(values.data(), static_cast<std::size_t>(values.size()), scale);
  scene.surfaces.push_back(actor);
  if (white != nullptr)
  {
    CurveActor curve;
    curve.curves = white;
    curve.radius = 1.6;
    scene.curves.push_back(curve);
  }
  return RenderSurfaces(scene, options);
}

double
RelativeChange(const Eigen::VectorXd & a, const Eigen::VectorXd & b)
{
  return (a - b).norm() / a.norm();
}
