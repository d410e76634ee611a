#include "shapetonHandleLoops.h"

#include "shapetonColonTube.h"
#include "shapetonConformalTube.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
using namespace testsurfaces;

/** A tube bent into a U with legs 10 mm apart, joined by a handle near their ends. */
struct BentTube
{
  static constexpr double leg = 80.0;
  static constexpr double bend = 25.0; // radius of its axis, mm

  BentTube()
  {
    shapeton::SurfaceMesh straight = Cylinder(40, 80, 20.0, 2.0 * leg + Pi * bend);
    straight.V.leftCols(2) *= -1.0; // the first vertex is away from the other leg
    mesh = straight;
    along = straight.V.col(2);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
    {
      mesh.V.row(v) = Bent(straight.V.row(v).transpose()).transpose();
    }
    std::vector<std::array<int, 3>> faces;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
    {
      faces.push_back({ mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2) });
    }
    colontube::JoinFaces(faces, this->Innermost(true), this->Innermost(false));
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
    {
      mesh.F.row(f) << faces[f][0], faces[f][1], faces[f][2];
    }
  }

  static Eigen::Vector3d
  Bent(const Eigen::Vector3d & p)
  {
    const double angle = std::clamp((p.z() - leg) / bend, 0.0, Pi);
    const double beyond = p.z() - leg - angle * bend;
    return { -(bend - p.x()) * std::cos(angle),
             p.y(),
             leg + (bend - p.x()) * std::sin(angle) + (angle > 0.0 ? -beyond : beyond) };
  }

  /** The face on this leg next to a point between the legs. */
  int
  Innermost(bool isFirstLeg) const
  {
    int    best = -1;
    double least = 1e9;
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      const Eigen::RowVector3d center =
        (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3.0;
      const double distance = (center - Eigen::RowVector3d(0.0, 0.0, 15.0)).norm();
      if ((center.x() < 0.0) == isFirstLeg && distance < least)
      {
        least = distance;
        best = f;
      }
    }
    return best;
  }

  shapeton::SurfaceMesh mesh;
  Eigen::VectorXd       along; ///< of each vertex, mm
};

/** Number of components after all faces at the vertices of the loops were removed. */
std::size_t
PartsBeside(const shapeton::SurfaceMesh & mesh, const std::vector<shapeton::HandleLoop> & loops)
{
  std::set<int> vertices;
  for (const shapeton::HandleLoop & loop : loops)
  {
    vertices.insert(loop.vertices.begin(), loop.vertices.end());
  }
  const auto isApart = [&](int f) {
    return vertices.count(mesh.F(f, 0)) + vertices.count(mesh.F(f, 1)) + vertices.count(mesh.F(f, 2)) == 0;
  };
  return shapeton::SurfaceConnectivity(FacesWhere(mesh, isApart)).Components().size();
}
} // namespace

TEST(HandleLoops, ShortestLoopOfATorusIsItsMeridian)
{
  // The shortest loop is a 12-sided polygon around the tube, at any place; the other kind of loop is at least 2 pi 16
  // long.
  const shapeton::SurfaceMesh         torus = Torus(60, 12, 20.0, 4.0);
  const shapeton::SurfaceConnectivity connectivity(torus);
  const auto                          loops = shapeton::FindHandleLoops(torus, connectivity);
  ASSERT_EQ(1U, loops.size());
  EXPECT_NEAR(12 * 2.0 * 4.0 * std::sin(Pi / 12), loops[0].length, 1e-9);
  EXPECT_EQ(12U, loops[0].vertices.size());
  EXPECT_EQ(1U, PartsBeside(torus, loops));
  // A fat torus with a small hole: the shortest loop passes through the hole, around it on the inside.
  const shapeton::SurfaceMesh fat = Torus(24, 48, 12.0, 10.0);
  const auto                  inside = shapeton::FindHandleLoops(fat, shapeton::SurfaceConnectivity(fat));
  ASSERT_EQ(1U, inside.size());
  const double least = 24 * 2.0 * 2.0 * std::sin(Pi / 24);
  EXPECT_GT(inside[0].length, least - 1e-9);
  EXPECT_LT(inside[0].length, 1.2 * least); // a local minimum: the way to a shorter parallel and back is longer
  EXPECT_EQ(24U, inside[0].vertices.size());
}

TEST(HandleLoops, ClosedSurfacesBecomeSpheres)
{
  for (const auto & torus : { Torus(60, 12, 20.0, 4.0), Torus(24, 48, 12.0, 10.0) })
  {
    const shapeton::HandleCuts          cuts = shapeton::CutHandles(torus);
    const shapeton::SurfaceConnectivity after(cuts.mesh);
    EXPECT_EQ(0, cuts.genus);
    EXPECT_EQ(1U, cuts.handles.size());
    EXPECT_TRUE(after.IsClosed());
    EXPECT_TRUE(after.IsOriented());
    EXPECT_EQ(2, after.Components().front().eulerCharacteristic);
  }
}

TEST(HandleLoops, LoopsAreDisjointAndLeaveTheTubeWhole)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const shapeton::SurfaceMesh         mesh = MakeColonTube({ 12000, 15, seed }).mesh;
    const shapeton::SurfaceConnectivity connectivity(mesh);
    const auto                          loops = shapeton::FindHandleLoops(mesh, connectivity);
    EXPECT_LE(loops.size(), 15U); // some may touch
    EXPECT_GE(loops.size(), 12U);
    std::set<int> vertices;
    std::size_t   number = 0;
    for (const shapeton::HandleLoop & loop : loops)
    {
      vertices.insert(loop.vertices.begin(), loop.vertices.end());
      number += loop.vertices.size();
      EXPECT_EQ(3U, loop.vertices.size()); // the generator joins triangles
      for (const int v : loop.vertices)
      {
        EXPECT_FALSE(connectivity.IsBoundaryVertex(v));
      }
    }
    EXPECT_EQ(number, vertices.size());
    EXPECT_EQ(1U, PartsBeside(mesh, loops));
    EXPECT_TRUE(
      std::is_sorted(loops.begin(), loops.end(), [](const auto & a, const auto & b) { return a.length < b.length; }));
  }
}

TEST(HandleLoops, NoneWithoutHandles)
{
  // The loop around a tube does not belong to a handle: it separates the ends.
  const shapeton::SurfaceMesh mesh = MakeColonTube({ 6000, 0, 1 }).mesh;
  EXPECT_TRUE(shapeton::FindHandleLoops(mesh, shapeton::SurfaceConnectivity(mesh)).empty());
  const shapeton::HandleCuts cuts = shapeton::CutHandles(mesh);
  EXPECT_EQ(mesh.F, cuts.mesh.F);
  EXPECT_EQ(mesh.V, cuts.mesh.V);
}

TEST(HandleLoops, CutsGiveTheTubeBack)
{
  const shapeton::SurfaceMesh         plain = MakeColonTube({ 12000, 0, 2 }).mesh;
  const shapeton::SurfaceMesh         mesh = MakeColonTube({ 12000, 15, 2 }).mesh;
  const shapeton::HandleCuts          cuts = shapeton::CutHandles(mesh);
  const shapeton::SurfaceConnectivity after(cuts.mesh);
  EXPECT_EQ(0, cuts.genus);
  EXPECT_EQ(15U, cuts.handles.size());
  EXPECT_TRUE(after.IsManifold());
  EXPECT_TRUE(after.IsOriented());
  EXPECT_EQ(2U, after.BoundaryLoops().size());
  const shapeton::SurfaceLocator locator(plain.V, plain.F);
  const double                   edge = shapeton::EdgeLengths(after, cuts.mesh.V).mean();
  for (int v = 0; v < cuts.mesh.NumberOfVertices(); ++v)
  {
    EXPECT_LT(locator.FindClosest(cuts.mesh.V.row(v).transpose()).distance, edge);
  }
  const shapeton::SurfaceArray * const filled = shapeton::FindSurfaceArray(cuts.mesh.cellArrays, "filled");
  ASSERT_NE(nullptr, filled);
  EXPECT_EQ(cuts.filledFaces, static_cast<int>(filled->values.sum()));
  EXPECT_EQ(0.0, filled->values.topRows(mesh.NumberOfFaces()).sum());
  EXPECT_EQ(mesh.V, cuts.mesh.V.topRows(mesh.NumberOfVertices()));
}

TEST(HandleLoops, WrongSurfacesAreRefused)
{
  shapeton::SurfaceMesh two = Torus(12, 6, 10.0, 3.0);
  const auto            faces = two.F.rows();
  two.F.conservativeResize(faces + 1, Eigen::NoChange);
  two.F.row(faces) = two.F.row(0);
  EXPECT_THROW(shapeton::FindHandleLoops(two, shapeton::SurfaceConnectivity(two)), shapeton::InputError);
  EXPECT_THROW(shapeton::CutHandles(two), shapeton::InputError);
}

TEST(HandleLoops, TheCutOfATubeTakesNoShortcut)
{
  const BentTube                      tube;
  const shapeton::SurfaceConnectivity connectivity(tube.mesh);
  ASSERT_EQ(1, connectivity.Components().front().genus);
  const Eigen::VectorXd   lengths = shapeton::EdgeLengths(connectivity, tube.mesh.V);
  const shapeton::TubeMap map = shapeton::FlattenTube(
    tube.mesh, connectivity, lengths, shapeton::FindTubeEnds(tube.mesh, connectivity, "the tube"));
  for (std::size_t i = 0; i + 1 < map.cutPath.size(); ++i)
  {
    EXPECT_LT(std::abs(tube.along[map.cutPath[i]] - tube.along[map.cutPath[i + 1]]), 10.0);
  }
  // The loop is around the handle, not around the tube; if the tube is narrower, arcLength shows which one to cut.
  const shapeton::HandleCuts cuts = shapeton::CutHandles(tube.mesh);
  EXPECT_EQ(0, cuts.genus);
  EXPECT_LT(cuts.longestLoop, 15.0);
  shapeton::SurfaceMesh narrow = tube.mesh;
  const double          neck = 7.0 / 80.0 * tube.along.maxCoeff(); // at the seventh ring, beyond the handle
  for (Eigen::Index v = 0; v < narrow.V.rows(); ++v)
  {
    if (tube.along[v] < BentTube::leg)
    {
      const Eigen::RowVector3d axis(-BentTube::bend, 0.0, tube.along[v]);
      narrow.V.row(v) += 0.99 * std::exp(-std::pow((tube.along[v] - neck) / 2.5, 2)) * (axis - narrow.V.row(v));
    }
  }
  const shapeton::SurfaceConnectivity again(narrow);
  const auto                          around = shapeton::FindHandleLoops(narrow, again);
  ASSERT_EQ(1U, around.size());
  EXPECT_NEAR(neck, tube.along[around[0].vertices[0]], 0.1); // around the tube
  narrow.pointArrays.push_back({ "arcLength", tube.along, false });
  const auto ofHandle = shapeton::FindHandleLoops(narrow, again);
  ASSERT_EQ(1U, ofHandle.size());
  EXPECT_EQ(3U, ofHandle[0].vertices.size());
  EXPECT_GT(ofHandle[0].length, around[0].length);
}
