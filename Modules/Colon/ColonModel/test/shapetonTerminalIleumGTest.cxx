#include "shapetonCecalScene.h"
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
  EXPECT_NEAR(ileum->volume, 1e-3 * M_PI * 25.0 * 46.0, 0.5);

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

TEST(TerminalIleum, LeavesAtTheValve)
{
  Scene scene;
  scene.ileumLength = 50.0;
  shapeton::IleocecalValve elsewhere;
  elsewhere.position = { -cecalscene::radius, 0.0, 100.0 };
  const auto images = cecalscene::Draw(scene);
  EXPECT_FALSE(shapeton::FindTerminalIleum(images.lumen, cecalscene::Line(scene), elsewhere));
}
