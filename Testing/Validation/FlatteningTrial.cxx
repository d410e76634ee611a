#include "FlatteningTrial.h"

#include "shapetonHeatDiffusionMetric.h"
#include "shapetonSurfaceSimplification.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

using namespace shapeton;

TubeCase::TubeCase(const testsurfaces::ColonTube & generated)
  : tube(generated)
  , connectivity(tube.mesh)
  , ends(FindTubeEnds(tube.mesh, connectivity, "the tube"))
  , lengths(EdgeLengths(connectivity, tube.mesh.V))
{}

TubeMap
TubeCase::Flatten(const Eigen::VectorXd & metric) const
{
  return FlattenTube(tube.mesh, connectivity, metric, ends);
}

Eigen::VectorXd
TubeCase::Diffused(double t) const
{
  return ComputeHeatDiffusionMetric(tube.mesh, t).edgeLengths;
}

FlatDistortion
TubeCase::Distortion(const TubeMap & map, const Eigen::VectorXd & metric) const
{
  return MeasureFlatDistortion(map.flat.F, FlatCoordinates(map.flat, "the map"), SidesOfFaces(connectivity, metric));
}

testsurfaces::ColonTube
GenerateTube(int faces, int handles, int seed, int span, double length)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = faces;
  options.handles = handles;
  options.seed = seed;
  options.handleSpan = span;
  options.length = length;
  return testsurfaces::MakeColonTube(options);
}

testsurfaces::ColonTube
GenerateDecimatedTube(int handles, int seed)
{
  SurfaceSimplificationSettings options;
  options.faces = 55000;
  testsurfaces::ColonTube tube = GenerateTube(1000000, handles, seed);
  tube.mesh = SimplifySurface(tube.mesh, options);
  return tube;
}

std::vector<SurfaceHandle>
TrueHandles(const testsurfaces::ColonTube & tube)
{
  std::vector<SurfaceHandle> handles;
  for (const auto & vertices : tube.handles)
  {
    SurfaceHandle handle;
    handle.vertices.assign(vertices.begin(), vertices.end());
    for (const int v : vertices)
    {
      handle.place += tube.mesh.V.row(v).transpose() / 6.0;
    }
    handles.push_back(handle);
  }
  return handles;
}

int
LocatedHandles(const std::vector<SurfaceHandle> & found, std::vector<SurfaceHandle> truth, double distance)
{
  int located = 0;
  for (const SurfaceHandle & handle : found)
  {
    const auto near = std::find_if(truth.begin(), truth.end(), [&](const SurfaceHandle & other) {
      return (other.place - handle.place).norm() < distance;
    });
    if (near != truth.end())
    {
      truth.erase(near);
      ++located;
    }
  }
  return located;
}

namespace
{
/** Sums of face normals around each vertex, outward, not normalized. */
VertexMatrix
OutwardNormals(const SurfaceMesh & mesh)
{
  VertexMatrix normals = VertexMatrix::Zero(mesh.V.rows(), 3);
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)), c = mesh.V.row(mesh.F(f, 2));
    for (int k = 0; k < 3; ++k)
    {
      normals.row(mesh.F(f, k)) += (b - a).cross(c - a).transpose();
    }
  }
  return normals;
}

/** Moves the wall inward by up to 0.8 of the radius, with a squared cosine profile. */
void
AddBump(const VertexMatrix &       before,
        int                        center,
        const Eigen::RowVector3d & inwards,
        double                     radius,
        VertexMatrix &             after)
{
  for (Eigen::Index v = 0; v < before.rows(); ++v)
  {
    const Eigen::RowVector3d away = before.row(v) - before.row(center);
    const double             across = (away - away.dot(inwards) * inwards).norm() / radius;
    if (away.norm() < 2.0 * radius && across < 1.0)
    {
      after.row(v) += 0.8 * radius * std::pow(std::cos(0.5 * testsurfaces::colontube::pi * across), 2) * inwards;
    }
  }
}
} // namespace

PolypTube
GenerateTubeWithPolyps(int faces, int seed, double length, double radius)
{
  PolypTube          result{ GenerateTube(faces, 0, seed, 4, length), {} };
  SurfaceMesh &      mesh = result.tube.mesh;
  const VertexMatrix before = mesh.V;
  const VertexMatrix normals = OutwardNormals(mesh);
  constexpr int      number = 20;
  for (int i = 0; i < number; ++i)
  {
    const int center = static_cast<int>(static_cast<double>(before.rows()) * (i + 1.0 + 0.37 * seed) / (number + 3.0));
    AddBump(before, center, -normals.row(center).normalized(), radius, mesh.V);
    result.polyps.emplace_back();
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      if ((before.row(mesh.F(f, 0)) - before.row(center)).norm() < radius)
      {
        result.polyps.back().push_back(f);
      }
    }
  }
  return result;
}

double
AspectRatioOnMap(const SurfaceMesh & flat, const std::vector<int> & faces)
{
  const Eigen::MatrixX2d uv = FlatCoordinates(flat, "the map");
  const double           period = FlatCircumference(flat, "the map");
  const double           reference = uv(flat.F(faces.front(), 0), 1);
  Eigen::Vector2d        first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d        second = Eigen::Matrix2d::Zero();
  double                 sum = 0.0;
  for (const int f : faces)
  {
    const Eigen::RowVector2d a = uv.row(flat.F(f, 0)), b = uv.row(flat.F(f, 1)), c = uv.row(flat.F(f, 2));
    const double             area = std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
    Eigen::Vector2d          center = (a + b + c).transpose() / 3.0;
    center[1] -= period * std::round((center[1] - reference) / period);
    first += area * center;
    second += area * center * center.transpose();
    sum += area;
  }
  const Eigen::Matrix2d covariance = second / sum - first * first.transpose() / (sum * sum);
  const Eigen::Vector2d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues();
  return std::sqrt(axes[1] / axes[0]);
}
