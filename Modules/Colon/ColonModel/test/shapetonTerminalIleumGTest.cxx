#include "shapetonCecalScene.h"
#include "shapetonPi.h"
#include "shapetonTerminalIleum.h"

#include <gtest/gtest.h>

using cecalscene::Scene;

namespace
{
std::optional<shapeton::TerminalIleum>
Find(const Scene & scene, const cecalscene::Images & images)
{
  shapeton::IleocecalValve valve;
  valve.position = cecalscene::valveBase;
  return shapeton::FindTerminalIleum(images.lumen, cecalscene::Line(scene), valve);
}
} // namespace

TEST(TerminalIleum, IsCutOffTheColonAndNothingElseIs)
{
  Scene scene;
  scene.ileumLength = 50.0;
  const auto images = cecalscene::Draw(scene);
  const auto ileum = Find(scene, images);
  ASSERT_TRUE(ileum);
  EXPECT_NEAR(ileum->length, 46.0, 3.0); // 4 mm are not removed
  EXPECT_LT((ileum->mouth - Eigen::Vector3d(cecalscene::radius + 4.0, 0.0, 145.0)).norm(), 3.0);
  EXPECT_NEAR(ileum->volume, 1e-3 * shapeton::Pi * 25.0 * 46.0, 0.5);

  shapeton::TakeOut(*ileum, images.lumen.GetPointer());
  Scene colon = scene;
  colon.ileumLength = 0.0;
  int wrong = 0;
  basetest::ForVoxels(images.lumen, [&](const auto & index, const auto & point) {
    const bool isNearMouth = std::abs(point[0] - cecalscene::radius) < 7.0;
    const bool isLumen = cecalscene::IsLumen(colon, basetest::ToEigen(point));
    wrong += !isNearMouth && (images.lumen->GetPixel(index) != 0) != isLumen ? 1 : 0;
  });
  EXPECT_EQ(wrong, 0);
}

TEST(TerminalIleum, IsNoHaustrumAndNoColon)
{
  Scene scene;
  EXPECT_FALSE(Find(scene, cecalscene::Draw(scene)));
  scene.ileumLength = 20.0; // as deep as a haustrum
  EXPECT_FALSE(Find(scene, cecalscene::Draw(scene)));
  scene.ileumLength = 50.0;
  scene.ileumRadius = 12.0; // as wide as a colon
  EXPECT_FALSE(Find(scene, cecalscene::Draw(scene)));
}

/** A line through the colon to the height of the ileum, back and forth in the cecum, and then through the ileum to its
 * end, or to the pole if there is no ileum. The radius at a point is that of the largest inscribed ball. \param turns
 * number of extra turns, 48 mm each. */
shapeton::CurveSet
LineThroughIleum(const cecalscene::Scene & scene, int turns = 0)
{
  constexpr double reach = 12.0; // mm

  lumenshapes::Points points;
  std::vector<double> radii;
  const double        turn = scene.ileumLength > 0.0 ? 145.0 : cecalscene::end - 5.0;
  for (double z = 5.0; z < turn; z += 1.0)
  {
    points.emplace_back(scene.turn * Eigen::Vector3d(0.0, 0.0, z));
    radii.push_back(std::min(cecalscene::radius, cecalscene::end - z));
  }
  for (int mm = 0; mm < 48 * turns; ++mm)
  {
    const double y = std::abs(std::remainder(mm - reach, 4.0 * reach)) - reach; // a triangle wave, from 0
    points.emplace_back(scene.turn * Eigen::Vector3d(0.0, y, turn));
    radii.push_back(cecalscene::radius - std::abs(y));
  }
  for (double x = 0.0; x < cecalscene::radius + scene.ileumLength - 2.0; x += 1.0)
  {
    points.emplace_back(scene.turn * Eigen::Vector3d(x, 0.0, turn));
    radii.push_back(std::min(cecalscene::radius, std::hypot(std::max(0.0, cecalscene::radius - x), scene.ileumRadius)));
  }
  shapeton::CurveSet line = lumenshapes::Centerline(points);
  const auto         number = static_cast<Eigen::Index>(points.size());
  line.pointArrays[0].values = Eigen::VectorXd::LinSpaced(number, 0.0, static_cast<double>(number - 1)); // exactly
  line.pointArrays[1].values = Eigen::Map<Eigen::VectorXd>(radii.data(), number);
  return line;
}

TEST(RefluxedIleum, IsCutOffTheEndOfTheLine)
{
  cecalscene::Scene scene;
  scene.hasValve = false;
  scene.ileumRadius = 7.0;
  scene.turn = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const double length : { 60.0, 90.0 })
  {
    scene.ileumLength = length;
    const auto images = cecalscene::Draw(scene, Eigen::Vector3d(1.2, 1.0, 1.6));
    const auto ileum = shapeton::FindRefluxedIleum(images.lumen, LineThroughIleum(scene));
    ASSERT_TRUE(ileum);
    EXPECT_NEAR(length, ileum->length, 3.0);
    EXPECT_NEAR(1e-3 * 3.14159 * 49.0 * length, ileum->volume, 0.1 * ileum->volume);
    const Eigen::Vector3d mouth = scene.turn.transpose() * ileum->mouth;
    EXPECT_NEAR(cecalscene::radius, mouth.x(), 3.0);
    EXPECT_NEAR(145.0, mouth.z(), 1.0);
    std::size_t removed = 0;
    basetest::ForVoxels(ileum->mask, [&](const auto & index, const auto & point) {
      const Eigen::Vector3d p = scene.turn.transpose() * basetest::ToEigen(point);
      removed += ileum->mask->GetPixel(index) != 0 && p.x() < cecalscene::radius - 3.0;
    });
    EXPECT_EQ(0U, removed) << "voxels of the colon";
  }
}

TEST(RefluxedIleum, BeginsWhereTheLineLeavesTheCecumAfterTurns)
{
  cecalscene::Scene scene;
  scene.hasValve = false;
  scene.ileumRadius = 7.0;
  scene.ileumLength = 90.0;
  const auto ileum = shapeton::FindRefluxedIleum(cecalscene::Draw(scene).lumen, LineThroughIleum(scene, 4));
  ASSERT_TRUE(ileum);
  EXPECT_NEAR(ileum->length, 90.0, 3.0);
  EXPECT_NEAR(ileum->mouth.x(), cecalscene::radius, 3.0);
}

TEST(RefluxedIleum, MayBeWideFarFromTheValve)
{
  cecalscene::Scene scene;
  scene.hasValve = false;
  scene.ileumRadius = 7.0;
  scene.ileumLength = 90.0;
  const auto         images = cecalscene::Draw(scene);
  shapeton::CurveSet line = LineThroughIleum(scene);
  const auto         widen = [&](double radius) {
    line.pointArrays[1].values.bottomRows(35).setConstant(radius);
    return shapeton::FindRefluxedIleum(images.lumen, line).has_value();
  };
  EXPECT_TRUE(widen(13.4)); // as in a phantom
  EXPECT_FALSE(widen(15.1));
}

/** A line through the colon, the slit between the lips of the valve at 130 mm, and an ileum of 150 mm. Its middle is 3
 * mm wide at the slit. */
shapeton::CurveSet
LineThroughValve(double lengthOfColon, double radiusOfSlit)
{
  const double        colon = cecalscene::valveBase.z();
  lumenshapes::Points points;
  std::vector<double> radii;
  for (double z = colon - lengthOfColon; z < colon; z += 1.0)
  {
    points.emplace_back(0.0, 0.0, z);
    radii.push_back(cecalscene::radius);
  }
  for (double x = 0.0; x < cecalscene::radius + 150.0; x += 1.0)
  {
    points.emplace_back(x, 0.0, colon);
    const double inTube = std::max(0.0, cecalscene::radius - 9.0 - x);
    radii.push_back(inTube > 0.0 ? std::max(inTube, radiusOfSlit) : x < cecalscene::radius ? radiusOfSlit : 7.0);
  }
  shapeton::CurveSet line = lumenshapes::Centerline(points);
  const auto         number = static_cast<Eigen::Index>(points.size());
  line.pointArrays[0].values = Eigen::VectorXd::LinSpaced(number, 0.0, static_cast<double>(number - 1));
  line.pointArrays[1].values = Eigen::Map<Eigen::VectorXd>(radii.data(), number);
  return line;
}

/** An open valve of two lips, and an ileum to the border of the image behind the slit. \param ml volume of the ileum.
 */
cecalscene::Images
OpenValve(double radiusOfSlit, double radiusOfIleum, double & ml)
{
  cecalscene::Scene scene;
  scene.hasTwoLips = true;
  const auto images = cecalscene::Draw(scene);
  ml = 0.0;
  basetest::ForVoxels(images.lumen, [&](const auto & index, const auto & point) {
    const double fromAxis = std::hypot(point[1], point[2] - cecalscene::valveBase.z());
    const bool   isIleum = point[0] >= cecalscene::radius && fromAxis < radiusOfIleum;
    const bool   isSlit = point[0] > 0.0 && point[0] < cecalscene::radius && fromAxis < radiusOfSlit;
    ml += isIleum ? 1e-3 * 1.5 * 1.5 * 1.5 : 0.0;
    images.lumen->SetPixel(index, isIleum || isSlit ? 1 : images.lumen->GetPixel(index));
  });
  return images;
}

TEST(TerminalIleum, MayBeWideBehindASlit)
{
  cecalscene::Scene scene;
  scene.hasTwoLips = true;
  const auto find = [&](double radiusOfSlit, double radiusOfIleum, double & ml) {
    return Find(scene, OpenValve(radiusOfSlit, radiusOfIleum, ml));
  };
  double     ml = 0.0;
  const auto ileum = find(1.6, 12.0, ml);
  ASSERT_TRUE(ileum);
  EXPECT_NEAR(ileum->volume, ml, 0.05 * ml);
  EXPECT_LT((ileum->mouth - cecalscene::valveBase).norm(), 10.0);
  EXPECT_FALSE(find(1.6, 17.0, ml)) << "wider than an ileum";
  EXPECT_FALSE(find(6.0, 12.0, ml)) << "no slit";
}

TEST(IleumBehindValve, IsCutOffWhereTheLinePassesTheValve)
{
  double     ml = 0.0;
  const auto images = OpenValve(1.6, 7.0, ml);
  const auto ileum = shapeton::FindIleumBehindValve(images.lumen, images.ct, LineThroughValve(700.0, 2.0));
  ASSERT_TRUE(ileum);
  EXPECT_NEAR(ileum->length, 160.0, 3.0); // with the slit between the lips
  EXPECT_LT((ileum->mouth - cecalscene::valveBase).norm(), 15.0);
  EXPECT_NEAR(ileum->volume, ml, 1.0);
  EXPECT_FALSE(shapeton::FindIleumBehindValve(images.lumen, images.ct, LineThroughValve(700.0, 5.0))) << "no slit";
  EXPECT_FALSE(shapeton::FindIleumBehindValve(images.lumen, images.ct, LineThroughValve(500.0, 2.0))) << "no colon";
  const auto plain = cecalscene::Draw({ false });
  EXPECT_FALSE(shapeton::FindIleumBehindValve(plain.lumen, plain.ct, LineThroughValve(700.0, 2.0))) << "no valve";
}

TEST(RefluxedIleum, IsNoColon)
{
  cecalscene::Scene scene;
  scene.hasValve = false;
  const auto cecum = cecalscene::Draw(scene);
  EXPECT_FALSE(shapeton::FindRefluxedIleum(cecum.lumen, LineThroughIleum(scene))) << "the line ends in the cecum";
  scene.ileumLength = 80.0;
  scene.ileumRadius = 17.0;
  const auto wide = cecalscene::Draw(scene);
  EXPECT_FALSE(shapeton::FindRefluxedIleum(wide.lumen, LineThroughIleum(scene))) << "as wide as colon";
  scene.ileumRadius = 7.0;
  const auto narrow = cecalscene::Draw(scene);
  basetest::ForVoxels(narrow.lumen, [&](const auto & index, const auto & point) {
    if (point[2] > 152.0)
    {
      narrow.lumen->SetPixel(index, 0);
    }
  });
  EXPECT_FALSE(shapeton::FindRefluxedIleum(narrow.lumen, LineThroughIleum(scene)))
    << "a spastic colon, no cecum beside it";
}

TEST(TerminalIleum, LeavesAtTheValve)
{
  Scene scene;
  scene.ileumLength = 50.0;
  shapeton::IleocecalValve elsewhere;
  elsewhere.position = { -cecalscene::radius, 0.0, 100.0 };
  const auto images = cecalscene::Draw(scene);
  EXPECT_FALSE(shapeton::FindTerminalIleum(images.lumen, cecalscene::Line(scene), elsewhere));
}
