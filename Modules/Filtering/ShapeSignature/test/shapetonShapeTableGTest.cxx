#include "shapetonExceptions.h"
#include "shapetonSampledShapes.h"
#include "shapetonShapeTable.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace shapeton;
using namespace signaturetest;

namespace
{
/** Label 3: two balls; label 5: a box; label 9: a few voxels. */
Image::Pointer
Labels()
{
  const auto image = MakeImage({ 60, 40, 40 });
  Draw(image, Ball(6.0, { 15.0, 0.0, 0.0 }), 3.0F);
  Draw(image, Ball(8.0, { -15.0, 0.0, 0.0 }), 3.0F);
  Draw(
    image,
    [](const Eigen::Vector3d & p) {
      return Box({ 6.0, 30.0, 10.0 })(p);
    },
    5.0F);
  Draw(image, Ball(1.0, { 25.0, 15.0, 15.0 }), 9.0F);
  return image;
}

std::string
ReadText(const std::string & path)
{
  std::ifstream      file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string
Refusal(const std::string & text)
{
  const basetest::Folder folder;
  std::ofstream(folder / "t.csv") << text;
  const std::string message = basetest::MessageOf([&] { ReadShapeTable(folder / "t.csv"); });
  return message.substr(message.find("t.csv"));
}
} // namespace

TEST(ShapeTable, DescribesLabels)
{
  const auto       labels = Labels();
  const ShapeTable table = DescribeShapes(labels, labels);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].Name(), "3");
  EXPECT_EQ(table.rows[1].Name(), "5");
  EXPECT_EQ(table.rows[1].voxels, CountVoxels(VoxelsOfLabel(labels, 5)));
  EXPECT_EQ(table.rows[1].meanIntensity, 5.0); // the labels are the intensities here
  EXPECT_EQ(table.rows[1].intensityDeviation, 0.0);
  ASSERT_EQ(table.remarks.size(), 1U);
  EXPECT_EQ(table.remarks[0], "label 9 is skipped: it has 8 voxels, fewer than the 64 that a signature needs");
}

TEST(ShapeTable, DescribesComponentsLargestFirst)
{
  const auto       labels = Labels();
  const ShapeTable table = DescribeShapes(labels, labels, { true });
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].Name(), "3.1");
  EXPECT_EQ(table.rows[1].Name(), "3.2");
  EXPECT_EQ(table.rows[2].Name(), "5.1");
  EXPECT_GT(table.rows[0].voxels, table.rows[1].voxels);
  EXPECT_EQ(table.rows[0].voxels + table.rows[1].voxels, CountVoxels(VoxelsOfLabel(labels, 3)));
  EXPECT_EQ(table.remarks, Remarks{ "label 9: 8 voxels in components with fewer than 64 voxels are skipped" });
}

TEST(ShapeTable, ReadsBackWhatItWrote)
{
  const basetest::Folder folder;
  const auto             labels = Labels();
  const ShapeTable       table = DescribeShapes(labels, labels, { true });
  WriteShapeTable(table, folder / "a.csv");
  const ShapeTable again = ReadShapeTable(folder / "a.csv");
  ASSERT_EQ(again.rows.size(), table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    EXPECT_EQ(again.rows[i].Name(), table.rows[i].Name());
    EXPECT_EQ(again.rows[i].signature.remainingHeat, table.rows[i].signature.remainingHeat);
    EXPECT_EQ(again.rows[i].signature.displacement, table.rows[i].signature.displacement);
    EXPECT_EQ(again.rows[i].signature.spectrum, table.rows[i].signature.spectrum);
    EXPECT_EQ(again.rows[i].signature.volume, table.rows[i].signature.volume);
  }
  WriteShapeTable(again, folder / "b.csv");
  EXPECT_EQ(ReadText(folder / "a.csv"), ReadText(folder / "b.csv"));
}

TEST(ShapeTable, RefusesLabelsThatAreNone)
{
  const auto image = MakeImage({ 8, 8, 8 });
  const auto describe = [&] { DescribeShapes(image, image); };
  EXPECT_EQ(basetest::MessageOf(describe), "InputError: all voxels are 0: the label map has no label");
  image->GetBufferPointer()[7] = 1.0F;
  EXPECT_NE(basetest::MessageOf(describe).find("no shape has a signature: label 1 is skipped"), std::string::npos);
  image->GetBufferPointer()[7] = -1024.0F;
  EXPECT_NE(basetest::MessageOf(describe).find("has the value -1024; labels must be integers"), std::string::npos);
  image->GetBufferPointer()[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(basetest::MessageOf(describe).find("has the value nan; labels must be integers"), std::string::npos);
}

TEST(ShapeTable, RefusesTablesThatAreNone)
{
  const basetest::Folder folder;
  const auto             labels = Labels();
  WriteShapeTable(DescribeShapes(labels, labels), folder / "good.csv");
  const std::string text = ReadText(folder / "good.csv");
  const std::string header = text.substr(0, text.find('\n') + 1);
  std::string       line = text.substr(header.size(), text.find('\n', header.size()) + 1 - header.size());
  EXPECT_NE(Refusal("a,b\n1,2\n").find("label"), std::string::npos);
  EXPECT_EQ(Refusal(header), "t.csv: the table contains no shape; create it with ShapeSignature");
  EXPECT_NE(Refusal(header + "x" + line).find("line 2"), std::string::npos);
  const auto withFirstNumbers = [&](const std::string & numbers) {
    std::size_t rest = 0;
    for (int comma = 0; comma < 7; ++comma)
    {
      rest = line.find(',', rest) + 1;
    }
    return Refusal(header + numbers + ',' + line.substr(rest));
  };
  EXPECT_NE(withFirstNumbers("1,0,100,5,0,-4,10").find("line 2: volume is -4, which is out of range"),
            std::string::npos);
  EXPECT_NE(withFirstNumbers("1,0,100,5,0,4,0").find("line 2: surface is 0, which is out of range"), std::string::npos);
  EXPECT_NE(withFirstNumbers("1.5,0,100,5,0,4,9").find("line 2: the label 1.5 is not a non-negative integer"),
            std::string::npos);
  EXPECT_NE(Refusal(text.substr(0, text.size() / 2)).find("line"), std::string::npos); // truncated in the middle of a
                                                                                       // row
}

TEST(ShapeTable, RefusesCurvesOfNoShape)
{
  const auto image = MakeImage({ 24, 24, 24 });
  Draw(image, Ball(8.0));
  const ShapeSignature ball = ComputeShapeSignature(VoxelsOfLabel(image, 1), image);
  EXPECT_NO_THROW(RequireSound(ball, "ball"));
  ShapeSignature warmer = ball;
  std::swap(warmer.remainingHeat[2], warmer.remainingHeat[8]);
  EXPECT_THROW(RequireSound(warmer, "x"), InputError);
  ShapeSignature back = ball;
  std::swap(back.displacement[2], back.displacement[8]);
  EXPECT_THROW(RequireSound(back, "x"), InputError);
  ShapeSignature tall = ball;
  tall.elongation = 0.5;
  EXPECT_THROW(RequireSound(tall, "x"), InputError);
}
