#include "shapetonPelvis.h"

#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Image = itk::Image<float, 3>;
using Eigen::Vector3d;

/** A pelvis of simple solids, LPS, mm: hip bones, lumbar spine and sacrum. */
struct SolidPelvis
{
  double crest{ 40.0 };
  bool   hasSpine{ true };
  bool   hasGasAtHips{ false };

  static bool
  IsIn(double value, double low, double high)
  {
    return value >= low && value <= high;
  }
  bool
  IsHip(const Vector3d & p) const
  {
    const double lateral = std::abs(p.x());
    return IsIn(p.z(), -110.0, crest) && IsIn(p.y(), -40.0, 80.0) && std::abs(lateral - 95.0) < 8.0;
  }
  /** The front edge of the spine is at y = 10; from the promontory at z = -20, the sacrum recedes by 2 mm per mm. */
  bool
  IsSpine(const Vector3d & p) const
  {
    const double front = p.z() >= -20.0 ? 10.0 : 10.0 + 2.0 * (-20.0 - p.z());
    return hasSpine && std::abs(p.x()) < 20.0 && IsIn(p.z(), -60.0, 140.0) && IsIn(p.y(), front, front + 35.0);
  }
  /** Contrast agent in the bowel in front of the sacrum and the iliac bones. */
  static bool
  IsContrast(const Vector3d & p)
  {
    return (p - Vector3d(0, -40, -50)).norm() < 30.0 || (p - Vector3d(70, -40, 60)).norm() < 12.0;
  }
  float
  ValueAt(const Vector3d & p) const
  {
    const bool isGas = hasGasAtHips && IsIn(std::abs(p.x()) - 103.0, 0.0, 12.0) && IsIn(p.z(), -110.0, crest);
    const bool isBody = std::hypot(p.x() / 160.0, p.y() / 110.0) < 1.0;
    return IsHip(p) || IsSpine(p) ? 350.0F : IsContrast(p) ? 500.0F : !isBody || isGas ? -1000.0F : 40.0F;
  }
};

Image::Pointer
ImageOf(const SolidPelvis & pelvis,
        const Vector3d &    low,
        const Vector3d &    extent,
        const Vector3d &    spacing,
        double              tilt)
{
  const auto      axes = Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
  Image::SizeType size;
  for (int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<itk::SizeValueType>(extent[a] / spacing[a]);
  }
  const auto image = basetest::NewImageInFrame<Image>(size, spacing, low, axes);
  basetest::Sample(image.GetPointer(), [&](const auto & point) { return pelvis.ValueAt(basetest::ToEigen(point)); });
  return image;
}

Image::Pointer
WholeImage(const SolidPelvis & pelvis)
{
  return ImageOf(pelvis, { -170, -120, -130 }, { 340, 240, 260 }, { 1.5, 1.5, 2.0 }, 0.0);
}

void
ExpectPelvis(const std::optional<shapeton::Pelvis> & found, const SolidPelvis & pelvis)
{
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->leftCrest.z(), pelvis.crest, 5.0);
  EXPECT_NEAR(found->rightCrest.z(), pelvis.crest, 5.0);
  EXPECT_NEAR(found->leftCrest.x(), 95.0, 4.0);
  EXPECT_NEAR(found->rightCrest.x(), -95.0, 4.0);
  EXPECT_NEAR(found->promontory.x(), 0.0, 6.0);
  EXPECT_NEAR(found->promontory.y(), 10.0, 6.0);
  EXPECT_NEAR(found->promontory.z(), -20.0, 8.0);
}
} // namespace

TEST(Pelvis, IsFoundBesideContrastAgent)
{
  const SolidPelvis pelvis;
  ExpectPelvis(shapeton::FindPelvis(WholeImage(pelvis)), pelvis);
}

TEST(Pelvis, IsFoundInAnObliqueAnisotropicImage)
{
  const SolidPelvis pelvis;
  ExpectPelvis(shapeton::FindPelvis(ImageOf(pelvis, { -170, -40, -210 }, { 340, 340, 340 }, { 1.2, 1.6, 3.5 }, 0.35)),
               pelvis);
}

TEST(Pelvis, IsNotInViewOfACroppedScan)
{
  const SolidPelvis pelvis;
  const auto        crop = [&](double low, double height) {
    return shapeton::FindPelvis(ImageOf(pelvis, { -170, -120, low }, { 340, 240, height }, { 2, 2, 2 }, 0.0));
  };
  EXPECT_FALSE(crop(45.0, 90.0));    // above the crests
  EXPECT_FALSE(crop(-10.0, 140.0));  // only the tops of the hip bones
  EXPECT_FALSE(crop(-130.0, 165.0)); // below the crests
}

TEST(Pelvis, IsNotContrastAgentBesideGas)
{
  SolidPelvis fluid;
  fluid.hasGasAtHips = true;
  EXPECT_FALSE(shapeton::FindPelvis(WholeImage(fluid)));
  SolidPelvis painted;
  painted.hasSpine = false;
  EXPECT_FALSE(shapeton::FindPelvis(WholeImage(painted)));
}

TEST(Pelvis, IsMirrored)
{
  const shapeton::Pelvis pelvis{ { 90, 1, 2 }, { -80, 3, 4 }, { 5, 6, 7 } };
  const shapeton::Pelvis mirrored = shapeton::Mirrored(pelvis);
  EXPECT_EQ(mirrored.leftCrest, Vector3d(80, 3, 4));
  EXPECT_EQ(mirrored.rightCrest, Vector3d(-90, 1, 2));
  EXPECT_EQ(mirrored.promontory, Vector3d(-5, 6, 7));
}
