// Heat diffusion distances of all edges of colon-like tubes: exact, and from 50, 200 and 500 eigenpairs, in one run.
// The numbers of faces are arguments. What the exact distances are worth is measured against eight poles, against 500
// eigenpairs, and against columns of exp(-2t M^-1 L) by Chebyshev expansion, which needs no factorisation.
#include "itkColonTube.h"
#include "itkHeatDiffusionMetric.h"

#include "itkMultiThreaderBase.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace
{
using namespace itk;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 8, Eigen::RowMajor>;

constexpr int mostFacesForPairs = 60000;

class Stopwatch
{
public:
  double
  Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_Start).count();
  }

private:
  std::chrono::steady_clock::time_point m_Start{ std::chrono::steady_clock::now() };
};

double
PeakMegabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Errors
{
  double rms;
  double largest;
};

Errors
RelativeErrors(const Eigen::VectorXd & values, const Eigen::VectorXd & right)
{
  const Eigen::ArrayXd errors = (values - right).array() / right.array();
  return { std::sqrt(errors.square().mean()), errors.abs().maxCoeff() };
}

void
PrintBound(const char * text, double value, double asked)
{
  std::printf("  %-64s %10.3g   asked %g   %s\n", text, value, asked, value <= asked ? "met" : "NOT MET");
}

/** The coefficients of exp(-half (1 + s)) in Chebyshev polynomials of s in [-1, 1]. */
std::vector<double>
ChebyshevCoefficients(double half)
{
  const int           degree = 40 + static_cast<int>(9.0 * std::sqrt(half));
  const int           nodes = 2 * degree;
  const double        step = testsurfaces::colontube::pi / nodes;
  std::vector<double> coefficients(degree + 1, 0.0);
  for (int k = 0; k <= degree; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      const double angle = (j + 0.5) * step;
      coefficients[k] += (k == 0 ? 1.0 : 2.0) / nodes * std::exp(-half * (1.0 + std::cos(angle))) * std::cos(k * angle);
    }
  }
  return coefficients;
}

/** exp(-2t A) on some columns, A = M^-1/2 L M^-1/2. */
Columns
ApplyExponential(const Eigen::SparseMatrix<double, Eigen::RowMajor> & A, double t, const Columns & start)
{
  double bound = 0.0; // of the largest eigenvalue, by Gershgorin
  for (Eigen::Index row = 0; row < A.rows(); ++row)
  {
    double sum = 0.0;
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator element(A, row); element; ++element)
    {
      sum += std::abs(element.value());
    }
    bound = std::max(bound, sum);
  }
  const std::vector<double> coefficients = ChebyshevCoefficients(t * bound);
  Columns                   product(start.rows(), 8);
  Columns                   before = start;
  product.noalias() = A * before;
  Columns now = (2.0 / bound) * product - before;
  Columns sum = coefficients[0] * before + coefficients[1] * now;
  for (std::size_t k = 2; k < coefficients.size(); ++k)
  {
    product.noalias() = A * now;
    before = (4.0 / bound) * product - 2.0 * now - before;
    before.swap(now);
    sum += coefficients[k] * now;
  }
  return sum;
}

/** The largest relative error of the distances of random edges, four edges at a time. */
double
ErrorAgainstColumns(const SurfaceLaplacian & laplacian, const HeatDiffusionMetric & metric, int blocks)
{
  const Eigen::VectorXd                        scale = laplacian.mass.cwiseSqrt().cwiseInverse();
  Eigen::SparseMatrix<double, Eigen::RowMajor> A = StiffnessMatrix(laplacian);
  A = scale.asDiagonal() * A * scale.asDiagonal();
  double largest = 0.0;
  for (int block = 0; block < blocks; ++block)
  {
    std::array<Eigen::Index, 4> edges;
    Columns                     start = Columns::Zero(A.rows(), 8);
    for (int i = 0; i < 4; ++i)
    {
      edges[i] = static_cast<Eigen::Index>(static_cast<double>(laplacian.edges.size()) *
                                           testsurfaces::colontube::Uniform(7, block, i));
      start(laplacian.edges[edges[i]][0], 2 * i) = scale[laplacian.edges[edges[i]][0]];
      start(laplacian.edges[edges[i]][1], 2 * i + 1) = scale[laplacian.edges[edges[i]][1]];
    }
    const Columns heat = ApplyExponential(A, metric.time, start);
    for (int i = 0; i < 4; ++i)
    {
      const auto & [p, q] = laplacian.edges[edges[i]];
      const double square =
        scale[p] * (heat(p, 2 * i) - heat(p, 2 * i + 1)) + scale[q] * (heat(q, 2 * i + 1) - heat(q, 2 * i));
      largest = std::max(largest, std::abs(metric.edgeLengths[edges[i]] / std::sqrt(square) - 1.0));
    }
  }
  return largest;
}

void
CompareWithPairs(const SurfaceLaplacian & laplacian, const HeatDiffusionMetric & metric, double exactSeconds)
{
  for (const int pairs : { 50, 200, 500 })
  {
    const Stopwatch       watch;
    const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, pairs);
    const auto            truncated = TruncatedHeatDiffusionMetric(laplacian, spectrum, metric.time, pairs);
    const double          seconds = watch.Seconds();
    const Errors          errors = RelativeErrors(truncated.edgeLengths, metric.edgeLengths);
    std::printf("  %d eigenpairs: %.2f s, relative difference rms %.2g, largest %.2g, last lambda t %.1f\n",
                pairs,
                seconds,
                errors.rms,
                errors.largest,
                spectrum.eigenvalues[pairs - 1] * metric.time);
    if (pairs == 500)
    {
      PrintBound("exact against 500 eigenpairs, relative rms", errors.rms, 1e-5);
    }
    else
    {
      PrintBound(pairs == 50 ? "time of exact / time of 50 eigenpairs" : "time of exact / time of 200 eigenpairs",
                 exactSeconds / seconds,
                 pairs == 50 ? 2.0 : 0.25);
    }
  }
}

void
Run(int faces)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = faces;
  options.length = std::min(1500.0, 1500.0 * faces / 55000.0); // small ones are short, so that t serves their radius
  const auto                tube = testsurfaces::MakeColonTube(options);
  const SurfaceConnectivity connectivity(tube.mesh);
  const SurfaceLaplacian    laplacian = MakeSurfaceLaplacian(connectivity, tube.mesh.V);
  const Eigen::VectorXd     lengths = EdgeLengths(connectivity, tube.mesh.V);
  const bool                hasPairs = faces <= mostFacesForPairs;
  const double              t =
    hasPairs ? 32.0 * std::pow(lengths.mean(), 2) : DefaultDiffusionTime(connectivity, lengths, tube.narrowestRadius);

  const Stopwatch                 setUp;
  const HeatDiffusionMetricSolver solver(laplacian);
  const double                    setUpSeconds = setUp.Seconds();
  const Stopwatch                 computation;
  const HeatDiffusionMetric       metric = solver.Compute(t);
  const double                    seconds = computation.Seconds();
  std::printf("\n%d faces, t = %.1f mm^2 = %.1f h^2, %u threads\n",
              tube.mesh.NumberOfFaces(),
              t,
              t / std::pow(lengths.mean(), 2),
              MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  std::printf(
    "  order and symbolic analysis %.3f s, %d poles %.3f s; factor %.1f million, %.2f billion products for each "
    "pole; peak %.0f MB\n",
    setUpSeconds,
    HeatDiffusionMetricSolver::defaultPoles,
    seconds,
    1e-6 * static_cast<double>(solver.Inversion().FactorElements()),
    1e-9 * solver.Inversion().Products(),
    PeakMegabytes());
  PrintBound("exact against 8 poles, largest relative error",
             RelativeErrors(metric.edgeLengths, solver.Compute(t, 8).edgeLengths).largest,
             1e-6);
  const int blocks = faces > 300000 ? 1 : 13;
  std::printf("  columns of %d vertices:\n", 8 * blocks);
  PrintBound("exact against columns of the exponential, largest relative error",
             ErrorAgainstColumns(laplacian, metric, blocks),
             1e-6);
  if (hasPairs)
  {
    CompareWithPairs(laplacian, metric, setUpSeconds + seconds);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  std::vector<int> faces;
  for (int i = 1; i < argc; ++i)
  {
    faces.push_back(std::atoi(argv[i]));
    if (faces.back() < 2000)
    {
      std::fprintf(stderr, "usage: %s [NUMBER OF FACES >= 2000]...\n", argv[0]);
      return 2;
    }
  }
  for (const int number : faces.empty() ? std::vector<int>{ 12000, 55000, 200000, 1000000 } : faces)
  {
    Run(number);
  }
  return 0;
}
