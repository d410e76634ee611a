#include "shapetonFlatCoordinateMap.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonTestFolder.h"
#include "shapetonExceptions.h"

#include "itkImageFileReader.h"
#include "itkMetaDataObject.h"
#include "itkNrrdImageIO.h"

#include <gtest/gtest.h>

namespace
{
using namespace flattubes;
using shapeton::FlatColonGrid;
using shapeton::FlatCoordinateMap;

FlatCoordinateMap::Pointer
Read(const std::string & path)
{
  const auto reader = itk::ImageFileReader<FlatCoordinateMap>::New();
  reader->SetFileName(path);
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->Update();
  return reader->GetOutput();
}
} // namespace

class FlatCoordinateMapOf : public testing::TestWithParam<bool>
{};

INSTANTIATE_TEST_SUITE_P(Mirrored, FlatCoordinateMapOf, testing::Bool());

TEST_P(FlatCoordinateMapOf, BothDirectionsIsReadBackAsItWasWritten)
{
  TubeForm form;
  form.circumference = 61.0;
  form.isMirrored = GetParam();
  shapeton::FlatColonGridOptions options;
  options.pixelSize = 0.7;
  const FlatColonGrid grid(MakeCylinder(form), options);
  ASSERT_EQ(grid.IsMirrored(), GetParam());
  const basetest::Folder folder;
  const std::string      path = folder / "map.nrrd";
  WriteFlatCoordinateMap(grid, path, { { "Shapeton.tool", "a test" } });
  const auto map = Read(path);
  ASSERT_EQ(map->GetLargestPossibleRegion().GetSize()[0], static_cast<itk::SizeValueType>(grid.Columns()));
  ASSERT_EQ(map->GetLargestPossibleRegion().GetSize()[1], static_cast<itk::SizeValueType>(grid.Rows()));
  ForPixels(grid, [&](int column, int row) {
    const itk::Index<2>                index{ { column, row } };
    const FlatCoordinateMap::PixelType pixel = map->GetPixel(index);
    FlatCoordinateMap::PointType       uv;
    map->TransformIndexToPhysicalPoint(index, uv);
    const Eigen::Vector2d expected = grid.UvOfPixel(column, row);
    ASSERT_NEAR(uv[0], expected.x(), 1e-9);
    ASSERT_NEAR(uv[1], expected.y(), 1e-9);
    const Eigen::Vector3d point = grid.PointOfPixel(column, row);
    ASSERT_LT((Eigen::Vector3d(pixel[0], pixel[1], pixel[2]) - point).norm(), 1e-4);
  });
  std::string tool;
  ASSERT_TRUE(itk::ExposeMetaData(map->GetMetaDataDictionary(), "Shapeton.tool", tool));
  EXPECT_EQ(tool, "a test");
}

TEST(FlatCoordinateMap, RefusesOtherNamesAndPlaces)
{
  const FlatColonGrid grid(MakeCylinder({}));
  EXPECT_THROW(WriteFlatCoordinateMap(grid, "map.png"), shapeton::ParameterError);
  EXPECT_THROW(shapeton::RequireCoordinateMapName(".nrrd"), shapeton::ParameterError);
  EXPECT_EQ(shapeton::RequireCoordinateMapName(""), "");
  EXPECT_THROW(WriteFlatCoordinateMap(grid, "/no/such/folder/map.nrrd"), shapeton::OutputError);
}
