#include "shapetonSurfaceConnectivity.h"
#include "shapetonTestSurfaces.h"

#include "gtest/gtest.h"

#include <set>
#include <stdexcept>

namespace
{
using namespace testsurfaces;
using shapeton::SurfaceConnectivity;

struct Known
{
  const char *          name;
  shapeton::SurfaceMesh mesh;
  int                   euler, loops, genus; // genus -1: not orientable
};

std::vector<Known>
KnownSurfaces()
{
  return { { "octahedron", Octahedron(), 2, 0, 0 },
           { "sphere", Icosphere(2, 3.0), 2, 0, 0 },
           { "torus", Torus(9, 7, 5, 2), 0, 0, 1 },
           { "cylinder", Cylinder(8, 5, 2, 9), 0, 2, 0 },
           { "square", Square(4, 1), 1, 1, 0 },
           { "Moebius strip", MoebiusStrip(12, 3), 0, 1, -1 },
           { "triangle", FromLists({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }), 1, 1, 0 } };
}

TEST(SurfaceConnectivity, KnowsTheTopologyOfKnownSurfaces)
{
  for (const Known & known : KnownSurfaces())
  {
    SCOPED_TRACE(known.name);
    const SurfaceConnectivity connectivity(known.mesh);
    ASSERT_EQ(connectivity.Components().size(), 1u);
    const shapeton::SurfaceComponent & component = connectivity.Components()[0];
    EXPECT_EQ(component.eulerCharacteristic, known.euler);
    EXPECT_EQ(component.boundaryLoops, known.loops);
    EXPECT_EQ(connectivity.BoundaryLoops().size(), static_cast<std::size_t>(known.loops));
    EXPECT_EQ(component.genus.value_or(-1), known.genus);
    EXPECT_EQ(component.isOrientable, known.genus >= 0);
    EXPECT_EQ(connectivity.IsOriented(), known.genus >= 0);
    EXPECT_TRUE(connectivity.IsManifold());
    EXPECT_EQ(connectivity.IsClosed(), known.loops == 0);
  }
}

TEST(SurfaceConnectivity, LoopsRunAlongTheirFacesFromTheLeastVertex)
{
  const SurfaceConnectivity square(Square(2, 1)); // vertices 0 1 2 / 3 4 5 / 6 7 8
  ASSERT_EQ(square.BoundaryLoops().size(), 1u);
  EXPECT_EQ(square.BoundaryLoops()[0], std::vector<int>({ 0, 1, 2, 5, 8, 7, 6, 3 }));
  const SurfaceConnectivity cylinder(Cylinder(5, 3, 1, 1));
  ASSERT_EQ(cylinder.BoundaryLoops().size(), 2u);
  EXPECT_EQ(cylinder.BoundaryLoops()[0], std::vector<int>({ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(cylinder.BoundaryLoops()[1], std::vector<int>({ 15, 19, 18, 17, 16 }));
}

TEST(SurfaceConnectivity, LoopOfAMoebiusStripGoesAroundTwice)
{
  const int                 around = 12;
  const SurfaceConnectivity strip(MoebiusStrip(around, 3));
  ASSERT_EQ(strip.BoundaryLoops().size(), 1u);
  const auto & loop = strip.BoundaryLoops()[0];
  EXPECT_EQ(loop.size(), 2u * around);
  EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), 2u * around);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int edge = strip.FindEdge(loop[i], loop[(i + 1) % loop.size()]);
    ASSERT_GE(edge, 0);
    EXPECT_TRUE(strip.IsBoundaryEdge(edge));
  }
}

TEST(SurfaceConnectivity, NeighborsOfAGridVertex)
{
  const SurfaceConnectivity square(Square(2, 1));
  EXPECT_EQ(square.NeighborsOfVertex(4), std::vector<int>({ 0, 1, 3, 5, 7, 8 }));
  EXPECT_EQ(square.NeighborsOfVertex(2), std::vector<int>({ 1, 5 }));
  EXPECT_FALSE(square.IsBoundaryVertex(4));
  EXPECT_TRUE(square.IsBoundaryVertex(2));
  EXPECT_EQ(square.FindEdge(4, 8), square.FindEdge(8, 4));
  EXPECT_EQ(square.FindEdge(2, 4), -1);
}

TEST(SurfaceConnectivity, FansAndNonManifoldEdges)
{
  // Two triangles sharing vertex 0, and three sharing the edge 5 6.
  const SurfaceConnectivity connectivity(
    FromLists(std::vector<Eigen::Vector3d>(10, Eigen::Vector3d::Zero()),
              { { 0, 1, 2 }, { 0, 3, 4 }, { 5, 6, 7 }, { 6, 5, 8 }, { 5, 6, 9 } }));
  EXPECT_EQ(connectivity.FansOfVertex(0), 2);
  EXPECT_TRUE(connectivity.IsNonManifoldVertex(0));
  EXPECT_EQ(connectivity.FansOfVertex(1), 1);
  EXPECT_FALSE(connectivity.IsNonManifoldVertex(1));
  EXPECT_TRUE(connectivity.IsNonManifoldEdge(connectivity.FindEdge(5, 6)));
  EXPECT_EQ(connectivity.FansOfVertex(5), 1);
  EXPECT_EQ(connectivity.FanOfFaces(5, true), std::vector<int>({ 0, 1, 2 }));
  EXPECT_TRUE(connectivity.IsNonManifoldVertex(5));
  EXPECT_FALSE(connectivity.IsManifold());
  ASSERT_EQ(connectivity.Components().size(), 3u); // faces that share only a vertex are not connected
  EXPECT_EQ(connectivity.Components()[0].genus, 0);
  EXPECT_FALSE(connectivity.Components()[2].isManifold);
  EXPECT_FALSE(connectivity.Components()[2].genus.has_value());
}

TEST(SurfaceConnectivity, APinchedComponentIsNotManifold)
{
  // An annulus pinched at vertex 0, so its faces form separate fans there.
  shapeton::SurfaceMesh mesh = Cylinder(8, 1, 1, 1);
  for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
  {
    mesh.F.data()[i] = mesh.F.data()[i] == 4 ? 0 : mesh.F.data()[i];
  }
  const SurfaceConnectivity connectivity(mesh);
  ASSERT_EQ(connectivity.Components().size(), 1u);
  EXPECT_EQ(connectivity.FansOfVertex(0), 2);
  EXPECT_FALSE(connectivity.Components()[0].isManifold);
}

TEST(SurfaceConnectivity, DegenerateFacesTakePartInNothing)
{
  const SurfaceConnectivity connectivity(
    FromLists(std::vector<Eigen::Vector3d>(5, Eigen::Vector3d::Zero()), { { 0, 1, 2 }, { 0, 0, 3 }, { 4, 4, 4 } }));
  EXPECT_EQ(connectivity.NumberOfEdges(), 3);
  EXPECT_EQ(connectivity.EdgeOfFace(1, 0), -1);
  EXPECT_EQ(connectivity.ComponentOfFaces(), std::vector<int>({ 0, -1, -1 }));
  EXPECT_EQ(connectivity.FansOfVertex(3), 0);
}

TEST(SurfaceConnectivity, IndicesAreChecked)
{
  shapeton::FaceMatrix F(1, 3);
  F << 0, 1, 3;
  EXPECT_THROW(SurfaceConnectivity(F, 3), std::out_of_range);
  F << 0, -1, 2;
  EXPECT_THROW(SurfaceConnectivity(F, 3), std::out_of_range);
  F.resize(0, 3);
  EXPECT_EQ(SurfaceConnectivity(F, 0).NumberOfEdges(), 0);
  EXPECT_FALSE(SurfaceConnectivity(F, 0).IsClosed());
}

// ---- comparison with brute force on random faces ----

shapeton::FaceMatrix
RandomFaces(int vertices, int faces, std::uint64_t seed)
{
  Random               random(seed);
  shapeton::FaceMatrix F(faces, 3);
  for (Eigen::Index i = 0; i < F.size(); ++i)
  {
    F.data()[i] = random.Below(vertices);
  }
  return F;
}

bool
Has(const shapeton::FaceMatrix & F, int f, int v)
{
  return F(f, 0) == v || F(f, 1) == v || F(f, 2) == v;
}

bool
IsDegenerate(const shapeton::FaceMatrix & F, int f)
{
  return F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
}

std::vector<int>
FacesWith(const shapeton::FaceMatrix & F, int a, int b)
{
  std::vector<int> faces;
  for (int f = 0; f < F.rows(); ++f)
  {
    if (!IsDegenerate(F, f) && Has(F, f, a) && Has(F, f, b))
    {
      faces.push_back(f);
    }
  }
  return faces;
}

/** Number of classes of `faces` after joining those that share two vertices, one of them v unless v < 0. */
int
BruteForceClasses(const shapeton::FaceMatrix & F, const std::vector<int> & faces, int v)
{
  std::map<int, int> label;
  for (const int f : faces)
  {
    label[f] = f;
  }
  for (bool changes = true; changes;)
  {
    changes = false;
    for (const int f : faces)
    {
      for (const int g : faces)
      {
        int shared = 0;
        for (int k = 0; k < 3; ++k)
        {
          shared += Has(F, g, F(f, k));
        }
        if (f != g && shared >= 2 && (v < 0 || (Has(F, f, v) && Has(F, g, v))) && label[g] < label[f])
        {
          label[f] = label[g];
          changes = true;
        }
      }
    }
  }
  std::set<int> classes;
  for (const auto & entry : label)
  {
    classes.insert(entry.second);
  }
  return static_cast<int>(classes.size());
}

class SurfaceConnectivityBruteForce : public testing::TestWithParam<int>
{};

TEST_P(SurfaceConnectivityBruteForce, EdgesFacesAndFans)
{
  const int                  vertices = 4 + GetParam() % 9;
  const shapeton::FaceMatrix F = RandomFaces(vertices, 2 + GetParam() % 17, GetParam());
  const SurfaceConnectivity  connectivity(F, vertices);
  int                        edges = 0;
  std::vector<int>           all;
  for (int f = 0; f < F.rows(); ++f)
  {
    if (!IsDegenerate(F, f))
    {
      all.push_back(f);
    }
  }
  for (int a = 0; a < vertices; ++a)
  {
    std::vector<int> neighbors;
    for (int b = 0; b < vertices; ++b)
    {
      const std::vector<int> faces = a == b ? std::vector<int>() : FacesWith(F, a, b);
      const int              edge = a == b ? -1 : connectivity.FindEdge(a, b);
      ASSERT_EQ(edge >= 0, !faces.empty());
      if (edge >= 0)
      {
        neighbors.push_back(b);
        edges += a < b;
        const auto range = connectivity.FacesOfEdge(edge);
        EXPECT_EQ(std::vector<int>(range.begin(), range.end()), faces);
      }
    }
    EXPECT_EQ(connectivity.NeighborsOfVertex(a), neighbors);
    const std::vector<int> own = FacesWith(F, a, a);
    const auto             range = connectivity.FacesOfVertex(a);
    EXPECT_EQ(std::vector<int>(range.begin(), range.end()), own);
    EXPECT_EQ(connectivity.FansOfVertex(a), BruteForceClasses(F, own, a));
  }
  EXPECT_EQ(connectivity.NumberOfEdges(), edges);
  EXPECT_EQ(static_cast<int>(connectivity.Components().size()), BruteForceClasses(F, all, -1));
}

INSTANTIATE_TEST_SUITE_P(Random, SurfaceConnectivityBruteForce, testing::Range(1, 41));
} // namespace
