#include "shapetonExactOrientation.h"

#include "shapetonFlatDistortion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Place = Eigen::RowVector2d;

/** Moves x by the given number of ulps. */
double
Stepped(double x, int steps)
{
  for (int i = 0; i < std::abs(steps); ++i)
  {
    x = std::nextafter(x, steps > 0 ? 2.0 * x : 0.0);
  }
  return x;
}
} // namespace

TEST(ExactOrientation, TellsTheTurnOfTriangles)
{
  const Place a(0, 0), b(3, 1), c(1, 2);
  EXPECT_EQ(1, shapeton::ExactOrientation(a, b, c));
  EXPECT_EQ(1, shapeton::ExactOrientation(b, c, a));
  EXPECT_EQ(-1, shapeton::ExactOrientation(a, c, b));
  EXPECT_EQ(0, shapeton::ExactOrientation(a, b, a));
  EXPECT_EQ(0, shapeton::ExactOrientation(a, b, 5.0 * b));
}

TEST(ExactOrientation, StepsOfTheLastBitCount)
{
  // Kettner et al., Classroom examples of robustness problems (2008): near the line y = x the sign is the sign of the
  // steps.
  const Place b(12.0, 12.0), c(24.0, 24.0);
  for (int i = -20; i <= 20; ++i)
  {
    for (int k = -20; k <= 20; ++k)
    {
      const Place a(Stepped(0.5, i), Stepped(0.5, k));
      const int   sign = a[0] < a[1] ? 1 : a[0] > a[1] ? -1 : 0;
      EXPECT_EQ(sign, shapeton::ExactOrientation(a, b, c)) << i << ' ' << k;
      EXPECT_EQ(-sign, shapeton::ExactOrientation(b, a, c)) << i << ' ' << k;
    }
  }
}

TEST(ExactOrientation, TermsOfManyMagnitudesDoNotCancel)
{
  // Offsets from the line y = x far below one ulp of the larger coordinates.
  const double tiny = std::ldexp(1.0, -60);
  const Place  b(1.0, 1.0), c(1e8, 1e8);
  EXPECT_EQ(0, shapeton::ExactOrientation({ tiny, tiny }, b, c));
  EXPECT_EQ(1, shapeton::ExactOrientation({ 0.0, tiny }, b, c));
  EXPECT_EQ(-1, shapeton::ExactOrientation({ tiny, 0.0 }, b, c));
}

TEST(ExactOrientation, FlippedFacesAreThoseOfTheLesserArea)
{
  shapeton::FaceMatrix F(4, 3);
  F << 0, 1, 2, 0, 2, 3, 0, 2, 4, 0, 2, 2;
  Eigen::MatrixX2d uv(5, 2);
  uv << 0, 0, 2, 0, 2, 2, 0, 2, 1, std::nextafter(1.0, 0.0); // the last point is just below the diagonal
  EXPECT_EQ((std::vector<char>{ 0, 0, 1, 1 }), shapeton::FlippedFaces(F, uv));
}
