#include "shapetonColonFlexures.h"

#include "shapetonSchematicColon.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

using shapeton::ColonFlexures;
using shapeton::FindColonFlexures;
using shapeton::FlexureRule;

TEST(ColonFlexures, AreFoundOnASchematicColonInTheirOrder)
{
  const SchematicColon colon = MakeSchematicColon();
  const ColonFlexures  found = FindColonFlexures(colon.centerline);
  ASSERT_EQ(found.NumberFound(), 4);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(found.flexures[k].number, k + 1);
    EXPECT_NEAR(found.flexures[k].arcLength, colon.flexures[k], 25.0) << shapeton::NameOfFlexure(k + 1);
    EXPECT_GT(found.flexures[k].confidence, 0.3);
    EXPECT_LE(found.flexures[k].confidence, 1.0);
    EXPECT_NEAR(found.flexures[k].tangent.norm(), 1.0, 1e-9);
  }
  EXPECT_TRUE(found.warnings.empty());
}

TEST(ColonFlexures, OfARedundantDescendingColonAreWhereItBeginsAndEnds)
{
  const SchematicColon colon = MakeSchematicColon({ { 50, -20, 250 }, { 60, 10, 290 }, { 150, 20, 300 } });
  const ColonFlexures  found = FindColonFlexures(colon.centerline);
  ASSERT_EQ(found.NumberFound(), 4);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(found.flexures[k].arcLength, colon.flexures[k], 30.0) << shapeton::NameOfFlexure(k + 1);
  }
}

namespace
{
/** A colon whose sigmoid has extra loops; the descending colon is vertical and turns medially at its lower end. */
SchematicColon
ColonWithLongSigmoid(int loops)
{
  std::vector<Eigen::Vector3d> places{ { 0, 40, 0 }, { 0, 62, 60 }, { 0, 45, 120 } };
  for (int i = 0; i < loops; ++i)
  {
    const double z = 130.0 + 25.0 * i;
    places.insert(places.end(), { { -50.0, -10.0, z }, { -20.0, -45.0, z + 20.0 }, { 40.0, -45.0, z + 10.0 } });
  }
  const std::size_t junction = places.size() + 1;
  places.insert(places.end(),
                { { 40, 0, 120 },
                  { 110, 40, 130 },
                  { 125, 45, 240 },
                  { 130, 50, 350 },
                  { 80, -20, 320 },
                  { 0, -55, 215 },
                  { -90, -15, 290 },
                  { -115, 40, 320 },
                  { -125, 45, 240 },
                  { -118, 40, 150 } });
  SchematicColon colon;
  colon.centerline = RoundedCurve(places);
  colon.flexures[1] = ArcLengthNear(colon.centerline, places[junction]);
  return colon;
}

double
FractionOf(const SchematicColon & colon)
{
  return colon.flexures[1] / colon.centerline.pointArrays[0].values.maxCoeff();
}
} // namespace

TEST(ColonFlexures, EndTheDescendingColonWhereItsVerticalCourseTurnsMedially)
{
  EXPECT_LT(FractionOf(ColonWithLongSigmoid(0)), 0.25);
  EXPECT_GT(FractionOf(ColonWithLongSigmoid(3)), 0.5);
  for (int loops = 0; loops <= 3; ++loops)
  {
    const SchematicColon colon = ColonWithLongSigmoid(loops);
    const ColonFlexures  found = FindColonFlexures(colon.centerline);
    ASSERT_TRUE(found.flexures[1].isFound);
    EXPECT_NEAR(found.flexures[1].arcLength, colon.flexures[1], 30.0) << loops << " loops";
    EXPECT_FALSE(found.isJunctionFromBones);
  }
}

TEST(ColonFlexures, EndTheDescendingColonAtThePelvicBrim)
{
  const SchematicColon         colon = ColonWithLongSigmoid(1);
  const shapeton::Pelvis       pelvis{ { 100, 40, 190 }, { -100, 40, 190 }, { 0, 50, 130 } };
  const shapeton::ColonFlexure byCourse = FindColonFlexures(colon.centerline).flexures[1];
  const ColonFlexures          byBones = FindColonFlexures(colon.centerline, FlexureRule::Ordered, pelvis);
  EXPECT_TRUE(byBones.isJunctionFromBones);
  EXPECT_NEAR(byBones.flexures[1].arcLength, colon.flexures[1], 25.0);
  EXPECT_GE(byBones.flexures[1].confidence, byCourse.confidence);

  shapeton::Pelvis far = pelvis;
  far.promontory.z() -= 300.0;
  const ColonFlexures without = FindColonFlexures(colon.centerline, FlexureRule::Ordered, far);
  EXPECT_FALSE(without.isJunctionFromBones);
  EXPECT_NEAR(without.flexures[1].arcLength, byCourse.arcLength, 4.0);

  SchematicColon mirrored = colon;
  mirrored.centerline.V.col(0) *= -1.0;
  EXPECT_TRUE(
    FindColonFlexures(mirrored.centerline, FlexureRule::Ordered, shapeton::Mirrored(pelvis)).isJunctionFromBones);
}

TEST(ColonFlexures, DoNotDependOnWhereThePatientLies)
{
  SchematicColon      colon = MakeSchematicColon();
  const ColonFlexures before = FindColonFlexures(colon.centerline);
  colon.centerline.V.rowwise() += Eigen::RowVector3d(300.0, -200.0, 1024.0);
  const ColonFlexures after = FindColonFlexures(colon.centerline);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_DOUBLE_EQ(before.flexures[k].arcLength, after.flexures[k].arcLength);
    EXPECT_NEAR(after.flexures[k].point.z() - before.flexures[k].point.z(), 1024.0, 1e-9);
  }
}

TEST(ColonFlexures, OfAMirroredPatientAreTheSameAndItIsTold)
{
  SchematicColon      colon = MakeSchematicColon();
  const ColonFlexures before = FindColonFlexures(colon.centerline);
  colon.centerline.V.col(0) *= -1.0;
  const ColonFlexures after = FindColonFlexures(colon.centerline);
  EXPECT_FALSE(before.isMirrored);
  EXPECT_TRUE(after.isMirrored);
  ASSERT_EQ(after.NumberFound(), 4);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_DOUBLE_EQ(before.flexures[k].arcLength, after.flexures[k].arcLength);
    EXPECT_NEAR(before.flexures[k].confidence, after.flexures[k].confidence, 0.05);
  }
  ASSERT_EQ(after.warnings.size(), 1u);
  EXPECT_NE(after.warnings[0].find("right side"), std::string::npos);
}

TEST(ColonFlexures, OfALineFromTheCecumToTheRectumAreInDoubt)
{
  SchematicColon colon = MakeSchematicColon();
  EXPECT_FALSE(FindColonFlexures(colon.centerline).isBackwards);
  colon.centerline.V = colon.centerline.V.colwise().reverse().eval();
  const ColonFlexures found = FindColonFlexures(colon.centerline);
  EXPECT_TRUE(found.isBackwards);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings[0].find("from the cecum to the rectum"), std::string::npos);
  for (const shapeton::ColonFlexure & flexure : found.flexures)
  {
    EXPECT_LT(flexure.confidence, 0.5);
  }
}

TEST(ColonFlexures, OfThePublishedRuleIncludeTheTwoHighestBends)
{
  const SchematicColon colon = MakeSchematicColon();
  const ColonFlexures  found = FindColonFlexures(colon.centerline, FlexureRule::Published);
  ASSERT_TRUE(found.flexures[2].isFound);
  ASSERT_TRUE(found.flexures[3].isFound);
  EXPECT_NEAR(found.flexures[2].arcLength, colon.flexures[2], 30.0);
  EXPECT_NEAR(found.flexures[3].arcLength, colon.flexures[3], 30.0);
  for (int k = 1; k < 4; ++k)
  {
    const bool bothFound = found.flexures[k].isFound && found.flexures[k - 1].isFound;
    EXPECT_TRUE(!bothFound || found.flexures[k].arcLength > found.flexures[k - 1].arcLength);
  }
}

TEST(ColonFlexures, OfAPartOfAColonAreNotNamed)
{
  const shapeton::CurveSet part = RoundedCurve({ { 0, 0, 0 }, { 0, 0, 200 }, { 150, 0, 250 } });
  for (const FlexureRule rule : { FlexureRule::Ordered, FlexureRule::Published })
  {
    const ColonFlexures found = FindColonFlexures(part, rule);
    EXPECT_EQ(found.NumberFound(), 0);
    EXPECT_EQ(found.warnings.size(), 1u);
    EXPECT_NE(found.flexures[2].reason.find("part of a colon"), std::string::npos);
  }
}

TEST(ColonFlexures, OfALineLikeNoColonAreNotFound)
{
  // A straight upward line in the midline, without bends.
  const ColonFlexures found = FindColonFlexures(RoundedCurve({ { 0, 0, 0 }, { 0, 0, 1500 } }));
  EXPECT_LT(found.NumberFound(), 4);
  EXPECT_FALSE(found.warnings.empty());
}

TEST(ColonFlexures, NeedAnArcLengthThatAscends)
{
  shapeton::CurveSet curve = MakeSchematicColon().centerline;
  curve.pointArrays[0].values = -curve.pointArrays[0].values;
  EXPECT_THROW(FindColonFlexures(curve), shapeton::InputError);
  curve.pointArrays.clear();
  EXPECT_THROW(FindColonFlexures(curve), shapeton::InputError);
}
