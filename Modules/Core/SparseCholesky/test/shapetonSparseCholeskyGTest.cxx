#include "shapetonSparseCholesky.h"

#include "itkMultiThreaderBase.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Edges = std::vector<std::array<int, 2>>;

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
  explicit System(int n) : edges(GridEdges(n)), diagonal(n * n, 0.125), offDiagonal(edges.size())
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      offDiagonal[e] = std::sin(1.0 + 3.0 * e);
      diagonal[edges[e][0]] += std::abs(offDiagonal[e]);
      diagonal[edges[e][1]] += std::abs(offDiagonal[e]);
    }
  }
  std::vector<double>
  Times(const std::vector<double> & x) const
  {
    std::vector<double> b(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      b[i] = diagonal[i] * x[i];
    }
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      b[edges[e][0]] += offDiagonal[e] * x[edges[e][1]];
      b[edges[e][1]] += offDiagonal[e] * x[edges[e][0]];
    }
    return b;
  }
  Edges               edges;
  std::vector<double> diagonal;
  std::vector<double> offDiagonal;
};

std::vector<double>
Wave(std::size_t size)
{
  std::vector<double> x(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    x[i] = std::cos(0.1 * i * i);
  }
  return x;
}
} // namespace

TEST(SparseCholesky, SolvesWhatWasMultiplied)
{
  for (const int n : { 1, 2, 3, 7, 40, 150 })
  {
    const System              system(n);
    const std::vector<double> expected = Wave(n * n);
    shapeton::SparseCholesky  solver(n * n, system.edges);
    ASSERT_TRUE(solver.Factorise(system.diagonal, system.offDiagonal));
    std::vector<double> x = system.Times(expected);
    solver.Solve(x);
    for (int i = 0; i < n * n; ++i)
    {
      ASSERT_NEAR(x[i], expected[i], 1e-11) << n << ' ' << i;
    }
  }
}

TEST(SparseCholesky, OneAnalysisServesSeveralMatrices)
{
  System                   system(30);
  shapeton::SparseCholesky solver(900, system.edges);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(solver.Factorise(system.diagonal, system.offDiagonal));
    std::vector<double> x = system.Times(Wave(900));
    solver.Solve(x);
    ASSERT_NEAR(x[17], std::cos(0.1 * 17 * 17), 1e-12);
    for (double & d : system.diagonal)
    {
      d *= 1.5;
    }
  }
}

TEST(SparseCholesky, AMatrixWithANegativeEigenvalueIsRefused)
{
  System                   system(30);
  shapeton::SparseCholesky solver(900, system.edges);
  const double             kept = system.diagonal[431];
  system.diagonal[431] = -1e-3;
  EXPECT_FALSE(solver.Factorise(system.diagonal, system.offDiagonal));
  system.diagonal[431] = kept;
  EXPECT_TRUE(solver.Factorise(system.diagonal, system.offDiagonal));
  system.diagonal[3] = std::nan("");
  EXPECT_FALSE(solver.Factorise(system.diagonal, system.offDiagonal));
}

TEST(SparseCholesky, TheSameBytesForAnyNumberOfThreads)
{
  const System                     system(120);
  std::vector<std::vector<double>> results;
  for (const unsigned int threads : { 1U, 2U, 5U })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    shapeton::SparseCholesky solver(14400, system.edges);
    ASSERT_TRUE(solver.Factorise(system.diagonal, system.offDiagonal));
    results.push_back(Wave(14400));
    solver.Solve(results.back());
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(SparseCholesky, SeveralComponents)
{
  shapeton::SparseCholesky solver(4, { { 2, 0 } });
  ASSERT_TRUE(solver.Factorise({ 2.0, 4.0, 2.0, 0.5 }, { 1.0 }));
  std::vector<double> x{ 3.0, 4.0, 3.0, 1.0 };
  solver.Solve(x);
  EXPECT_NEAR(x[0], 1.0, 1e-15);
  EXPECT_NEAR(x[1], 1.0, 1e-15);
  EXPECT_NEAR(x[2], 1.0, 1e-15);
  EXPECT_NEAR(x[3], 2.0, 1e-15);
}
