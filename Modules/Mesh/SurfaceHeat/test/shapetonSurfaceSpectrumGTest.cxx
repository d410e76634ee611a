#include "shapetonSurfaceSpectrum.h"

#include "shapetonIntrinsicSurfaces.h"
#include "shapetonProgressTests.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

void
ExpectEigenvalues(const SurfaceSpectrum & spectrum, std::vector<double> expected, double tolerance)
{
  std::sort(expected.begin(), expected.end());
  EXPECT_NEAR(spectrum.eigenvalues[0], 0.0, 1e-9 * expected.back());
  for (int i = 1; i < spectrum.NumberOfPairs(); ++i)
  {
    EXPECT_NEAR(spectrum.eigenvalues[i], expected[i], tolerance * expected[i]) << i;
  }
}

/** Values m^2 a + n^2 b for integers m, n of the given signs. */
std::vector<double>
Products(int from, int fromSecond, int to, double a, double b)
{
  std::vector<double> values;
  for (int m = from; m <= to; ++m)
  {
    for (int n = fromSecond; n <= to; ++n)
    {
      values.push_back(m * m * a + n * n * b);
    }
  }
  return values;
}

TEST(SurfaceSpectrum, OfASphereHasItsMultiplicities)
{
  const double          radius = 3.0;
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(LaplacianOf(Icosphere(4, radius)), 36);
  std::vector<double>   expected;
  for (int l = 0; l < 6; ++l)
  {
    expected.insert(expected.end(), 2 * l + 1, l * (l + 1) / (radius * radius));
  }
  ExpectEigenvalues(spectrum, expected, 0.02);
}

TEST(SurfaceSpectrum, OfFlatSurfacesIsThatOfTheirWaves)
{
  const auto spectrumOf = [](Wrap wrap) {
    return ComputeSurfaceSpectrum(FlatGrid(60, 40, wrap, 6.0, 4.0).Laplacian(), 20);
  };
  const double across = Pi * Pi / 36.0, along = Pi * Pi / 16.0; // of half a wave
  ExpectEigenvalues(spectrumOf(Wrap::None), Products(0, 0, 8, across, along), 0.02);
  ExpectEigenvalues(spectrumOf(Wrap::Around), Products(-8, 0, 8, 4.0 * across, along), 0.02);
  ExpectEigenvalues(spectrumOf(Wrap::Both), Products(-8, -8, 8, 4.0 * across, 4.0 * along), 0.02);
}

TEST(SurfaceSpectrum, ConvergesWithTheSquareOfTheEdge)
{
  const double exact = Pi * Pi / 36.0;
  double       errors[2];
  for (int i = 0; i < 2; ++i)
  {
    const FlatGrid grid(15 << i, 10 << i, Wrap::None, 6.0, 4.0);
    errors[i] = std::abs(ComputeSurfaceSpectrum(grid.Laplacian(), 6).eigenvalues[1] - exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.2);
}

TEST(SurfaceSpectrum, IsOrthonormalWithSmallResidualsAndFixedSigns)
{
  const auto            laplacian = LaplacianOf(Roughened(Cylinder(30, 40, 5.0, 20.0), 0.1, 1));
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, 40);
  const Eigen::MatrixXd products =
    spectrum.eigenfunctions.transpose() * laplacian.mass.asDiagonal() * spectrum.eigenfunctions;
  EXPECT_LT((products - Eigen::MatrixXd::Identity(40, 40)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(spectrum.residuals.maxCoeff(), 1e-9);
  EXPECT_LT((spectrum.eigenfunctions.col(0).array() - 1.0 / std::sqrt(laplacian.mass.sum())).abs().maxCoeff(), 1e-9);
  for (int i = 0; i < 40; ++i)
  {
    EXPECT_GT(spectrum.eigenfunctions.col(i).maxCoeff(), -0.999999 * spectrum.eigenfunctions.col(i).minCoeff());
  }
  const SurfaceSpectrum again = ComputeSurfaceSpectrum(laplacian, 40);
  EXPECT_EQ(again.eigenvalues, spectrum.eigenvalues);
  EXPECT_EQ(again.eigenfunctions, spectrum.eigenfunctions);
}

TEST(SurfaceSpectrum, IsTheSameByLanczosAndDense)
{
  const auto            laplacian = LaplacianOf(Roughened(Square(20, 10.0), 0.1, 2));
  const SurfaceSpectrum lanczos = ComputeSurfaceSpectrum(laplacian, 30);
  const SurfaceSpectrum dense = ComputeSurfaceSpectrum(laplacian, 441);
  EXPECT_LT((lanczos.eigenvalues - dense.eigenvalues.head(30)).cwiseAbs().maxCoeff(), 1e-9);
  for (int i = 0; i < 30; ++i)
  {
    const double product = lanczos.eigenfunctions.col(i).dot(laplacian.mass.cwiseProduct(dense.eigenfunctions.col(i)));
    EXPECT_NEAR(std::abs(product), 1.0, 1e-7) << i;
  }
}

TEST(SurfaceSpectrum, RefusesTooManyPairsAndSaysWhenItDoesNotConverge)
{
  const auto laplacian = LaplacianOf(Square(20, 10.0));
  EXPECT_THROW(ComputeSurfaceSpectrum(laplacian, 0), InputError);
  EXPECT_THROW(ComputeSurfaceSpectrum(laplacian, 442), InputError);
  SurfaceSpectrumOptions options;
  options.restarts = 1;
  options.tolerance = 1e-15;
  EXPECT_THROW(ComputeSurfaceSpectrum(laplacian, 60, options), InputError);
}
TEST(SurfaceSpectrum, IsAbortedByProgressOfEachStep)
{
  const auto laplacian = LaplacianOf(Roughened(Square(40, 10.0), 0.1, 2));
  const auto work = [&](const Progress & progress) {
    SurfaceSpectrumOptions options;
    options.progress = progress;
    ComputeSurfaceSpectrum(laplacian, 30, options);
  };
  test::ExpectProgress(work, 70); // Lanczos keeps 72 vectors
}
} // namespace
