#include "shapetonShapeTransferFunction.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonColorMap.h"
#include "shapetonHeatColoring.h"

#include "shapetonTestErrors.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
/** Message of the ParameterError for this text; empty if no error is thrown. */
std::string
MessageOf(const std::string & text)
{
  return basetest::ErrorOf<shapeton::ParameterError>([&] { shapeton::ShapeTransferFunction::Parse(text); });
}

/** A volume property as parsed by 3D Slicer: nine lines read through a buffer of 1024 characters, each function as a
 * count and that many numbers, with strictly ascending heat values. */
struct SlicerVolumeProperty
{
  int                              interpolation;
  int                              shade;
  double                           diffuse;
  double                           ambient;
  double                           specular;
  double                           specularPower;
  std::vector<std::vector<double>> opacity;
  std::vector<std::vector<double>> gradientOpacity;
  std::vector<std::vector<double>> color;
};

std::vector<std::vector<double>>
ReadNodes(const std::string & line, std::size_t nodeSize)
{
  std::istringstream stream(line);
  std::size_t        size = 0;
  stream >> size;
  EXPECT_EQ(size % nodeSize, 0U);
  std::vector<std::vector<double>> nodes;
  double                           previous = -1e299;
  for (std::size_t i = 0; i < size; i += nodeSize)
  {
    std::vector<double> node;
    for (std::size_t k = 0; k < nodeSize; ++k)
    {
      std::string text;
      stream >> text;
      node.push_back(std::atof(text.c_str()));
    }
    EXPECT_GT(node[0], previous) << "the reader would move this point";
    previous = node[0];
    nodes.push_back(node);
  }
  std::string rest;
  EXPECT_FALSE(stream >> rest);
  return nodes;
}

SlicerVolumeProperty
ReadLikeSlicer(const std::string & path)
{
  std::ifstream            file(path);
  std::vector<std::string> lines;
  char                     buffer[1024];
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_TRUE(file.getline(buffer, sizeof(buffer))) << "line " << i << " is missing or too long";
    lines.emplace_back(buffer);
  }
  EXPECT_EQ(file.get(), EOF);
  return { std::stoi(lines[0]),    std::stoi(lines[1]),    std::stod(lines[2]),
           std::stod(lines[3]),    std::stod(lines[4]),    std::stod(lines[5]),
           ReadNodes(lines[6], 2), ReadNodes(lines[7], 2), ReadNodes(lines[8], 4) };
}

/** The value of a piecewise linear function; constant beyond its ends. */
double
Interpolate(const std::vector<std::vector<double>> & nodes, double heat, std::size_t value)
{
  if (heat <= nodes.front()[0])
  {
    return nodes.front()[value];
  }
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    if (heat <= nodes[i][0])
    {
      const double share = (heat - nodes[i - 1][0]) / (nodes[i][0] - nodes[i - 1][0]);
      return nodes[i - 1][value] + share * (nodes[i][value] - nodes[i - 1][value]);
    }
  }
  return nodes.back()[value];
}

/** Expects that the property matches the lines for all heat values more than `margin` away from their ends. */
void
ExpectSameFunction(const shapeton::ShapeTransferFunction & expected,
                   const SlicerVolumeProperty &            property,
                   double                                  margin)
{
  for (int i = 0; i <= 20000; ++i)
  {
    const double heat = i / 20000.0;
    bool         isNearEnd = false;
    for (const auto & line : expected.GetLines())
    {
      isNearEnd = isNearEnd || std::fabs(heat - line.lowerHeat) < margin || std::fabs(heat - line.upperHeat) < margin;
    }
    if (isNearEnd)
    {
      continue;
    }
    const int    line = expected.LineOf(static_cast<float>(heat));
    const double opacity = line < 0 ? 0.0 : expected.GetLines()[line].opacity;
    ASSERT_NEAR(Interpolate(property.opacity, heat, 1), opacity, 1e-4) << heat;
    for (std::size_t channel = 0; line >= 0 && channel < 3; ++channel)
    {
      ASSERT_NEAR(
        Interpolate(property.color, heat, channel + 1), expected.GetLines()[line].color[channel] / 255.0, 1e-4)
        << heat;
    }
  }
}

shapeton::HeatClass
MakeClass(unsigned int label, double lower, double upper, std::uint64_t voxels)
{
  shapeton::HeatClass heatClass;
  heatClass.label = label;
  heatClass.lowerHeat = lower;
  heatClass.upperHeat = upper;
  heatClass.meanHeat = 0.5 * (lower + upper);
  heatClass.voxels = voxels;
  return heatClass;
}
} // namespace

TEST(ShapeTransferFunction, ReadsLines)
{
  const auto lines =
    shapeton::ShapeTransferFunction::Parse("0.18-0.21:red:1, 1e-3 - 2E-3 : #3366cc : 0.4,.5-1:Lime:0").GetLines();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].lowerHeat, 1e-3);
  EXPECT_EQ(lines[0].upperHeat, 2e-3);
  EXPECT_EQ(lines[0].color, shapeton::MakeColor(0x33, 0x66, 0xcc));
  EXPECT_EQ(lines[0].opacity, 0.4);
  EXPECT_EQ(lines[1].lowerHeat, 0.18);
  EXPECT_EQ(lines[1].color, shapeton::MakeColor(255, 0, 0));
  EXPECT_EQ(lines[2].upperHeat, 1.0);
  EXPECT_EQ(lines[2].opacity, 0.0);
}

TEST(ShapeTransferFunction, ASignInAnExponentIsNoSeparator)
{
  const auto line = shapeton::ShapeTransferFunction::Parse("1e-3-2e-3:red:1").GetLines().front();
  EXPECT_EQ(line.lowerHeat, 1e-3);
  EXPECT_EQ(line.upperHeat, 2e-3);
  const auto other = shapeton::ShapeTransferFunction::Parse("5e-05-1e+0:red:1").GetLines().front();
  EXPECT_EQ(other.lowerHeat, 5e-5);
  EXPECT_EQ(other.upperHeat, 1.0);
}

TEST(ShapeTransferFunction, NamesTheFaultyPiece)
{
  const std::pair<const char *, const char *> faults[] = {
    { "", "\"\"" },
    { "0.1-0.2:red:1,", "\"\"" },
    { "0.1-0.2:red", "0.1-0.2:red" },
    { "0.1-0.2:red:1:2", "0.1-0.2:red:1:2" },
    { "0.1:red:1", "\"0.1\"" },
    { "1e-3:red:1", "\"1e-3\"" },
    { "-0.1-0.2:red:1", "\"-0.1-0.2\"" },
    { "0.1-0.2-0.3:red:1", "\"0.1-0.2-0.3\"" },
    { "0.1-x:red:1", "\"0.1-x\"" },
    { "nan-0.2:red:1", "\"nan-0.2\"" },
    { "0.1-inf:red:1", "\"0.1-inf\"" },
    { "0,1-0,2:red:1", "\"0\"" },
    { "0.1-0.2:rouge:1", "\"rouge\"" },
    { "0.1-0.2:#12:1", "\"#12\"" },
    { "0.1-0.2:red:half", "\"half\"" },
    { "0.1-0.2:red:", "\"\"" },
    { "0.1-0.2:red:1.5", "1.5" },
    { "0.2-0.1:red:1", "0.2-0.1" },
    { "0.1-0.1:red:1", "0.1-0.1" },
    { "0.5-1.5:red:1", "0.5-1.5" },
    { "0.1-0.10000001:red:1", "narrower" },
    { "0.1-0.3:red:1,0.2-0.4:blue:1", "0.1-0.3 and 0.2-0.4 overlap" },
  };
  for (const auto & [text, piece] : faults)
  {
    const std::string message = MessageOf(text);
    EXPECT_NE(message.find(piece), std::string::npos) << '"' << text << "\" gives: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  std::string many;
  for (int i = 0; i < 13; ++i)
  {
    many +=
      (i == 0 ? "" : ",") + std::string("0.") + std::to_string(10 + i) + "-0." + std::to_string(11 + i) + ":red:1";
  }
  EXPECT_NE(MessageOf(many).find("13"), std::string::npos);
}

TEST(ShapeTransferFunction, LinesAreHalfOpenAndMayTouch)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("0.25-0.5:red:1,0.5-0.75:blue:1");
  EXPECT_EQ(function.LineOf(0.2499F), -1);
  EXPECT_EQ(function.LineOf(0.25F), 0);
  EXPECT_EQ(function.LineOf(0.5F), 1);
  EXPECT_EQ(function.LineOf(0.75F), -1);
  EXPECT_EQ(shapeton::ShapeTransferFunction().LineOf(0.5F), -1);
  EXPECT_EQ(shapeton::ShapeTransferFunction::Parse("0.5-1:red:1").LineOf(1.0F), 0);
}

TEST(ShapeTransferFunction, OneLineAlone)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("0.25-0.5:red:1,0.5-0.75:blue:0.3");
  const auto alone = function.OnlyLine(1);
  ASSERT_EQ(alone.GetLines().size(), 1U);
  EXPECT_EQ(alone.LineOf(0.3F), -1);
  EXPECT_EQ(alone.LineOf(0.6F), 0);
  EXPECT_THROW(function.OnlyLine(2), std::out_of_range);
}

TEST(ShapeTransferFunction, TextRoundTrip)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("1e-5-2e-5:teal:0.125,0.1-0.3333333333333333:#abcdef:1");
  const auto back = shapeton::ShapeTransferFunction::Parse(function.ToText());
  ASSERT_EQ(back.GetLines().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(back.GetLines()[i].lowerHeat, function.GetLines()[i].lowerHeat);
    EXPECT_EQ(back.GetLines()[i].upperHeat, function.GetLines()[i].upperHeat);
    EXPECT_EQ(back.GetLines()[i].color, function.GetLines()[i].color);
    EXPECT_EQ(back.GetLines()[i].opacity, function.GetLines()[i].opacity);
  }
}

TEST(ShapeTransferFunction, SlicerReadsTheVolumeProperty)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("0.1-0.2:red:0.5,0.2-0.25:#3366cc:1,0.7-1:yellow:0.25");
  const std::string path = shapeton::TemporaryFolder("vp") + "/a.vp";
  function.WriteVolumeProperty(path);
  const SlicerVolumeProperty property = ReadLikeSlicer(path);
  EXPECT_EQ(property.interpolation, VTK_NEAREST_INTERPOLATION);
  EXPECT_EQ(property.shade, 1);
  EXPECT_EQ(property.diffuse, 0.6);
  EXPECT_EQ(property.ambient, 0.3);
  EXPECT_EQ(property.specular, 0.2);
  EXPECT_EQ(property.specularPower, 10.0);
  EXPECT_EQ(property.gradientOpacity, (std::vector<std::vector<double>>{ { 0.0, 1.0 }, { 1.0, 1.0 } }));
  ExpectSameFunction(function, property, 7e-5);
  // Half-open: the line includes its lower end, but not its upper end.
  EXPECT_NEAR(Interpolate(property.opacity, 0.1, 1), 0.5, 1e-6);
  EXPECT_NEAR(Interpolate(property.opacity, 0.2, 1), 1.0, 1e-6);
  EXPECT_NEAR(Interpolate(property.opacity, 0.25, 1), 0.0, 1e-6);
}

TEST(ShapeTransferFunction, TheLargestFunctionFitsIntoSlicersBuffer)
{
  std::vector<shapeton::TransferFunctionLine> lines;
  for (std::size_t i = 0; i < shapeton::ShapeTransferFunction::MaximumNumberOfLines; ++i)
  {
    const double lower = 1.2345678901e-3 + 1.234567891e-3 * static_cast<double>(i);
    lines.push_back({ lower, lower + 1.0123456789e-3, shapeton::MakeColor(23, 101, 211), 0.123456 });
  }
  const shapeton::ShapeTransferFunction function(lines);
  const std::string                     path = shapeton::TemporaryFolder("vp-largest") + "/a.vp";
  function.WriteVolumeProperty(path);
  const SlicerVolumeProperty property = ReadLikeSlicer(path);
  EXPECT_EQ(property.color.size(), 2 * lines.size());
  for (const auto & line : lines)
  {
    EXPECT_NEAR(Interpolate(property.opacity, 0.5 * (line.lowerHeat + line.upperHeat), 1), 0.1235, 1e-9);
    EXPECT_NEAR(Interpolate(property.opacity, line.upperHeat + 4e-8, 1), 0.0, 1e-6);
  }
}

TEST(ShapeTransferFunction, SlicerSamplesEveryPointInATextureOfItsSize)
{
  const auto function =
    shapeton::ShapeTransferFunction::Parse("1e-5-2e-5:red:1,3e-5-0.02:lime:1,0.02-0.020001:blue:1,0.5-1:red:1");
  const std::string path = shapeton::TemporaryFolder("vp-narrow") + "/a.vp";
  function.WriteVolumeProperty(path);
  const SlicerVolumeProperty property = ReadLikeSlicer(path);
  for (const auto * points : { &property.opacity, &property.color })
  {
    for (std::size_t k = 1; k < points->size(); ++k)
    {
      EXPECT_GE((*points)[k][0] - (*points)[k - 1][0],
                1.0 / 16384.0); // VTK takes as many samples as the least distance needs
    }
  }
  EXPECT_EQ(Interpolate(property.opacity, 0.01, 1), 1.0);
  EXPECT_EQ(Interpolate(property.opacity, 0.3, 1), 0.0);
}

TEST(ShapeTransferFunction, AnEmptyFunctionAndLinesAtTheEndsAreWritten)
{
  const std::string folder = shapeton::TemporaryFolder("vp-ends");
  shapeton::ShapeTransferFunction().WriteVolumeProperty(folder + "/empty.vp");
  std::ifstream file(folder + "/empty.vp");
  EXPECT_TRUE(file.good());
  const auto whole = shapeton::ShapeTransferFunction::Parse("0-1:red:0.5");
  whole.WriteVolumeProperty(folder + "/whole.vp");
  const SlicerVolumeProperty property = ReadLikeSlicer(folder + "/whole.vp");
  EXPECT_EQ(Interpolate(property.opacity, 0.0, 1), 0.5);
  EXPECT_EQ(Interpolate(property.opacity, 0.999, 1), 0.5);
}

TEST(ShapeTransferFunction, UnwritableVolumePropertyIsAnOutputError)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("0-1:red:0.5");
  EXPECT_THROW(function.WriteVolumeProperty("/nonexistent-folder/a.vp"), shapeton::OutputError);
  if (std::filesystem::exists("/dev/full"))
  {
    EXPECT_THROW(function.WriteVolumeProperty("/dev/full"), shapeton::OutputError);
  }
}

TEST(ShapeTransferFunction, VtkShowsTheSame)
{
  const auto function = shapeton::ShapeTransferFunction::Parse("0.1-0.2:red:0.5,0.2-0.25:#3366cc:1");
  const auto property = function.ToVolumeProperty();
  EXPECT_DOUBLE_EQ(property->GetScalarOpacity()->GetValue(0.15), 0.5);
  EXPECT_DOUBLE_EQ(property->GetScalarOpacity()->GetValue(0.22), 1.0);
  EXPECT_DOUBLE_EQ(property->GetScalarOpacity()->GetValue(0.3), 0.0);
  EXPECT_DOUBLE_EQ(property->GetScalarOpacity()->GetValue(0.05), 0.0);
  double color[3];
  property->GetRGBTransferFunction()->GetColor(0.22, color);
  EXPECT_NEAR(color[0], 0x33 / 255.0, 1e-12);
  EXPECT_NEAR(color[2], 0xcc / 255.0, 1e-12);
  EXPECT_EQ(property->GetInterpolationType(), VTK_NEAREST_INTERPOLATION);
  EXPECT_EQ(property->GetShade(), 1);
}

TEST(ShapeTransferFunction, ClassesBecomeLinesInTheirColors)
{
  const auto lines = shapeton::ShapeTransferFunction::FromClasses(
                       { MakeClass(0, 0.0, 0.05, 9000), MakeClass(1, 0.05, 0.3, 27000), MakeClass(2, 0.3, 0.5, 1000) })
                       .GetLines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].lowerHeat, 0.05);
  EXPECT_EQ(lines[0].color, shapeton::ClassColor(1));
  EXPECT_EQ(lines[0].name, "class 1: 0.05 to 0.3");
  EXPECT_EQ(lines[1].color, shapeton::ClassColor(2));
  EXPECT_DOUBLE_EQ(lines[1].opacity, 0.9);
  EXPECT_DOUBLE_EQ(lines[0].opacity, 0.1); // 27 times the voxels
}

TEST(ShapeTransferFunction, TheSurroundingsAreNoLineUnlessThereIsNothingElse)
{
  std::vector<shapeton::HeatClass> classes{ MakeClass(0, 0.0, 0.05, 900),
                                            MakeClass(1, 0.05, 0.3, 5000),
                                            MakeClass(2, 0.3, 0.5, 1000) };
  classes[1].isSurroundings = true;
  const auto lines = shapeton::ShapeTransferFunction::FromClasses(classes).GetLines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].lowerHeat, 0.3);
  EXPECT_EQ(lines[0].color, shapeton::ClassColor(2)) << "colors do not depend on what is shown";
  classes.pop_back();
  EXPECT_EQ(shapeton::ShapeTransferFunction::FromClasses(classes).GetLines().size(), 1U);
}

TEST(ShapeTransferFunction, IncoherentClassesAreTransparentInRenderingAndSlices)
{
  std::vector<shapeton::HeatClass> classes{ MakeClass(0, 0.0, 0.05, 900),
                                            MakeClass(1, 0.05, 0.3, 8000),
                                            MakeClass(2, 0.3, 0.5, 1000) };
  classes[1].coherence = 0.5;
  classes[2].coherence = 0.1;
  const auto function = shapeton::ShapeTransferFunction::FromClasses(classes);
  ASSERT_EQ(function.GetLines().size(), 2U);
  EXPECT_EQ(function.GetLines()[0].opacity, 0.9) << "the only class that is shown";
  EXPECT_EQ(function.GetLines()[1].opacity, 0.0);
  EXPECT_EQ(function.GetLines()[1].name, "class 2: incoherent");
  EXPECT_TRUE(shapeton::ColorByLine(function)(0.1F));
  EXPECT_FALSE(shapeton::ColorByLine(function)(0.4F));
}
