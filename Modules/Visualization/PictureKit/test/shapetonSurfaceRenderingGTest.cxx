#include "shapetonSurfaceRendering.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonSceneTestMeshes.h"

#include <array>
#include <limits>
#include <stdexcept>

namespace
{
const shapeton::RGBColor background = shapeton::MakeColor(18, 19, 25);
const shapeton::RGBColor red = shapeton::MakeColor(200, 30, 30);
const shapeton::RGBColor green = shapeton::MakeColor(30, 160, 30);

shapeton::SurfaceRenderingOptions
PlainOptions(unsigned int side = 300)
{
  shapeton::SurfaceRenderingOptions options;
  options.width = side;
  options.height = side;
  options.annotations = false;
  options.depthShading = 0.0;
  return options;
}

shapeton::SurfaceActor
Actor(const shapeton::SurfaceMesh & mesh, const shapeton::RGBColor & color = red)
{
  shapeton::SurfaceActor actor;
  actor.surface = &mesh;
  actor.color = color;
  return actor;
}

/** The pixel of a point, LPS. */
shapeton::RGBColor
SeenAt(const shapeton::SurfaceScene &            scene,
       const shapeton::SurfaceRenderingOptions & options,
       double                                    x,
       double                                    y,
       double                                    z)
{
  const double point[3] = { x, y, z };
  const auto   place = shapeton::ViewOfScene(scene, options).Project(shapeton::PatientView::PointType(point));
  return shapeton::At(shapeton::RenderSurfaces(scene, options),
                      static_cast<int>(std::lround(place[0])),
                      static_cast<int>(std::lround(place[1])));
}

bool
IsReddish(const shapeton::RGBColor & color)
{
  return color[0] > 2 * color[1];
}

/** A torus with a curve in its tube and two markers. */
struct TorusScene
{
  TorusScene()
  {
    curve.V.resize(72, 3);
    curve.curves.resize(1);
    Eigen::VectorXd angle(72);
    for (int i = 0; i < 72; ++i)
    {
      angle[i] = 5.0 * i;
      curve.V.row(i) << 30.0 * std::cos(angle[i] * shapeton::testPi / 180),
        30.0 * std::sin(angle[i] * shapeton::testPi / 180), 0.0;
      curve.curves[0].push_back(i);
    }
    scale.title = "angle (degrees)";
    scale.upper = 355.0;
    scene.surfaces.push_back(Actor(torus, shapeton::MakeColor(168, 186, 212)));
    scene.surfaces[0].opacity = 0.35;
    scene.curves.push_back({ &curve, 1.0, red, shapeton::ColorsOf(angle.data(), 72, scale) });
    scene.markers.push_back({ curve.V.row(0).transpose(), 3.0, scale.ColorOf(0.0), "begin" });
    scene.markers.push_back({ curve.V.row(71).transpose(), 3.0, scale.ColorOf(355.0), "end" });
  }

  shapeton::SurfaceMesh  torus = shapeton::TorusMesh(30.0, 12.0);
  shapeton::CurveSet     curve;
  shapeton::ColorScale   scale;
  shapeton::SurfaceScene scene;
};
} // namespace

TEST(SurfaceRendering, ASphereCoversItsDisc)
{
  const shapeton::SurfaceMesh sphere = shapeton::SphereMesh({ 3.0, -7.0, 11.0 }, 40.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(sphere));
  const auto options = PlainOptions();
  const auto picture = shapeton::RenderSurfaces(scene, options);
  // Relative to the center, where pixels are fully covered; at the border coverage is partial.
  double covered = 0.0;
  for (itk::SizeValueType i = 0; i < picture->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    covered += picture->GetBufferPointer()[i] == background ? 0.0 : 1.0;
  }
  const double mm = shapeton::ViewOfScene(scene, options).GetMillimetersPerPixel();
  const double border = shapeton::testPi * 40.0 / mm; // border pixels are overcounted by half on average
  EXPECT_NEAR((covered - border) * mm * mm, shapeton::testPi * 1600.0, 0.004 * shapeton::testPi * 1600.0);
}

TEST(SurfaceRendering, WhatIsNearerHidesWhatIsBehind)
{
  const shapeton::SurfaceMesh front = shapeton::CoronalSheet(-20, 20, -20, 20, -5.0);
  const shapeton::SurfaceMesh back = shapeton::CoronalSheet(-20, 20, -20, 20, 5.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces = { Actor(back, green), Actor(front, red) };
  auto options = PlainOptions();
  EXPECT_TRUE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
  shapeton::LookFrom(shapeton::PatientSide::Posterior, options);
  EXPECT_FALSE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
  std::swap(scene.surfaces[0], scene.surfaces[1]);
  EXPECT_FALSE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
}

TEST(SurfaceRendering, SheetsThatCrossAreCutWhereTheyCross)
{
  // One surface slopes away to the left, the other to the right; they meet at x = 0.
  const auto tilted = [](double slope) {
    return shapeton::ParametricMesh(
      1, 1, [=](double u, double v) { return Eigen::RowVector3d(40 * u - 20, slope * (40 * u - 20), 40 * v - 20); });
  };
  const shapeton::SurfaceMesh a = tilted(1.0);
  const shapeton::SurfaceMesh b = tilted(-1.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces = { Actor(a, red), Actor(b, green) };
  for (const double off : { 0.5, 5.0, 19.0 })
  {
    EXPECT_TRUE(IsReddish(SeenAt(scene, PlainOptions(), -off, 0, 3))) << off;
    EXPECT_FALSE(IsReddish(SeenAt(scene, PlainOptions(), off, 0, 3))) << off;
  }
}

TEST(SurfaceRendering, ATorusHasAHoleFromAboveAlone)
{
  const shapeton::SurfaceMesh torus = shapeton::TorusMesh(30.0, 10.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(torus));
  auto options = PlainOptions();
  EXPECT_NE(SeenAt(scene, options, 0, 0, 0), background);
  for (const auto side : { shapeton::PatientSide::Superior, shapeton::PatientSide::Inferior })
  {
    shapeton::LookFrom(side, options);
    EXPECT_EQ(SeenAt(scene, options, 0, 0, 0), background);
    EXPECT_EQ(SeenAt(scene, options, 19, 0, 0), background);
    EXPECT_NE(SeenAt(scene, options, 21, 0, 0), background);
    EXPECT_NE(SeenAt(scene, options, 39, 0, 0), background);
  }
}

TEST(SurfaceRendering, SidesShowThePatientTheRightWayRound)
{
  // Balls at the left, back and head side of a sphere, and their expected pixel offsets from the center.
  const shapeton::SurfaceMesh       sphere = shapeton::SphereMesh({ 0, 0, 0 }, 30.0, 24);
  const std::array<const char *, 6> across{ "L", "P", "R", "A", "L", "L" };
  const std::array<const char *, 6> up{ "H", "H", "H", "H", "P", "A" };
  for (int side = 0; side < 6; ++side)
  {
    for (const char * letter : { "L", "R", "A", "P", "H", "F" })
    {
      const std::string      names = "LPHRAF";
      const auto             k = static_cast<int>(names.find(*letter));
      shapeton::SurfaceScene scene;
      scene.surfaces.push_back(Actor(sphere, green));
      shapeton::MarkerActor ball;
      ball.point[k % 3] = k < 3 ? 40.0 : -40.0;
      ball.color = red;
      scene.markers.push_back(ball);
      auto options = PlainOptions(120);
      shapeton::LookFrom(static_cast<shapeton::PatientSide>(side), options);
      if (std::string(letter) != across[side] && std::string(letter) != up[side])
      {
        continue;
      }
      const auto picture = shapeton::RenderSurfaces(scene, options);
      double     x = 0.0;
      double     y = 0.0;
      int        number = 0;
      for (int j = 0; j < 120; ++j)
      {
        for (int i = 0; i < 120; ++i)
        {
          if (IsReddish(shapeton::At(picture, i, j)))
          {
            x += i;
            y += j;
            ++number;
          }
        }
      }
      ASSERT_GT(number, 20);
      const bool isAcross = std::string(letter) == across[side];
      const auto green0 = shapeton::ViewOfScene(scene, options).Project(shapeton::PatientView::PointType(0.0));
      EXPECT_EQ(isAcross, x / number > green0[0] + 20) << side << letter;
      EXPECT_EQ(!isAcross, y / number < green0[1] - 20) << side << letter;
    }
  }
}

TEST(SurfaceRendering, FillsThePictureFromEverySide)
{
  // A thin diagonal rod: its bounding box is much larger than its visible extent.
  const shapeton::SurfaceMesh rod = shapeton::ParametricMesh(40, 12, [](double u, double v) {
    const double a = 2.0 * shapeton::testPi * v;
    return Eigen::RowVector3d(200 * u + std::cos(a), 200 * u + std::sin(a), 7.0 * std::sin(a));
  });
  shapeton::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(rod));
  auto options = PlainOptions();
  options.azimuth = 45.0; // it runs to the right
  const auto picture = shapeton::RenderSurfaces(scene, options);
  int        left = 300;
  int        right = -1;
  for (int x = 0; x < 300; ++x)
  {
    for (int y = 0; y < 300; ++y)
    {
      if (shapeton::At(picture, x, y) != background)
      {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
  }
  EXPECT_NEAR(left, 18, 1); // 6 % margin on each side
  EXPECT_NEAR(right, 281, 1);
}

TEST(SurfaceRendering, ColorsOfVerticesBlendAndThoseOfFacesDoNot)
{
  const shapeton::SurfaceMesh sheet = shapeton::CoronalSheet(-20, 20, -20, 20, 0.0);
  const auto                  seen = [&](const shapeton::SurfaceActor & actor, double x) {
    shapeton::SurfaceScene scene;
    scene.surfaces.push_back(actor);
    return SeenAt(scene, PlainOptions(), x, 0, 0);
  };
  shapeton::SurfaceActor byVertex = Actor(sheet);
  byVertex.vertexColors = { shapeton::MakeColor(0, 0, 0),
                            shapeton::MakeColor(200, 100, 40),
                            shapeton::MakeColor(0, 0, 0),
                            shapeton::MakeColor(200, 100, 40) };
  for (const double x : { -15.0, 0.0, 12.0 })
  {
    const double share = (x + 20.0) / 40.0;
    const auto   expected = seen(Actor(sheet,
                                     shapeton::MakeColor(static_cast<unsigned char>(200 * share + 0.5),
                                                         static_cast<unsigned char>(100 * share + 0.5),
                                                         static_cast<unsigned char>(40 * share + 0.5))),
                               x);
    const auto   got = seen(byVertex, x);
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(got[channel], expected[channel], 2) << x;
    }
  }
  shapeton::SurfaceActor byFace = Actor(sheet);
  byFace.faceColors = { green, red }; // below and above the diagonal
  EXPECT_EQ(seen(byFace, 10.0), seen(Actor(sheet, green), 10.0));
  EXPECT_EQ(seen(byFace, -10.0), seen(Actor(sheet, red), -10.0));
}

TEST(SurfaceRendering, SeeThroughLayersMultiply)
{
  // From the front, a layer of opacity 0.4 transmits 1 - 0.4 / 4; the edge between its two faces is invisible.
  const shapeton::SurfaceMesh one = shapeton::CoronalSheet(-20, 20, -20, 20, -5.0);
  const shapeton::SurfaceMesh two = shapeton::CoronalSheet(-20, 20, -20, 20, 0.0);
  const shapeton::SurfaceMesh three = shapeton::CoronalSheet(-20, 20, -20, 20, 5.0);
  shapeton::SurfaceScene      scene;
  const auto                  add = [&](const shapeton::SurfaceMesh & mesh) {
    scene.surfaces.push_back(Actor(mesh, shapeton::MakeColor(255, 255, 255)));
    scene.surfaces.back().opacity = 0.4;
  };
  double passed = 1.0;
  for (const auto * mesh : { &one, &two, &three })
  {
    add(*mesh);
    passed *= 0.9;
    const auto picture = shapeton::RenderSurfaces(scene, PlainOptions(101));
    for (int i = 10; i <= 90; ++i) // also across the diagonals
    {
      ASSERT_NEAR(shapeton::At(picture, i, 50)[0], 255 * (1.0 - passed) + 18 * passed, 1.0) << i;
      ASSERT_NEAR(shapeton::At(picture, i, 100 - i)[0], 255 * (1.0 - passed) + 18 * passed, 1.0) << i;
    }
  }
}

TEST(SurfaceRendering, NoGapsBetweenFaces)
{
  const shapeton::SurfaceMesh fine = shapeton::ParametricMesh(
    97, 89, [](double u, double v) { return Eigen::RowVector3d(40 * u - 20, 0.0, 40 * v * (0.8 + 0.2 * u) - 20); });
  const shapeton::SurfaceMesh coarse = shapeton::CoronalSheet(-20, 20, -20, 20, 0.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(fine));
  auto       options = PlainOptions(260);
  const auto picture = shapeton::RenderSurfaces(scene, options);
  const auto inside = shapeton::At(picture, 120, 170);
  for (int x = 20; x < 240; ++x)
  {
    for (int y = 90; y < 240; ++y)
    {
      ASSERT_EQ(shapeton::At(picture, x, y), inside) << x << " " << y;
    }
  }
}

TEST(SurfaceRendering, ACurveIsSeenThroughTheWallOnlyWhereThisIsSeeThrough)
{
  TorusScene torus;
  torus.scene.markers.clear();
  torus.scene.curves[0].vertexColors.clear();
  auto options = PlainOptions();
  shapeton::LookFrom(shapeton::PatientSide::Superior, options);
  EXPECT_TRUE(IsReddish(SeenAt(torus.scene, options, 30, 0, 0)));
  EXPECT_FALSE(IsReddish(SeenAt(torus.scene, options, 36, 0, 0)));
  torus.scene.surfaces[0].opacity = 1.0;
  EXPECT_FALSE(IsReddish(SeenAt(torus.scene, options, 30, 0, 0)));
}

TEST(SurfaceRendering, ATubeIsAsThickAsItsRadiusSays)
{
  shapeton::CurveSet line;
  line.V.resize(2, 3);
  line.V << -50, 0, 0, 50, 0, 0;
  line.curves = { { 0, 1 } };
  shapeton::SurfaceScene scene;
  scene.curves.push_back({ &line, 6.0, red, {} });
  auto options = PlainOptions();
  options.zoom = 4.0;
  const auto picture = shapeton::RenderSurfaces(scene, options);
  int        thickness = 0;
  for (int y = 0; y < 300; ++y)
  {
    thickness += shapeton::At(picture, 150, y) == background ? 0 : 1;
  }
  EXPECT_NEAR(thickness * shapeton::ViewOfScene(scene, options).GetMillimetersPerPixel(), 12.0, 0.4);
}

TEST(SurfaceRendering, DepthShadingDarkensWhatLiesBehind)
{
  const shapeton::SurfaceMesh front = shapeton::CoronalSheet(-20, 0, -20, 20, -15.0);
  const shapeton::SurfaceMesh back = shapeton::CoronalSheet(0, 20, -20, 20, 15.0);
  shapeton::SurfaceScene      scene;
  scene.surfaces = { Actor(front), Actor(back) };
  auto       options = PlainOptions();
  const auto plain = SeenAt(scene, options, 0.5, 0, 0);
  EXPECT_EQ(plain, SeenAt(scene, options, -0.5, 0, 0));
  options.depthShading = 0.6;
  EXPECT_LT(SeenAt(scene, options, 0.5, 0, 0)[0], plain[0] - 30); // next to the step
  EXPECT_EQ(SeenAt(scene, options, -0.5, 0, 0), plain);
  EXPECT_EQ(SeenAt(scene, options, 17, 0, 0), plain); // far from it
}

TEST(SurfaceRendering, SameBytesForAnyNumberOfThreads)
{
  const TorusScene                  torus;
  shapeton::SurfaceRenderingOptions options;
  options.width = 400;
  options.height = 300;
  options.azimuth = 20.0;
  options.elevation = 35.0;
  options.colorBar = torus.scale;
  basetest::ExpectSameWithAnyThreads([&] { return basetest::BytesOf(shapeton::RenderSurfaces(torus.scene, options)); },
                                     { 2, 3, 7 });
}

TEST(SurfaceRendering, RefusesWhatCannotBeDrawn)
{
  const shapeton::SurfaceMesh sphere = shapeton::SphereMesh({ 0, 0, 0 }, 10.0, 6);
  const auto refuses = [](const shapeton::SurfaceScene & scene, shapeton::SurfaceRenderingOptions options = {}) {
    EXPECT_THROW(shapeton::RenderSurfaces(scene, options), std::invalid_argument);
  };
  shapeton::SurfaceScene scene;
  refuses(scene);
  scene.surfaces.push_back({});
  refuses(scene);
  scene.surfaces[0] = Actor(sphere);
  scene.surfaces[0].opacity = 0.0;
  refuses(scene);
  scene.surfaces[0].opacity = 1.0;
  scene.surfaces[0].faceColors.resize(3);
  refuses(scene);
  scene.surfaces[0].faceColors.clear();
  shapeton::SurfaceRenderingOptions options;
  options.zoom = 0.0;
  refuses(scene, options);
  options.zoom = 1.0;
  options.width = 50;
  options.colorBar = shapeton::ColorScale();
  refuses(scene, options);
  shapeton::SurfaceMesh broken = sphere;
  broken.F(0, 0) = 1000000;
  scene.surfaces[0].surface = &broken;
  refuses(scene);
  broken = sphere;
  broken.V(5, 1) = std::numeric_limits<double>::quiet_NaN();
  refuses(scene);
}

TEST(SurfaceRendering, Baseline)
{
  TorusScene                        torus;
  shapeton::SurfaceRenderingOptions options;
  options.width = 560;
  options.height = 420;
  options.azimuth = 20.0;
  options.elevation = 35.0;
  options.title = "Torus";
  options.colorBar = torus.scale;
  options.legend = { { torus.scene.surfaces[0].color, "wall" } };
  shapeton::ExpectBaseline(shapeton::RenderSurfaces(torus.scene, options), "shapetonSurfaceRendering.png");
}
