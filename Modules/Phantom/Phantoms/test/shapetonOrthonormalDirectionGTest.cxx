#include "shapetonOrthonormalDirection.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using MatrixType = itk::Matrix<double, 3, 3>;

MatrixType
Rounded30Degrees()
{
  MatrixType direction;
  direction.SetIdentity();
  direction(0, 0) = direction(1, 1) = 0.866;
  direction(1, 0) = 0.5;
  direction(0, 1) = -0.5;
  return direction;
}

double
DistanceFromOrthonormal(const MatrixType & direction)
{
  MatrixType identity;
  identity.SetIdentity();
  const auto difference = direction.GetTranspose() * direction.GetVnlMatrix().as_matrix() - identity.GetVnlMatrix();
  return difference.absolute_value_max();
}
} // namespace

TEST(OrthonormalDirection, RemovesRounding)
{
  auto direction = Rounded30Degrees();
  EXPECT_GT(DistanceFromOrthonormal(direction), 1e-5);
  ASSERT_TRUE(shapeton::MakeOrthonormal(direction, 1e-3));
  EXPECT_LT(DistanceFromOrthonormal(direction), 1e-15);
  EXPECT_NEAR(direction(0, 0), 0.866, 1e-4);
  EXPECT_NEAR(direction(0, 1), -0.5, 1e-4);
}

TEST(OrthonormalDirection, KeepsHandedness)
{
  auto direction = Rounded30Degrees();
  EXPECT_FALSE(shapeton::IsLeftHanded(direction));
  direction(2, 2) = -1.0;
  ASSERT_TRUE(shapeton::MakeOrthonormal(direction, 1e-3));
  EXPECT_TRUE(shapeton::IsLeftHanded(direction));
  EXPECT_DOUBLE_EQ(direction(2, 2), -1.0);
}

TEST(OrthonormalDirection, KeepsTheIdentityExactly)
{
  MatrixType direction;
  direction.SetIdentity();
  const MatrixType before = direction;
  ASSERT_TRUE(shapeton::MakeOrthonormal(direction, 1e-3));
  EXPECT_EQ(direction, before);
}

TEST(OrthonormalDirection, RefusesSkewScaledAndNonFinite)
{
  const auto good = Rounded30Degrees();
  auto       bad = good;
  bad(0, 2) = 0.1;
  EXPECT_FALSE(shapeton::MakeOrthonormal(bad, 1e-3));
  bad = good;
  bad(2, 2) = 1.01;
  EXPECT_FALSE(shapeton::MakeOrthonormal(bad, 1e-3));
  EXPECT_DOUBLE_EQ(bad(2, 2), 1.01);
  bad(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(shapeton::MakeOrthonormal(bad, 1e-3));
}
