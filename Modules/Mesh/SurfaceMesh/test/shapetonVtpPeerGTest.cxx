#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceTestFiles.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestSurfaces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "gtest/gtest.h"

// VTK's VTP reader and writer, which 3D Slicer uses, as reference implementations.
namespace
{
using namespace testsurfaces;

/** Two vertices, a line, a triangle, a quadrilateral; arrays on points and cells, field data. */
vtkSmartPointer<vtkPolyData>
MakePolyData()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (const auto & p : { Eigen::Vector3d(0, 0, 0),
                          Eigen::Vector3d(7, 0, 0),
                          Eigen::Vector3d(7, 7, 0.5),
                          Eigen::Vector3d(0, 7, 0),
                          Eigen::Vector3d(0, 0, 9) })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  verts->InsertNextCell({ 4 });
  lines->InsertNextCell({ 0, 4 });
  polys->InsertNextCell({ 0, 1, 4 });
  polys->InsertNextCell({ 0, 1, 2, 3 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(verts);
  data->SetLines(lines);
  data->SetPolys(polys);
  vtkNew<vtkFloatArray> heat;
  heat->SetName("heat & more");
  vtkNew<vtkIntArray> label;
  label->SetName("label");
  for (int i = 0; i < 5; ++i)
  {
    heat->InsertNextValue(0.25f * static_cast<float>(i));
  }
  for (int i = 0; i < 4; ++i)
  {
    label->InsertNextValue(10 * i - 5);
  }
  vtkNew<vtkStringArray> note;
  note->SetName("note");
  note->InsertNextValue("made by VTK");
  data->GetPointData()->AddArray(heat);
  data->GetCellData()->AddArray(label);
  data->GetFieldData()->AddArray(note);
  return data;
}

/** Writes with this data mode, header type, encoding of appended data and compressor. */
void
ExpectThatWeRead(int data, int header, bool isEncoded, vtkXMLWriterBase::CompressorType compressor)
{
  SCOPED_TRACE(testing::Message() << "data mode " << data << ", header type " << header
                                  << (isEncoded ? ", encoded" : ", raw") << ", compressor " << compressor);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(MakePolyData());
  writer->SetDataMode(data);
  writer->SetHeaderType(header);
  writer->SetEncodeAppendedData(isEncoded);
  writer->SetCompressorType(compressor);
  writer->WriteToOutputStringOn();
  ASSERT_EQ(writer->Write(), 1);
  const shapeton::SurfaceFile   file = ReadBytes("vtp", writer->GetOutputString());
  const shapeton::SurfaceMesh & mesh = file.mesh;
  ASSERT_EQ(mesh.NumberOfVertices(), 5);
  EXPECT_EQ(mesh.V.row(2), Eigen::RowVector3d(7, 7, 0.5));
  ASSERT_EQ(mesh.NumberOfFaces(), 3);
  EXPECT_EQ(mesh.F.row(0), Eigen::RowVector3i(0, 1, 4));
  ASSERT_EQ(mesh.pointArrays.size(), 1u);
  EXPECT_EQ(mesh.pointArrays[0].name, "heat & more");
  EXPECT_EQ(mesh.pointArrays[0].values(3, 0), 0.75);
  EXPECT_FALSE(mesh.pointArrays[0].areIntegers);
  ASSERT_EQ(mesh.cellArrays.size(), 1u);
  EXPECT_EQ(mesh.cellArrays[0].values, Eigen::Vector3d(15, 25, 25)); // the quadrilateral was cut
  EXPECT_TRUE(mesh.cellArrays[0].areIntegers);
  ASSERT_EQ(mesh.facts.size(), 1u);
  EXPECT_EQ(mesh.facts[0].second, "made by VTK");
  EXPECT_EQ(file.notes.front(), "2 points and lines were skipped");
}

TEST(VtpPeer, WeReadWhatVtkWrites)
{
  using Writer = vtkXMLWriterBase;
  ExpectThatWeRead(Writer::Ascii, Writer::UInt32, true, Writer::NONE);
  ExpectThatWeRead(Writer::Binary, Writer::UInt32, true, Writer::NONE);
  ExpectThatWeRead(Writer::Binary, Writer::UInt64, true, Writer::ZLIB);
  ExpectThatWeRead(Writer::Binary, Writer::UInt32, true, Writer::LZ4);
  ExpectThatWeRead(Writer::Appended, Writer::UInt32, true, Writer::NONE);
  ExpectThatWeRead(Writer::Appended, Writer::UInt64, false, Writer::NONE);
  ExpectThatWeRead(Writer::Appended, Writer::UInt32, false, Writer::ZLIB);
  ExpectThatWeRead(Writer::Appended, Writer::UInt64, true, Writer::LZMA);
  ExpectThatWeRead(Writer::Appended, Writer::UInt64, false, Writer::LZ4);
}

TEST(VtpPeer, BlocksAreJoined)
{
  const Folder folder;
  shapeton::WriteSurface(Icosphere(5, 100.0), folder / "a.vtp"); // more than one block of 32 KiB
  EXPECT_EQ(shapeton::ReadSurfaceFile(folder / "a.vtp").mesh.V, Icosphere(5, 100.0).V);
}

TEST(VtpPeer, VtkReadsWhatWeWrite)
{
  shapeton::SurfaceMesh mesh = Icosphere(2, 10.0);
  mesh.pointArrays.push_back({ "heat", mesh.V.col(1), false });
  mesh.facts = { { "tool", "test" } };
  const Folder folder;
  shapeton::WriteSurface(mesh, folder / "a.vtp");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "a.vtp").c_str());
  reader->Update();
  vtkPolyData * const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), mesh.V.rows());
  ASSERT_EQ(data->GetNumberOfPolys(), mesh.F.rows());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_EQ(Eigen::Map<const Eigen::RowVector3d>(data->GetPoint(v)), mesh.V.row(v));
    EXPECT_EQ(data->GetPointData()->GetArray("heat")->GetTuple1(v), mesh.V(v, 1));
  }
  auto * const space = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SPACE"));
  ASSERT_NE(space, nullptr);
  EXPECT_EQ(space->GetValue(0), "LPS");
}

TEST(VtpPeer, StripsAndSeveralPieces)
{
  const std::string           piece = "<Piece NumberOfPoints='4' NumberOfPolys='0' NumberOfStrips='1'><Points>"
                                      "<DataArray type='Float64' NumberOfComponents='3' format='ascii'>"
                                      "0 0 0 1 0 0 0 1 0 1 1 0</DataArray></Points><Strips>"
                                      "<DataArray type='Int32' Name='connectivity' format='ascii'> 0 1 2 3 </DataArray>"
                                      "<DataArray type='Int32' Name='offsets' format='ascii'>4</DataArray></Strips></Piece>";
  const shapeton::SurfaceMesh mesh =
    ReadBytes("vtp",
              "<?xml version='1.0'?><!-- a > b --><VTKFile type='PolyData'><PolyData>" + piece + piece +
                "</PolyData></VTKFile>")
      .mesh;
  ASSERT_EQ(mesh.NumberOfVertices(), 8);
  ASSERT_EQ(mesh.NumberOfFaces(), 4);
  EXPECT_EQ(mesh.F.row(0), Eigen::RowVector3i(0, 1, 2));
  EXPECT_EQ(mesh.F.row(1), Eigen::RowVector3i(2, 1, 3));
  EXPECT_EQ(mesh.F.row(3), Eigen::RowVector3i(6, 5, 7));
}
} // namespace
