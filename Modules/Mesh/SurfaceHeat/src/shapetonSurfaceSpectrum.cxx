#include "shapetonSurfaceSpectrum.h"

#include "shapetonExceptions.h"
#include "shapetonOpenEndedProgress.h"
#include "shapetonPi.h"
#include "shapetonSparseCholesky.h"

#include <Eigen/Dense>
#include <Spectra/SymEigsShiftSolver.h>

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** A dense decomposition is faster below this size. */
constexpr int fewVertices = 300;

/** Pairs of M^-1/2 L M^-1/2. */
struct SymmetricPairs
{
  std::vector<double>          values;
  std::vector<Eigen::VectorXd> vectors;

  /** Eigenvalues, ascending. */
  void
  Sort()
  {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    SymmetricPairs sorted;
    for (const std::size_t i : order)
    {
      sorted.values.push_back(values[i]);
      sorted.vectors.push_back(std::move(vectors[i]));
    }
    *this = std::move(sorted);
  }
};

/** Inverse of M^-1/2 L M^-1/2 + shift in the interface of Spectra, on the complement of the computed pairs. */
class ShiftedInverse
{
public:
  using Scalar = double;

  /** \param steps notified of each vector that the inverse is applied to. */
  ShiftedInverse(const SurfaceLaplacian &      laplacian,
                 const SymbolicFactorization & symbolic,
                 double                        shift,
                 OpenEndedProgress &           steps)
    : m_RootMass(laplacian.mass.cwiseSqrt()), m_Shift(shift), m_Factor(symbolic), m_Steps(steps)
  {
    if (!m_Factor.Factorize(
          StiffnessDiagonal(laplacian) + shift * laplacian.mass, -laplacian.weights, steps.NextStep()))
    {
      throw InputError("the stiffness matrix of the surface cannot be factorized; repair or remesh the surface");
    }
  }
  void
  LeaveOut(const SymmetricPairs & known)
  {
    m_Known = &known;
  }
  Eigen::Index
  rows() const
  {
    return m_RootMass.size();
  }
  Eigen::Index
  cols() const
  {
    return m_RootMass.size();
  }
  void
  set_shift(double)
  {
    // The matrix was factorized with its shift.
  }
  void
  perform_op(const double * from, double * to) const
  {
    const Eigen::Map<const Eigen::VectorXd> x(from, m_RootMass.size());
    Eigen::Map<Eigen::VectorXd>             y(to, m_RootMass.size());
    y = m_RootMass.cwiseProduct(x);
    m_Factor.SolveInPlace(y);
    y = y.cwiseProduct(m_RootMass);
    for (std::size_t i = 0; m_Known && i < m_Known->values.size(); ++i)
    {
      y -= m_Known->vectors[i].dot(x) / (m_Known->values[i] + m_Shift) * m_Known->vectors[i];
    }
    m_Steps.Step();
  }

private:
  Eigen::VectorXd        m_RootMass;
  double                 m_Shift;
  SparseCholesky         m_Factor;
  OpenEndedProgress &    m_Steps;
  const SymmetricPairs * m_Known{ nullptr };
};

SymmetricPairs
DensePairs(const SurfaceLaplacian & laplacian, int pairs)
{
  const Eigen::VectorXd scale = laplacian.mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd matrix = scale.asDiagonal() * Eigen::MatrixXd(StiffnessMatrix(laplacian)) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  SymmetricPairs                                       found;
  for (int i = 0; i < pairs; ++i)
  {
    found.values.push_back(solver.eigenvalues()[i]);
    found.vectors.push_back(solver.eigenvectors().col(i));
  }
  return found;
}

/** By Weyl's law the mean spacing of the eigenvalues is 4 pi / area. */
double
EigenvalueStep(const SurfaceLaplacian & laplacian)
{
  return 4.0 * Pi / laplacian.mass.sum();
}

/** Adds the smallest unknown pairs. */
void
AddPairs(ShiftedInverse &               inverse,
         double                         shift,
         int                            pairs,
         const SurfaceSpectrumOptions & options,
         SymmetricPairs &               known)
{
  const int subspace = std::min(static_cast<int>(inverse.rows()), std::max(2 * pairs, pairs + 20));
  inverse.LeaveOut(known);
  Spectra::SymEigsShiftSolver<ShiftedInverse> solver(inverse, pairs, subspace, -shift);
  solver.init();
  const auto converged = solver.compute(
    Spectra::SortRule::LargestMagn, options.restarts, options.tolerance, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
  {
    throw InputError("only " + std::to_string(converged) + " of " + std::to_string(pairs) +
                     " eigenpairs converged; request fewer, or remesh the surface");
  }
  const Eigen::VectorXd values = solver.eigenvalues();
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  for (int i = 0; i < pairs; ++i)
  {
    known.values.push_back(values[i]);
    known.vectors.push_back(vectors.col(i));
  }
  known.Sort();
}

/** Single-vector Lanczos finds one direction of a multiple eigenspace, and others only by rounding errors. Therefore
 * the pairs are counted, and missing ones are computed in the complement of the others. */
SymmetricPairs
LanczosPairs(const SurfaceLaplacian & laplacian, int pairs, const SurfaceSpectrumOptions & options)
{
  constexpr int               spare = 6;
  constexpr int               attempts = 8;
  const double                shift = 0.5 * EigenvalueStep(laplacian);
  OpenEndedProgress           steps(options.progress, 4.0 * pairs);
  const SymbolicFactorization symbolic(laplacian.NumberOfVertices(), laplacian.edges, EliminationOrder::MinimumDegree);
  const Eigen::VectorXd       diagonal = StiffnessDiagonal(laplacian);
  steps.Step();
  // L - `number` M has as many negative eigenvalues as there are eigenvalues below `number` (Sylvester's law of
  // inertia).
  auto countBelow = [&, counter = SparseCholesky(symbolic)](double number) mutable {
    counter.Factorize(diagonal - number * laplacian.mass, -laplacian.weights, steps.NextStep());
    return counter.NegativeEigenvalues();
  };
  ShiftedInverse inverse(laplacian, symbolic, shift, steps);
  SymmetricPairs found;
  AddPairs(inverse, shift, pairs + spare, options, found);
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    // The widest gap above the requested pairs, where a count is reliable.
    int below = pairs;
    for (int i = pairs; i < pairs + spare; ++i)
    {
      if (found.values[i] - found.values[i - 1] > found.values[below] - found.values[below - 1])
      {
        below = i;
      }
    }
    const int missing = countBelow(0.5 * (found.values[below] + found.values[below - 1])) - below;
    if (missing == 0)
    {
      return found;
    }
    AddPairs(inverse, shift, std::max(1, missing), options, found);
  }
  throw InputError("eigenpairs of multiple eigenvalues are missing; perturb or remesh the surface");
}

void
FixSign(Eigen::Ref<Eigen::VectorXd> function)
{
  Eigen::Index place = 0;
  function.cwiseAbs().maxCoeff(&place);
  if (function[place] < 0.0)
  {
    function = -function;
  }
}
} // namespace

SurfaceSpectrum
ComputeSurfaceSpectrum(const SurfaceLaplacian & laplacian, int pairs, const SurfaceSpectrumOptions & options)
{
  const int vertices = laplacian.NumberOfVertices();
  if (pairs < 1 || pairs > vertices)
  {
    throw InputError("a surface of " + std::to_string(vertices) + " vertices has as many eigenpairs, not " +
                     std::to_string(pairs));
  }
  const bool isDense = vertices <= fewVertices || 3 * pairs > vertices; // Lanczos keeps more than twice the pairs
  const SymmetricPairs  found = isDense ? DensePairs(laplacian, pairs) : LanczosPairs(laplacian, pairs, options);
  SurfaceSpectrum       spectrum{ Eigen::VectorXd(pairs), Eigen::MatrixXd(vertices, pairs), {} };
  const Eigen::VectorXd rootMass = laplacian.mass.cwiseSqrt();
  const Eigen::SparseMatrix<double> stiffness = StiffnessMatrix(laplacian);
  spectrum.residuals.resize(pairs);
  for (int i = 0; i < pairs; ++i)
  {
    auto function = spectrum.eigenfunctions.col(i);
    spectrum.eigenvalues[i] = std::max(0.0, found.values[i]);
    function = found.vectors[i].cwiseQuotient(rootMass);
    FixSign(function);
    const Eigen::VectorXd rest = stiffness * function - spectrum.eigenvalues[i] * laplacian.mass.cwiseProduct(function);
    spectrum.residuals[i] = rest.cwiseQuotient(rootMass).norm();
  }
  options.progress(1.0);
  spectrum.residuals /= std::max(spectrum.eigenvalues[pairs - 1], EigenvalueStep(laplacian));
  return spectrum;
}
} // namespace shapeton
