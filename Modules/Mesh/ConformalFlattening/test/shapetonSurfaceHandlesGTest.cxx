#include "shapetonSurfaceHandles.h"

#include "shapetonColonTube.h"
#include "shapetonConformalTube.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace testsurfaces;

/** A tube with its Euclidean map and the handles found on it. */
struct Detected
{
  explicit Detected(const shapeton::SurfaceMesh & surface)
    : mesh(surface)
    , connectivity(mesh)
    , map(shapeton::FlattenTube(mesh,
                                connectivity,
                                shapeton::EdgeLengths(connectivity, mesh.V),
                                shapeton::FindTubeEnds(mesh, connectivity, "the tube")))
    , detection(shapeton::DetectHandles(connectivity, map.flat))
  {}
  shapeton::SurfaceMesh         mesh;
  shapeton::SurfaceConnectivity connectivity;
  shapeton::TubeMap             map;
  shapeton::HandleDetection     detection;
};

Eigen::Vector3d
PlaceOf(const shapeton::SurfaceMesh & mesh, const std::array<int, 6> & handle)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int v : handle)
  {
    sum += mesh.V.row(v).transpose() / 6.0;
  }
  return sum;
}

/** Number of true places within `distance` of a detected handle, each used once. */
int
Located(std::vector<Eigen::Vector3d> truth, const std::vector<shapeton::SurfaceHandle> & found, double distance)
{
  int located = 0;
  for (const shapeton::SurfaceHandle & handle : found)
  {
    const auto nearest = std::min_element(truth.begin(), truth.end(), [&](const auto & a, const auto & b) {
      return (a - handle.place).norm() < (b - handle.place).norm();
    });
    if (nearest != truth.end() && (*nearest - handle.place).norm() <= distance)
    {
      truth.erase(nearest);
      ++located;
    }
  }
  return located;
}
} // namespace

TEST(SurfaceHandles, AllAreFoundWhereTheyAre)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const ColonTube              tube = MakeColonTube({ 12000, 15, seed });
    const Detected               found(tube.mesh);
    std::vector<Eigen::Vector3d> truth;
    for (const auto & handle : tube.handles)
    {
      truth.push_back(PlaceOf(tube.mesh, handle));
    }
    const double edge = shapeton::EdgeLengths(found.connectivity, tube.mesh.V).mean();
    EXPECT_EQ(15, found.detection.genus);
    EXPECT_EQ(15U, found.detection.handles.size());
    EXPECT_EQ(15, Located(truth, found.detection.handles, 3.0 * edge));
    for (const shapeton::SurfaceHandle & handle : found.detection.handles)
    {
      EXPECT_EQ(1, handle.genus);
      EXPECT_LT(handle.radius, 12.0 * edge);
      EXPECT_TRUE(std::is_sorted(handle.vertices.begin(), handle.vertices.end()));
    }
  }
}

TEST(SurfaceHandles, FlatPlaceIsThatOfTheHandle)
{
  const Detected         found(MakeColonTube({ 6000, 4, 2 }).mesh);
  const Eigen::MatrixX2d uv = shapeton::FlatCoordinates(found.map.flat, "it");
  const double           period = found.map.circumference;
  for (const shapeton::SurfaceHandle & handle : found.detection.handles)
  {
    double least = 1e9;
    for (const int v : handle.vertices)
    {
      Eigen::Vector2d step = uv.row(v).transpose() - handle.flatPlace;
      step.y() -= period * std::round(step.y() / period);
      least = std::min(least, step.norm());
    }
    EXPECT_LT(least, 8.0);
  }
}

TEST(SurfaceHandles, RemovalGivesTheTubeBack)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const Detected plain(MakeColonTube({ 12000, 0, seed }).mesh);
    EXPECT_TRUE(plain.detection.handles.empty());
    EXPECT_EQ(0, plain.detection.genus);
    const Detected                found(MakeColonTube({ 12000, 15, seed }).mesh);
    const shapeton::HandleRemoval removal =
      shapeton::RemoveHandles(found.mesh, found.connectivity, found.detection.handles);
    const shapeton::SurfaceConnectivity after(removal.mesh);
    EXPECT_EQ(0, removal.genus);
    EXPECT_TRUE(after.IsManifold());
    EXPECT_TRUE(after.IsOriented());
    ASSERT_EQ(2U, after.BoundaryLoops().size());
    EXPECT_EQ(found.connectivity.BoundaryLoops()[0].size(), after.BoundaryLoops()[0].size());
    EXPECT_EQ(15, removal.filledHoles);
    // The filling follows the original surface.
    const shapeton::SurfaceLocator locator(plain.mesh.V, plain.mesh.F);
    const double                   edge = shapeton::EdgeLengths(after, removal.mesh.V).mean();
    double                         farthest = 0.0;
    for (int v = 0; v < removal.mesh.NumberOfVertices(); ++v)
    {
      farthest = std::max(farthest, locator.FindClosest(removal.mesh.V.row(v).transpose()).distance);
    }
    EXPECT_LT(farthest, edge);
    const shapeton::SurfaceArray * filled = shapeton::FindSurfaceArray(removal.mesh.cellArrays, "filled");
    ASSERT_NE(nullptr, filled);
    EXPECT_EQ(removal.filledFaces, static_cast<int>(filled->values.sum()));
    const Detected again(removal.mesh);
    EXPECT_EQ(0, again.detection.genus);
    EXPECT_NEAR(1.0, again.map.modulusU / plain.map.modulusU, 0.005);
    EXPECT_NEAR(1.0, again.map.modulusV / plain.map.modulusV, 0.005);
  }
}

TEST(SurfaceHandles, DecimatedSurfacesToo)
{
  const ColonTube                         tube = MakeColonTube({ 40000, 10, 4 });
  shapeton::SurfaceSimplificationSettings options;
  options.faces = 10000;
  const Detected found(shapeton::SimplifySurface(tube.mesh, options));
  EXPECT_EQ(10, found.detection.genus);
  const shapeton::HandleRemoval removal =
    shapeton::RemoveHandles(found.mesh, found.connectivity, found.detection.handles);
  EXPECT_EQ(0, removal.genus);
}

TEST(SurfaceHandles, ArraysAndLoopsFollow)
{
  shapeton::SurfaceMesh mesh = MakeColonTube({ 6000, 3, 2 }).mesh;
  mesh.pointArrays.push_back({ "height", mesh.V.col(2), false });
  mesh.cellArrays.push_back({ "bridged", shapeton::SurfaceArray::ValueMatrix::Ones(mesh.NumberOfFaces(), 1), true });
  const int last = mesh.NumberOfVertices() - 1;
  mesh.fieldArrays.push_back({ "rectumLoop", shapeton::SurfaceArray::ValueMatrix::Constant(1, 1, last), true });
  const Detected                found(mesh);
  const shapeton::HandleRemoval removal = shapeton::RemoveHandles(mesh, found.connectivity, found.detection.handles);
  EXPECT_NO_THROW(shapeton::RequireSound(removal.mesh, "it"));
  const int renumbered = static_cast<int>(removal.mesh.fieldArrays.at(0).values(0, 0));
  EXPECT_EQ(mesh.V.row(last), removal.mesh.V.row(renumbered));
  EXPECT_EQ(removal.mesh.NumberOfFaces() - removal.filledFaces,
            static_cast<int>(removal.mesh.cellArrays.at(0).values.sum()));
  EXPECT_EQ(mesh.NumberOfFaces() - removal.removedFaces + removal.filledFaces, removal.mesh.NumberOfFaces());
}

TEST(SurfaceHandles, NearMarksRings)
{
  const shapeton::SurfaceMesh         mesh = Square(10, 10.0);
  const shapeton::SurfaceConnectivity connectivity(mesh);
  shapeton::SurfaceHandle             handle;
  handle.vertices = { 60 }; // the center
  for (int rings = 0; rings < 3; ++rings)
  {
    const std::vector<char> isNear = shapeton::FacesNearHandles(connectivity, { handle }, rings);
    // Rings around a grid vertex contain 6, 24 and 54 faces.
    EXPECT_EQ(6 * (rings + 1) * (rings + 1), std::count(isNear.begin(), isNear.end(), 1));
  }
}

TEST(SurfaceHandles, WrongSurfacesAreRefused)
{
  const Detected                      found(MakeColonTube({ 6000, 1, 1 }).mesh);
  const shapeton::SurfaceMesh         other = Square(4, 4.0);
  const shapeton::SurfaceConnectivity connectivity(other);
  EXPECT_THROW(shapeton::DetectHandles(connectivity, found.map.flat), shapeton::InputError);
  EXPECT_THROW(shapeton::DetectHandles(connectivity, other), shapeton::InputError);
  EXPECT_THROW(shapeton::RemoveHandles(other, connectivity, found.detection.handles), shapeton::InputError);
}
