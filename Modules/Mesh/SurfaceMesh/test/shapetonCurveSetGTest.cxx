#include "shapetonCurveSet.h"
#include "shapetonSurfaceTestFiles.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestSurfaces.h"
#include "shapetonTestErrors.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "gtest/gtest.h"

namespace
{
using namespace testsurfaces;

/** A line with three vertices, a point, and a line with two vertices. */
shapeton::CurveSet
MakeCurves()
{
  shapeton::CurveSet curves;
  curves.V.resize(5, 3);
  curves.V << 0, 0, 0, 1.5, 0, 0.1, 2, 1, 0, 7, 7, 7, -3, 1e-3, 5;
  curves.curves = { { 0, 1, 2 }, { 3 }, { 4, 0 } };
  curves.pointArrays.push_back({ "radius", Eigen::VectorXd(curves.V.col(0)), false });
  curves.cellArrays.push_back({ "id", Eigen::Vector3d(10, 20, 30), true });
  curves.facts = { { "tool", "test" } };
  return curves;
}

std::string
FaultOfCurves(const shapeton::CurveSet & curves)
{
  return basetest::ErrorOf([&] { shapeton::RequireSound(curves, "it"); });
}

TEST(CurveSet, AFileKeepsAllOfItWithPointsFirstForVtkToo)
{
  const Folder folder;
  shapeton::WriteCurves(MakeCurves(), folder / "a.vtp");
  const shapeton::CurveSet read = shapeton::ReadCurves(folder / "a.vtp");
  EXPECT_EQ(read.V, MakeCurves().V);
  EXPECT_EQ(read.curves, (std::vector<std::vector<int>>{ { 3 }, { 0, 1, 2 }, { 4, 0 } }));
  EXPECT_EQ(shapeton::PointValues(read, "radius", "it"), MakeCurves().V.col(0));
  ASSERT_EQ(read.cellArrays.size(), 1u);
  EXPECT_EQ(read.cellArrays[0].values, Eigen::Vector3d(20, 10, 30));
  EXPECT_TRUE(read.cellArrays[0].areIntegers);
  EXPECT_EQ(read.facts, MakeCurves().facts);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "a.vtp").c_str());
  reader->Update();
  vtkPolyData * const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfVerts(), 1);
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  EXPECT_EQ(data->GetCell(1)->GetNumberOfPoints(), 3);
  EXPECT_EQ(data->GetCell(1)->GetPointId(2), 2);
  EXPECT_EQ(data->GetCellData()->GetArray("id")->GetTuple1(1), 10);
}

TEST(CurveSet, FacesAreNoCurvesAndCurvesNoFaces)
{
  const Folder folder;
  shapeton::WriteSurface(Octahedron(), folder / "surface.vtp");
  EXPECT_TRUE(shapeton::ReadCurves(folder / "surface.vtp").curves.empty());
  shapeton::WriteCurves(MakeCurves(), folder / "curves.vtp");
  EXPECT_THROW(shapeton::ReadSurfaceFile(folder / "curves.vtp"), shapeton::InputError);
}

TEST(CurveSet, CurvesAndTheirSurfaceAreReadApart)
{
  const Folder       folder;
  shapeton::CurveSet curves = MakeCurves();
  curves.cellArrays[0].values.resize(4, 1);
  curves.cellArrays[0].values << 10, 20, 30, 40;
  shapeton::FaceMatrix face(1, 3);
  face << 0, 1, 4;
  shapeton::WriteCurvesOnSurface(curves, face, folder / "both.vtp");
  const shapeton::CurveSet read = shapeton::ReadCurves(folder / "both.vtp");
  EXPECT_EQ(read.curves, (std::vector<std::vector<int>>{ { 3 }, { 0, 1, 2 }, { 4, 0 } }));
  EXPECT_EQ(read.cellArrays[0].values, Eigen::Vector3d(20, 10, 30));
  const shapeton::SurfaceMesh surface = shapeton::ReadSurfaceFile(folder / "both.vtp").mesh;
  EXPECT_EQ(surface.F, face);
  EXPECT_EQ(surface.cellArrays.at(0).values(0, 0), 40);
  EXPECT_THROW(shapeton::WriteCurvesOnSurface(MakeCurves(), face, folder / "x.vtp"), shapeton::InputError);
  face(0, 2) = 5;
  EXPECT_THROW(shapeton::WriteCurvesOnSurface(curves, face, folder / "x.vtp"), shapeton::InputError);
  EXPECT_THROW(shapeton::WriteCurvesOnSurface(curves, face, folder / "x.stl"), shapeton::ParameterError);
}

TEST(CurveSet, NoCurvesAreWrittenAndRead)
{
  const Folder       folder;
  shapeton::CurveSet curves;
  curves.cellArrays = { { "id", shapeton::SurfaceArray::ValueMatrix(0, 2), true } };
  shapeton::WriteCurves(curves, folder / "none.vtp");
  const shapeton::CurveSet read = shapeton::ReadCurves(folder / "none.vtp");
  EXPECT_EQ(read.V.rows(), 0);
  EXPECT_TRUE(read.curves.empty());
  EXPECT_EQ(shapeton::FindSurfaceArray(read.cellArrays, "id")->values.cols(), 2);
}

TEST(CurveSet, FaultsAreNamed)
{
  EXPECT_EQ(FaultOfCurves(MakeCurves()), "");
  EXPECT_NE(FaultOfCurves({}).find("no points"), std::string::npos);
  shapeton::CurveSet curves = MakeCurves();
  curves.curves[2].clear();
  EXPECT_NE(FaultOfCurves(curves).find("curve 2 has no vertices"), std::string::npos);
  curves.curves[2] = { 0, 5 };
  EXPECT_NE(FaultOfCurves(curves).find("refers to vertex 5, but there are 5"), std::string::npos);
  curves = MakeCurves();
  curves.V(1, 1) = std::nan("");
  EXPECT_NE(FaultOfCurves(curves).find("vertex 1"), std::string::npos);
  curves = MakeCurves();
  curves.cellArrays[0].values.resize(2, 1);
  EXPECT_NE(FaultOfCurves(curves).find("\"id\" has 2 rows for 3"), std::string::npos);
  EXPECT_THROW(shapeton::PointValues(MakeCurves(), "arcLength", "it"), shapeton::InputError);
  EXPECT_THROW(shapeton::WriteCurves(MakeCurves(), "curves.stl"), shapeton::ParameterError);
  EXPECT_THROW(shapeton::ReadCurves("curves.stl"), shapeton::InputError);
}
} // namespace
