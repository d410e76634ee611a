#include "shapetonSurfaceFolds.h"

#include "shapetonFoldTubes.h"

#include <gtest/gtest.h>

#include <set>

using shapeton::FlatColon;

TEST(SurfaceFolds, AreThoseThatWereMade)
{
  std::vector<foldtubes::Fold> folds;
  for (int i = 0; i < 5; ++i)
  {
    folds.push_back({ 25.0 + 25.0 * i, 1.1 * i, 18.0, 6.0 });
  }
  const FlatColon               flat(foldtubes::MakeTube(folds));
  const shapeton::SurfaceMesh & surface = flat.Surface();
  const shapeton::SurfaceFolds  found = FindSurfaceFolds(flat);
  EXPECT_EQ(found.number, 5);
  EXPECT_GE(found.leastCurvature, 0.0);
  for (const foldtubes::Fold & fold : folds)
  {
    std::set<int> numbers;
    for (int face = 0; face < surface.NumberOfFaces(); ++face)
    {
      const Eigen::Vector3d p = surface.V.row(surface.F(face, 0));
      const double          around = std::remainder(-std::atan2(p.y(), p.x()) - fold.angle, 2.0 * flattubes::pi);
      if (std::abs(p.z() - fold.u) < 0.6 && std::abs(around) < 0.3)
      {
        numbers.insert(found.foldOfFace[face]);
      }
    }
    ASSERT_EQ(numbers.size(), 1u);
    EXPECT_GT(*numbers.begin(), 0);
  }
}

TEST(SurfaceFolds, AreNotMadeUpWhereTheWallIs)
{
  shapeton::SurfaceMesh bridged = foldtubes::MakeTube({ { 80.0, 0.0, 18.0, 6.0 } });
  EXPECT_EQ(FindSurfaceFolds(FlatColon(bridged)).number, 1);
  for (shapeton::SurfaceArray & array : bridged.cellArrays)
  {
    array.values.setOnes(); // the only array is "bridged"
  }
  EXPECT_EQ(FindSurfaceFolds(FlatColon(bridged)).number, 0);
}

// The fold crosses the cut.
TEST(SurfaceFolds, AreOneOnBothSidesOfTheCut)
{
  for (const bool isInsideOut : { false, true })
  {
    flattubes::TubeForm form;
    form.isInsideOut = isInsideOut;
    const FlatColon              flat(foldtubes::MakeTube({ { 80.0, 0.0, 18.0, 6.0 } }, form));
    const shapeton::SurfaceFolds found = FindSurfaceFolds(flat);
    EXPECT_EQ(found.number, 1);
    ASSERT_EQ(found.curvature.size(), flat.Surface().V.rows());
    const std::vector<int> & source = flat.Grid().SourceOfPoints();
    const int                around = 120;
    for (int i = 0; i < found.curvature.size(); i += around + 1)
    {
      ASSERT_EQ(source[i], source[i + around]);
      ASSERT_EQ(found.curvature[i], found.curvature[i + around]);
    }
  }
}
