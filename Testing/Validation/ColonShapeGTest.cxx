#include "Tables.h"
#include "ColonShape.h"

#include "shapetonFoldTubes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shapeton;

namespace
{
/** Four equal folds on a straight tube of 160 mm. */
constexpr foldtubes::Fold oneFold{ 0.0, 0.0, 20.0, 6.0, 0.0, 0.0, 2.0 };

FlatColon
TubeWithFolds()
{
  std::vector<foldtubes::Fold> folds;
  for (const double u : { 30.0, 65.0, 100.0, 130.0 })
  {
    folds.push_back(oneFold);
    folds.back().u = u;
    folds.back().angle = 0.03 * u;
  }
  return FlatColon(foldtubes::MakeTube(folds));
}

/** Centerline on the axis of the tube, one point per mm, with balls of 17 mm and a bridge of 20 mm. */
CurveSet
AxisOfTube()
{
  CurveSet line;
  line.V.setZero(160, 3);
  line.curves.emplace_back();
  for (const char * const name : { "arcLength", "radius", "gap" })
  {
    flattubes::AddArray(line.pointArrays, name, 160, 1);
  }
  for (int i = 0; i < 160; ++i)
  {
    const Eigen::Vector3d opposite = flattubes::OnCylinder(1.0, i, flattubes::pi);
    line.V.row(i) = 0.5 * (flattubes::OnCylinder(1.0, i, 0.0) + opposite);
    line.curves[0].push_back(i);
    line.pointArrays[0].values(i, 0) = i;
    line.pointArrays[1].values(i, 0) = i < 20 ? 1.0 : 17.0;
    line.pointArrays[2].values(i, 0) = i < 20 ? 1.0 : 0.0;
  }
  return line;
}
} // namespace

TEST(ColonShape, TubeWithFoldsIsMeasuredAsItWasMade)
{
  const SegmentShape shape = MeasureColonShape(TubeWithFolds(), AxisOfTube())[0];
  ASSERT_EQ(shape.lengths, std::vector<double>{ 159.0 });
  EXPECT_NEAR(shape.tortuosities.at(0), 1.0, 0.01);
  EXPECT_NEAR(shape.turnings.at(0), 0.0, 1e-6);
  EXPECT_EQ(shape.inscribedRadii.size(), 139U); // not on the bridge
  EXPECT_EQ(MeanOf(shape.inscribedRadii), 17.0);
  EXPECT_NEAR(LowerQuantile(shape.radii, 0.9), foldtubes::radius, 0.02); // between the folds
  EXPECT_LT(LowerQuantile(shape.radii, 0.0), 19.0);                      // at a fold
  EXPECT_NEAR(shape.foldsPerDecimeter.at(0), 4 / 1.59, 1e-9);

  const double turn = 2.0 * flattubes::pi * foldtubes::radius;
  EXPECT_NEAR(MeanOf(shape.extents), 360.0 * 2.0 * oneFold.halfLength / turn, 12.0);
  EXPECT_NEAR(shape.spacings.at(0), 159.0 / (4.0 * 2.0 * oneFold.halfLength / turn), 13.0);
  ASSERT_EQ(shape.heights.size(), 4U);
  // Measured above the feet, where the flank has its largest outward curvature; for a Gaussian, at sqrt(3) standard
  // deviations.
  EXPECT_GT(MeanOf(shape.heights), oneFold.height * (1.0 - std::exp(-1.5)));
  EXPECT_LT(MeanOf(shape.heights), oneFold.height);
  ASSERT_EQ(shape.thicknesses.size(), 4U);
  EXPECT_NEAR(MeanOf(shape.thicknesses), 2.3548 * oneFold.thickness, 0.25); // of a Gaussian
}

TEST(ColonShape, ColonsArePutTogetherSampleBySample)
{
  ColonShape one;
  one[2].heights = { 3.0, 5.0 };
  one[2].lengths = { 400.0 };
  ColonShape both = one;
  AddShape(one, both);
  EXPECT_EQ(both[2].heights, (std::vector<double>{ 3.0, 5.0, 3.0, 5.0 }));
  EXPECT_EQ(both[2].lengths.size(), 2U);
  EXPECT_TRUE(both[1].heights.empty());
}
