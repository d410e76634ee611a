#include "shapetonMeshAdapter.h"

#include "itkDefaultDynamicMeshTraits.h"
#include "itkQuadEdgeMesh.h"
#include "itkTransformMeshFilter.h"
#include "itkTranslationTransform.h"

#include "itkQuadraticEdgeCell.h"

#include <gtest/gtest.h>

using namespace shapeton;

namespace
{
/** A square of two triangles, or a single one if the second is omitted. */
SurfaceMesh
Square()
{
  SurfaceMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0.1, 0, 0.3, 1, 0, 0, 1, 1, 0, 0, 1, -0.7;
  mesh.F.resize(2, 3);
  mesh.F << 0, 1, 2, 0, 2, 3;
  mesh.pointArrays = { { "uv", (Eigen::MatrixXd(4, 2) << 0, 1, 2, 3, 4, 5, 6, 7).finished() },
                       { "source point", Eigen::Vector4d(9, 8, 7, 6), true } };
  mesh.cellArrays = { { "segment", Eigen::Vector2d(3, 4), true } };
  mesh.fieldArrays = { { "rectumLoop", Eigen::Vector3d(2, 0, 1), true } };
  mesh.facts = { { "version", "0.2" }, { "tool", "none" } };
  return mesh;
}

template <typename TMesh>
class MeshAdapter : public testing::Test
{};
using Meshes = testing::Types<PipelineMesh,
                              itk::Mesh<itk::VariableLengthVector<float>, 3>,
                              itk::QuadEdgeMesh<itk::VariableLengthVector<double>, 3>>;
TYPED_TEST_SUITE(MeshAdapter, Meshes, );
} // namespace

TYPED_TEST(MeshAdapter, ASurfaceComesBackWithAllThatIsOnIt)
{
  const SurfaceMesh surface = Square();
  const auto        mesh = TypeParam::New();
  FillMesh(surface, *mesh);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4U);
  const SurfaceMesh back = SurfaceOf(*mesh);
  EXPECT_TRUE(back.V.isApprox(surface.V, 1e-7)); // coordinates of some meshes are floats
  EXPECT_EQ(back.F.rows(), 2);
  EXPECT_EQ(back.pointArrays, surface.pointArrays);
  EXPECT_EQ(back.cellArrays, surface.cellArrays);
  EXPECT_EQ(back.fieldArrays, surface.fieldArrays);
  EXPECT_EQ(back.facts, surface.facts);
  for (Eigen::Index f = 0; f < 2; ++f) // the same corners in the same cyclic order
  {
    int shift = 0;
    while (shift < 2 && back.F(f, shift) != surface.F(f, 0))
    {
      ++shift;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_EQ(back.F(f, (corner + shift) % 3), surface.F(f, corner));
    }
  }
}

TEST(MeshAdapterOfScalars, ArraysAreEqualWhereNameKindAndValuesAre)
{
  const SurfaceArray array{ "rectumLoop", Eigen::Vector3d(2, 0, 1), true };
  EXPECT_TRUE(array == array);
  EXPECT_FALSE(array == (SurfaceArray{ "loop", array.values, true }));
  EXPECT_FALSE(array == (SurfaceArray{ array.name, array.values, false }));
  EXPECT_FALSE(array == (SurfaceArray{ array.name, array.values.transpose(), true }));
  EXPECT_FALSE(array == (SurfaceArray{ array.name, Eigen::Vector3d(2, 1, 0), true }));
}

TEST(MeshAdapterOfScalars, HoldsTheArrayThatIsNamed)
{
  using ScalarMesh = itk::Mesh<float, 3>;
  const auto mesh = ScalarMesh::New();
  FillMesh(Square(), *mesh, "source point", "segment");
  float value = 0.0F;
  ASSERT_TRUE(mesh->GetPointData(1, &value));
  EXPECT_EQ(value, 8.0F);
  ASSERT_TRUE(mesh->GetCellData(1, &value));
  EXPECT_EQ(value, 4.0F);
  const SurfaceMesh back = SurfaceOf(*mesh);
  ASSERT_EQ(back.pointArrays.size(), 1U);
  EXPECT_EQ(back.pointArrays[0].name, "source point");
  EXPECT_THROW(FillMesh(Square(), *ScalarMesh::New(), "uv"), ParameterError); // two components
  EXPECT_THROW(FillMesh(Square(), *ScalarMesh::New(), "heat"), ParameterError);

  const auto plain = ScalarMesh::New();
  FillMesh(Square(), *plain);
  EXPECT_TRUE(SurfaceOf(*plain).pointArrays.empty());
}

TEST(MeshAdapterOfScalars, ValuesOfOthersHaveNoNames)
{
  using ScalarMesh = itk::Mesh<double, 3>;
  const auto mesh = ScalarMesh::New();
  FillMesh(Square(), *mesh);
  mesh->GetMetaDataDictionary().Clear();
  for (unsigned int i = 0; i < 4; ++i)
  {
    mesh->SetPointData(i, 0.5 * i);
  }
  const SurfaceMesh back = SurfaceOf(*mesh);
  ASSERT_EQ(back.pointArrays.size(), 1U);
  EXPECT_EQ(back.pointArrays[0].name, "pointData");
  EXPECT_EQ(back.pointArrays[0].values, Eigen::Vector4d(0, 0.5, 1, 1.5));
}

TEST(MeshAdapterOfScalars, AFilterOfItkMovesTheSurface)
{
  using Transform = itk::TranslationTransform<double, 3>;
  using DoubleMesh = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double>>;
  const auto input = DoubleMesh::New();
  FillMesh(Square(), *input, "source point");
  const auto transform = Transform::New();
  transform->Translate(Transform::OutputVectorType(2.0));
  const auto filter = itk::TransformMeshFilter<DoubleMesh, DoubleMesh, Transform>::New();
  filter->SetInput(input);
  filter->SetTransform(transform);
  filter->Update();
  const SurfaceMesh moved = SurfaceOf(*filter->GetOutput());
  EXPECT_TRUE(moved.V.isApprox((Square().V.array() + 2.0).matrix(), 1e-15));
  EXPECT_EQ(moved.F, Square().F);
  EXPECT_EQ(moved.pointArrays.at(0).values, Eigen::Vector4d(9, 8, 7, 6));
}

TEST(MeshAdapterOfOthers, GapsInIdentifiersAreClosed)
{
  using Sparse = itk::Mesh<double, 3, itk::DefaultDynamicMeshTraits<double, 3, 3, double>>;
  const auto mesh = Sparse::New();
  for (const unsigned int identifier : { 30, 10, 20 })
  {
    const double      place[] = { 0.1 * identifier, identifier == 20 ? 5.0 : 0.0, 0.0 };
    Sparse::PointType point(place);
    mesh->SetPoint(identifier, point);
    mesh->SetPointData(identifier, identifier);
  }
  Sparse::CellType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TriangleCell<Sparse::CellType>);
  const Sparse::PointIdentifier corners[] = { 20, 30, 10 };
  cell->SetPointIds(corners);
  mesh->SetCell(7, cell);
  mesh->SetCellData(7, 1.5);
  const SurfaceMesh surface = SurfaceOf(*mesh);
  EXPECT_EQ(surface.F, FaceMatrix(Eigen::RowVector3i(1, 2, 0)));
  EXPECT_EQ(surface.pointArrays.at(0).values, Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(surface.cellArrays.at(0).values(0, 0), 1.5);
  EXPECT_EQ(surface.V(1, 1), 5.0);
}

TEST(MeshAdapterOfOthers, WhatIsNoTriangleIsRefused)
{
  const auto empty = PipelineMesh::New();
  EXPECT_THROW(SurfaceOf(*empty), InputError);
  SurfaceMesh thrice = Square();
  thrice.cellArrays.clear();
  thrice.F.resize(3, 3);
  thrice.F << 0, 1, 2, 0, 2, 3, 0, 2, 1; // the edge 0-2 has three faces
  EXPECT_THROW(FillMesh(thrice, *itk::QuadEdgeMesh<double, 3>::New()), InputError);
  const auto filled = PipelineMesh::New();
  EXPECT_NO_THROW(FillMesh(thrice, *filled));
  EXPECT_THROW(FillMesh(thrice, *filled), ParameterError); // it is no longer empty
}

TEST(MeshAdapterOfOthers, LinesOfThreePointsAreNoTrianglesAndPointsMustBeThere)
{
  const auto mesh = PipelineMesh::New();
  FillMesh(Square(), *mesh);
  using Cell = PipelineMesh::CellType;
  const auto add = [&](Cell * made, std::vector<PipelineMesh::PointIdentifier> corners) {
    Cell::CellAutoPointer cell;
    cell.TakeOwnership(made);
    cell->SetPointIds(corners.data());
    mesh->SetCell(mesh->GetNumberOfCells(), cell);
  };
  add(new itk::QuadraticEdgeCell<Cell>, { 0, 1, 2 });
  EXPECT_EQ(SurfaceOf(*mesh).F, Square().F);
  add(new itk::TriangleCell<Cell>, { 0, 1, 99 });
  EXPECT_THROW(SurfaceOf(*mesh), InputError);
}
