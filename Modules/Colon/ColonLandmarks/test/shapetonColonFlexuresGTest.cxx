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
  // Straight up, without bends and at the midline.
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
