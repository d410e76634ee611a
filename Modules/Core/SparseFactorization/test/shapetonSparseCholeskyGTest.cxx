#include "shapetonSparseCholesky.h"
#include "shapetonProgressTests.h"

#include "shapetonExceptions.h"

#include "itkMultiThreaderBase.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>

namespace
{
using namespace shapeton;
using Edges = std::vector<std::array<int, 2>>;

constexpr EliminationOrder bothOrders[] = { EliminationOrder::MinimumDegree, EliminationOrder::NestedDissection };

Edges
GridEdges(int n)
{
  Edges edges;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      if (j + 1 < n)
      {
        edges.push_back({ i * n + j, i * n + j + 1 });
      }
      if (i + 1 < n)
      {
        edges.push_back({ (i + 1) * n + j, i * n + j });
      }
    }
  }
  return edges;
}

/** A diagonally dominant matrix with positive and negative elements. */
struct System
{
  explicit System(int n)
    : edges(GridEdges(n)), diagonal(Eigen::VectorXd::Constant(n * n, 0.125)), offDiagonal(edges.size())
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      const double element = std::sin(1.0 + 3.0 * e);
      offDiagonal[static_cast<Eigen::Index>(e)] = element;
      diagonal[edges[e][0]] += std::abs(element);
      diagonal[edges[e][1]] += std::abs(element);
    }
  }
  Eigen::SparseMatrix<double>
  Matrix() const
  {
    std::vector<Eigen::Triplet<double>> elements;
    for (Eigen::Index i = 0; i < diagonal.size(); ++i)
    {
      elements.emplace_back(i, i, diagonal[i]);
    }
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      elements.emplace_back(edges[e][0], edges[e][1], offDiagonal[static_cast<Eigen::Index>(e)]);
      elements.emplace_back(edges[e][1], edges[e][0], offDiagonal[static_cast<Eigen::Index>(e)]);
    }
    Eigen::SparseMatrix<double> matrix(diagonal.size(), diagonal.size());
    matrix.setFromTriplets(elements.begin(), elements.end());
    return matrix;
  }
  SparseCholesky
  Solver(EliminationOrder order = EliminationOrder::NestedDissection) const
  {
    return SparseCholesky(SymbolicFactorization(static_cast<int>(diagonal.size()), edges, order));
  }
  Edges           edges;
  Eigen::VectorXd diagonal;
  Eigen::VectorXd offDiagonal;
};

Eigen::MatrixXd
Waves(int size, int columns)
{
  Eigen::MatrixXd x(size, columns);
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      x(i, j) = std::cos(0.1 * i * i + j);
    }
  }
  return x;
}
} // namespace

TEST(SparseCholesky, SolvesWhatWasMultiplied)
{
  for (const EliminationOrder order : bothOrders)
  {
    for (const int n : { 1, 2, 3, 7, 40, 150 })
    {
      const System          system(n);
      const Eigen::MatrixXd expected = Waves(n * n, 3);
      SparseCholesky        solver = system.Solver(order);
      ASSERT_TRUE(solver.Factorize(system.diagonal, system.offDiagonal));
      Eigen::MatrixXd x = system.Matrix() * expected;
      solver.SolveInPlace(x);
      EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-11) << n;
    }
  }
}

TEST(SparseCholesky, TakesEigensMatrices)
{
  const System          system(40);
  const Eigen::MatrixXd expected = Waves(1600, 2);
  Eigen::MatrixXd       x = system.Matrix() * expected;
  ASSERT_TRUE(SolvePositiveDefinite(system.Matrix(), x));
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-11);
  Eigen::SparseMatrix<double> indefinite = system.Matrix();
  indefinite.coeffRef(7, 7) = -1.0;
  x = expected;
  EXPECT_FALSE(SolvePositiveDefinite(indefinite, x));
  EXPECT_EQ(x, expected);
}

TEST(SparseCholesky, OneAnalysisServesSeveralMatrices)
{
  System                system(30);
  const Eigen::MatrixXd expected = Waves(900, 1);
  SparseCholesky        solver = system.Solver();
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(solver.Factorize(system.diagonal, system.offDiagonal));
    Eigen::MatrixXd x = system.Matrix() * expected;
    solver.SolveInPlace(x);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-12);
    system.diagonal *= 1.5;
  }
}

TEST(SparseCholesky, AMatrixWithANegativeEigenvalueIsRefused)
{
  System         system(30);
  SparseCholesky solver = system.Solver();
  const double   kept = system.diagonal[431];
  system.diagonal[431] = -1e-3;
  EXPECT_FALSE(solver.Factorize(system.diagonal, system.offDiagonal));
  system.diagonal[431] = kept;
  EXPECT_TRUE(solver.Factorize(system.diagonal, system.offDiagonal));
  system.diagonal[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver.Factorize(system.diagonal, system.offDiagonal));
  EXPECT_FALSE(solver.HasFactor());
}

TEST(SparseCholesky, IndefiniteMatricesAreSolvedAndTheirNegativeEigenvaluesCounted)
{
  System                system(20);
  const Eigen::VectorXd eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(system.Matrix())).eigenvalues();
  const Eigen::MatrixXd expected = Waves(400, 2);
  SparseCholesky        solver = system.Solver();
  for (const double shift : { 0.3, 0.8, 0.9, 5.0 })
  {
    system.diagonal.array() -= shift;
    EXPECT_FALSE(solver.Factorize(system.diagonal, system.offDiagonal));
    ASSERT_TRUE(solver.HasFactor());
    EXPECT_EQ(solver.NegativeEigenvalues(), (eigenvalues.array() < shift).count()) << shift;
    Eigen::MatrixXd x = system.Matrix() * expected;
    solver.SolveInPlace(x);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-7) << shift;
    system.diagonal.array() += shift;
  }
}

TEST(SparseCholesky, TheSameBytesForAnyNumberOfThreads)
{
  const System system(120);
  for (const EliminationOrder order : bothOrders)
  {
    std::vector<Eigen::MatrixXd> results;
    for (const unsigned int threads : { 1U, 2U, 5U })
    {
      itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
      SparseCholesky solver = system.Solver(order);
      ASSERT_TRUE(solver.Factorize(system.diagonal, system.offDiagonal));
      results.push_back(Waves(14400, 2));
      solver.SolveInPlace(results.back());
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
  }
}

TEST(SparseCholesky, SeveralComponents)
{
  SparseCholesky solver(SymbolicFactorization(4, Edges{ { 2, 0 } }, EliminationOrder::MinimumDegree));
  ASSERT_TRUE(solver.Factorize(Eigen::Vector4d(2.0, 4.0, 2.0, 0.5), Eigen::VectorXd::Ones(1)));
  Eigen::MatrixXd x = Eigen::Vector4d(3.0, 4.0, 3.0, 1.0);
  solver.SolveInPlace(x);
  EXPECT_LT((x - Eigen::Vector4d(1.0, 1.0, 1.0, 2.0)).norm(), 1e-15);
}

TEST(SymbolicFactorization, RefusesWhatIsNoPattern)
{
  const auto analyze = [](int n, const Edges & edges) {
    return SymbolicFactorization(n, edges, EliminationOrder::NestedDissection);
  };
  EXPECT_THROW(analyze(0, {}), InputError);
  EXPECT_THROW(analyze(3, { { 0, 3 } }), InputError);
  EXPECT_THROW(analyze(3, { { -1, 2 } }), InputError);
  EXPECT_THROW(analyze(3, { { 1, 1 } }), InputError);
  EXPECT_THROW(analyze(3, { { 0, 1 }, { 1, 0 } }), InputError);
}

TEST(SymbolicFactorization, MatricesOfAnotherSizeAreRefused)
{
  SparseCholesky solver = System(5).Solver();
  EXPECT_THROW(solver.Factorize(Eigen::VectorXd::Ones(24), Eigen::VectorXd::Zero(40)), InputError);
  EXPECT_THROW(solver.Factorize(Eigen::VectorXd::Ones(25), Eigen::VectorXd::Zero(39)), InputError);
}

TEST(SparseCholesky, IsAbortedByProgressAndWorksAfterwards)
{
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1); // only one thread reports progress
  const System   system(120);
  SparseCholesky solver = system.Solver(EliminationOrder::NestedDissection);
  test::ExpectProgress(
    [&](const Progress & progress) { solver.Factorize(system.diagonal, system.offDiagonal, progress); }, 15);
  EXPECT_FALSE(solver.HasFactor()); // the last factorization was aborted
  ASSERT_TRUE(solver.Factorize(system.diagonal, system.offDiagonal));
  const Eigen::MatrixXd expected = Waves(14400, 2);
  Eigen::MatrixXd       x = system.Matrix() * expected;
  solver.SolveInPlace(x);
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SparseCholesky, ATerminationSignalEndsTheOrdering)
{
  // METIS would catch the signal and report an error of the graph.
  const auto orderUntilTerminated = [] {
    const Edges edges = GridEdges(1000); // takes seconds
    std::signal(SIGALRM, [](int) { std::raise(SIGTERM); });
    ualarm(200'000, 0); // microseconds
    SymbolicFactorization(1'000'000, edges, EliminationOrder::NestedDissection);
  };
  EXPECT_EXIT(orderUntilTerminated(), testing::KilledBySignal(SIGTERM), "");
}
