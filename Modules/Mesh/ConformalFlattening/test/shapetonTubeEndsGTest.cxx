#include "shapetonTubeEnds.h"

#include "shapetonTestSurfaces.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
Tube()
{
  return Cylinder(10, 8, 20.0, 90.0);
}

std::string
ErrorOf(const shapeton::SurfaceMesh & mesh)
{
  return basetest::ErrorOf([&] { shapeton::PrepareTube(mesh, "the surface"); });
}

/** The mean height of the first end. */
double
HeightOfFirst(const shapeton::SurfaceMesh & mesh)
{
  const shapeton::TubeEnds ends = shapeton::FindTubeEnds(mesh, shapeton::SurfaceConnectivity(mesh), "it");
  double                   sum = 0.0;
  for (const int v : ends.first)
  {
    sum += mesh.V(v, 2) / static_cast<double>(ends.first.size());
  }
  return sum;
}

shapeton::SurfaceMesh
WithRectum(shapeton::SurfaceMesh mesh, int vertex)
{
  shapeton::SurfaceArray array{ "rectumLoop", shapeton::SurfaceArray::ValueMatrix::Constant(1, 1, vertex), true };
  mesh.fieldArrays.push_back(array);
  return mesh;
}
} // namespace

TEST(TubeEnds, RectumComesFirstWhereItIsKnown)
{
  const shapeton::SurfaceMesh mesh = Tube();
  EXPECT_NEAR(0.0, HeightOfFirst(mesh), 1e-12);
  EXPECT_NEAR(0.0, HeightOfFirst(WithRectum(mesh, 3)), 1e-12);
  const int last = mesh.NumberOfVertices() - 1;
  EXPECT_NEAR(90.0, HeightOfFirst(WithRectum(mesh, last)), 1e-12);
  const auto ends = [](const shapeton::SurfaceMesh & surface) {
    return shapeton::FindTubeEnds(surface, shapeton::SurfaceConnectivity(surface), "it");
  };
  EXPECT_FALSE(ends(mesh).isRectumKnown);
  EXPECT_TRUE(ends(WithRectum(mesh, last)).isRectumKnown);
  EXPECT_FALSE(ends(WithRectum(mesh, 45)).isRectumKnown); // not on a boundary
  EXPECT_EQ(20U, ends(mesh).Vertices().size());
}

TEST(TubeEnds, OtherSurfacesAreRefusedWithWhatTheyNeed)
{
  EXPECT_NE(std::string::npos, ErrorOf(Icosphere(1, 30.0)).find("has no boundary"));
  EXPECT_NE(std::string::npos, ErrorOf(Square(4, 30.0)).find("the parameter \"domain\" = rectangle"));
  const std::string three = ErrorOf(FacesWhere(Tube(), [](int face) { return face != 62; }));
  // Two ends of ten edges, and the hole of face 62 with sides of 11.25 mm, 12.36 mm and the diagonal.
  EXPECT_NE(std::string::npos, three.find("has 3 boundaries of 124 mm (10 edges around ")) << three;
  EXPECT_NE(std::string::npos, three.find("40.3 mm (3 edges around 9.51, 16.6, 37.5)")) << three;
  EXPECT_NE(std::string::npos, three.find("the parameter \"domain\" = slit"));
  EXPECT_NE(std::string::npos, ErrorOf(MoebiusStrip(20, 4)).find("is one-sided (not orientable)"));
  shapeton::SurfaceMesh beside = Tube();
  beside.V.array() += 500.0;
  EXPECT_NE(std::string::npos, ErrorOf(Together({ Tube(), beside })).find("has 2 components after cutting"));
  shapeton::SurfaceMesh broken = Tube();
  broken.V(7, 1) = std::nan("");
  EXPECT_NE(std::string::npos, ErrorOf(broken).find("vertex 7 has a coordinate that is not finite"));
}

TEST(TubeEnds, SoundTubesStayAsTheyAreAndInvertedOnesAreTurned)
{
  const shapeton::SurfaceMesh  mesh = WithRectum(Tube(), 4);
  const shapeton::PreparedTube same = shapeton::PrepareTube(mesh, "it");
  EXPECT_TRUE(same.warnings.empty());
  EXPECT_EQ(mesh.F, same.mesh.F);
  EXPECT_EQ(mesh.V, same.mesh.V);
  shapeton::SurfaceMesh inverted = mesh;
  inverted.F.col(1).swap(inverted.F.col(2));
  const shapeton::PreparedTube tube = shapeton::PrepareTube(inverted, "it");
  EXPECT_EQ(mesh.F, tube.mesh.F);
  ASSERT_EQ(1U, tube.warnings.size());
  EXPECT_NE(std::string::npos, tube.warnings[0].find("pointed inward"));
}

TEST(TubeEnds, DefectsAreRepairedWithAWarning)
{
  const shapeton::SurfaceMesh mesh = WithRectum(Tube(), Tube().NumberOfVertices() - 1);
  shapeton::SurfaceMesh       bad = mesh;
  // A leading unreferenced vertex, a flipped face, a degenerate face and a duplicate face.
  bad.V.resize(mesh.V.rows() + 1, 3);
  bad.V.row(0) << 1.0, 2.0, 3.0;
  bad.V.bottomRows(mesh.V.rows()) = mesh.V;
  bad.F.resize(mesh.F.rows() + 2, 3);
  bad.F.topRows(mesh.F.rows()) = mesh.F.array() + 1;
  bad.F.row(mesh.F.rows()) = bad.F.row(3);
  bad.F.row(mesh.F.rows() + 1) << 5, 5, 6;
  std::swap(bad.F(30, 0), bad.F(30, 1));
  bad.fieldArrays[0].values(0, 0) += 1;
  const shapeton::PreparedTube tube = shapeton::PrepareTube(bad, "it");
  EXPECT_GE(tube.warnings.size(), 3U);
  EXPECT_EQ(mesh.V, tube.mesh.V);
  EXPECT_EQ(mesh.NumberOfFaces(), tube.mesh.NumberOfFaces());
  EXPECT_NEAR(90.0, HeightOfFirst(tube.mesh), 1e-12);
}

TEST(TubeEnds, SeamsOfEqualPositionsAreClosed)
{
  const shapeton::SurfaceMesh  strip = Grid(10, 8, Wrap::None, [](double s, double t) {
    const double turn = s == 1.0 ? 0.0 : 2.0 * Pi * s;
    return Eigen::Vector3d(20.0 * std::cos(turn), 20.0 * std::sin(turn), 90.0 * t);
  });
  const shapeton::PreparedTube tube = shapeton::PrepareTube(strip, "it");
  EXPECT_EQ(Tube().NumberOfVertices(), tube.mesh.NumberOfVertices());
  EXPECT_FALSE(tube.warnings.empty());
}

// A seam from one end to the center; the surface has two boundaries with or without it.
TEST(TubeEnds, ASeamThatEndsInsideIsClosed)
{
  const shapeton::SurfaceMesh whole = Tube();
  const int                   first = whole.F(0, 0);
  shapeton::SurfaceMesh       torn = whole; // the faces on one side of the line of vertices above `first`
  const int                   rows = 4;
  const int                   copies = static_cast<int>(torn.V.rows());
  torn.V.conservativeResize(copies + rows, Eigen::NoChange);
  for (int row = 0; row < rows; ++row)
  {
    const int vertex = first + 10 * row;
    torn.V.row(copies + row) = whole.V.row(vertex);
    for (int f = 0; f < torn.NumberOfFaces(); ++f)
    {
      const bool isBeyond = (whole.V(whole.F(f, 0), 1) + whole.V(whole.F(f, 1), 1) + whole.V(whole.F(f, 2), 1)) > 0.0;
      for (int k = 0; k < 3 && isBeyond; ++k)
      {
        torn.F(f, k) = whole.F(f, k) == vertex ? copies + row : torn.F(f, k);
      }
    }
  }
  ASSERT_EQ(2U, shapeton::SurfaceConnectivity(torn).BoundaryLoops().size());
  const shapeton::PreparedTube tube = shapeton::PrepareTube(torn, "it");
  EXPECT_EQ(whole.V, tube.mesh.V);
  EXPECT_EQ(whole.F, tube.mesh.F);
}

TEST(TubeEnds, LoopArraysFollowTheirVertices)
{
  const shapeton::SurfaceMesh before = WithRectum(Tube(), 12);
  shapeton::SurfaceMesh       after = before;
  after.V = before.V.colwise().reverse();
  shapeton::RenumberLoopArrays(before, after);
  EXPECT_EQ(before.NumberOfVertices() - 1 - 12, after.fieldArrays.at(0).values(0, 0));
  shapeton::SurfaceMesh elsewhere = before;
  elsewhere.V.array() += 1.0;
  shapeton::RenumberLoopArrays(before, elsewhere);
  EXPECT_TRUE(elsewhere.fieldArrays.empty());
}
