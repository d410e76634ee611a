#include "shapetonFrontKernels.h"
#include "shapetonKernelSets.h"
#include "shapetonTestRandom.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <functional>

namespace
{
using namespace shapeton;
using namespace shapeton::FrontKernels;

/** A complex matrix in kernel layout, with zero padding. */
struct Matrix
{
  Matrix(int rows, int columns, std::uint64_t seed)
    : rows(rows), columns(columns), values(2 * PaddedRows(rows) * columns, 0.0)
  {
    shapeton::test::Random random(seed);
    for (int j = 0; j < columns; ++j)
    {
      for (int i = 0; i < rows; ++i)
      {
        values[j * PaddedRows(rows) + i] = random.Signed();
        values[(columns + j) * PaddedRows(rows) + i] = random.Signed();
      }
    }
  }
  Block
  AsBlock()
  {
    return { values.data(), PaddedRows(rows), static_cast<std::ptrdiff_t>(PaddedRows(rows)) * columns };
  }
  Elements
  AsElements() const
  {
    return { values.data(), 1, PaddedRows(rows), static_cast<std::ptrdiff_t>(PaddedRows(rows)) * columns };
  }
  Eigen::MatrixXcd
  Dense() const
  {
    Eigen::MatrixXcd dense(rows, columns);
    for (int j = 0; j < columns; ++j)
    {
      for (int i = 0; i < rows; ++i)
      {
        dense(i, j) = { values[j * PaddedRows(rows) + i], values[(columns + j) * PaddedRows(rows) + i] };
      }
    }
    return dense;
  }

  int                 rows;
  int                 columns;
  std::vector<double> values;
};

/** Checks a rows x columns product of the given depth: correct and bitwise identical for all kernel sets. */
void
CheckMultiply(int                                                                                         rows,
              int                                                                                         columns,
              int                                                                                         depth,
              Store                                                                                       store,
              const std::function<Eigen::MatrixXcd(const Eigen::MatrixXcd &, const Eigen::MatrixXcd &)> & expected)
{
  std::vector<double> first;
  for (const Set * set : KernelsOfThisCpu<Set>())
  {
    Matrix     A(rows, depth, 1), B(depth, columns, 2), C(rows, columns, 3);
    const auto right = expected(C.Dense(), A.Dense() * B.Dense());
    set->Multiply(PaddedRows(rows), columns, depth, A.AsBlock(), B.AsElements(), C.AsBlock(), store, false);
    EXPECT_LT((C.Dense() - right).cwiseAbs().maxCoeff(), 1e-13 * (1 + depth)) << set->name;
    first = first.empty() ? C.values : first;
    EXPECT_EQ(first, C.values) << set->name;
  }
}

TEST(FrontKernels, MultiplyAsEigenDoesAndWithTheSameBytesOnEveryCpu)
{
  for (const int rows : { 1, 7, 8, 9, 40 })
  {
    for (const int columns : { 1, 3, 4, 5, 13 })
    {
      for (const int depth : { 1, 6, 128, 129, 300 })
      {
        CheckMultiply(rows, columns, depth, Store::Assign, [](const auto &, const auto & AB) { return AB; });
        CheckMultiply(rows, columns, depth, Store::Negate, [](const auto &, const auto & AB) { return -AB; });
        CheckMultiply(rows, columns, depth, Store::Add, [](const auto & C, const auto & AB) { return C + AB; });
        CheckMultiply(rows, columns, depth, Store::Subtract, [](const auto & C, const auto & AB) { return C - AB; });
      }
    }
  }
}

TEST(FrontKernels, MultiplyTheLowerTriangle)
{
  for (const Set * set : KernelsOfThisCpu<Set>())
  {
    Matrix                 A(50, 20, 1), B(20, 50, 2), C(50, 50, 3);
    const Eigen::MatrixXcd right = C.Dense() - A.Dense() * B.Dense();
    set->Multiply(PaddedRows(50), 50, 20, A.AsBlock(), B.AsElements(), C.AsBlock(), Store::Subtract, true);
    const Eigen::MatrixXcd error = (C.Dense() - right).triangularView<Eigen::Lower>();
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-13) << set->name;
  }
}

TEST(FrontKernels, InvertAsEigenDoesAndWithTheSameBytesOnEveryCpu)
{
  for (const int n : { 1, 2, 7, 8, 9, 31, 48 })
  {
    std::vector<double> first;
    for (const Set * set : KernelsOfThisCpu<Set>())
    {
      Matrix A(n, n, 4);
      for (int i = 0; i < n; ++i)
      {
        A.values[i * PaddedRows(n) + i] += 2.0 * n;
      }
      const Eigen::MatrixXcd right = A.Dense().inverse();
      std::vector<double>    work(2 * PaddedRows(n));
      set->Invert(n, A.AsBlock(), work.data());
      EXPECT_LT((A.Dense() - right).cwiseAbs().maxCoeff(), 1e-14) << set->name;
      first = first.empty() ? A.values : first;
      EXPECT_EQ(first, A.values) << set->name;
    }
  }
}
} // namespace
