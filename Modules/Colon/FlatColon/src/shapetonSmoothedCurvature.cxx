#include "shapetonSmoothedCurvature.h"

#include "shapetonSurfaceDiffusion.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shapeton
{
namespace
{
/** 1/mm, the curvature of a ball with a radius of 1 mm. Higher values are mesh defects, such as needles. */
constexpr double greatestCurvature = 1.0;

void
ClearBoundary(const SurfaceConnectivity & connectivity, Eigen::VectorXd & values)
{
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    if (connectivity.IsBoundaryEdge(edge))
    {
      for (const int vertex : connectivity.VerticesOfEdge(edge))
      {
        values[vertex] = 0.0;
      }
    }
  }
}
} // namespace

Eigen::VectorXd
SmoothedMeanCurvature(const VertexMatrix & V, const FaceMatrix & F, double time, CurvatureUnit unit)
{
  RequireParameter(time >= 0.0 && std::isfinite(time), "the smoothing time of the curvature must not be negative");
  const SurfaceConnectivity         connectivity(F, static_cast<int>(V.rows()));
  const SurfaceLaplacian            laplacian = MakeSurfaceLaplacian(connectivity, EdgeLengths(connectivity, V));
  const Eigen::SparseMatrix<double> stiffness = StiffnessMatrix(laplacian);
  // Degenerate faces are treated as needles. L V = -2 H M n with outward n: L V points inward where the surface bulges
  // inward.
  Eigen::VectorXd      values = -(stiffness * V).cwiseProduct(VertexNormals(V, F)).rowwise().sum();
  const Eigen::ArrayXd area = laplacian.mass.array().max(1e-12);
  const Eigen::ArrayXd curvature = (0.5 * values.array() / area).max(-greatestCurvature).min(greatestCurvature);
  values = unit == CurvatureUnit::PerArea ? curvature : (-2.0 * curvature * area).eval();
  ClearBoundary(connectivity, values);
  Eigen::MatrixXd smoothed = values;
  DiffuseOverSurface(laplacian, time, smoothed);
  return smoothed;
}
} // namespace shapeton
