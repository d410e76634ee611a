#include "shapetonHaustralFolds.h"

#include "shapetonFlatCoordinateMap.h"
#include "shapetonFoldTubes.h"
#include "shapetonProgressTests.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using foldtubes::Fold;
using foldtubes::MakeTube;
using shapeton::FindHaustralFolds;
using shapeton::FlatColon;
using shapeton::FlatColonGrid;
using shapeton::HaustralFold;
using shapeton::HaustralFolds;
using shapeton::HaustralFoldScheme;
using shapeton::HaustralFoldSettings;

constexpr double pi = flattubes::pi;

std::vector<Fold>
FourFolds()
{
  return { { 30.0, 2.0, 18.0, 6.0 }, { 55.0, 0.0, 15.0, 5.0 }, { 90.0, 4.0, 20.0, 8.0 }, { 125.0, 3.0, 12.0, 4.0 } };
}

double
DistanceOnMap(const FlatColonGrid & grid, const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  return std::hypot(a.x() - b.x(), std::remainder(a.y() - b.y(), grid.Circumference()));
}
} // namespace

TEST(HaustralFolds, FindsFoldsWithTheirPlaceLengthAndHeight)
{
  const FlatColon         flat(MakeTube(FourFolds()));
  const HaustralFolds     found = FindHaustralFolds(flat);
  const std::vector<Fold> truth = FourFolds();
  ASSERT_EQ(found.folds.size(), truth.size());
  EXPECT_TRUE(found.warnings.empty());
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const HaustralFold &  fold = found.folds[i];
    const Eigen::Vector2d center(truth[i].u, foldtubes::radius * truth[i].angle);
    EXPECT_EQ(fold.label, static_cast<int>(i) + 1);
    EXPECT_LT(DistanceOnMap(flat.Grid(), fold.centerUv, center), 1.5);
    EXPECT_NEAR(fold.arcLength, 10.0 + truth[i].u, 1.0);
    EXPECT_NEAR(std::abs(fold.angle), 90.0, 5.0);
    EXPECT_NEAR(fold.height, truth[i].height, 0.25 * truth[i].height);
    EXPECT_NEAR(fold.length, 2.0 * truth[i].halfLength, 5.0);
    EXPECT_GT(fold.reliability, 0.5);
    for (int end = 0; end < 2; ++end)
    {
      const double sign = fold.endUv[end].y() < fold.centerUv.y() ? -1.0 : 1.0;
      const double way = std::abs(fold.endUv[end].y() - fold.centerUv.y()) > 60.0 ? -sign : sign;
      EXPECT_LT(DistanceOnMap(flat.Grid(), fold.endUv[end], center + Eigen::Vector2d(0.0, way * truth[i].halfLength)),
                3.0);
      const shapeton::FlatPixel pixel = flat.Grid().PixelOfUv(fold.endUv[end]);
      EXPECT_LT((flat.Grid().PointOfPixel(pixel.column, pixel.row) - fold.ends[end]).norm(), 1e-9);
    }
  }
}

TEST(HaustralFolds, AFoldAcrossTheCutIsOne)
{
  const FlatColon     flat(MakeTube(FourFolds()));
  const HaustralFolds found = FindHaustralFolds(flat);
  ASSERT_EQ(found.folds.size(), 4u);
  for (const HaustralFold & fold : found.folds)
  {
    EXPECT_EQ(fold.crossesCut, fold.label == 2);
  }
  int sides[2] = { 0, 0 };
  for (int column = 0; column < flat.Grid().Columns(); ++column)
  {
    sides[0] += found.labels->GetPixel({ { column, 0 } }) == 2;
    sides[1] += found.labels->GetPixel({ { column, flat.Grid().Rows() - 1 } }) == 2;
  }
  EXPECT_GT(sides[0], 0);
  EXPECT_GT(sides[1], 0);
}

TEST(HaustralFolds, LabelsLieOnTheCoordinateMap)
{
  const FlatColon     flat(MakeTube(FourFolds()));
  const HaustralFolds found = FindHaustralFolds(flat);
  const auto          map = shapeton::MakeFlatCoordinateMap(flat.Grid());
  EXPECT_EQ(found.labels->GetLargestPossibleRegion(), map->GetLargestPossibleRegion());
  EXPECT_EQ(found.labels->GetOrigin(), map->GetOrigin());
  EXPECT_EQ(found.labels->GetSpacing(), map->GetSpacing());
  EXPECT_EQ(found.labels->GetDirection(), map->GetDirection());
  for (const HaustralFold & fold : found.folds)
  {
    const shapeton::FlatPixel pixel = flat.Grid().PixelOfUv(fold.centerUv);
    EXPECT_EQ(found.labels->GetPixel({ { pixel.column, pixel.row } }), fold.label);
  }
}

TEST(HaustralFolds, ASmoothTubeHasNoneAndSaysSo)
{
  for (const HaustralFoldScheme scheme : { HaustralFoldScheme::GraphCut, HaustralFoldScheme::Published })
  {
    HaustralFoldSettings options;
    options.scheme = scheme;
    const HaustralFolds found = FindHaustralFolds(FlatColon(flattubes::MakeCylinder({})), options);
    EXPECT_TRUE(found.folds.empty());
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_NE(found.warnings[0].find("no haustral folds"), std::string::npos);
  }
}

TEST(HaustralFolds, TinyTubesAreNoError)
{
  EXPECT_TRUE(FindHaustralFolds(FlatColon(flattubes::MakeCylinder({ 8, 3, 6.0, 2.0 }))).folds.empty());
}

TEST(HaustralFolds, BridgedStretchesHoldNone)
{
  shapeton::SurfaceMesh mesh = MakeTube(FourFolds());
  for (Eigen::Index face = 0; face < mesh.F.rows(); ++face)
  {
    mesh.cellArrays[0].values(face, 0) = mesh.V(mesh.F(face, 0), 2) > 75.0 && mesh.V(mesh.F(face, 0), 2) < 105.0;
  }
  const HaustralFolds found = FindHaustralFolds(FlatColon(mesh));
  ASSERT_EQ(found.folds.size(), 3u);
  EXPECT_GT(found.folds[2].centerUv.x(), 110.0);
}

TEST(HaustralFolds, RidgesAlongTheTubeAreNoFolds)
{
  std::vector<Fold> folds = FourFolds();
  folds.push_back({ 75.0, 2.0, 3.0, 5.0, 0.0, 0.0, 12.0 }); // narrow, longitudinal
  const FlatColon flat(MakeTube(folds));
  EXPECT_EQ(FindHaustralFolds(flat).folds.size(), 4u);
  HaustralFoldSettings options;
  options.minimumAngle = 0.0;
  EXPECT_EQ(FindHaustralFolds(flat, options).folds.size(), 5u);
}

TEST(HaustralFolds, LengthAndAreaAreOnTheSurface)
{
  HaustralFoldSettings options;
  const FlatColon      flat(MakeTube(FourFolds()));
  const HaustralFolds  all = FindHaustralFolds(flat);
  options.minimumLength = 0.5 * (all.folds[3].length + all.folds[1].length);
  EXPECT_EQ(FindHaustralFolds(flat, options).folds.size(), 3u);
  options.minimumLength = 0.0;
  options.minimumArea = 0.5 * (all.folds[3].area + all.folds[1].area);
  EXPECT_EQ(FindHaustralFolds(flat, options).folds.size(), 3u);
  // A map at twice the scale results in the same folds, since measurements are in space.
  shapeton::SurfaceMesh large = MakeTube(FourFolds());
  large.pointArrays[0].values *= 2.0;
  large.fieldArrays[0].values *= 2.0;
  large.fieldArrays[1].values *= 2.0;
  const HaustralFolds scaled = FindHaustralFolds(FlatColon(large));
  ASSERT_EQ(scaled.folds.size(), all.folds.size());
  for (std::size_t i = 0; i < all.folds.size(); ++i)
  {
    EXPECT_NEAR(scaled.folds[i].length, all.folds[i].length, 0.1 * all.folds[i].length);
    EXPECT_NEAR(scaled.folds[i].area, all.folds[i].area, 0.15 * all.folds[i].area);
  }
}

TEST(HaustralFolds, TaeniaeSplitWhatHasGrownTogether)
{
  std::vector<Fold> folds = FourFolds();
  folds[2].dip = 0.22; // both halves join at angle 4
  folds[2].halfLength = 30.0;
  const FlatColon flat(MakeTube(folds));
  EXPECT_EQ(FindHaustralFolds(flat).folds.size(), 4u);
  shapeton::CurveSet taenia;
  taenia.V.resize(161, 3);
  taenia.curves.emplace_back();
  for (int i = 0; i <= 160; ++i)
  {
    taenia.V.row(i) = flattubes::OnCylinder(foldtubes::radius, i, -4.0);
    taenia.curves[0].push_back(i);
  }
  HaustralFoldSettings options;
  options.taeniae = &taenia;
  EXPECT_EQ(FindHaustralFolds(flat, options).folds.size(), 5u);
}

TEST(HaustralFolds, EndsNearTheBorderAreMoreReliable)
{
  const HaustralFolds  found = FindHaustralFolds(FlatColon(MakeTube(FourFolds())));
  const HaustralFold & far = found.folds[3]; // at the angle 3
  EXPECT_NEAR(far.endReliability[0], 0.5 * far.reliability, 0.05);
  const Fold           nearBorder{ 60.0, 18.5 / foldtubes::radius, 18.0, 6.0 };
  const HaustralFolds  one = FindHaustralFolds(FlatColon(MakeTube({ nearBorder, { 120.0, 3.0, 12.0, 6.0 } })));
  const HaustralFold & fold = one.folds[0];
  const int            low = fold.endUv[0].y() < fold.endUv[1].y() ? 0 : 1;
  EXPECT_GT(fold.endReliability[low], 0.9 * fold.reliability);
  EXPECT_LT(fold.endReliability[1 - low], 0.6 * fold.reliability);
}

TEST(HaustralFolds, OrientationOfFacesAndMapDoesNotMatter)
{
  const HaustralFolds expected = FindHaustralFolds(FlatColon(MakeTube(FourFolds())));
  flattubes::TubeForm form;
  form.isInsideOut = true;
  const HaustralFolds insideOut = FindHaustralFolds(FlatColon(MakeTube(FourFolds(), form)));
  form.isInsideOut = false;
  form.isMirrored = true;
  const HaustralFolds mirrored = FindHaustralFolds(FlatColon(MakeTube(FourFolds(), form)));
  ASSERT_EQ(insideOut.folds.size(), expected.folds.size());
  ASSERT_EQ(mirrored.folds.size(), expected.folds.size());
  for (std::size_t i = 0; i < expected.folds.size(); ++i)
  {
    EXPECT_NEAR(insideOut.folds[i].length, expected.folds[i].length, 1.0);
    EXPECT_LT((mirrored.folds[i].center - expected.folds[i].center).norm(), 2.0);
  }
}

TEST(HaustralFolds, NeedlesDoNoHarm)
{
  shapeton::SurfaceMesh mesh = MakeTube(FourFolds());
  // A vertex on the line between two neighbors creates a degenerate face.
  const Eigen::Index face = 2 * 120 * 75;
  const auto         corner = [&](int k) { return mesh.V.row(mesh.F(face, k)); };
  corner(0) = 0.5 * (corner(1) + corner(2)).eval();
  EXPECT_EQ(FindHaustralFolds(FlatColon(mesh)).folds.size(), 4u);
}

// A knob that is mapped to one pixel has the area of many folds, but a single curvature value.
TEST(HaustralFolds, AreaInOnePixelDoesNotOutweighFolds)
{
  constexpr double      reach = 8.0; // mm
  const Eigen::Vector2d middle(70.5, 40.5);
  shapeton::SurfaceMesh tube = MakeTube(FourFolds());
  const HaustralFolds   plain = FindHaustralFolds(FlatColon(tube));
  for (shapeton::SurfaceArray & array : tube.pointArrays)
  {
    for (Eigen::Index i = 0; array.name == "uv" && i < tube.V.rows(); ++i)
    {
      const Eigen::Vector2d away = array.values.row(i).transpose() - middle;
      if (away.norm() < reach)
      {
        tube.V.row(i).head<2>() *= 1.0 - 1.5 * std::exp(-0.08 * away.squaredNorm());
        array.values.row(i) = (middle + 0.06 * away).transpose();
      }
    }
  }
  const FlatColon     flat(tube);
  const HaustralFolds found = FindHaustralFolds(flat);
  for (const HaustralFold & fold : plain.folds)
  {
    const auto same = std::find_if(found.folds.begin(), found.folds.end(), [&](const HaustralFold & other) {
      return DistanceOnMap(flat.Grid(), other.centerUv, fold.centerUv) < 2.0;
    });
    ASSERT_NE(same, found.folds.end());
    EXPECT_NEAR(same->area, fold.area, 0.1 * fold.area);
  }
}

TEST(HaustralFolds, ThreadsDoNotMatter)
{
  const FlatColon flat(MakeTube(FourFolds()));
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const HaustralFolds                             found = FindHaustralFolds(flat);
      std::vector<std::pair<double, Eigen::Vector3d>> folds;
      for (const auto & fold : found.folds)
      {
        folds.emplace_back(fold.length, fold.ends[0]);
      }
      return std::make_pair(basetest::BytesOf(found.labels), folds);
    },
    { 3 });
}

TEST(HaustralFolds, RefusesWrongOptions)
{
  const FlatColon flat(flattubes::MakeCylinder({}));
  const auto      refuses = [&](const auto & change) {
    HaustralFoldSettings options;
    change(options);
    EXPECT_THROW(FindHaustralFolds(flat, options), shapeton::ParameterError);
  };
  refuses([](HaustralFoldSettings & o) { o.minimumLength = -1.0; });
  refuses([](HaustralFoldSettings & o) { o.minimumArea = std::nan(""); });
  refuses([](HaustralFoldSettings & o) { o.minimumElongation = 0.5; });
  refuses([](HaustralFoldSettings & o) { o.minimumAngle = 91.0; });
  refuses([](HaustralFoldSettings & o) { o.smoothingTime = -2.0; });
  refuses([](HaustralFoldSettings & o) { o.contrast = 0.0; });
  refuses([](HaustralFoldSettings & o) { o.publishedLow = 1.0; });
}

TEST(HaustralFolds, RefusesTaeniaeOfAnotherSurface)
{
  shapeton::CurveSet taenia;
  taenia.V.resize(2, 3);
  taenia.V << 500.0, 0.0, 0.0, 500.0, 0.0, 100.0;
  taenia.curves = { { 0, 1 } };
  HaustralFoldSettings options;
  options.taeniae = &taenia;
  EXPECT_THROW(FindHaustralFolds(FlatColon(MakeTube(FourFolds())), options), shapeton::InputError);
}

TEST(HaustralFolds, AreNotFoundAfterAnAbort)
{
  const FlatColon flat(MakeTube(FourFolds()));
  const auto      work = [&](const shapeton::Progress & progress) {
    HaustralFoldSettings options;
    options.progress = progress;
    FindHaustralFolds(flat, options);
  };
  shapeton::test::ExpectProgress(work, 12); // including one call per fold
}
