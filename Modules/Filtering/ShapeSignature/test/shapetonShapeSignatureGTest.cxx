#include "shapetonPi.h"
#include "shapetonSampledShapes.h"
#include "shapetonShapeSearch.h"
#include "shapetonTestFolder.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shapeton;
using namespace signaturetest;

namespace
{
const ShapeSignature::Curve & times = ShapeSignature::Times();

ShapeSignature
SignatureOf(Image * image, const Solid & solid)
{
  Draw(image, solid);
  return ComputeShapeSignature(VoxelsOfLabel(image, 1), image);
}

ShapeSignature
SignatureOf(const Solid & solid, double spacing = 1.0)
{
  return SignatureOf(MakeImage({ 72, 72, 72 }, { spacing, spacing, spacing }), solid);
}

/** The heat content of a ball of radius 1. */
double
HeatOfBall(double t)
{
  double sum = 0.0;
  for (int n = 1; n < 400; ++n)
  {
    sum += std::exp(-n * n * shapeton::Pi * shapeton::Pi * t) / (n * n);
  }
  return 6.0 / (shapeton::Pi * shapeton::Pi) * sum;
}

/** The heat content of an interval. */
double
HeatOfInterval(double length, double t)
{
  double sum = 0.0;
  for (int n = 1; n < 400; n += 2)
  {
    sum += std::exp(-n * n * shapeton::Pi * shapeton::Pi * t / (length * length)) / (n * n);
  }
  return 8.0 / (shapeton::Pi * shapeton::Pi) * sum;
}

/** The mean squared displacement in an insulated interval. */
double
DisplacementInInterval(double length, double t)
{
  double sum = 0.0;
  for (int n = 1; n < 400; n += 2)
  {
    sum -= std::expm1(-n * n * shapeton::Pi * shapeton::Pi * t / (length * length)) / std::pow(n, 4);
  }
  return 16.0 * length * length / std::pow(shapeton::Pi, 4) * sum;
}

void
ExpectClose(double value, double truth, double relative, const std::string & what)
{
  EXPECT_NEAR(value, truth, relative * std::abs(truth)) << what;
}
} // namespace

TEST(ShapeSignature, OfABallHasTheClosedForms)
{
  const ShapeSignature ball = SignatureOf(Ball(20.0));
  ExpectClose(ball.volume, 4.0 / 3.0 * shapeton::Pi * 8000.0, 0.005, "volume");
  ExpectClose(ball.surface, 4.0 * shapeton::Pi * 400.0, 0.01, "surface");
  EXPECT_NEAR(ball.elongation, 1.0, 0.005);
  EXPECT_NEAR(ball.flatness, 1.0, 0.005);
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    EXPECT_NEAR(ball.remainingHeat[k], HeatOfBall(times[k]), 0.01) << times[k];
  }
  ExpectClose(ball.displacement.back(), 2.0 * 0.6, 0.01, "twice the square of the radius of gyration");
  // Eigenvalues l (l + 1) with multiplicity 2 l + 1 on a sphere of area 4 pi.
  for (std::size_t i = 0; i < 15; ++i)
  {
    const int l = i < 3 ? 1 : i < 8 ? 2 : 3;
    ExpectClose(ball.spectrum[i], 4.0 * shapeton::Pi * l * (l + 1), 0.02, "eigenvalue " + std::to_string(i + 1));
  }
}

TEST(ShapeSignature, OfABoxHasTheClosedFormsHoweverItLies)
{
  const Eigen::Vector3d sides(16.0, 24.0, 44.0);
  const double          radius = std::cbrt(0.75 * sides.prod() / shapeton::Pi);
  for (const double degrees : { 0.0, 30.0 })
  {
    const ShapeSignature box = SignatureOf(Turned(Box(sides), degrees, { 1.0, 2.0, -1.0 }));
    ExpectClose(box.volume, sides.prod(), 0.02, "volume");
    ExpectClose(box.surface, 2.0 * (16.0 * 24.0 + 24.0 * 44.0 + 44.0 * 16.0), 0.05, "surface");
    ExpectClose(box.elongation, 44.0 / 24.0, 0.01, "elongation");
    ExpectClose(box.flatness, 24.0 / 16.0, 0.015, "flatness");
    for (std::size_t k = 0; k < times.size(); ++k)
    {
      const double t = times[k] * radius * radius;
      double       heat = 1.0, displacement = 0.0;
      for (const double side : sides)
      {
        heat *= HeatOfInterval(side, t);
        displacement += DisplacementInInterval(side, t) / (radius * radius);
      }
      EXPECT_NEAR(box.remainingHeat[k], heat, 0.015) << degrees << " degrees, time " << times[k];
      ExpectClose(box.displacement[k], displacement, 0.03, "displacement at " + std::to_string(times[k]));
    }
  }
}

TEST(ShapeSignature, HardlyChangesWithRotationScaleSamplingAndSlantedImages)
{
  const ShapeSignature  hammer = SignatureOf(Hammer());
  const Eigen::Vector3d axis(2.0, -1.0, 1.5);
  const Eigen::Matrix3d slant = Eigen::AngleAxisd(0.6, Eigen::Vector3d(1.0, 1.0, 0.3).normalized()).toRotationMatrix();
  const std::vector<std::pair<std::string, ShapeSignature>> copies{
    { "turned", SignatureOf(Turned(Hammer(), 30.0, axis)) },
    { "half", SignatureOf(Scaled(Hammer(), 0.5)) },
    { "double", SignatureOf(MakeImage({ 110, 110, 110 }), Scaled(Hammer(), 2.0)) },
    { "fine", SignatureOf(MakeImage({ 110, 110, 110 }, { 0.5, 0.5, 0.5 }), Hammer()) },
    { "slanted", SignatureOf(MakeImage({ 64, 64, 26 }, { 1.0, 1.0, 2.5 }, slant), Hammer()) },
    { "mirrored", SignatureOf([](const Eigen::Vector3d & p) {
        return Hammer()({ -p[0], p[1], p[2] });
      }) }
  };
  for (const auto & [how, copy] : copies)
  {
    const SignatureDifference difference = DifferenceOf(hammer, copy);
    EXPECT_LT(difference.remainingHeat, 0.08) << how;
    EXPECT_LT(difference.displacement, 0.035) << how;
    EXPECT_LT(difference.spectrum, 0.05) << how;
    EXPECT_LT(difference.surface, 0.14) << how; // the smallest copy has 900 voxels
    EXPECT_LT(difference.elongation, 0.03) << how;
    EXPECT_LT(difference.flatness, 0.03) << how;
  }
  const SignatureDifference other = DifferenceOf(hammer, SignatureOf(Box({ 13.0, 18.0, 25.0 })));
  EXPECT_GT(other.remainingHeat, 0.16); // another shape differs by more than twice the bounds
  EXPECT_GT(other.displacement, 0.07);
  EXPECT_GT(other.spectrum, 0.1);
}

TEST(ShapeSignature, CurvesKeepTheirOrder)
{
  const ShapeSignature hammer = SignatureOf(Hammer());
  EXPECT_TRUE(std::is_sorted(hammer.remainingHeat.rbegin(), hammer.remainingHeat.rend()));
  EXPECT_TRUE(std::is_sorted(hammer.displacement.begin(), hammer.displacement.end()));
  EXPECT_TRUE(std::is_sorted(hammer.spectrum.begin(), hammer.spectrum.end()));
}

TEST(ShapeSignature, IsTheSameForAnyNumberOfThreads)
{
  basetest::ExpectSameWithAnyThreads(
    [] {
      const ShapeSignature signature = SignatureOf(Hammer());
      return std::make_tuple(signature.remainingHeat, signature.displacement, signature.spectrum, signature.surface);
    },
    { 3 });
}

TEST(ShapeSignature, RefusesWhatHasNoShape)
{
  EXPECT_EQ(basetest::MessageOf([] { SignatureOf(Ball(2.0)); }),
            "InputError: it has 32 voxels, fewer than the 64 that a signature needs");
  // A sheet of 400 x 400 x 1 voxels; the ball of equal volume has a radius of 34 voxels.
  EXPECT_NE(basetest::MessageOf([] {
              SignatureOf(MakeImage({ 402, 402, 3 }), Box({ 400.0, 400.0, 1.0 }));
            }).find("InputError: the shape is too thin for its size"),
            std::string::npos);
  const auto image = MakeImage({ 20, 20, 20 });
  Draw(image, Ball(6.0));
  EXPECT_THROW(ComputeShapeSignature(VoxelsOfLabel(image, 1), MakeImage({ 20, 20, 21 })), std::invalid_argument);
}
