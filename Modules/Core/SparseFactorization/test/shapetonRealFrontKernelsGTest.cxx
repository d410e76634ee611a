#include "shapetonFrontKernels.h"
#include "shapetonKernelSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using namespace shapeton;
using namespace shapeton::FrontKernels;

/** B B^T + I of a smooth B. */
std::vector<double>
PositiveMatrix(int n)
{
  std::vector<double> matrix(n * PaddedRows(n) + rowGroup, 0.0);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      double sum = i == j ? 1.0 : 0.0;
      for (int k = 0; k < n; ++k)
      {
        sum += std::sin(i + 2.0 * k + 0.3 * i * k) * std::sin(j + 2.0 * k + 0.3 * j * k);
      }
      matrix[j * PaddedRows(n) + i] = sum;
    }
  }
  return matrix;
}
} // namespace

TEST(RealFrontKernels, FactorTimesItsTransposeIsTheMatrix)
{
  for (const Set * set : KernelsOfThisCpu<Set>())
  {
    for (const int n : { 1, 2, 7, 8, 9, 30, 61 })
    {
      const std::vector<double> matrix = PositiveMatrix(n);
      std::vector<double>       factor = matrix;
      std::vector<double>       signs(n);
      const std::ptrdiff_t      stride = PaddedRows(n);
      ASSERT_EQ(set->Factor(n, n, { factor.data(), stride }, signs.data()), -1);
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j <= i; ++j)
        {
          double sum = 0.0;
          for (int k = 0; k <= j; ++k)
          {
            sum += factor[k * stride + i] * factor[k * stride + j];
          }
          ASSERT_NEAR(sum, matrix[j * stride + i], 1e-11 * n) << set->name << ' ' << n << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

TEST(RealFrontKernels, AllSetsGiveTheSameBytes)
{
  constexpr int       n = 93;
  constexpr int       width = 29;
  std::vector<double> first;
  for (const Set * set : KernelsOfThisCpu<Set>())
  {
    std::vector<double>  matrix = PositiveMatrix(n);
    std::vector<double>  signs(width);
    std::vector<double>  update((n - width) * PaddedRows(n - width), 0.25);
    const std::ptrdiff_t stride = PaddedRows(n);
    ASSERT_EQ(set->Factor(n, width, { matrix.data(), stride }, signs.data()), -1);
    set->SubtractSquare(n - width,
                        0,
                        n - width,
                        width,
                        { matrix.data() + width, stride },
                        signs.data(),
                        { update.data(), PaddedRows(n - width) });
    std::vector<double> result;
    for (int j = 0; j < width; ++j)
    {
      result.insert(result.end(), matrix.begin() + j * stride + j, matrix.begin() + j * stride + n);
    }
    for (int j = 0; j < n - width; ++j)
    {
      const auto column = update.begin() + j * PaddedRows(n - width);
      result.insert(result.end(), column + j, column + n - width);
    }
    first = first.empty() ? result : first;
    EXPECT_EQ(result, first) << set->name;
  }
}

TEST(RealFrontKernels, StripsGiveTheSameBytesAsTheWhole)
{
  constexpr int             n = 70;
  const std::vector<double> matrix = PositiveMatrix(n);
  std::vector<double>       panel(matrix);
  std::vector<double>       signs(40, 1.0);
  signs[7] = -1.0;
  const std::ptrdiff_t stride = PaddedRows(n);
  std::vector<double>  whole(n * stride, 1.0);
  std::vector<double>  strips = whole;
  BestKernels<Set>().SubtractSquare(n, 0, n, 40, { panel.data(), stride }, signs.data(), { whole.data(), stride });
  for (int begin = 0; begin < n; begin += 16)
  {
    BestKernels<Set>().SubtractSquare(
      n, begin, std::min(begin + 16, n), 40, { panel.data(), stride }, signs.data(), { strips.data(), stride });
  }
  for (int j = 0; j < n; ++j)
  {
    EXPECT_TRUE(
      std::equal(whole.begin() + j * stride + j, whole.begin() + j * stride + n, strips.begin() + j * stride + j));
  }
}

TEST(RealFrontKernels, SignsOfAnIndefiniteMatrixAndPivotsOf0AreReported)
{
  std::vector<double> matrix = PositiveMatrix(20);
  matrix[13 * PaddedRows(20) + 13] = -5.0;
  for (const Set * set : KernelsOfThisCpu<Set>())
  {
    std::vector<double>  factor = matrix;
    std::vector<double>  signs(20);
    const std::ptrdiff_t stride = PaddedRows(20);
    ASSERT_EQ(set->Factor(20, 20, { factor.data(), stride }, signs.data()), -1);
    EXPECT_EQ(signs[13], -1.0);
    EXPECT_EQ(std::count(signs.begin(), signs.begin() + 13, 1.0), 13);
    for (int i = 0; i < 20; ++i)
    {
      double sum = 0.0;
      for (int k = 0; k <= std::min(i, 15); ++k)
      {
        sum += factor[k * stride + i] * signs[k] * factor[k * stride + 15];
      }
      EXPECT_NEAR(sum, i >= 15 ? matrix[15 * stride + i] : sum, 1e-10);
    }
    std::vector<double> zero(8 * 8, 0.0);
    EXPECT_EQ(set->Factor(8, 8, { zero.data(), 8 }, signs.data()), 0);
  }
}
