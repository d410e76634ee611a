#include "shapetonDicomPictures.h"
#include "shapetonDicomResultsTesting.h"
#include "shapetonFileBytes.h"
#include "shapetonMappedImage.h"
#include "shapetonSurfaceReader.h"

namespace
{
using namespace shapeton;

SurfaceMesh
Tetrahedron()
{
  SurfaceMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
  mesh.F.resize(4, 3);
  mesh.F << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return mesh;
}

using DicomPictures = ResultsOfASeries;
} // namespace

TEST_F(DicomPictures, PixelsComeBack)
{
  const auto picture = itk::Image<itk::RGBPixel<unsigned char>, 2>::New();
  picture->SetRegions(itk::Size<2>{ { 3, 5 } });
  picture->Allocate();
  auto * const bytes = reinterpret_cast<unsigned char *>(picture->GetBufferPointer());
  for (int i = 0; i < 45; ++i)
  {
    bytes[i] = static_cast<unsigned char>(5 * i);
  }
  WriteDicomPicture(source, picture, HeaderOfTest(), folder + "/sc.dcm");
  DcmFileFormat file = Loaded(folder + "/sc.dcm");
  EXPECT_EQ(ValueOf(file, DCM_Rows), "5");
  EXPECT_EQ(ValueOf(file, DCM_Columns), "3");
  EXPECT_EQ(ValueOf(file, DCM_StudyInstanceUID), "1.2.3");
  const Uint8 * pixels = nullptr;
  unsigned long count = 0;
  ASSERT_TRUE(file.getDataset()->findAndGetUint8Array(DCM_PixelData, pixels, &count).good());
  EXPECT_EQ(std::vector<Uint8>(pixels, pixels + 45), std::vector<Uint8>(bytes, bytes + 45));
}

TEST_F(DicomPictures, SurfaceComesBack)
{
  WriteDicomSurface(source, Tetrahedron(), { "WALL", "99SHAPETON", "Wall" }, HeaderOfTest(), folder + "/stl.dcm");
  DcmFileFormat file = Loaded(folder + "/stl.dcm");
  EXPECT_EQ(ValueOf(file, DCM_FrameOfReferenceUID), "1.2.4");
  const Uint8 * stl = nullptr;
  unsigned long count = 0;
  ASSERT_TRUE(file.getDataset()->findAndGetUint8Array(DCM_EncapsulatedDocument, stl, &count).good());
  EXPECT_EQ(ValueOf(file, DCM_EncapsulatedDocumentLength), "284"); // 84 + 4 * 50
  WriteFileBytes(folder + "/back.stl", std::string(reinterpret_cast<const char *>(stl), 284));
  const SurfaceMesh back = ReadSurface(folder + "/back.stl").mesh;
  EXPECT_EQ(back.NumberOfVertices(), 4);
  EXPECT_EQ(back.V.maxCoeff(), 10.0);
}

TEST_F(DicomPictures, MapKeepsItsValuesAndPlaces)
{
  const auto         image = NewImageOn<itk::Image<float, 3>>(source.grid, true);
  std::vector<float> values;
  for (int i = 0; i < 7 * 9 * 6; ++i)
  {
    values.push_back(0.1F * static_cast<float>(i) - 3.0F);
  }
  std::copy(values.begin(), values.end(), image->GetBufferPointer());
  const DicomMapMeaning meaning{ { "CHD", "99SHAPETON", "Cumulative heat" },
                                 { "1", "UCUM", "no units" },
                                 "HEAT",
                                 "heat",
                                 { "818983003", "SCT", "Abdomen" } };
  WriteDicomMap(source, image, meaning, HeaderOfTest(), folder + "/map.dcm");
  DcmFileFormat   file = Loaded(folder + "/map.dcm");
  const Float32 * pixels = nullptr;
  unsigned long   count = 0;
  ASSERT_TRUE(file.getDataset()->findAndGetFloat32Array(DCM_FloatPixelData, pixels, &count).good());
  EXPECT_EQ(std::vector<float>(pixels, pixels + count), values);
  EXPECT_EQ(ValueOf(file, DCM_RealWorldValueSlope), "1");
  EXPECT_EQ(ValueOf(file, DCM_NumberOfFrames), "6");
  EXPECT_EQ(ValueOf(file, DCM_ReferencedSOPInstanceUID), source.series.slices.front().sopInstanceUID);
  image->SetOrigin(itk::Point<double, 3>(0.0));
  EXPECT_TRUE(Refuses([&] { WriteDicomMap(source, image, meaning, HeaderOfTest(), folder + "/other.dcm"); },
                      "is not on the grid of the series"));
}
