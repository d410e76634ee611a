#include "shapetonRectalCatheter.h"

#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonTestScene.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

namespace
{
using shapeton::At;
using shapeton::ColonTestScene;
using shapeton::Tube;
using shapeton::TurnedAxes;
using Vec = ColonTestScene::Vec;
using ImageType = itk::Image<float, 3>;

constexpr double Rectum = 18.0; // mm, radius
constexpr double Bore = 2.5;
constexpr double Outer = 5.0;
constexpr double Plastic = 150.0; // HU

/** Tube along z through (x, y) up to `tip`, bent by `bend` mm toward x within the rectum. */
std::function<double(const Vec &)>
BentTube(double x, double y, double tip, double radius, double bend)
{
  return [=](const Vec & p) {
    const double share = std::max(0.0, p[2] + 20.0) / 60.0;
    return std::min(radius - std::hypot(p[0] - x - bend * share * share, p[1] - y), tip - p[2]);
  };
}

/** A rectum from z = -20 to 56 in a body that ends at z = -45, and a catheter through both with its tip at `tip`. */
ColonTestScene
RectumScene(double tip, double y = 0.0, double wall = Plastic, double bend = 0.0)
{
  return ColonTestScene({ { BentTube(0, y, tip - 4.0, Bore, bend), 1e9, 0.0 },
                          { BentTube(0, y, tip, Outer, bend), -1e9, wall },
                          { Tube(At(0, 0, 18), 2, 20, Rectum), 1e9, 0.0 },
                          { [](const Vec & p) { return -45.0 - p[2]; }, 1e9, 0.0 } },
                        36.0);
}

ImageType::Pointer
Sampled(const ColonTestScene & scene, const std::array<double, 3> & spacing, const itk::Matrix<double, 3, 3> & axes)
{
  std::array<int, 3> size;
  for (int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<int>((a < 2 ? 80.0 : 116.0) / spacing[a]);
  }
  return shapeton::SampledImage(scene, size, spacing, axes);
}

shapeton::ColonLumen
Segment(const ImageType * image)
{
  shapeton::ColonLumenSettings options;
  options.position = "HFS";
  return shapeton::SegmentColonLumen(image, options);
}

shapeton::ColonLumen
Segment(const ColonTestScene & scene)
{
  return Segment(Sampled(scene, { 1.1, 1.1, 1.1 }, TurnedAxes(0.0, 0.0)));
}

/** Voxels in the rectum, farther than `margin` mm from its wall, that are not lumen. */
int
HolesInRectum(const shapeton::ColonLumen & lumen, double margin)
{
  const auto   inside = Tube(At(0, 0, 18), 2, 20, Rectum - margin);
  int          holes = 0;
  const auto * labels = lumen.labels.GetPointer();
  basetest::ForVoxels(labels, [&](const auto & index, const auto & x) {
    holes += inside(x.GetVectorFromOrigin()) > 0.0 && labels->GetPixel(index) == 0;
  });
  return holes;
}

void
ExpectTube(const shapeton::ColonLumen & lumen, double tip, double margin = 2.0)
{
  ASSERT_TRUE(lumen.catheter.has_value());
  const auto & catheter = *lumen.catheter;
  EXPECT_TRUE(catheter.isSure) << catheter.evidence.confidence;
  EXPECT_NEAR(catheter.boreDiameter, 2.0 * Bore, 0.4);
  EXPECT_NEAR(catheter.outerDiameter, 2.0 * Outer, 0.4);
  EXPECT_NEAR(catheter.axis.front()[2], -45.0, 4.0);
  EXPECT_NEAR(catheter.axis.back()[2], tip, 2.5);
  EXPECT_EQ(HolesInRectum(lumen, margin), 0);
}

TEST(RectalCatheter, ATubeInGasIsFoundAndFilledIn)
{
  const auto lumen = Segment(RectumScene(24.0));
  ExpectTube(lumen, 24.0);
  EXPECT_NEAR(lumen.catheter->wallHU, Plastic, 60.0);
  EXPECT_GT(lumen.catheter->evidence.enclosedLength, 25.0);
  EXPECT_EQ(lumen.catheter->balloonDiameter, 0.0);
  ASSERT_FALSE(lumen.warnings.empty());
  EXPECT_NE(lumen.warnings.back().find("a rectal catheter, which was filled in"), std::string::npos);
}

TEST(RectalCatheter, AxesAndSpacingMakeNoDifference)
{
  ExpectTube(Segment(Sampled(RectumScene(24.0), { 0.8, 0.9, 1.5 }, TurnedAxes(0.3, 0.25))), 24.0);
}

TEST(RectalCatheter, ATubeInFluidIsFoundAndFilledIn)
{
  auto scene = RectumScene(24.0, 10.5);
  scene.lumens[2].level = 4.0;
  scene.lumens[2].fluid = 700.0;
  ExpectTube(Segment(scene), 24.0);
}

TEST(RectalCatheter, ASoftBentTubeIsFoundAndFilledIn) { ExpectTube(Segment(RectumScene(24.0, 0.0, 30.0, 10.0)), 24.0); }

/** A balloon with a diameter of 22 mm and a 1.6 mm membrane. */
ColonTestScene
BalloonScene(double content, double membraneHU)
{
  constexpr double radius = 11.0, membrane = 1.6;
  auto             scene = RectumScene(24.0);
  const auto       ball = [](double r) { return [r](const Vec & x) { return r - (x - At(0, 0, 6)).GetNorm(); }; };
  const double     level = content < 0.0 ? 1e9 : -1e9;
  scene.lumens.insert(scene.lumens.begin() + 2,
                      { { ball(radius), level, content }, { ball(radius + membrane), -1e9, membraneHU } });
  return scene;
}

void
ExpectBalloon(const ColonTestScene & scene)
{
  const auto lumen = Segment(scene);
  ExpectTube(lumen, 24.0);
  EXPECT_NEAR(lumen.catheter->balloonDiameter, 25.2, 1.0);
  EXPECT_LT((lumen.catheter->balloonCenter.GetVectorFromOrigin() - At(0, 0, 6)).GetNorm(), 0.5);
}

TEST(RectalCatheter, ABalloonOfGasIsFilledIn) { ExpectBalloon(BalloonScene(-1000.0, 60.0)); }

TEST(RectalCatheter, ABalloonOfWaterIsFilledIn) { ExpectBalloon(BalloonScene(8.0, 60.0)); }

TEST(RectalCatheter, ABalloonOfGasInFluidIsFilledIn)
{
  auto scene = BalloonScene(-1000.0, 60.0);
  scene.lumens[4].level = 6.0; // the rectum
  scene.lumens[4].fluid = 700.0;
  ExpectBalloon(scene);
}

/** Blur reduces the membrane to less than half its contrast, so the gas on both sides is connected. */
TEST(RectalCatheter, ABalloonWithAThinMembraneIsSeen) { ExpectBalloon(BalloonScene(-1000.0, -550.0)); }

/** A collar around the tube with flat ends is not a balloon. */
TEST(RectalCatheter, ACollarIsNoBalloon)
{
  auto       scene = RectumScene(24.0);
  const auto collar = [](const Vec & x) { return std::min(10.0 - std::hypot(x[0], x[1]), 7.0 - std::abs(x[2] - 6.0)); };
  scene.lumens.insert(scene.lumens.begin() + 2, { collar, -1e9, 40.0 });
  const auto lumen = Segment(scene);
  ASSERT_TRUE(lumen.catheter && lumen.catheter->isSure);
  EXPECT_EQ(lumen.catheter->balloonDiameter, 0.0);
}

/** A deflated balloon is a sleeve around the tube. */
TEST(RectalCatheter, ASleeveIsNoBalloon)
{
  auto       scene = RectumScene(24.0);
  const auto sleeve = Tube(At(0, 0, 6), 2, 3.0, 6.5);
  scene.lumens.insert(scene.lumens.begin() + 2, { sleeve, -1e9, 60.0 });
  const auto lumen = Segment(scene);
  ExpectTube(lumen, 24.0);
  EXPECT_EQ(lumen.catheter->balloonDiameter, 0.0);
}

TEST(RectalCatheter, TheAxisRunsInTheMiddleOfTheBore)
{
  constexpr double bend = 10.0, y = -6.0;
  const auto       lumen = Segment(RectumScene(24.0, y, Plastic, bend));
  ASSERT_TRUE(lumen.catheter.has_value());
  int number = 0;
  for (const auto & p : lumen.catheter->axis)
  {
    if (p[2] < 14.0) // above, it closes at the tip
    {
      const double share = std::max(0.0, p[2] + 20.0) / 60.0;
      EXPECT_LT(std::hypot(p[0] - bend * share * share, p[1] - y), 0.25) << p;
      ++number;
    }
  }
  EXPECT_GT(number, 50);
}

/** The result is invariant to spacing and to mirroring from left to right. */
TEST(RectalCatheter, MirrorAndResamplingKeepIt)
{
  auto       scene = RectumScene(24.0, -6.0, Plastic, 8.0);
  const auto one = Segment(scene).catheter;
  const auto at = scene.lumens;
  for (std::size_t n = 0; n < at.size(); ++n)
  {
    scene.lumens[n].depth = [depth = at[n].depth](const Vec & x) { return depth(At(-x[0], x[1], x[2])); };
  }
  const auto other = Segment(Sampled(scene, { 1.3, 1.3, 1.3 }, TurnedAxes(0.0, 0.0))).catheter;
  ASSERT_TRUE(one && other && one->isSure && other->isSure);
  EXPECT_NEAR(other->boreDiameter, one->boreDiameter, 0.3);
  EXPECT_NEAR(other->outerDiameter, one->outerDiameter, 0.3);
  const auto p = one->axis[one->axis.size() / 2];
  double     nearest = 1e9;
  for (const auto & q : other->axis)
  {
    nearest = std::min(nearest, (At(-q[0], q[1], q[2]) - p.GetVectorFromOrigin()).GetNorm());
  }
  EXPECT_LT(nearest, 0.8);
}

TEST(RectalCatheter, ABowelWithoutOneHasNone)
{
  auto scene = RectumScene(24.0);
  scene.lumens.erase(scene.lumens.begin(), scene.lumens.begin() + 2);
  EXPECT_FALSE(Segment(scene).catheter.has_value());
  // A collapsed bowel is a thread of gas in tissue.
  scene.lumens.push_back({ BentTube(0, 26, 30, Bore, 0), 1e9, 0.0 });
  EXPECT_FALSE(Segment(scene).catheter.has_value());
  // A slit between two folds has walls on two sides only.
  scene.fold = [](const Vec & x) { return std::min({ 4.0 - std::abs(x[0]), std::abs(x[0]) - 2.0, x[1] }); };
  EXPECT_FALSE(Segment(scene).catheter.has_value());
}

/** Rays toward the adjacent wall end in tissue. */
TEST(RectalCatheter, ATubeThatSinksOntoTheWallIsFoundAndFilledIn)
{
  ExpectTube(Segment(RectumScene(24.0, 4.0, 30.0, (Rectum - Outer) / 0.54)), 24.0);
}

/** Gas next to the tube, connected by a hole in its wall, does not shift the axis. */
TEST(RectalCatheter, TheAxisKeepsToTheBoreWhereItBranches)
{
  auto       scene = RectumScene(24.0);
  const auto hole = Tube(At(0, 4.5, -36), 1, 4.5, 1.6);
  const auto thread = Tube(At(0, 9, -28), 2, 7.0, 1.8);
  scene.lumens.insert(scene.lumens.begin(), { { hole, 1e9, 0.0 }, { thread, 1e9, 0.0 } });
  const auto lumen = Segment(scene);
  ExpectTube(lumen, 24.0);
  for (const auto & p : lumen.catheter->axis)
  {
    EXPECT_LT(std::hypot(p[0], p[1]), 1.0) << p;
  }
}

/** A tube with only a few millimeters in the rectum is a doubtful catheter. */
TEST(RectalCatheter, AShortPieceInTheRectumIsDoubtful)
{
  const auto lumen = Segment(RectumScene(-10.0));
  ASSERT_TRUE(lumen.catheter.has_value());
  EXPECT_FALSE(lumen.catheter->isSure);
  EXPECT_EQ(lumen.catheter->filledMl, 0.0);
  EXPECT_NE(lumen.warnings.back().find("it may be a catheter"), std::string::npos);
}
} // namespace
