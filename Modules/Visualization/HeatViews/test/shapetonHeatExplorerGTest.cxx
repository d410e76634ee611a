#include "shapetonHeatExplorer.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
using ImageType = itk::Image<float, 3>;

std::string
AsItIs(const std::string & path)
{
  return path;
}

ImageType::Pointer
VolumeOf(const ImageType::SizeType & size)
{
  auto volume = basetest::NewImage<ImageType>(size, { 0.5, 0.75, 2.0 });
  for (std::size_t i = 0; i < volume->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    volume->GetBufferPointer()[i] = static_cast<float>(i % 101) / 101.0F;
  }
  return volume;
}

std::string
FolderFor(const std::string & name)
{
  const std::string folder = testing::TempDir() + "/" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder + "/" + shapeton::HeatExplorer::DataFolder);
  return folder;
}

/** The page of a volume after steps 10 and 20. */
std::string
WritePage(const std::string & name, const ImageType * volume, const shapeton::HeatObjectList * objects = nullptr)
{
  const std::string       folder = FolderFor(name);
  shapeton::HeatHistogram histogram({ 0, 10, 20 });
  histogram.AddToRow(2, volume->GetBufferPointer(), volume->GetBufferedRegion().GetNumberOfPixels());
  shapeton::HeatExplorer explorer(folder, AsItIs);
  explorer.AddStep(volume, 10);
  explorer.AddStep(volume, 20);
  explorer.AddStep(volume, 20);
  shapeton::HeatExplorerContent content;
  content.title = "A volume";
  content.histogram = &histogram;
  content.gray = volume;
  content.lines = shapeton::ShapeTransferFunction::Parse("0.18359375-0.25:#05bffa:0.6");
  content.ranges = shapeton::HeatRangesOf({ 0.125, 0.5, 0.25, 0.375 });
  content.objects = objects;
  explorer.Write(content);
  return folder;
}

std::string
WritePage(const std::string & name, const ImageType::SizeType & size = { { 9, 8, 7 } })
{
  return WritePage(name, VolumeOf(size));
}

shapeton::Json
InfoOf(const std::string & folder)
{
  const std::string text = shapeton::ReadFileBytes(folder + "/explorer/info.js");
  const std::string head = "block(\"info\",null,";
  EXPECT_EQ(text.substr(0, head.size()), head);
  return shapeton::Json::parse(text.substr(head.size(), text.size() - head.size() - 3));
}
} // namespace

TEST(HeatExplorer, WritesThePageAndItsData)
{
  const std::string folder = WritePage("explorer-files");
  for (const char * name : { "explorer.html", "explorer/gray.js", "explorer/histogram.js", "explorer/bins-10.js" })
  {
    EXPECT_TRUE(std::filesystem::exists(folder + "/" + name)) << name;
  }
  const shapeton::Json info = InfoOf(folder);
  EXPECT_EQ(info["stored"], shapeton::Json({ 10, 20 }));
  EXPECT_EQ(info["volume"]["size"], shapeton::Json({ 9, 8, 7 }));
  EXPECT_EQ(info["volume"]["spacing"], shapeton::Json({ 0.5, 0.75, 2.0 }));
  EXPECT_EQ(info["lines"][0]["lower"], 0.18359375);
  EXPECT_EQ(info["planes"][0]["left"], "R");
  EXPECT_EQ(info["ranges"], shapeton::Json({ { 0.125, 0.5 }, { 0.25, 0.375 } }));
}

TEST(HeatExplorer, EqualInputGivesEqualBytes)
{
  const std::string first = WritePage("explorer-first");
  const std::string second = WritePage("explorer-second");
  for (const auto & entry : std::filesystem::recursive_directory_iterator(first))
  {
    if (entry.is_regular_file())
    {
      const std::string name = entry.path().string().substr(first.size());
      EXPECT_EQ(shapeton::ReadFileBytes(first + name), shapeton::ReadFileBytes(second + name)) << name;
    }
  }
}

TEST(HeatExplorer, OfALargeVolumeEveryNthVoxelIsKept)
{
  const shapeton::Json volume = InfoOf(WritePage("explorer-large", { { 400, 400, 225 } }))["volume"];
  EXPECT_EQ(volume["stride"], 2);
  EXPECT_EQ(volume["size"], shapeton::Json({ 200, 200, 113 }));
  EXPECT_EQ(volume["spacing"], shapeton::Json({ 1.0, 1.5, 4.0 }));
}

TEST(HeatExplorer, StoresObjectsOnTheGridOfTheVolume)
{
  using LabelImage = shapeton::HeatObjectList::LabelImage;
  const itk::Matrix<double, 3, 3> turn(basetest::Rotation(0, 0.3) * basetest::Rotation(2, 0.4));
  const ImageType::SizeType       size{ { 9, 8, 7 } };
  const auto               volume = basetest::NewImage<ImageType>(size, { 0.7, 1.1, 1.9 }, { 12.0, -31.0, 5.5 }, turn);
  shapeton::HeatObjectList list;
  list.labels = shapeton::NewImageOn<LabelImage>(volume, true);
  std::vector<std::uint16_t> expected(volume->GetBufferedRegion().GetNumberOfPixels());
  for (std::size_t voxel = 0; voxel < expected.size(); ++voxel)
  {
    expected[voxel] = static_cast<std::uint16_t>(voxel * 7 % 300);
    list.labels->GetBufferPointer()[voxel] = expected[voxel];
  }
  list.objects.resize(2);
  list.objects[1].parent = 1;
  list.objects[1].voxels = 12;
  const std::string    folder = WritePage("explorer-objects", volume, &list);
  shapeton::PageBlocks blocks("", true, AsItIs);
  blocks.Put("labels", expected, 9 * 8);
  EXPECT_EQ(shapeton::ReadFileBytes(folder + "/explorer/labels.js"), blocks.Script());

  const shapeton::Json info = InfoOf(folder);
  EXPECT_EQ(info["objects"][1]["number"], 2);
  EXPECT_EQ(info["objects"][1]["parent"], 1);
  EXPECT_EQ(info["objects"][1]["voxels"], 12);
  const itk::Index<3>   index{ { 5, 2, 6 } };
  itk::Point<double, 3> point;
  list.labels->TransformIndexToPhysicalPoint(index, point);
  for (unsigned int k = 0; k < 3; ++k) // as the page finds a point
  {
    double position = info["volume"]["origin"][k].get<double>();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      position += info["volume"]["axes"][axis][k].get<double>() * info["volume"]["spacing"][axis].get<double>() *
                  static_cast<double>(index[axis]);
    }
    EXPECT_NEAR(position, point[k], 1e-9);
  }
}

TEST(HeatExplorer, WithoutObjectsThePageHasNoLabels)
{
  const std::string folder = WritePage("explorer-lines");
  EXPECT_FALSE(std::filesystem::exists(folder + "/explorer/labels.js"));
  EXPECT_FALSE(InfoOf(folder).contains("objects"));
}

TEST(HeatExplorer, NeedsATimeStep)
{
  shapeton::HeatExplorer explorer(FolderFor("explorer-empty"), AsItIs);
  EXPECT_THROW(explorer.Write({}), std::logic_error);
}
