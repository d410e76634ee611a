#include "shapetonColonGravity.h"

#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
TEST(ColonGravity, DirectionOfEachPatientPosition)
{
  // LPS: x to the left, y to the back, z to the head; for a patient lying on the right side, gravity points to the
  // right.
  const std::pair<const char *, std::array<double, 3>> truth[] = {
    { "HFS", { 0, 1, 0 } },    { "FFS", { 0, 1, 0 } },           { "HFP", { 0, -1, 0 } },
    { "FFP", { 0, -1, 0 } },   { "HFDR", { -1, 0, 0 } },         { "FFDR", { -1, 0, 0 } },
    { "HFDL", { 1, 0, 0 } },   { "FFDL", { 1, 0, 0 } },          { "supine", { 0, 1, 0 } },
    { "prone", { 0, -1, 0 } }, { "leftDecubitus", { 1, 0, 0 } }, { "rightDecubitus", { -1, 0, 0 } }
  };
  for (const auto & entry : truth)
  {
    const auto gravity = shapeton::GravityOfPatientPosition(entry.first);
    ASSERT_TRUE(gravity) << entry.first;
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ((*gravity)[a], entry.second[a]) << entry.first;
    }
    EXPECT_EQ(*shapeton::GravityOfPatientPosition(shapeton::NameOfGravity(*gravity)), *gravity);
  }
}

TEST(ColonGravity, OtherTextsHaveNoDirection)
{
  for (const char * text : { "", "SITTING", "hfs", "HF", "HFSS", "Supine", "LFP" })
  {
    EXPECT_FALSE(shapeton::GravityOfPatientPosition(text)) << text;
  }
}

TEST(ColonGravity, OnlyAutoAndAnEmptyTextLeaveItOpen)
{
  EXPECT_FALSE(shapeton::GivenGravity("auto"));
  EXPECT_FALSE(shapeton::GivenGravity(""));
  EXPECT_EQ(shapeton::GivenGravity("HFP"), shapeton::GravityOfPatientPosition("prone"));
  EXPECT_THROW(shapeton::GivenGravity("SITTING"), shapeton::ParameterError);
}
} // namespace
