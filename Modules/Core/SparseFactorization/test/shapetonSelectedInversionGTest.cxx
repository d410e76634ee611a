#include "shapetonSelectedInversion.h"

#include "shapetonExceptions.h"
#include "shapetonProgressTests.h"
#include "shapetonTestRandom.h"

#include "itkMultiThreaderBase.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace
{
using namespace shapeton;
using test::Random;
using Edges = std::vector<std::array<int, 2>>;

SelectedInversion
InversionOf(int n, const Edges & edges)
{
  return SelectedInversion(SymbolicFactorization(n, edges, EliminationOrder::NestedDissection));
}

/** Elements with a numerical range in the right half plane: dominant diagonals of positive real part. */
SymmetricElements
RandomMatrix(int n, const Edges & edges, std::uint64_t seed)
{
  Random            random(seed);
  SymmetricElements matrix{ Eigen::VectorXcd(n), Eigen::VectorXcd(edges.size()) };
  Eigen::VectorXd   sums = Eigen::VectorXd::Constant(n, 0.5);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const std::complex<double> value(random.Signed(), random.Signed());
    matrix.offDiagonal[static_cast<Eigen::Index>(e)] = value;
    sums[edges[e][0]] += std::abs(value);
    sums[edges[e][1]] += std::abs(value);
  }
  for (int i = 0; i < n; ++i)
  {
    matrix.diagonal[i] = { sums[i], 3.0 * random.Signed() };
  }
  return matrix;
}

void
CheckAgainstDense(int n, const Edges & edges, std::uint64_t seed = 1)
{
  const SymmetricElements matrix = RandomMatrix(n, edges, seed);
  Eigen::MatrixXcd        dense = matrix.diagonal.asDiagonal();
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    dense(edges[e][0], edges[e][1]) = dense(edges[e][1], edges[e][0]) =
      matrix.offDiagonal[static_cast<Eigen::Index>(e)];
  }
  const Eigen::MatrixXcd  right = dense.inverse();
  const SymmetricElements inverse = InversionOf(n, edges).Invert(matrix);
  const double            scale = right.cwiseAbs().maxCoeff();
  EXPECT_LT((inverse.diagonal - right.diagonal()).cwiseAbs().maxCoeff(), 1e-12 * scale);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    EXPECT_LT(std::abs(inverse.offDiagonal[static_cast<Eigen::Index>(e)] - right(edges[e][0], edges[e][1])),
              1e-12 * scale);
  }
}

Edges
RandomEdges(int n, int number, int bandwidth, std::uint64_t seed)
{
  Random                       random(seed);
  std::set<std::array<int, 2>> edges;
  for (int i = 0; i < number; ++i)
  {
    const int a = random.Below(n);
    const int b = a + 1 + random.Below(bandwidth);
    if (b < n)
    {
      edges.insert(random.Below(2) == 0 ? std::array<int, 2>{ a, b } : std::array<int, 2>{ b, a });
      edges.erase({ b, a }); // one of the two directions
    }
  }
  return { edges.begin(), edges.end() };
}

TEST(SelectedInversion, OfRandomPatternsIsThatOfADenseInverse)
{
  for (int n = 2; n <= 60; n += 7)
  {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      CheckAgainstDense(n, RandomEdges(n, 3 * n, n, seed), seed);
    }
  }
  CheckAgainstDense(400, RandomEdges(400, 900, 400, 9));
}

TEST(SelectedInversion, OfBandedPatterns)
{
  CheckAgainstDense(300, RandomEdges(300, 2000, 5, 1));
  CheckAgainstDense(200, RandomEdges(200, 400, 1, 2));
}

TEST(SelectedInversion, OfArrows)
{
  for (const int hub : { 0, 99, 199 })
  {
    Edges edges;
    for (int i = 0; i < 200; ++i)
    {
      if (i != hub)
      {
        edges.push_back({ i, hub });
      }
    }
    CheckAgainstDense(200, edges);
  }
}

TEST(SelectedInversion, OfFullMatricesWiderThanAFront)
{
  for (const int n : { 47, 48, 49, 150 })
  {
    Edges edges;
    for (int a = 0; a < n; ++a)
    {
      for (int b = a + 1; b < n; ++b)
      {
        edges.push_back({ a, b });
      }
    }
    CheckAgainstDense(n, edges);
  }
}

/** A triangulated torus. */
Edges
EdgesOfTorus(int rows, int columns)
{
  Edges edges;
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const int below = (i + 1) % rows * columns;
      const int right = (j + 1) % columns;
      edges.push_back({ i * columns + j, i * columns + right });
      edges.push_back({ i * columns + j, below + j });
      edges.push_back({ i * columns + j, below + right });
    }
  }
  return edges;
}

TEST(SelectedInversion, OfSurfaces) { CheckAgainstDense(360, EdgesOfTorus(30, 12)); }

TEST(SelectedInversion, OfSeveralComponentsAndSingleVertices)
{
  CheckAgainstDense(1, {});
  CheckAgainstDense(40, {});
  Edges edges = RandomEdges(100, 250, 10, 3);
  for (const auto & [a, b] : RandomEdges(100, 250, 100, 4))
  {
    edges.push_back({ a + 120, b + 120 });
  }
  CheckAgainstDense(230, edges);
}

TEST(SelectedInversion, GivesTheSameBytesForAnyNumberOfThreads)
{
  const int                      n = 1800;
  const Edges                    edges = EdgesOfTorus(60, 30);
  const SelectedInversion        inversion = InversionOf(n, edges);
  std::vector<SymmetricElements> first;
  for (const unsigned int threads : { 1, 2, 3 })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    for (const int atOnce : { 1, 2, 5 })
    {
      std::vector<SymmetricElements> all;
      inversion.InvertAll(
        5,
        [&](int i) { return RandomMatrix(n, edges, i + 1); },
        [&](int i, const SymmetricElements & inverse) {
          EXPECT_EQ(i, static_cast<int>(all.size()));
          all.push_back(inverse);
        },
        atOnce);
      ASSERT_EQ(all.size(), 5u);
      first = first.empty() ? all : first;
      for (int i = 0; i < 5; ++i)
      {
        EXPECT_EQ(all[i].diagonal, first[i].diagonal);
        EXPECT_EQ(all[i].offDiagonal, first[i].offDiagonal);
      }
    }
  }
}

TEST(SelectedInversion, RefusesSingularAndNotFiniteMatricesWithAnyNumberOfThreads)
{
  const SelectedInversion inversion = InversionOf(3, { { 0, 1 }, { 1, 2 } });
  SymmetricElements       matrix{ Eigen::VectorXcd::Zero(3), Eigen::VectorXcd::Zero(2) };
  for (const unsigned int threads : { 1, 3 })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    EXPECT_THROW(inversion.Invert(matrix), InputError);
  }
  matrix.diagonal.setOnes();
  EXPECT_NO_THROW(inversion.Invert(matrix));
  matrix.offDiagonal[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(inversion.Invert(matrix), InputError);
  matrix.offDiagonal.resize(1);
  EXPECT_THROW(inversion.Invert(matrix), InputError);
}
TEST(SelectedInversion, IsAbortedByProgressAndWorksAfterwards)
{
  const int               n = 3000;
  const Edges             edges = RandomEdges(n, 3 * n, 60, 4);
  const SymmetricElements matrix = RandomMatrix(n, edges, 4);
  const SelectedInversion inversion = InversionOf(n, edges);
  const SymmetricElements expected = inversion.Invert(matrix);
  for (const unsigned int threads : { 1U, 2U, 5U })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    int taken = 0;
    test::ExpectProgress(
      [&](const Progress & progress) {
        inversion.InvertAll(
          4,
          [&](int) { return matrix; },
          [&](int, const SymmetricElements & inverse) {
            taken += inverse.diagonal == expected.diagonal && inverse.offDiagonal == expected.offDiagonal;
          },
          2,
          progress);
      },
      threads == 1 ? 20 : 1); // only one thread reports progress
    EXPECT_GE(taken, 4);      // at the end of the run
  }
}
} // namespace
