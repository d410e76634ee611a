#include "shapetonHeatKernel.h"

#include "shapetonIntrinsicSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

/** A flat torus of 6 mm x 4 mm and its first 200 eigenpairs. */
struct TorusKernel
{
  TorusKernel()
    : grid(48, 32, Wrap::Both, 6.0, 4.0), laplacian(grid.Laplacian()), spectrum(ComputeSurfaceSpectrum(laplacian, 200))
  {}
  int
  At(int i, int j) const
  {
    return (j % 32) * 48 + i % 48;
  }
  FlatGrid         grid;
  SurfaceLaplacian laplacian;
  SurfaceSpectrum  spectrum;
};

const TorusKernel &
Kernel()
{
  static const TorusKernel kernel;
  return kernel;
}

/** The heat kernel of a flat torus: Gaussians around all images of the source. */
double
Gaussians(double x, double y, double t)
{
  double sum = 0.0;
  for (int m = -4; m <= 4; ++m)
  {
    for (int n = -4; n <= 4; ++n)
    {
      const double dx = x + 6.0 * m;
      const double dy = y + 4.0 * n;
      sum += std::exp(-(dx * dx + dy * dy) / (4.0 * t)) / (4.0 * Pi * t);
    }
  }
  return sum;
}

TEST(HeatKernel, OfAFlatTorusIsASumOfGaussians)
{
  const auto & k = Kernel();
  for (const double t : { 0.1, 0.4, 2.0 })
  {
    const double atSource = Gaussians(0.0, 0.0, t);
    EXPECT_NEAR(HeatKernel(k.spectrum, k.At(5, 3), k.At(5, 3), t), atSource, 0.03 * atSource);
    EXPECT_NEAR(HeatKernel(k.spectrum, k.At(5, 3), k.At(9, 3), t), Gaussians(0.5, 0.0, t), 0.03 * atSource);
    EXPECT_NEAR(HeatKernel(k.spectrum, k.At(5, 3), k.At(9, 11), t), Gaussians(0.5, 1.0, t), 0.03 * atSource);
  }
}

TEST(HeatKernel, KeepsHeatAndFillsTheArea)
{
  const auto & k = Kernel();
  double       heat = 0.0;
  for (int q = 0; q < k.laplacian.NumberOfVertices(); ++q)
  {
    heat += HeatKernel(k.spectrum, 7, q, 0.3) * k.laplacian.mass[q];
  }
  EXPECT_NEAR(heat, 1.0, 1e-10);
  const Eigen::VectorXd late = HeatKernelSignature(k.spectrum, 1000.0);
  EXPECT_NEAR(late.minCoeff(), 1.0 / 24.0, 1e-10);
  EXPECT_NEAR(late.maxCoeff(), 1.0 / 24.0, 1e-10);
}

TEST(HeatKernel, SignatureIsItsDiagonal)
{
  const auto &          k = Kernel();
  const Eigen::VectorXd signature = HeatKernelSignature(k.spectrum, 0.2);
  for (const int p : { 0, 100, 777 })
  {
    EXPECT_NEAR(signature[p], HeatKernel(k.spectrum, p, p, 0.2), 1e-13);
  }
}

TEST(HeatKernel, DistanceIsTheNormOfADifferenceOfHeats)
{
  const auto & k = Kernel();
  const int    p = k.At(3, 4);
  const int    q = k.At(10, 9);
  double       square = 0.0;
  for (int r = 0; r < k.laplacian.NumberOfVertices(); ++r)
  {
    const double step = HeatKernel(k.spectrum, p, r, 0.2) - HeatKernel(k.spectrum, q, r, 0.2);
    square += step * step * k.laplacian.mass[r];
  }
  EXPECT_NEAR(DiffusionDistance(k.spectrum, p, q, 0.2), std::sqrt(square), 1e-10);
}

TEST(HeatKernel, DistanceIsAMetric)
{
  const auto & k = Kernel();
  const int    n = k.laplacian.NumberOfVertices();
  Random       random(5);
  const auto   d = [&](int p, int q) { return DiffusionDistance(k.spectrum, p, q, 0.1); };
  for (int i = 0; i < 200; ++i)
  {
    const int p = random.Below(n), q = random.Below(n), r = random.Below(n);
    EXPECT_LE(d(p, r), d(p, q) + d(q, r) + 1e-12);
    EXPECT_EQ(d(p, q), d(q, p));
    EXPECT_EQ(d(p, p), 0.0);
  }
  const Eigen::VectorXd all = DiffusionDistances(k.spectrum, 11, 0.1);
  EXPECT_EQ(all.size(), n);
  EXPECT_NEAR(all[500], d(11, 500), 1e-12);
  EXPECT_EQ(all[11], 0.0);
}

TEST(HeatKernel, TimesSpanWhatTheSpectrumResolves)
{
  const auto &              k = Kernel();
  const std::vector<double> times = HeatKernelSignatureTimes(k.spectrum, 5);
  ASSERT_EQ(times.size(), 5u);
  EXPECT_NEAR(ShareOfLastPair(k.spectrum, times.front()), 1e-4, 1e-12);
  EXPECT_NEAR(times.back() * k.spectrum.eigenvalues[1], 4.0 * std::log(10.0), 1e-9);
  for (std::size_t i = 2; i < times.size(); ++i)
  {
    EXPECT_NEAR(times[i] / times[i - 1], times[1] / times[0], 1e-9);
  }
  EXPECT_EQ(HeatKernelSignatureTimes(k.spectrum, 1), std::vector<double>{ times.front() });
  EXPECT_THROW(HeatKernelSignatureTimes(ComputeSurfaceSpectrum(k.laplacian, 1), 4), InputError);
}

TEST(HeatKernel, RefusesTimesAndVerticesThatAreNone)
{
  const auto & k = Kernel();
  for (const double t : { 0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    EXPECT_THROW(HeatKernel(k.spectrum, 0, 1, t), InputError);
    EXPECT_THROW(HeatKernelSignature(k.spectrum, t), InputError);
    EXPECT_THROW(DiffusionDistances(k.spectrum, 0, t), InputError);
  }
  EXPECT_THROW(DiffusionDistance(k.spectrum, 0, 48 * 32, 0.1), InputError);
  EXPECT_THROW(HeatKernel(k.spectrum, -1, 0, 0.1), InputError);
}
} // namespace
