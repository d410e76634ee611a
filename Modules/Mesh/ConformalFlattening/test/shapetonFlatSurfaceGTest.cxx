#include "shapetonFlatSurface.h"

#include "shapetonTestSurfaces.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
FlatSquare()
{
  shapeton::SurfaceMesh mesh = Square(4, 8.0);
  mesh.cellArrays.push_back(
    { "bridged", shapeton::SurfaceArray::ValueMatrix::Constant(mesh.NumberOfFaces(), 1, 1.0), true });
  mesh.fieldArrays.push_back({ "rectumLoop", shapeton::SurfaceArray::ValueMatrix::Zero(3, 1), true });
  shapeton::CutSurface   cut = shapeton::CutAlongPaths(mesh, shapeton::SurfaceConnectivity(mesh), { { 11, 12, 13 } });
  const Eigen::MatrixX2d uv = cut.mesh.V.leftCols<2>();
  return shapeton::MakeFlatSurface(std::move(cut), uv);
}
} // namespace

TEST(FlatSurface, HasWhatItWasGiven)
{
  shapeton::SurfaceMesh flat = FlatSquare();
  shapeton::SetFlatExtent(flat, 120.0, 1500.0);
  shapeton::SetFlatExtent(flat, 130.0, 1600.0);
  EXPECT_DOUBLE_EQ(130.0, shapeton::FlatCircumference(flat, "the surface"));
  EXPECT_DOUBLE_EQ(1600.0, shapeton::FlatLength(flat, "the surface"));
  EXPECT_EQ(Eigen::MatrixX2d(flat.V.leftCols<2>()), shapeton::FlatCoordinates(flat, "the surface"));
  const std::vector<int> source = shapeton::FlatSourcePoints(flat, "the surface");
  EXPECT_EQ(12, source.back());
  EXPECT_EQ(25U + 1U, source.size());
  EXPECT_NE(nullptr, shapeton::FindSurfaceArray(flat.cellArrays, "bridged"));
  EXPECT_NE(nullptr, shapeton::FindSurfaceArray(flat.fieldArrays, "rectumLoop"));
  EXPECT_EQ(3U, flat.fieldArrays.size());
  EXPECT_NO_THROW(shapeton::RequireSound(flat, "flat"));
}

TEST(FlatSurface, FlatSurfacesCanBeFlattenedAgain)
{
  shapeton::SurfaceMesh flat = FlatSquare();
  shapeton::SetFlatExtent(flat, 120.0, 1500.0);
  shapeton::CutSurface        cut = shapeton::CutAlongPaths(flat, shapeton::SurfaceConnectivity(flat), {});
  const shapeton::SurfaceMesh again =
    shapeton::MakeFlatSurface(std::move(cut), Eigen::MatrixX2d::Zero(flat.V.rows(), 2));
  EXPECT_EQ(flat.pointArrays.size(), again.pointArrays.size());
  EXPECT_THROW(shapeton::FlatCircumference(again, "it"), shapeton::InputError);
  EXPECT_EQ(0.0, shapeton::FlatCoordinates(again, "it").norm());
}

TEST(FlatSurface, MissingOrBrokenArraysAreNamed)
{
  const shapeton::SurfaceMesh plain = Square(4, 8.0);
  const auto errorOf = [](const auto & body) -> std::string { return basetest::ErrorOf([&] { body(); }); };
  EXPECT_NE(std::string::npos,
            errorOf([&] { shapeton::FlatCoordinates(plain, "a.vtp"); }).find("a.vtp is not a flat surface"));
  EXPECT_NE(std::string::npos, errorOf([&] { shapeton::FlatSourcePoints(plain, "a.vtp"); }).find("sourcePointId"));
  EXPECT_NE(std::string::npos, errorOf([&] { shapeton::FlatCircumference(plain, "a.vtp"); }).find("\"circumference\""));
  shapeton::SurfaceMesh flat = FlatSquare();
  shapeton::SetFlatExtent(flat, 0.0, 1.0);
  EXPECT_NE(std::string::npos, errorOf([&] { shapeton::FlatCircumference(flat, "a.vtp"); }).find("not positive"));
  shapeton::CutSurface cut = shapeton::CutAlongPaths(plain, shapeton::SurfaceConnectivity(plain), {});
  EXPECT_THROW(shapeton::MakeFlatSurface(cut, Eigen::MatrixX2d::Zero(3, 2)), shapeton::InputError);
  EXPECT_THROW(shapeton::MakeFlatSurface(cut, Eigen::MatrixX2d::Constant(plain.V.rows(), 2, std::nan(""))),
               shapeton::InputError);
}

TEST(FlatSurface, NumbersThatAreNotPointsAreNamed)
{
  for (const double wrong : { -4000000.0, 2e9 + 1e9, 0.5, std::nan("") })
  {
    shapeton::SurfaceMesh flat = FlatSquare();
    for (shapeton::SurfaceArray & array : flat.pointArrays)
    {
      if (array.name == "sourcePointId")
      {
        array.values(3, 0) = wrong;
      }
    }
    const std::string error = basetest::ErrorOf([&] { shapeton::FlatSourcePoints(flat, "a.vtp"); });
    EXPECT_NE(std::string::npos, error.find("a.vtp: its point array sourcePointId contains")) << wrong << ": " << error;
  }
}
