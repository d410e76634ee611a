#include "shapetonShapeScene.h"
#include "shapetonJson.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

namespace
{
using PointType = shapeton::ShapeScene::PointType;
using VectorType = PointType::VectorType;

shapeton::ShapeScene
SceneOf(const std::string & objects)
{
  return shapeton::ShapeScene::FromJson(shapeton::Json::parse(R"({ "units": "mm", "objects": [)" + objects + "] }"),
                                        "test");
}

PointType
MakePoint(double x, double y, double z)
{
  const double values[3] = { x, y, z };
  return PointType(values);
}

VectorType
Gradient(const shapeton::ShapeScene & scene, const PointType & point)
{
  constexpr double step = 1e-3;
  VectorType       gradient;
  for (unsigned int i = 0; i < 3; ++i)
  {
    VectorType shift;
    shift.Fill(0.0);
    shift[i] = step;
    gradient[i] = (scene.SignedDistance(0, point + shift) - scene.SignedDistance(0, point - shift)) / (2.0 * step);
  }
  return gradient;
}

/** Makes random points of a cube. */
auto
RandomPoints(double halfExtent)
{
  return
    [engine = std::mt19937(7), uniform = std::uniform_real_distribution<double>(-halfExtent, halfExtent)]() mutable {
      const double x = uniform(engine);
      const double y = uniform(engine);
      return MakePoint(x, y, uniform(engine));
    };
}

const char * const placed = R"(, "center": [1, -2, 3], "rotation": { "axis": [1, 2, -1], "angle": 35 })";
} // namespace

// The magnitude of a 1-Lipschitz function is at most the distance to its zero set. If a step of length |d| against the
// gradient ends on the zero set, it is also at least that distance, and thus equal.
class ExactDistance : public testing::TestWithParam<const char *>
{};

TEST_P(ExactDistance, IsTheDistanceToTheSurface)
{
  const auto scene = SceneOf("{ " + std::string(GetParam()) + placed + " }");
  auto       points = RandomPoints(14.0);
  PointType  before = points();
  int        inside = 0;
  int        landed = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const PointType point = points();
    const double    distance = scene.SignedDistance(0, point);
    EXPECT_LE(std::abs(distance - scene.SignedDistance(0, before)), (point - before).GetNorm() + 1e-8);
    before = point;
    inside += distance < 0.0;
    const VectorType gradient = Gradient(scene, point);
    const bool       insideABend = distance < 0.0 && scene.GetObject(0).name == "tube 1"; // only a lower bound there
    if (std::abs(gradient.GetNorm() - 1.0) < 1e-4 && !insideABend)                        // not on the medial axis
    {
      ++landed;
      EXPECT_NEAR(scene.SignedDistance(0, point - gradient * distance), 0.0, 2e-3);
    }
  }
  EXPECT_GT(inside, 40);
  EXPECT_GT(landed, 3500);
}

INSTANTIATE_TEST_SUITE_P(Primitives,
                         ExactDistance,
                         testing::Values(R"("kind": "sphere", "radius": 6)",
                                         R"("kind": "cube", "side": 9)",
                                         R"("kind": "box", "size": [4, 9, 13])",
                                         R"("kind": "cylinder", "radius": 5, "length": 7)",
                                         R"("kind": "capsule", "radius": 4, "length": 9)",
                                         R"("kind": "torus", "ringRadius": 7, "tubeRadius": 3)",
                                         R"("kind": "tube", "radius": 2.5,
                                            "points": [[-8, 0, 0], [0, 5, 2], [4, -3, 1], [4, -3, -6]])"));

TEST(ShapeScene, KnownDistances)
{
  const auto box = SceneOf(R"({ "kind": "box", "size": [2, 4, 6], "center": [10, 0, 0] })");
  EXPECT_EQ(box.SignedDistance(0, MakePoint(10, 0, 0)), -1.0);
  EXPECT_EQ(box.SignedDistance(0, MakePoint(14, 6, 3)), 5.0); // 3-4-5 from an edge
  const auto turned =
    SceneOf(R"({ "kind": "box", "size": [2, 4, 6], "rotation": { "axis": [0, 0, 2], "angle": 90 } })");
  EXPECT_EQ(turned.SignedDistance(0, MakePoint(2, 0, 0)), 0.0); // on the face, independent of the rounding of cos(90
                                                                // degrees)
  EXPECT_EQ(turned.SignedDistance(0, MakePoint(0, 1, 0)), 0.0);
  const auto capsule = SceneOf(R"({ "kind": "capsule", "radius": 2, "length": 6 })");
  EXPECT_EQ(capsule.SignedDistance(0, MakePoint(0, 0, 5)), 0.0); // the length refers to the axis
  const auto ellipsoid = SceneOf(R"({ "kind": "ellipsoid", "radii": [2, 3, 5] })");
  EXPECT_NEAR(ellipsoid.SignedDistance(0, MakePoint(0, 3.01, 0)), 0.01, 1e-4);
  EXPECT_NEAR(ellipsoid.SignedDistance(0, MakePoint(0, 0, 4.99)), -0.01, 1e-4);
}

TEST(ShapeScene, RotationTurnsCounterclockwise)
{
  const auto scene =
    SceneOf(R"({ "kind": "capsule", "radius": 1, "length": 10, "rotation": { "axis": [1, 0, 0], "angle": -30 } })");
  // (0, 0, 5) rotated by -30 degrees about x: y = 5 sin 30, z = 5 cos 30.
  EXPECT_NEAR(scene.SignedDistance(0, MakePoint(0, 2.5, 5 * std::sqrt(0.75))), -1.0, 1e-8);
  EXPECT_GT(scene.SignedDistance(0, MakePoint(0, -2.5, 5 * std::sqrt(0.75))), 2.0);
}

// The sign for a deformed box agrees with the forward map of points known to be inside or outside.
TEST(ShapeScene, TwistedAndBentBoxHoldsTheImagesOfItsPoints)
{
  const auto   scene = SceneOf(R"({ "kind": "box", "size": [4, 3, 20], "deformations": [
    { "kind": "twist", "angle": 80 }, { "kind": "bend", "angle": 100 } ] })");
  const double degree = std::acos(-1.0) / 180.0;
  const double arcRadius = 20.0 / (100.0 * degree);
  auto         points = RandomPoints(1.0);
  int          inside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const PointType unit = points();
    const double    x = 4.0 * unit[0];
    const double    y = 3.0 * unit[1];
    const double    z = 14.0 * unit[2];
    const double    turn = 80.0 * degree / 20.0 * z;
    const double    xTwisted = std::cos(turn) * x - std::sin(turn) * y;
    const double    yTwisted = std::sin(turn) * x + std::cos(turn) * y;
    const PointType image = MakePoint(arcRadius - (arcRadius - xTwisted) * std::cos(z / arcRadius),
                                      yTwisted,
                                      (arcRadius - xTwisted) * std::sin(z / arcRadius));
    const bool      expected = std::abs(x) <= 2.0 && std::abs(y) <= 1.5 && std::abs(z) <= 10.0;
    inside += expected;
    EXPECT_EQ(scene.SignedDistance(0, image) <= 0.0, expected) << x << ' ' << y << ' ' << z;
  }
  EXPECT_GT(inside, 2000);
}

TEST(ShapeScene, BumpsMoveTheSurface)
{
  const auto   scene = SceneOf(R"({ "kind": "sphere", "radius": 10, "deformations": [
    { "kind": "bumps", "amplitude": 1.5, "wavelength": 16 } ] })");
  const double waveNumber = 2.0 * std::acos(-1.0) / 16.0;
  auto         points = RandomPoints(1.0);
  for (int i = 0; i < 500; ++i)
  {
    VectorType ray = points().GetVectorFromOrigin();
    ray.Normalize();
    double inner = 8.0;
    double outer = 12.0;
    for (int step = 0; step < 60; ++step) // bisection of r - 10 = 1.5 sin sin sin
    {
      const double r = 0.5 * (inner + outer);
      const double bump =
        1.5 * std::sin(waveNumber * r * ray[0]) * std::sin(waveNumber * r * ray[1]) * std::sin(waveNumber * r * ray[2]);
      (r - 10.0 < bump ? inner : outer) = r;
    }
    EXPECT_NEAR(scene.SignedDistance(0, PointType(0.0) + ray * inner), 0.0, 1e-6);
  }
}

// Near the surface, the residual after a step of length |d| against the gradient is of second order.
class FirstOrderDistance : public testing::TestWithParam<const char *>
{};

TEST_P(FirstOrderDistance, IsTheDistanceToFirstOrder)
{
  const auto scene = SceneOf("{ " + std::string(GetParam()) + placed + " }");
  auto       points = RandomPoints(16.0);
  int        tested = 0;
  double     sumOfErrors = 0.0;
  for (int i = 0; i < 60000; ++i)
  {
    const PointType point = points();
    const double    distance = scene.SignedDistance(0, point);
    if (std::abs(distance) > 0.3)
    {
      continue;
    }
    VectorType gradient = Gradient(scene, point);
    gradient.Normalize();
    sumOfErrors += std::abs(scene.SignedDistance(0, point - gradient * distance));
    ++tested;
  }
  EXPECT_GT(tested, 500);
  EXPECT_LT(sumOfErrors / tested, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
  Deformed,
  FirstOrderDistance,
  testing::Values(
    R"("kind": "ellipsoid", "radii": [4, 6, 9])",
    R"("kind": "cylinder", "radius": 4, "length": 20, "deformations": [{ "kind": "bend", "angle": 90 }])",
    R"("kind": "sphere", "radius": 9, "deformations": [{ "kind": "bumps", "amplitude": 1, "wavelength": 12 }])",
    R"("kind": "box", "size": [6, 8, 20], "deformations": [{ "kind": "twist", "angle": 60 }])"));

// Where space is stretched most, f / |grad f| alone would be almost 0.
TEST(ShapeScene, NoSpuriousSurfaceFarFromDeformedObjects)
{
  const auto   bent = SceneOf(R"({ "kind": "box", "size": [4, 4, 20], "deformations": [
    { "kind": "twist", "angle": 80 }, { "kind": "bend", "angle": 120 } ] })");
  const double arcRadius = 20.0 / (120.0 * std::acos(-1.0) / 180.0);
  EXPECT_GT(bent.SignedDistance(0, MakePoint(arcRadius, 0.0, 0.0)), arcRadius - 2.0 * std::sqrt(2.0) - 1e-6);
  EXPECT_GT(bent.SignedDistance(0, MakePoint(arcRadius + 0.01, 0.0, 0.0)), arcRadius - 2.0 * std::sqrt(2.0) - 0.02);
  const auto twisted =
    SceneOf(R"({ "kind": "box", "size": [4, 4, 20], "deformations": [{ "kind": "twist", "angle": 3000 }] })");
  EXPECT_GT(twisted.SignedDistance(0, MakePoint(9.0, 0.0, 0.0)), 6.0);
}

TEST(ShapeScene, RelativeScenesScaleWithTheUnitLength)
{
  auto scene = shapeton::ShapeScene::Load("figure2.4");
  EXPECT_TRUE(scene.IsRelative());
  scene.SetUnitLength(80.0);
  EXPECT_EQ(scene.SignedDistance(0, MakePoint(30, 0, 0)), 10.0); // the half side is 20 mm
  EXPECT_NEAR(scene.GetObject(0).boundingRadius, 20.0 * std::sqrt(3.0), 1e-9);
}

TEST(ShapeScene, LaterObjectsOwnTheLabel)
{
  const auto scene = SceneOf(R"({ "kind": "sphere", "radius": 5, "label": 7 },
                                { "kind": "sphere", "radius": 2, "label": 0 })");
  EXPECT_EQ(scene.GetLabel(MakePoint(0, 0, 0)), 0);
  EXPECT_EQ(scene.GetLabel(MakePoint(3, 0, 0)), 7);
  EXPECT_EQ(scene.GetLabel(MakePoint(6, 0, 0)), 0);
}

TEST(ShapeScene, PresetsHoldTheObjectsOfTheFigures)
{
  const std::map<std::string, std::size_t> numberOfObjects{ { "figure2.4", 1 },  { "figure2.7a", 3 },
                                                            { "figure2.7b", 4 }, { "figure3.4", 4 },
                                                            { "figure3.5", 4 },  { "hydrogen", 4 },
                                                            { "vessels", 12 } };
  EXPECT_EQ(shapeton::ShapeScene::GetPresetNames().size(), numberOfObjects.size());
  for (const auto & name : shapeton::ShapeScene::GetPresetNames())
  {
    const auto scene = shapeton::ShapeScene::Load(name);
    EXPECT_TRUE(scene.IsRelative()) << name;
    EXPECT_EQ(scene.GetNumberOfObjects(), numberOfObjects.at(name)) << name;
  }
}

TEST(ShapeScene, LoadTellsAWrongNameFromAMissingFile)
{
  EXPECT_THROW(shapeton::ShapeScene::Load("figure9.9"), shapeton::ParameterError);
  EXPECT_THROW(shapeton::ShapeScene::Load("does-not-exist.json"), shapeton::InputError);
}

TEST(ShapeScene, ReadsAFile)
{
  const auto path = std::filesystem::path(SHAPETON_TEST_TEMPORARY_DIR) / "ShapeSceneTest.json";
  std::ofstream(path) << R"({ "units": "mm", "background": -1000, "objects": [{ "kind": "sphere", "radius": 3 }] })";
  const auto scene = shapeton::ShapeScene::Load(path.string());
  EXPECT_FALSE(scene.IsRelative());
  EXPECT_EQ(scene.GetBackground(), -1000.0);
  EXPECT_EQ(scene.GetObject(0).name, "sphere 1");
  EXPECT_EQ(scene.GetObject(0).label, 1);
  EXPECT_EQ(scene.GetObject(0).intensity, 1000.0);
}

#define OBJECT(text) R"({ "units": "mm", "objects": [ )" text " ] }"

TEST(ShapeScene, WrongOnesAreRefusedByKey)
{
  // A scene and the expected part of the message besides the name of the source.
  const std::pair<const char *, const char *> scenes[] = {
    { "[]", "the document must be an object" },
    { R"({ "objects": [] })", "lacks the key \"units\"" },
    { R"({ "units": "mm" })", "lacks the key \"objects\"" },
    { R"({ "units": "cm", "objects": [] })", "units must be mm or relative" },
    { R"({ "units": 1, "objects": [] })", "units must be a string" },
    { R"({ "units": "mm", "objects": {} })", "objects must be a list" },
    { R"({ "units": "mm", "objects": [], "object": [] })", "unknown key \"object\"" },
    { R"({ "units": "mm", "objects": [], "background": -1025 })", "background must be a number from -1024" },
    { R"({ "units": "mm", "objects": [], "description": 3 })", "description must be a string" },
    { OBJECT("7"), "objects[0] must be an object" },
    { OBJECT(R"({ "radius": 1 })"), "objects[0] lacks the key \"kind\"" },
    { OBJECT(R"({ "kind": "blob" })"), "objects[0].kind must be one of sphere" },
    { OBJECT(R"({ "kind": "sphere" })"), "objects[0] lacks the key \"radius\"" },
    { OBJECT(R"({ "kind": "sphere", "radius": -3 })"), "objects[0].radius must be a number above 0" },
    { OBJECT(R"({ "kind": "sphere", "radius": 0 })"), "objects[0].radius must be a number above 0" },
    { OBJECT(R"({ "kind": "sphere", "radius": "3" })"), "objects[0].radius must be a number above 0" },
    { OBJECT(R"({ "kind": "sphere", "radius": null })"), "objects[0].radius must be a number above 0" },
    { OBJECT(R"({ "kind": "sphere", "radius": 1e7 })"), "at most 1" },
    { OBJECT(R"({ "kind": "sphere", "radius": 1, "side": 1 })"), "objects[0] has the unknown key \"side\"" },
    { OBJECT(R"({ "kind": "box", "size": [1, 2] })"), "objects[0].size must be a list of three numbers" },
    { OBJECT(R"({ "kind": "box", "size": [1, 2, -1] })"), "objects[0].size[2] must be a number above 0" },
    { OBJECT(R"({ "kind": "box", "size": 3 })"), "objects[0].size must be a list" },
    { OBJECT(R"({ "kind": "torus", "ringRadius": 2, "tubeRadius": 3 })"), "objects[0].tubeRadius" },
    { OBJECT(R"({ "kind": "tube", "radius": 1, "points": [[0, 0, 0]] })"), "points must be a list" },
    { OBJECT(R"({ "kind": "tube", "radius": 1, "points": [[0, 0, 0], [1, true, 0]] })"),
      "objects[0].points[1][1] must be a number" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "center": [0, 0, 1e9] })"), "objects[0].center[2]" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "label": 256 })"), "objects[0].label must be" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "label": 1.5 })"), "objects[0].label must be a whole number" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "intensity": 40000 })"), "objects[0].intensity must be" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "rotation": 30 })"), "objects[0].rotation must be an object" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "rotation": { "axis": [0, 0, 0], "angle": 3 } })"),
      "objects[0].rotation.axis must not be zero" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "rotation": { "axis": [0, 0, 1] } })"),
      "objects[0].rotation lacks the key \"angle\"" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "deformations": [{ "kind": "melt" }] })"),
      "objects[0].deformations[0].kind must be bend, twist or bumps" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "deformations": [{ "kind": "bend", "angle": 180 }] })"),
      "bends the object into itself" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "deformations": [{ "kind": "bend", "angle": 20 },
                                                                         { "kind": "twist", "angle": 20 }] })"),
      "objects[0].deformations[1] follows a bend" },
    { OBJECT(R"({ "kind": "cube", "side": 1, "deformations": [{ "kind": "bumps", "amplitude": 0.2,
                                                                           "wavelength": 1 }] })"),
      "objects[0].deformations[0].amplitude must be less than wavelength" },
    { OBJECT(R"({ "kind": "ellipsoid", "radii": [1, 2, 3], "deformations": [{ "kind": "bumps",
                            "amplitude": 0.01, "wavelength": 1 }] })"),
      "adds bumps to an ellipsoid" }
  };
  for (const auto & [json, expected] : scenes)
  {
    const auto document = shapeton::Json::parse(json);
    const auto message = basetest::ErrorOf([&] { shapeton::ShapeScene::FromJson(document, "wrong.json"); });
    EXPECT_NE(message.find("wrong.json"), std::string::npos) << message << json;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}
