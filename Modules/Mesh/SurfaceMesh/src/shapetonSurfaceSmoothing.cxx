#include "shapetonSurfaceSmoothing.h"
#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"
#include "shapetonVertexNeighbors.h"

#include <Eigen/Core>

#include <algorithm>

namespace shapeton
{
namespace
{
// The pass band is 1 / ShrinkingStep + 1 / GrowingStep = 0.1, the default of VTK's windowed sinc filter.
constexpr double ShrinkingStep = 0.5;
constexpr double GrowingStep = -0.5263157894736842;

/** Vertices whose neighbors do not form a ring: boundary vertices and isolated ones. */
std::vector<char>
FixedVertices(const SurfaceMesh & mesh)
{
  // Around an interior vertex, each neighbor is the end of one edge and the start of another.
  std::vector<std::int64_t> balance(static_cast<std::size_t>(mesh.NumberOfVertices()), 0);
  std::vector<char>         isFixed(static_cast<std::size_t>(mesh.NumberOfVertices()), 1);
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::int64_t next = mesh.F(f, (k + 1) % 3);
      const std::int64_t last = mesh.F(f, (k + 2) % 3);
      balance[mesh.F(f, k)] += next - last;
      isFixed[mesh.F(f, k)] = 0;
    }
  }
  for (std::size_t i = 0; i < isFixed.size(); ++i)
  {
    isFixed[i] = isFixed[i] != 0 || balance[i] != 0 ? 1 : 0;
  }
  return isFixed;
}

Eigen::Vector3d
LimitedMove(const Eigen::Vector3d & move, const Eigen::Vector3d & normal, const SurfaceSmoothingOptions & options)
{
  const double    along = move.dot(normal);
  Eigen::Vector3d tangential = move - along * normal;
  const double    length = tangential.norm();
  if (length > options.tangentialLimit)
  {
    tangential *= options.tangentialLimit / length;
  }
  return tangential + std::clamp(along, -options.normalLimit, options.normalLimit) * normal;
}
} // namespace

SurfaceMesh
SmoothSurface(const SurfaceMesh & mesh, const SurfaceSmoothingOptions & options)
{
  RequireParameter(options.iterations >= 0 && options.normalLimit >= 0.0 && options.tangentialLimit >= 0.0,
                   "iterations and limits of smoothing must not be negative");
  RequireSound(mesh, "the surface");
  const VertexNeighbors neighbors(mesh);
  Interruption::Check();
  const VertexMatrix normals = VertexNormals(mesh.V, mesh.F);
  Interruption::Check();
  const std::vector<char> isFixed = FixedVertices(mesh);
  SurfaceMesh             result = mesh;
  VertexMatrix            moved = mesh.V;
  for (int step = 0; step < 2 * options.iterations; ++step)
  {
    const double weight = step % 2 == 0 ? ShrinkingStep : GrowingStep;
    ParallelForBlocks(static_cast<std::size_t>(mesh.NumberOfVertices()), [&](std::size_t i) {
      const auto v = static_cast<Eigen::Index>(i);
      if (isFixed[i] != 0)
      {
        return;
      }
      Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
      const IndexRange   ring = neighbors[static_cast<int>(i)];
      for (const int other : ring)
      {
        mean += result.V.row(other);
      }
      mean /= ring.size();
      const Eigen::RowVector3d target = result.V.row(v) + weight * (mean - result.V.row(v));
      moved.row(v) = mesh.V.row(v) + LimitedMove(target - mesh.V.row(v), normals.row(v), options).transpose();
    });
    result.V.swap(moved);
  }
  return result;
}
} // namespace shapeton
