#include "shapetonHeatDiffusionMetric.h"

#include "shapetonExponentialPoles.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Below this fraction of H_pp + H_qq a difference has no valid digits. */
constexpr double rounding = 1e-12;
/** Allowed fraction of such edges. Sound surfaces have some such edges at needle tips; a larger fraction means that the
 * time is too long. */
constexpr double mostOfDrowned = 1e-3;

void
RequireFewDrowned(const HeatDiffusionMetric & metric)
{
  const Eigen::Index edges = metric.edgeLengths.size();
  if (metric.drownedEdges > mostOfDrowned * static_cast<double>(edges))
  {
    throw InputError("the diffusion distances of " + std::to_string(metric.drownedEdges) + " of " +
                     std::to_string(edges) +
                     " edges are lost to rounding; use a shorter time, eigenpairs, or remesh the surface");
  }
}

/** Edge distances from elements of the heat kernel at twice the time. \equation{5.4} for the squared distance; the
 * source states it for the distance, which contradicts (5.5). */
HeatDiffusionMetric
MetricOf(const SurfaceLaplacian & laplacian, const Eigen::VectorXd & diagonal, const Eigen::VectorXd & offDiagonal)
{
  const Eigen::Index  edges = offDiagonal.size();
  HeatDiffusionMetric metric;
  metric.edgeLengths.resize(edges);
  for (Eigen::Index edge = 0; edge < edges; ++edge)
  {
    const double sum = diagonal[laplacian.edges[edge][0]] + diagonal[laplacian.edges[edge][1]];
    const double square = sum - 2.0 * offDiagonal[edge];
    const double least = rounding * sum;
    metric.drownedEdges += square > least ? 0 : 1;
    metric.edgeLengths[edge] = std::sqrt(std::max(square, least));
  }
  RequireFewDrowned(metric);
  return metric;
}
} // namespace

HeatDiffusionMetricSolver::HeatDiffusionMetricSolver(SurfaceLaplacian laplacian)
  : m_Laplacian(std::move(laplacian))
  , m_Diagonal(StiffnessDiagonal(m_Laplacian))
  , m_Inversion(
      SymbolicFactorization(m_Laplacian.NumberOfVertices(), m_Laplacian.edges, EliminationOrder::NestedDissection))
{}

HeatDiffusionMetric
HeatDiffusionMetricSolver::Compute(double t, int poles, int atOnce, const Progress & progress) const
{
  RequireDiffusionTime(t);
  if (poles < leastPoles || poles > mostPoles)
  {
    throw InputError("the number of poles must be " + std::to_string(leastPoles) + " to " + std::to_string(mostPoles) +
                     ", not " + std::to_string(poles));
  }
  const ExponentialPoles & rational = GetExponentialPoles(poles);
  Eigen::VectorXd          diagonal = Eigen::VectorXd::Zero(m_Diagonal.size());
  Eigen::VectorXd          offDiagonal = Eigen::VectorXd::Zero(m_Laplacian.weights.size());
  m_Inversion.InvertAll(
    poles,
    [&](int i) {
      const std::complex<double> pole = rational.terms[i].pole;
      return SymmetricElements{ pole * m_Laplacian.mass + 2.0 * t * m_Diagonal,
                                (-2.0 * t * m_Laplacian.weights).cast<std::complex<double>>() };
    },
    [&](int i, const SymmetricElements & inverse) {
      diagonal += (rational.terms[i].residue * inverse.diagonal).real();
      offDiagonal += (rational.terms[i].residue * inverse.offDiagonal).real();
    },
    atOnce,
    progress);
  HeatDiffusionMetric metric = MetricOf(m_Laplacian, diagonal, offDiagonal);
  metric.time = t;
  metric.rationalError = rational.error;
  return metric;
}

HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceMesh & mesh, double t, const Progress & progress)
{
  RequireDiffusionTime(t);
  RequireSound(mesh, "the surface");
  progress(0.0);
  const SurfaceConnectivity connectivity(mesh);
  RequireOneManifold(connectivity, "the surface");
  progress(0.05);
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(connectivity, mesh.V);
  return ComputeHeatDiffusionMetric(connectivity, laplacian, t, progress.Part("", 0.1, 1.0));
}

HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceConnectivity & connectivity,
                           const SurfaceLaplacian &    laplacian,
                           double                      t,
                           const Progress &            progress)
{
  using Solver = HeatDiffusionMetricSolver;
  constexpr int atOnce = 2;
  progress(0.0);
  const Solver        solver(laplacian);
  HeatDiffusionMetric metric = solver.Compute(t, Solver::defaultPoles, atOnce, progress.Part("", 0.3, 0.9));
  if (!AreTriangles(connectivity, metric.edgeLengths))
  {
    metric = solver.Compute(t, Solver::mostPoles, atOnce, progress.Part("", 0.9, 1.0));
    metric.drownedEdges += static_cast<int>(LengthenShortestSides(connectivity, metric.edgeLengths).size());
    RequireFewDrowned(metric);
  }
  progress(1.0);
  return metric;
}

HeatDiffusionMetric
TruncatedHeatDiffusionMetric(const SurfaceLaplacian & laplacian, const SurfaceSpectrum & spectrum, double t, int pairs)
{
  RequireDiffusionTime(t);
  if (pairs < 2 || pairs > spectrum.NumberOfPairs())
  {
    throw InputError("the number of eigenpairs must be 2 to " + std::to_string(spectrum.NumberOfPairs()) + ", not " +
                     std::to_string(pairs));
  }
  const auto      edges = static_cast<Eigen::Index>(laplacian.edges.size());
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(edges);
  for (int i = 1; i < pairs; ++i) // the first one is constant
  {
    const double decay = std::exp(-2.0 * t * spectrum.eigenvalues[i]);
    const auto   function = spectrum.eigenfunctions.col(i);
    for (Eigen::Index edge = 0; edge < edges; ++edge)
    {
      const double step = function[laplacian.edges[edge][0]] - function[laplacian.edges[edge][1]];
      squares[edge] += decay * step * step;
    }
  }
  return { squares.cwiseSqrt(), t, pairs };
}
} // namespace shapeton
