#include "shapetonHiddenInBoth.h"

#include "shapetonTestColons.h"

#include "shapetonExceptions.h"

#include "gtest/gtest.h"

using namespace shapeton;

namespace
{
constexpr double shift = 50.0; // mm from the first position to the second, along the map

/** A tube that has no folds and whose lumen is collapsed between two distances, mm. */
ColonPosition
CollapsedBetween(double begin, double end)
{
  ColonPosition      position = tubecolons::MakeExamination("tube", std::vector<tubecolons::Fold>(), {}).position;
  CurveSet &         line = position.centerline;
  const Eigen::Index points = line.V.rows();
  SurfaceArray       gap{ "gap", SurfaceArray::ValueMatrix::Zero(points, 1), true };
  SurfaceArray       radius{ "radius", SurfaceArray::ValueMatrix::Constant(points, 1, tubecolons::radius), false };
  for (Eigen::Index i = 0; i < points; ++i)
  {
    const double s = line.pointArrays[0].values(i, 0);
    gap.values(i, 0) = s > begin && s < end ? 1.0 : 0.0;
  }
  line.pointArrays.push_back(gap);
  line.pointArrays.push_back(radius);
  return position;
}

SurfaceMesh
ShiftedMap(const ColonPosition & position)
{
  SurfaceMesh  map = position.flat->Surface();
  SurfaceArray mapped = *FindSurfaceArray(map.pointArrays, "uv");
  mapped.name = "mappedUv";
  mapped.values.col(0).array() += shift;
  map.pointArrays.push_back(mapped);
  return map;
}
} // namespace

TEST(HiddenInBoth, IsWhatTheMapTakesToHiddenWall)
{
  const ColonPosition                first = CollapsedBetween(100.0, 200.0), second = CollapsedBetween(120.0, 220.0);
  const std::vector<HinderedStretch> hidden = FindHiddenInBoth(first, second, ShiftedMap(first));
  ASSERT_EQ(hidden.size(), 1u); // 100 to 200 mm lie at 150 to 250 mm in the second position
  EXPECT_EQ(hidden[0].hindrance, ColonHindrance::NoLumen);
  EXPECT_NEAR(hidden[0].begin, 100.0, 5.0); // the points of the line are 5 mm apart
  EXPECT_NEAR(hidden[0].end, 220.0 - shift, 7.0);
  EXPECT_TRUE(FindHiddenInBoth(first, CollapsedBetween(300.0, 400.0), ShiftedMap(first)).empty());
}

TEST(HiddenInBoth, NeedsTheMap)
{
  const ColonPosition first = CollapsedBetween(100.0, 200.0);
  EXPECT_THROW(FindHiddenInBoth(first, first, first.flat->Surface()), InputError);
}
