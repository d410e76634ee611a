#include "shapetonPolyDataAdapter.h"
#include "shapetonMeshArrays.h"
#include "shapetonExceptions.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace shapeton;

namespace
{
/** A tetrahedron with an array of each kind. */
SurfaceMesh
Tetrahedron()
{
  SurfaceMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0.1, 0, 0, 1, 0, 0, 0, 1.7, 0, 0, 0, 1;
  mesh.F.resize(4, 3);
  mesh.F << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
  mesh.pointArrays = { { "uv", Eigen::MatrixXd::Random(4, 2) }, { "source", Eigen::Vector4d(3, 2, 1, 0), true } };
  mesh.cellArrays = { { "segment", Eigen::Vector4d(6, 5, 4, 1), true } };
  mesh.fieldArrays = { { "rectumLoop", Eigen::Vector3d(2, 0, 1), true } };
  mesh.facts = { { "tool", "ColonSegmentation" } };
  return mesh;
}
} // namespace

TEST(PolyDataAdapter, ASurfaceComesBackWithAllThatIsOnIt)
{
  const SurfaceMesh mesh = Tetrahedron();
  for (const PatientSpace space : { PatientSpace::LPS, PatientSpace::RAS })
  {
    const SurfaceMesh back = SurfaceOf(*PolyDataOf(mesh, space));
    EXPECT_EQ(back.V, mesh.V);
    EXPECT_EQ(back.F, mesh.F);
    EXPECT_EQ(back.pointArrays, mesh.pointArrays);
    EXPECT_EQ(back.cellArrays, mesh.cellArrays);
    EXPECT_EQ(back.fieldArrays, mesh.fieldArrays);
    EXPECT_EQ(back.facts, mesh.facts);
  }
}

TEST(PolyDataAdapter, RasTurnsPlacesAndKeepsTheOutside)
{
  const SurfaceMesh mesh = Tetrahedron();
  const auto        data = PolyDataOf(mesh, PatientSpace::RAS);
  double            place[3];
  data->GetPoint(2, place);
  EXPECT_EQ(place[0], 0.0);
  EXPECT_EQ(place[1], -1.7);
  EXPECT_EQ(place[2], 0.0);
  EXPECT_EQ(SpaceOf(*data->GetFieldData(), PatientSpace::LPS), PatientSpace::RAS);
  // A half turn, unlike a reflection, preserves the sign of the enclosed volume.
  double volume = 0.0;
  for (int f = 0; f < 4; ++f)
  {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
    {
      data->GetPoint(mesh.F(f, k), corners.col(k).data());
    }
    volume += corners.determinant() / 6.0;
  }
  EXPECT_NEAR(volume, 0.9 * 1.7 / 6.0, 1e-12);
}

TEST(PolyDataAdapter, PolygonsAreCutAndKeepTheirValues)
{
  vtkNew<vtkPoints> points;
  for (const auto & p : { Eigen::Vector3d(0, 0, 0),
                          Eigen::Vector3d(2, 0, 0),
                          Eigen::Vector3d(2, 2, 0),
                          Eigen::Vector3d(0, 2, 0),
                          Eigen::Vector3d(4, 1, 0) })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  lines->InsertNextCell({ 0, 4 });
  polys->InsertNextCell({ 0, 1, 2, 3 });
  polys->InsertNextCell({ 1, 4, 2 });
  vtkNew<vtkIntArray> labels;
  labels->SetName("label");
  for (const int label : { 9, 5, 6 }) // the cell of the line comes first
  {
    labels->InsertNextValue(label);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(polys);
  data->GetCellData()->AddArray(labels);

  const SurfaceMesh mesh = SurfaceOf(*data);
  ASSERT_EQ(mesh.NumberOfFaces(), 3);
  ASSERT_EQ(mesh.cellArrays.size(), 1U);
  EXPECT_EQ(mesh.cellArrays[0].values, Eigen::Vector3d(5, 5, 6));
  EXPECT_TRUE(mesh.cellArrays[0].areIntegers);
  const CurveSet curves = CurvesOf(*data);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0], (std::vector<int>{ 0, 4 }));
  EXPECT_EQ(curves.cellArrays[0].values(0, 0), 9.0);
}

TEST(PolyDataAdapter, CurvesComeBack)
{
  CurveSet curves;
  curves.V.resize(4, 3);
  curves.V << 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 10;
  curves.curves = { { 3 }, { 0, 1, 2 } };
  curves.pointArrays = { { "arcLength", Eigen::Vector4d(0, 1, 2, 5) } };
  curves.cellArrays = { { "taenia", Eigen::Vector2d(1, 2), true } };
  for (const PatientSpace space : { PatientSpace::LPS, PatientSpace::RAS })
  {
    const CurveSet back = CurvesOf(*PolyDataOf(curves, space));
    EXPECT_EQ(back.V, curves.V);
    EXPECT_EQ(back.curves, curves.curves);
    EXPECT_EQ(back.pointArrays, curves.pointArrays);
    EXPECT_EQ(back.cellArrays, curves.cellArrays);
  }
}

TEST(PolyDataAdapter, LooseVerticesAreACurveEach)
{
  CurveSet curves;
  curves.V = Eigen::MatrixXd::Random(4, 3);
  curves.curves = { { 0, 1, 2 } };
  const auto           data = PolyDataOf(curves);
  vtkIdType            loose[] = { 3, 1 };
  vtkNew<vtkCellArray> verts;
  data->SetVerts(verts);
  data->GetVerts()->InsertNextCell(2, loose); // before the line, as VTK counts cells
  vtkNew<vtkIntArray> labels;
  labels->SetName("label");
  labels->InsertNextValue(8);
  labels->InsertNextValue(9);
  data->GetCellData()->AddArray(labels);
  const CurveSet back = CurvesOf(*data);
  EXPECT_EQ(back.curves, (std::vector<std::vector<int>>{ { 3 }, { 1 }, { 0, 1, 2 } }));
  EXPECT_EQ(back.cellArrays.at(0).values, Eigen::Vector3d(8, 8, 9));
}

TEST(PolyDataAdapter, NumbersBeyond32BitsStayWhatTheyAre)
{
  const auto             data = PolyDataOf(Tetrahedron());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("id");
  for (const vtkIdType id : { 0LL, 5000000000LL, -1LL, 4278190080LL })
  {
    ids->InsertNextValue(id);
  }
  data->GetPointData()->AddArray(ids);
  const auto back = PolyDataOf(SurfaceOf(*data));
  EXPECT_EQ(back->GetPointData()->GetArray("id")->GetComponent(1, 0), 5e9);
  EXPECT_EQ(back->GetPointData()->GetArray("id")->GetComponent(3, 0), 4278190080.0);
}

TEST(PolyDataAdapter, WhatHoldsNoSurfaceIsRefused)
{
  vtkNew<vtkPolyData> empty;
  EXPECT_THROW(SurfaceOf(*empty), InputError);
  EXPECT_THROW(CurvesOf(*empty), InputError);
  const auto             data = PolyDataOf(Tetrahedron());
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LAS");
  data->GetFieldData()->AddArray(space);
  EXPECT_THROW(SurfaceOf(*data), InputError);
}
