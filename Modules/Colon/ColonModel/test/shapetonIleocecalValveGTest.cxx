#include "shapetonCecalScene.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

using cecalscene::Scene;
using shapeton::ValveSearch;

namespace
{
/** The center of the valve surface is between its base and its top, which is 11 mm above the base. */
void
ExpectValve(const ValveSearch & search, const Eigen::Matrix3d & turn)
{
  ASSERT_TRUE(search.valve) << search.reason;
  const Eigen::Vector3d top = turn * (cecalscene::valveBase - Eigen::Vector3d(11.0, 0.0, 0.0));
  EXPECT_LT((search.valve->position - top).norm(), 5.0);
  EXPECT_NEAR(search.valve->arcLength, 1000.0 + cecalscene::valveBase.z() - 5.0, 6.0);
  EXPECT_GE(search.valve->confidence, 0.5);
  EXPECT_LE(search.valve->confidence, 1.0);
}

Eigen::Matrix3d
Turn()
{
  return Eigen::AngleAxisd(0.6, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}
} // namespace

TEST(IleocecalValve, IsABulgeOfFat)
{
  const Scene       scene;
  const auto        images = cecalscene::Draw(scene);
  const ValveSearch search = cecalscene::Search(scene, images);
  ExpectValve(search, scene.turn);
  EXPECT_NEAR(search.valve->attenuation, -80.0, 15.0);
  EXPECT_GT(search.valve->length, 12.0); // the foot is not part of the bulge
  EXPECT_LT(search.valve->length, 24.0);
}

TEST(IleocecalValve, IsFoundByShapeAloneWithLessConfidence)
{
  const Scene       scene;
  const auto        images = cecalscene::Draw(scene);
  const ValveSearch alone = cecalscene::Search(scene, images, false);
  ExpectValve(alone, scene.turn);
  EXPECT_FALSE(std::isfinite(alone.valve->attenuation));
  EXPECT_LT(alone.valve->confidence, cecalscene::Search(scene, images).valve->confidence);
}

TEST(IleocecalValve, IsNoFoldAndNoBubble)
{
  Scene scene;
  scene.hasValve = false;
  scene.hasFold = true;
  const ValveSearch fold = cecalscene::Search(scene, cecalscene::Draw(scene));
  EXPECT_FALSE(fold.valve);
  EXPECT_FALSE(fold.reason.empty());
  scene.hasValve = true;
  scene.core = -900.0F;
  const ValveSearch bubble = cecalscene::Search(scene, cecalscene::Draw(scene));
  EXPECT_FALSE(bubble.valve);
  EXPECT_NE(bubble.reason.find("likely"), std::string::npos);
}

TEST(IleocecalValve, HasTwoLipsAndAPolypHasNone)
{
  Scene scene;
  scene.hasTwoLips = true;
  scene.hasPolyp = true;
  scene.core = 40.0F; // as the polyp
  const ValveSearch search = cecalscene::Search(scene, cecalscene::Draw(scene, Eigen::Vector3d::Constant(1.0)));
  ASSERT_TRUE(search.valve) << search.reason;
  EXPECT_LT((search.valve->position - cecalscene::valveBase).norm(), 12.0);
}

TEST(IleocecalValve, DoesNotDependOnAxesAndSpacings)
{
  const Scene scene;
  ExpectValve(cecalscene::Search(scene, cecalscene::Draw(scene, { 0.9, 1.6, 2.0 }, Turn())), scene.turn);
}

TEST(IleocecalValve, TurnsWithThePatientAndMirrors)
{
  Scene scene;
  scene.turn = Turn();
  ExpectValve(cecalscene::Search(scene, cecalscene::Draw(scene)), scene.turn);

  const ValveSearch straight = cecalscene::Search({}, cecalscene::Draw({}));
  Scene             mirrored;
  mirrored.turn.diagonal() << -1.0, 1.0, 1.0;
  const ValveSearch mirror = cecalscene::Search(mirrored, cecalscene::Draw(mirrored));
  ExpectValve(mirror, mirrored.turn);
  EXPECT_NEAR(mirror.valve->confidence, straight.valve->confidence, 0.05);
}

TEST(IleocecalValve, IsTheSameForAnyNumberOfThreads)
{
  const auto images = cecalscene::Draw({});
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const ValveSearch search = cecalscene::Search({}, images);
      return std::make_pair(search.valve.value().position, search.valve->confidence);
    },
    { 5 });
}

TEST(IleocecalValve, GoesWithTheCenterline)
{
  shapeton::CurveSet line = cecalscene::Line({});
  EXPECT_FALSE(shapeton::IleocecalValveOf(line));
  shapeton::IleocecalValve valve;
  valve.position = { 1.0, -2.0, 3.0 };
  valve.arcLength = 1100.0;
  valve.length = 25.0;
  valve.width = 12.0;
  valve.confidence = 0.75;
  ValveSearch search;
  search.valve = valve;
  search.candidates = { valve, valve };
  search.candidates[1].attenuation = -80.0;
  const ValveSearch read = shapeton::ValveFromJson(shapeton::ValveToJson(search));
  EXPECT_EQ(shapeton::ValveToJson(read), shapeton::ValveToJson(search));
  EXPECT_EQ(read.candidates[1].attenuation, -80.0);
  EXPECT_THROW(shapeton::ValveFromJson({ { "found", true } }), shapeton::InputError);
  shapeton::SetIleocecalValve(search, line);
  EXPECT_EQ(shapeton::ValveCandidatesOf(line).size(), 2U);
  const auto back = shapeton::IleocecalValveOf(line);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->position, valve.position);
  EXPECT_EQ(back->arcLength, valve.arcLength);
  EXPECT_EQ(back->confidence, valve.confidence);
  for (shapeton::SurfaceArray & array : line.fieldArrays)
  {
    array.values.resize(1, 3);
  }
  EXPECT_THROW(shapeton::IleocecalValveOf(line), shapeton::InputError);
  EXPECT_THROW(shapeton::ValveCandidatesOf(line), shapeton::InputError);
  shapeton::SetIleocecalValve(ValveSearch(), line);
  EXPECT_FALSE(shapeton::IleocecalValveOf(line));
  EXPECT_TRUE(shapeton::ValveCandidatesOf(line).empty());
}

namespace
{
/** Candidates on a line: coordinates, mm, and probabilities. */
std::vector<shapeton::IleocecalValve>
Candidates(const std::vector<std::pair<double, double>> & places)
{
  std::vector<shapeton::IleocecalValve> candidates;
  for (const auto & [z, confidence] : places)
  {
    shapeton::IleocecalValve valve;
    valve.position = { 0.0, 0.0, z };
    valve.confidence = confidence;
    candidates.push_back(valve);
  }
  return candidates;
}

std::array<ValveSearch, 2>
InBoth(const std::vector<std::pair<double, double>> & first, const std::vector<std::pair<double, double>> & second)
{
  std::vector<Eigen::Vector3d> places;
  for (const auto & [z, confidence] : first)
  {
    places.emplace_back(100.0, 0.0, z); // the second scan is elsewhere
  }
  auto there = Candidates(second);
  for (shapeton::IleocecalValve & one : there)
  {
    one.position.x() = 100.0;
  }
  return shapeton::FindValveInBoth(Candidates(first), there, places);
}
} // namespace

TEST(IleocecalValve, TheScanThatShowsItBetterDecides)
{
  // In the second scan a polyp is more likely than the valve, which has two lips in the first one.
  const auto both = InBoth({ { 80.0, 0.8 }, { 40.0, 0.1 } }, { { 45.0, 0.5 }, { 85.0, 0.01 } });
  ASSERT_TRUE(both[0].valve && both[1].valve);
  EXPECT_EQ(both[0].valve->position.z(), 80.0);
  EXPECT_EQ(both[1].valve->position.z(), 85.0);
  // Odds of 8 and 0.01 / 0.49 for the valve, and of 1 and 0.5 / 0.49 for the polyp.
  const double valve = std::pow(8.0, 0.8) * std::pow(0.01 / 0.49, 0.2), polyp = std::pow(0.5 / 0.49, 0.8);
  EXPECT_NEAR(both[1].valve->confidence, valve / (1.0 + valve + polyp), 1e-12);
  ASSERT_EQ(both[1].candidates.size(), 2U);
  EXPECT_EQ(both[1].candidates[1].position.z(), 45.0); // stays an alternative
  EXPECT_EQ(both[0].candidates[1].confidence, both[1].candidates[1].confidence);
}

TEST(IleocecalValve, TheOtherScanDecidesATie)
{
  const auto alone = InBoth({ { 80.0, 0.47 }, { 40.0, 0.42 } }, {});
  EXPECT_FALSE(alone[0].valve);
  const auto both = InBoth({ { 80.0, 0.47 }, { 40.0, 0.42 } }, { { 80.0, 0.67 }, { 40.0, 0.03 } });
  ASSERT_TRUE(both[0].valve && both[1].valve);
  EXPECT_EQ(both[0].valve->position.z(), 80.0);
  EXPECT_GT(both[0].valve->confidence, 0.55);
}

TEST(IleocecalValve, TwoPlacesThatDoNotAgreeAreDoubted)
{
  const auto both = InBoth({ { 20.0, 0.6 } }, { { 50.0, 0.6 } });
  EXPECT_FALSE(both[0].valve);
  EXPECT_FALSE(both[1].valve);
  EXPECT_NE(both[0].reason.find("likely"), std::string::npos);
}

TEST(IleocecalValve, OneScanWithoutCandidatesLeavesTheOther)
{
  const auto both = InBoth({ { 80.0, 0.9 } }, {});
  ASSERT_TRUE(both[0].valve);
  EXPECT_NEAR(both[0].valve->confidence, 0.9, 1e-12);
  EXPECT_FALSE(both[1].valve);
  EXPECT_THROW(shapeton::FindValveInBoth(Candidates({ { 0.0, 0.5 } }), {}, {}), shapeton::ParameterError);
}

TEST(IleocecalValve, NeedsArcLengths)
{
  shapeton::CurveSet line = cecalscene::Line({});
  line.pointArrays.clear();
  EXPECT_THROW(shapeton::FindIleocecalValve(cecalscene::Draw({}).lumen, nullptr, line), shapeton::InputError);
}
