#include "itkSurfaceRendering.h"

#include "itkPictureTestUtilities.h"
#include "itkSceneTestMeshes.h"

#include <array>
#include <limits>
#include <stdexcept>

namespace
{
const itk::RGBColor background = itk::MakeColor(18, 19, 25);
const itk::RGBColor red = itk::MakeColor(200, 30, 30);
const itk::RGBColor green = itk::MakeColor(30, 160, 30);

itk::SurfaceRenderingOptions
PlainOptions(unsigned int side = 300)
{
  itk::SurfaceRenderingOptions options;
  options.width = side;
  options.height = side;
  options.annotations = false;
  options.depthShading = 0.0;
  return options;
}

itk::SurfaceActor
Actor(const itk::SurfaceMesh & mesh, const itk::RGBColor & color = red)
{
  itk::SurfaceActor actor;
  actor.surface = &mesh;
  actor.color = color;
  return actor;
}

/** The pixel of a point, LPS. */
itk::RGBColor
SeenAt(const itk::SurfaceScene & scene, const itk::SurfaceRenderingOptions & options, double x, double y, double z)
{
  const double point[3] = { x, y, z };
  const auto   place = itk::ViewOfScene(scene, options).Project(itk::PatientView::PointType(point));
  return itk::At(itk::RenderSurfaces(scene, options),
                 static_cast<int>(std::lround(place[0])),
                 static_cast<int>(std::lround(place[1])));
}

bool
IsReddish(const itk::RGBColor & color)
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
      curve.V.row(i) << 30.0 * std::cos(angle[i] * itk::testPi / 180), 30.0 * std::sin(angle[i] * itk::testPi / 180),
        0.0;
      curve.curves[0].push_back(i);
    }
    scale.title = "angle (degrees)";
    scale.upper = 355.0;
    scene.surfaces.push_back(Actor(torus, itk::MakeColor(168, 186, 212)));
    scene.surfaces[0].opacity = 0.35;
    scene.curves.push_back({ &curve, 1.0, red, itk::ColorsOf(angle.data(), 72, scale) });
    scene.markers.push_back({ curve.V.row(0).transpose(), 3.0, scale.ColorOf(0.0), "begin" });
    scene.markers.push_back({ curve.V.row(71).transpose(), 3.0, scale.ColorOf(355.0), "end" });
  }

  itk::SurfaceMesh  torus = itk::TorusMesh(30.0, 12.0);
  itk::CurveSet     curve;
  itk::ColorScale   scale;
  itk::SurfaceScene scene;
};
} // namespace

TEST(SurfaceRendering, ASphereCoversItsDisc)
{
  const itk::SurfaceMesh sphere = itk::SphereMesh({ 3.0, -7.0, 11.0 }, 40.0);
  itk::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(sphere));
  const auto options = PlainOptions();
  const auto picture = itk::RenderSurfaces(scene, options);
  // In parts of what is seen in the middle, where the face of the sphere is full: its border is covered in part.
  double covered = 0.0;
  for (itk::SizeValueType i = 0; i < picture->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    covered += picture->GetBufferPointer()[i] == background ? 0.0 : 1.0;
  }
  const double mm = itk::ViewOfScene(scene, options).GetMillimetresPerPixel();
  const double border = itk::testPi * 40.0 / mm; // half of the length of the border in pixels counts too much
  EXPECT_NEAR((covered - border) * mm * mm, itk::testPi * 1600.0, 0.004 * itk::testPi * 1600.0);
}

TEST(SurfaceRendering, WhatIsNearerHidesWhatIsBehind)
{
  const itk::SurfaceMesh front = itk::CoronalSheet(-20, 20, -20, 20, -5.0);
  const itk::SurfaceMesh back = itk::CoronalSheet(-20, 20, -20, 20, 5.0);
  itk::SurfaceScene      scene;
  scene.surfaces = { Actor(back, green), Actor(front, red) };
  auto options = PlainOptions();
  EXPECT_TRUE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
  itk::LookFrom(itk::PatientSide::Posterior, options);
  EXPECT_FALSE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
  std::swap(scene.surfaces[0], scene.surfaces[1]);
  EXPECT_FALSE(IsReddish(SeenAt(scene, options, 0, 0, 0)));
}

TEST(SurfaceRendering, SheetsThatCrossAreCutWhereTheyCross)
{
  // One falls back to the left, the other to the right; they meet at x = 0.
  const auto tilted = [](double slope) {
    return itk::ParametricMesh(
      1, 1, [=](double u, double v) { return Eigen::RowVector3d(40 * u - 20, slope * (40 * u - 20), 40 * v - 20); });
  };
  const itk::SurfaceMesh a = tilted(1.0);
  const itk::SurfaceMesh b = tilted(-1.0);
  itk::SurfaceScene      scene;
  scene.surfaces = { Actor(a, red), Actor(b, green) };
  for (const double off : { 0.5, 5.0, 19.0 })
  {
    EXPECT_TRUE(IsReddish(SeenAt(scene, PlainOptions(), -off, 0, 3))) << off;
    EXPECT_FALSE(IsReddish(SeenAt(scene, PlainOptions(), off, 0, 3))) << off;
  }
}

TEST(SurfaceRendering, ATorusHasAHoleFromAboveAlone)
{
  const itk::SurfaceMesh torus = itk::TorusMesh(30.0, 10.0);
  itk::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(torus));
  auto options = PlainOptions();
  EXPECT_NE(SeenAt(scene, options, 0, 0, 0), background);
  for (const auto side : { itk::PatientSide::Superior, itk::PatientSide::Inferior })
  {
    itk::LookFrom(side, options);
    EXPECT_EQ(SeenAt(scene, options, 0, 0, 0), background);
    EXPECT_EQ(SeenAt(scene, options, 19, 0, 0), background);
    EXPECT_NE(SeenAt(scene, options, 21, 0, 0), background);
    EXPECT_NE(SeenAt(scene, options, 39, 0, 0), background);
  }
}

TEST(SurfaceRendering, SidesShowThePatientTheRightWayRound)
{
  // Balls at the patient's left, back and head of a sphere, and where they are seen: pixels from the middle.
  const itk::SurfaceMesh            sphere = itk::SphereMesh({ 0, 0, 0 }, 30.0, 24);
  const std::array<const char *, 6> across{ "L", "P", "R", "A", "L", "L" };
  const std::array<const char *, 6> up{ "H", "H", "H", "H", "P", "A" };
  for (int side = 0; side < 6; ++side)
  {
    for (const char * letter : { "L", "R", "A", "P", "H", "F" })
    {
      const std::string names = "LPHRAF";
      const auto        k = static_cast<int>(names.find(*letter));
      itk::SurfaceScene scene;
      scene.surfaces.push_back(Actor(sphere, green));
      itk::MarkerActor ball;
      ball.point[k % 3] = k < 3 ? 40.0 : -40.0;
      ball.color = red;
      scene.markers.push_back(ball);
      auto options = PlainOptions(120);
      itk::LookFrom(static_cast<itk::PatientSide>(side), options);
      if (std::string(letter) != across[side] && std::string(letter) != up[side])
      {
        continue;
      }
      const auto picture = itk::RenderSurfaces(scene, options);
      double     x = 0.0;
      double     y = 0.0;
      int        number = 0;
      for (int j = 0; j < 120; ++j)
      {
        for (int i = 0; i < 120; ++i)
        {
          if (IsReddish(itk::At(picture, i, j)))
          {
            x += i;
            y += j;
            ++number;
          }
        }
      }
      ASSERT_GT(number, 20);
      const bool isAcross = std::string(letter) == across[side];
      const auto green0 = itk::ViewOfScene(scene, options).Project(itk::PatientView::PointType(0.0));
      EXPECT_EQ(isAcross, x / number > green0[0] + 20) << side << letter;
      EXPECT_EQ(!isAcross, y / number < green0[1] - 20) << side << letter;
    }
  }
}

TEST(SurfaceRendering, FillsThePictureFromEverySide)
{
  // A thin rod across the view: its box is much larger than what is seen of it.
  const itk::SurfaceMesh rod = itk::ParametricMesh(40, 12, [](double u, double v) {
    const double a = 2.0 * itk::testPi * v;
    return Eigen::RowVector3d(200 * u + std::cos(a), 200 * u + std::sin(a), 7.0 * std::sin(a));
  });
  itk::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(rod));
  auto options = PlainOptions();
  options.azimuth = 45.0; // it runs to the right
  const auto picture = itk::RenderSurfaces(scene, options);
  int        left = 300;
  int        right = -1;
  for (int x = 0; x < 300; ++x)
  {
    for (int y = 0; y < 300; ++y)
    {
      if (itk::At(picture, x, y) != background)
      {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
  }
  EXPECT_NEAR(left, 18, 1); // 6 % of room at either side
  EXPECT_NEAR(right, 281, 1);
}

TEST(SurfaceRendering, ColoursOfVerticesBlendAndThoseOfFacesDoNot)
{
  const itk::SurfaceMesh sheet = itk::CoronalSheet(-20, 20, -20, 20, 0.0);
  const auto             seen = [&](const itk::SurfaceActor & actor, double x) {
    itk::SurfaceScene scene;
    scene.surfaces.push_back(actor);
    return SeenAt(scene, PlainOptions(), x, 0, 0);
  };
  itk::SurfaceActor byVertex = Actor(sheet);
  byVertex.vertexColors = {
    itk::MakeColor(0, 0, 0), itk::MakeColor(200, 100, 40), itk::MakeColor(0, 0, 0), itk::MakeColor(200, 100, 40)
  };
  for (const double x : { -15.0, 0.0, 12.0 })
  {
    const double share = (x + 20.0) / 40.0;
    const auto   expected = seen(Actor(sheet,
                                     itk::MakeColor(static_cast<unsigned char>(200 * share + 0.5),
                                                    static_cast<unsigned char>(100 * share + 0.5),
                                                    static_cast<unsigned char>(40 * share + 0.5))),
                               x);
    const auto   got = seen(byVertex, x);
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(got[channel], expected[channel], 2) << x;
    }
  }
  itk::SurfaceActor byFace = Actor(sheet);
  byFace.faceColors = { green, red }; // below and above the diagonal
  EXPECT_EQ(seen(byFace, 10.0), seen(Actor(sheet, green), 10.0));
  EXPECT_EQ(seen(byFace, -10.0), seen(Actor(sheet, red), -10.0));
}

TEST(SurfaceRendering, SeeThroughLayersMultiply)
{
  // Seen from the front a layer of opacity 0.4 lets 1 - 0.4 / 4 pass; no line is seen where its two faces meet.
  const itk::SurfaceMesh one = itk::CoronalSheet(-20, 20, -20, 20, -5.0);
  const itk::SurfaceMesh two = itk::CoronalSheet(-20, 20, -20, 20, 0.0);
  const itk::SurfaceMesh three = itk::CoronalSheet(-20, 20, -20, 20, 5.0);
  itk::SurfaceScene      scene;
  const auto             add = [&](const itk::SurfaceMesh & mesh) {
    scene.surfaces.push_back(Actor(mesh, itk::MakeColor(255, 255, 255)));
    scene.surfaces.back().opacity = 0.4;
  };
  double passed = 1.0;
  for (const auto * mesh : { &one, &two, &three })
  {
    add(*mesh);
    passed *= 0.9;
    const auto picture = itk::RenderSurfaces(scene, PlainOptions(101));
    for (int i = 10; i <= 90; ++i) // across the diagonals, too
    {
      ASSERT_NEAR(itk::At(picture, i, 50)[0], 255 * (1.0 - passed) + 18 * passed, 1.0) << i;
      ASSERT_NEAR(itk::At(picture, i, 100 - i)[0], 255 * (1.0 - passed) + 18 * passed, 1.0) << i;
    }
  }
}

TEST(SurfaceRendering, NoGapsBetweenFaces)
{
  const itk::SurfaceMesh fine = itk::ParametricMesh(
    97, 89, [](double u, double v) { return Eigen::RowVector3d(40 * u - 20, 0.0, 40 * v * (0.8 + 0.2 * u) - 20); });
  const itk::SurfaceMesh coarse = itk::CoronalSheet(-20, 20, -20, 20, 0.0);
  itk::SurfaceScene      scene;
  scene.surfaces.push_back(Actor(fine));
  auto       options = PlainOptions(260);
  const auto picture = itk::RenderSurfaces(scene, options);
  const auto inside = itk::At(picture, 120, 170);
  for (int x = 20; x < 240; ++x)
  {
    for (int y = 90; y < 240; ++y)
    {
      ASSERT_EQ(itk::At(picture, x, y), inside) << x << " " << y;
    }
  }
}

TEST(SurfaceRendering, ACurveIsSeenThroughTheWallOnlyWhereThisIsSeeThrough)
{
  TorusScene torus;
  torus.scene.markers.clear();
  torus.scene.curves[0].vertexColors.clear();
  auto options = PlainOptions();
  itk::LookFrom(itk::PatientSide::Superior, options);
  EXPECT_TRUE(IsReddish(SeenAt(torus.scene, options, 30, 0, 0)));
  EXPECT_FALSE(IsReddish(SeenAt(torus.scene, options, 36, 0, 0)));
  torus.scene.surfaces[0].opacity = 1.0;
  EXPECT_FALSE(IsReddish(SeenAt(torus.scene, options, 30, 0, 0)));
}

TEST(SurfaceRendering, ATubeIsAsThickAsItsRadiusSays)
{
  itk::CurveSet line;
  line.V.resize(2, 3);
  line.V << -50, 0, 0, 50, 0, 0;
  line.curves = { { 0, 1 } };
  itk::SurfaceScene scene;
  scene.curves.push_back({ &line, 6.0, red, {} });
  auto options = PlainOptions();
  options.zoom = 4.0;
  const auto picture = itk::RenderSurfaces(scene, options);
  int        thickness = 0;
  for (int y = 0; y < 300; ++y)
  {
    thickness += itk::At(picture, 150, y) == background ? 0 : 1;
  }
  EXPECT_NEAR(thickness * itk::ViewOfScene(scene, options).GetMillimetresPerPixel(), 12.0, 0.4);
}

TEST(SurfaceRendering, DepthShadingDarkensWhatLiesBehind)
{
  const itk::SurfaceMesh front = itk::CoronalSheet(-20, 0, -20, 20, -15.0);
  const itk::SurfaceMesh back = itk::CoronalSheet(0, 20, -20, 20, 15.0);
  itk::SurfaceScene      scene;
  scene.surfaces = { Actor(front), Actor(back) };
  auto       options = PlainOptions();
  const auto plain = SeenAt(scene, options, 0.5, 0, 0);
  EXPECT_EQ(plain, SeenAt(scene, options, -0.5, 0, 0));
  options.depthShading = 0.6;
  EXPECT_LT(SeenAt(scene, options, 0.5, 0, 0)[0], plain[0] - 30); // beside the step
  EXPECT_EQ(SeenAt(scene, options, -0.5, 0, 0), plain);
  EXPECT_EQ(SeenAt(scene, options, 17, 0, 0), plain); // far from it
}

TEST(SurfaceRendering, SameBytesForAnyNumberOfThreads)
{
  const TorusScene             torus;
  itk::SurfaceRenderingOptions options;
  options.width = 400;
  options.height = 300;
  options.azimuth = 20.0;
  options.elevation = 35.0;
  options.colorBar = torus.scale;
  const auto render = [&](unsigned int threads) {
    const itk::ThreadNumber number(threads);
    return itk::RenderSurfaces(torus.scene, options);
  };
  const auto one = render(1);
  for (const unsigned int threads : { 2U, 3U, 7U })
  {
    EXPECT_EQ(itk::GreatestDifference(one, render(threads)), 0) << threads;
  }
}

TEST(SurfaceRendering, RefusesWhatCannotBeDrawn)
{
  const itk::SurfaceMesh sphere = itk::SphereMesh({ 0, 0, 0 }, 10.0, 6);
  const auto             refuses = [](const itk::SurfaceScene & scene, itk::SurfaceRenderingOptions options = {}) {
    EXPECT_THROW(itk::RenderSurfaces(scene, options), std::invalid_argument);
  };
  itk::SurfaceScene scene;
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
  itk::SurfaceRenderingOptions options;
  options.zoom = 0.0;
  refuses(scene, options);
  options.zoom = 1.0;
  options.width = 50;
  options.colorBar = itk::ColorScale();
  refuses(scene, options);
  itk::SurfaceMesh broken = sphere;
  broken.F(0, 0) = 1000000;
  scene.surfaces[0].surface = &broken;
  refuses(scene);
  broken = sphere;
  broken.V(5, 1) = std::numeric_limits<double>::quiet_NaN();
  refuses(scene);
}

TEST(SurfaceRendering, Baseline)
{
  TorusScene                   torus;
  itk::SurfaceRenderingOptions options;
  options.width = 560;
  options.height = 420;
  options.azimuth = 20.0;
  options.elevation = 35.0;
  options.title = "Torus";
  options.colorBar = torus.scale;
  options.legend = { { torus.scene.surfaces[0].color, "wall" } };
  itk::ExpectBaseline(itk::RenderSurfaces(torus.scene, options), "itkSurfaceRendering.png");
}
