// Accuracy of the heat diffusion distances of edges (eight poles), compared with 500 eigenpairs and with columns of
// exp(-2t M^-1 L) by Chebyshev expansion, which needs no factorization.
#include "FlatteningTrial.h"
#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonDiffusionTime.h"
#include "shapetonHeatDiffusionMetric.h"

#include <array>
#include <cmath>

using namespace shapeton;

namespace
{
using EightColumns = Eigen::Matrix<double, Eigen::Dynamic, 8, Eigen::RowMajor>;

constexpr int mostFacesForPairs = 60000;

/** Coefficients of exp(-half (1 + s)) in Chebyshev polynomials of s in [-1, 1]. */
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

/** Applies exp(-2t A) to some columns, A = M^-1/2 L M^-1/2. */
EightColumns
ApplyExponential(const Eigen::SparseMatrix<double, Eigen::RowMajor> & A, double t, const EightColumns & start)
{
  double bound = 0.0; // bound of the largest eigenvalue, by Gershgorin
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
  EightColumns              product(start.rows(), 8);
  EightColumns              before = start;
  product.noalias() = A * before;
  EightColumns now = (2.0 / bound) * product - before;
  EightColumns sum = coefficients[0] * before + coefficients[1] * now;
  for (std::size_t k = 2; k < coefficients.size(); ++k)
  {
    product.noalias() = A * now;
    before = (4.0 / bound) * product - 2.0 * now - before;
    before.swap(now);
    sum += coefficients[k] * now;
  }
  return sum;
}

/** Largest relative error of the distances of random edges, four edges at a time. */
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
    EightColumns                start = EightColumns::Zero(A.rows(), 8);
    for (int i = 0; i < 4; ++i)
    {
      edges[i] = static_cast<Eigen::Index>(static_cast<double>(laplacian.edges.size()) *
                                           testsurfaces::colontube::Uniform(7, block, i));
      start(laplacian.edges[edges[i]][0], 2 * i) = scale[laplacian.edges[edges[i]][0]];
      start(laplacian.edges[edges[i]][1], 2 * i + 1) = scale[laplacian.edges[edges[i]][1]];
    }
    const EightColumns heat = ApplyExponential(A, metric.time, start);
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

/** Root mean square error against 500 eigenpairs, which suffice for surfaces of any size but take minutes for large
 * ones. */
double
ErrorAgainstPairs(const SurfaceLaplacian & laplacian, const HeatDiffusionMetric & metric)
{
  constexpr int pairs = 500;
  const auto    spectrum = ComputeSurfaceSpectrum(laplacian, pairs);
  return RelativeErrors(TruncatedHeatDiffusionMetric(laplacian, spectrum, metric.time, pairs).edgeLengths,
                        metric.edgeLengths)
    .rms;
}

void
AddRow(int faces, bool isQuick, ValidationReport & report, CsvTable & table)
{
  const double length = std::min(1500.0, 1500.0 * faces / 55000.0); // small tubes are short, so t matches their radius
  const TubeCase                  plain(GenerateTube(faces, 0, 1, 4, length));
  const SurfaceMesh &             mesh = plain.tube.mesh;
  const SurfaceLaplacian          laplacian = MakeSurfaceLaplacian(plain.connectivity, mesh.V);
  const HeatDiffusionMetricSolver solver(laplacian);
  const double                    h = plain.lengths.mean();
  const bool                      hasPairs = faces <= mostFacesForPairs;
  const double                    t = hasPairs ? 32.0 * h * h : DefaultDiffusionTime(h, plain.tube.narrowestRadius);
  const HeatDiffusionMetric       metric = solver.Compute(t);
  const double                    poles = RelativeErrors(metric.edgeLengths, solver.Compute(t, 8).edgeLengths).largest;
  const int                       blocks = isQuick ? 1 : 13;
  const double                    columns = ErrorAgainstColumns(laplacian, metric, blocks);
  const double                    pairs = hasPairs ? ErrorAgainstPairs(laplacian, metric) : 0.0;
  table.AddRow(Cells() << mesh.NumberOfFaces() << Rounded(t) << Rounded(t / (h * h))
                       << (hasPairs ? Rounded(pairs, 2) : "") << Rounded(poles, 2) << 8 * blocks << Rounded(columns, 2)
                       << report.Check(poles <= 1e-6 && columns <= 1e-6 && pairs <= 1e-5));
}
} // namespace

void
ValidateAccuracyOfMetric(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Colon-like tubes (`MakeColonTube()`). Edge lengths from " +
                 std::to_string(HeatDiffusionMetricSolver::defaultPoles) +
                 " poles are compared with three references; bounds apply to relative differences. 500 eigenpairs: "
                 "root mean square at most 1e-5. 8 poles: largest at most 1e-6. Columns of exp(-2t M^-1 L) at the ends "
                 "of random edges, by Chebyshev expansion without a factorization: largest at most 1e-6.");
  CsvTable table(Columns("faces | t, mm^2 | t / h^2 | against 500 eigenpairs, rms | against 8 poles, largest | "
                         "vertices of columns | against columns, largest | "));
  for (const int faces : settings.quick ? std::vector<int>{ 6000 } : std::vector<int>{ 12000, 55000, 200000, 1000000 })
  {
    AddRow(faces, settings.quick, report, table);
  }
  report.AddTable(table);
}
