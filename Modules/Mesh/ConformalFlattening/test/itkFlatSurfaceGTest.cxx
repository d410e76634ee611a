#include "itkFlatSurface.h"

#include "itkTestSurfaces.h"
#include "itkExceptions.h"

#include <gtest/gtest.h>

namespace
{
using namespace testsurfaces;

itk::SurfaceMesh
FlatSquare()
{
  itk::SurfaceMesh mesh = Square(4, 8.0);
  mesh.cellArrays.push_back(
    { "bridged", itk::SurfaceArray::ValueMatrix::Constant(mesh.NumberOfFaces(), 1, 1.0), true });
  mesh.fieldArrays.push_back({ "rectumLoop", itk::SurfaceArray::ValueMatrix::Zero(3, 1), true });
  itk::CutSurface        cut = itk::CutAlongPaths(mesh, itk::SurfaceConnectivity(mesh), { { 11, 12, 13 } });
  const Eigen::MatrixX2d uv = cut.mesh.V.leftCols<2>();
  return itk::MakeFlatSurface(std::move(cut), uv);
}
} // namespace

TEST(FlatSurface, HasWhatItWasGiven)
{
  itk::SurfaceMesh flat = FlatSquare();
  itk::SetFlatExtent(flat, 120.0, 1500.0);
  itk::SetFlatExtent(flat, 130.0, 1600.0);
  EXPECT_DOUBLE_EQ(130.0, itk::FlatCircumference(flat, "the surface"));
  EXPECT_DOUBLE_EQ(1600.0, itk::FlatLength(flat, "the surface"));
  EXPECT_EQ(Eigen::MatrixX2d(flat.V.leftCols<2>()), itk::FlatCoordinates(flat, "the surface"));
  const std::vector<int> source = itk::FlatSourcePoints(flat, "the surface");
  EXPECT_EQ(12, source.back());
  EXPECT_EQ(25U + 1U, source.size());
  EXPECT_NE(nullptr, itk::FindSurfaceArray(flat.cellArrays, "bridged"));
  EXPECT_NE(nullptr, itk::FindSurfaceArray(flat.fieldArrays, "rectumLoop"));
  EXPECT_EQ(3U, flat.fieldArrays.size());
  EXPECT_NO_THROW(itk::RequireSound(flat, "flat"));
}

TEST(FlatSurface, FlatSurfacesCanBeFlattenedAgain)
{
  itk::SurfaceMesh flat = FlatSquare();
  itk::SetFlatExtent(flat, 120.0, 1500.0);
  itk::CutSurface        cut = itk::CutAlongPaths(flat, itk::SurfaceConnectivity(flat), {});
  const itk::SurfaceMesh again = itk::MakeFlatSurface(std::move(cut), Eigen::MatrixX2d::Zero(flat.V.rows(), 2));
  EXPECT_EQ(flat.pointArrays.size(), again.pointArrays.size());
  EXPECT_THROW(itk::FlatCircumference(again, "it"), itk::InputError);
  EXPECT_EQ(0.0, itk::FlatCoordinates(again, "it").norm());
}

TEST(FlatSurface, MissingOrBrokenArraysAreNamed)
{
  const itk::SurfaceMesh plain = Square(4, 8.0);
  const auto             errorOf = [](const auto & body) -> std::string {
    try
    {
      body();
    }
    catch (const itk::InputError & error)
    {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(std::string::npos, errorOf([&] { itk::FlatCoordinates(plain, "a.vtp"); }).find("a.vtp is no flat surface"));
  EXPECT_NE(std::string::npos, errorOf([&] { itk::FlatSourcePoints(plain, "a.vtp"); }).find("sourcePointId"));
  EXPECT_NE(std::string::npos, errorOf([&] { itk::FlatCircumference(plain, "a.vtp"); }).find("\"circumference\""));
  itk::SurfaceMesh flat = FlatSquare();
  itk::SetFlatExtent(flat, 0.0, 1.0);
  EXPECT_NE(std::string::npos, errorOf([&] { itk::FlatCircumference(flat, "a.vtp"); }).find("not positive"));
  itk::CutSurface cut = itk::CutAlongPaths(plain, itk::SurfaceConnectivity(plain), {});
  EXPECT_THROW(itk::MakeFlatSurface(cut, Eigen::MatrixX2d::Zero(3, 2)), itk::InputError);
  EXPECT_THROW(itk::MakeFlatSurface(cut, Eigen::MatrixX2d::Constant(plain.V.rows(), 2, std::nan(""))), itk::InputError);
}
