#include "shapetonColorTable.h"

#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <cmath>

namespace
{
using basetest::Folder;
using basetest::MessageOf;

TEST(ColorTable, IsALineForEachLabelWithoutBlanksInNames)
{
  const Folder      folder;
  const std::string path = folder / "a.ctbl";
  shapeton::WriteColorTable({ { 1, "rectum", { 1.0, 0.0, 0.5 } }, { 7, "left side", { 0.0, 1.0, 0.0 } } }, path);
  EXPECT_EQ(shapeton::ReadFileBytes(path),
            "# Color table file\n# 3 values\n0 background 0 0 0 0\n1 rectum 255 0 128 255\n7 left_side 0 255 0 255\n");
}

TEST(ColorTable, NeighboringLabelsAreFarApartInColor)
{
  for (int label = 1; label < 500; ++label)
  {
    const auto color = shapeton::ColorOfLabel(label);
    for (const double channel : color)
    {
      EXPECT_GE(channel, 0.0);
      EXPECT_LE(channel, 1.0);
    }
    for (int other = label + 1; other < label + 4; ++other)
    {
      const auto   next = shapeton::ColorOfLabel(other);
      const double distance = std::hypot(color[0] - next[0], color[1] - next[1], color[2] - next[2]);
      EXPECT_GT(distance, 0.25) << label << " and " << other;
    }
  }
}

TEST(ColorTable, RefusesWhatSlicerWouldNotRead)
{
  const Folder folder;
  EXPECT_EQ(MessageOf([&] { shapeton::WriteColorTable({}, folder / "a.csv"); }).substr(0, 16), "ParameterError: ");
  for (const int value : { 0, -1, 32768 })
  {
    EXPECT_THROW(shapeton::WriteColorTable({ { value, "x", {} } }, folder / "a.ctbl"), std::invalid_argument);
  }
  EXPECT_THROW(shapeton::WriteColorTable({ { 1, "", {} } }, folder / "a.ctbl"), std::invalid_argument);
  EXPECT_THROW(shapeton::WriteColorTable({ { 1, "x", { 2.0, 0.0, 0.0 } } }, folder / "a.ctbl"), std::invalid_argument);
  EXPECT_THROW(shapeton::WriteColorTable({ { 1, "x", {} }, { 1, "y", {} } }, folder / "a.ctbl"), std::invalid_argument);
}
} // namespace
