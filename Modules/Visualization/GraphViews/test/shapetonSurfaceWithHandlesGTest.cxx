#include "shapetonSurfaceWithHandles.h"

#include "shapetonGraphFamilies.h"
#include "shapetonHandleCut.h"
#include "shapetonSurfaceQuality.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
/** Half-edges of each node in ascending order, which results in a high genus. */
shapeton::CombinatorialMap
AscendingMap(const shapeton::Graph & graph)
{
  shapeton::Rotation rotation(graph.nodes);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    rotation[graph.edges[e][0]].push_back(static_cast<int>(2 * e));
    rotation[graph.edges[e][1]].push_back(static_cast<int>(2 * e + 1));
  }
  return { graph, rotation };
}

/** Two grids on tori, joined by an edge: genus 2. */
shapeton::CombinatorialMap
TwoTori(int columns, int rows)
{
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(columns, rows);
  shapeton::Graph                  graph = torus.ToGraph();
  shapeton::Rotation               rotation = torus.GetRotation();
  const int                        halfEdges = torus.HalfEdges();
  for (const auto & edge : torus.ToGraph().edges)
  {
    graph.edges.push_back({ edge[0] + torus.Nodes(), edge[1] + torus.Nodes() });
  }
  for (const std::vector<int> & around : torus.GetRotation())
  {
    rotation.emplace_back();
    std::transform(
      around.begin(), around.end(), std::back_inserter(rotation.back()), [=](int h) { return h + halfEdges; });
  }
  rotation.front().push_back(2 * halfEdges);
  rotation[torus.Nodes()].push_back(2 * halfEdges + 1);
  graph.edges.push_back({ 0, torus.Nodes() });
  graph.nodes *= 2;
  return { graph, rotation };
}

/** Maps of several genera: short and long faces, parallel edges, loops, two components. */
std::vector<shapeton::CombinatorialMap>
SomeMaps()
{
  const shapeton::Graph loops{ 2, { { 0, 0 }, { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 1 }, { 1, 1 } }, {} };
  const shapeton::Graph apart{ 5, { { 0, 0 }, { 0, 0 }, { 1, 2 }, { 2, 1 }, { 1, 2 }, { 3, 4 } }, {} };
  return { shapeton::TorusGridMap(8, 3),
           TwoTori(5, 4),
           AscendingMap(loops),
           AscendingMap(apart),
           AscendingMap(shapeton::CompleteGraph(5)),
           AscendingMap(shapeton::CompleteGraph(8)),
           AscendingMap(shapeton::GeneralizedPetersenGraph(7, 2)) };
}

/** The half-edge that reaches the end of an edge of the map, over all hubs. */
int
LastHalfEdge(const shapeton::HandleCut & cut, int edge)
{
  int end = 2 * edge + 1;
  while (cut.across[end] >= 0)
  {
    end = shapeton::CombinatorialMap::Twin(cut.across[end]);
  }
  return end;
}

/** A cyclic list, rotated to start at its smallest element. */
std::vector<int>
FromLeast(std::vector<int> around)
{
  std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
  return around;
}

shapeton::SurfaceMesh
MeshOf(const shapeton::SurfaceWithHandles & surface)
{
  shapeton::SurfaceMesh mesh;
  mesh.V.resize(static_cast<Eigen::Index>(surface.Vertices().size()), 3);
  mesh.F.resize(static_cast<Eigen::Index>(surface.Triangles().size()), 3);
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    mesh.V.row(i) << surface.Vertices()[i][0], surface.Vertices()[i][1], surface.Vertices()[i][2];
  }
  for (Eigen::Index i = 0; i < mesh.F.rows(); ++i)
  {
    mesh.F.row(i) << surface.Triangles()[i][0], surface.Triangles()[i][1], surface.Triangles()[i][2];
  }
  return mesh;
}

/** Maps each neighbor of a vertex to the next one counterclockwise. */
std::vector<std::map<int, int>>
Fans(const shapeton::SurfaceMesh & mesh)
{
  std::vector<std::map<int, int>> fans(mesh.V.rows());
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      fans[mesh.F(f, k)][mesh.F(f, (k + 1) % 3)] = mesh.F(f, (k + 2) % 3);
    }
  }
  return fans;
}

/** Intersection of the line from p to q with a triangle. */
bool
Pierces(const Eigen::Vector3d & p, const Eigen::Vector3d & q, const std::array<Eigen::Vector3d, 3> & t)
{
  const auto volume = [](const auto & a, const auto & b, const auto & c, const auto & d) {
    return (b - a).cross(c - a).dot(d - a);
  };
  const double first = volume(p, q, t[0], t[1]);
  const double second = volume(p, q, t[1], t[2]);
  const double third = volume(p, q, t[2], t[0]);
  const bool   isInside = (first > 0.0 && second > 0.0 && third > 0.0) || (first < 0.0 && second < 0.0 && third < 0.0);
  return isInside && volume(t[0], t[1], t[2], p) * volume(t[0], t[1], t[2], q) < 0.0;
}

/** Intersecting pairs of an edge and a triangle without a common vertex, by brute force on intersecting boxes. */
int
SelfIntersections(const shapeton::SurfaceMesh & mesh)
{
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  std::vector<Eigen::AlignedBox3d>            boxes;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f)
  {
    triangles.push_back({ mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)), mesh.V.row(mesh.F(f, 2)) });
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d & corner : triangles.back())
    {
      box.extend(corner);
    }
    boxes.push_back(box);
  }
  int number = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t j = 0; j < boxes.size(); ++j)
    {
      if (i == j || !boxes[i].intersects(boxes[j]))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const int  a = mesh.F(i, k);
        const int  b = mesh.F(i, (k + 1) % 3);
        const auto other = mesh.F.row(j).array();
        if ((other != a).all() && (other != b).all())
        {
          number += Pierces(triangles[i][k], triangles[i][(k + 1) % 3], triangles[j]);
        }
      }
    }
  }
  return number;
}
} // namespace

/** Reversing and merging the hubs restores the map: rotations and crossed edges are unchanged. */
TEST(HandleCut, PutTogetherAgainItIsTheMap)
{
  for (const shapeton::CombinatorialMap & map : SomeMaps())
  {
    const shapeton::HandleCut cut(map);
    ASSERT_EQ(cut.sphere.Genus(), 0);
    ASSERT_EQ(cut.sphere.Components(), map.Components());
    ASSERT_EQ(static_cast<int>(cut.hubs.size()), map.Genus());
    std::vector<int> name(cut.sphere.HalfEdges(), -1);
    for (int edge = 0; edge < map.Edges(); ++edge)
    {
      name[2 * edge] = 2 * edge;
      name[LastHalfEdge(cut, edge)] = 2 * edge + 1;
    }
    for (int node = 0; node < map.Nodes(); ++node)
    {
      std::vector<int> around = cut.sphere.Around(node);
      std::transform(around.begin(), around.end(), around.begin(), [&](int h) { return name[h]; });
      EXPECT_EQ(around.empty() ? around : FromLeast(around), map.Around(node));
    }
    for (const auto & [first, second] : cut.hubs)
    {
      std::vector<int> beyond = cut.sphere.Around(first);
      std::transform(beyond.begin(), beyond.end(), beyond.begin(), [&](int h) { return cut.across[h]; });
      std::reverse(beyond.begin(), beyond.end());
      EXPECT_EQ(FromLeast(beyond), cut.sphere.Around(second));
    }
  }
}

TEST(HandleCut, TheCurveIsTheShortest)
{
  const shapeton::HandleCut cut(shapeton::TorusGridMap(9, 4));
  EXPECT_EQ(cut.sphere.Around(cut.hubs[0][0]).size(), 4U);
  EXPECT_TRUE(
    shapeton::HandleCut(shapeton::CombinatorialMap(shapeton::PathGraph(3), { { 0 }, { 1, 2 }, { 3 } })).hubs.empty());
}

TEST(SurfaceWithHandles, IsClosedAndHasTheGenusOfTheMap)
{
  for (const shapeton::CombinatorialMap & map : SomeMaps())
  {
    const shapeton::SurfaceMesh    mesh = MeshOf(shapeton::SurfaceWithHandles(map, 0.2));
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(mesh);
    EXPECT_TRUE(quality.isClosed && quality.isManifold && quality.isOriented);
    EXPECT_EQ(quality.components.size(), 1U);
    EXPECT_EQ(quality.genus, map.Genus());
    EXPECT_GT(quality.volume.value_or(0.0), 3.5); // positive: faces point outwards; a sphere has 4.19
    EXPECT_EQ(quality.defects.unreferencedVertices.size(), 0U);
    EXPECT_NEAR(mesh.V.rowwise().norm().minCoeff(), 1.0, 0.05); // at most the chord of a hole
  }
}

/** Edges run along the mesh, meet only at nodes, and follow the rotation around each node. Together with the genus
 * this shows that the map is embedded correctly. */
TEST(SurfaceWithHandles, EdgesLieOnTheSurfaceAndDoNotCross)
{
  for (const shapeton::CombinatorialMap & map : SomeMaps())
  {
    const shapeton::SurfaceWithHandles surface(map, 0.2);
    const auto                         fans = Fans(MeshOf(surface));
    std::set<int>                      taken;
    for (int edge = 0; edge < map.Edges(); ++edge)
    {
      const std::vector<int> & curve = surface.Edges()[edge];
      ASSERT_GE(curve.size(), 3U);
      EXPECT_EQ(curve.front(), map.Node(2 * edge));
      EXPECT_EQ(curve.back(), map.Node(2 * edge + 1));
      for (std::size_t i = 1; i < curve.size(); ++i)
      {
        EXPECT_EQ(fans[curve[i - 1]].count(curve[i]), 1U);
        EXPECT_TRUE(i + 1 == curve.size() || (curve[i] >= map.Nodes() && taken.insert(curve[i]).second));
      }
    }
    for (int node = 0; node < map.Nodes(); ++node)
    {
      std::map<int, int> halfEdgeOf;
      for (const int h : map.Around(node))
      {
        const std::vector<int> & curve = surface.Edges()[h / 2];
        halfEdgeOf[h % 2 == 0 ? curve[1] : curve[curve.size() - 2]] = h;
      }
      ASSERT_EQ(halfEdgeOf.size(), map.Around(node).size());
      std::vector<int> around;
      int              vertex = fans[node].begin()->first;
      for (std::size_t i = 0; i < fans[node].size(); ++i)
      {
        if (halfEdgeOf.count(vertex))
        {
          around.push_back(halfEdgeOf[vertex]);
        }
        vertex = fans[node].at(vertex);
      }
      EXPECT_EQ(around.empty() ? around : FromLeast(around), map.Around(node));
    }
  }
}

TEST(SurfaceWithHandles, DoesNotMeetItself)
{
  for (const shapeton::CombinatorialMap & map : SomeMaps())
  {
    const shapeton::SurfaceMesh mesh = MeshOf(shapeton::SurfaceWithHandles(map, 0.3));
    EXPECT_EQ(SelfIntersections(mesh), 0) << "genus " << map.Genus();
  }
}

TEST(SurfaceWithHandles, AMapOfTheSphereHasNoHandle)
{
  const shapeton::CombinatorialMap tetrahedron(shapeton::CompleteGraph(4),
                                               { { 0, 2, 4 }, { 1, 8, 6 }, { 3, 7, 10 }, { 5, 11, 9 } });
  ASSERT_EQ(tetrahedron.Genus(), 0);
  const shapeton::SurfaceMesh mesh = MeshOf(shapeton::SurfaceWithHandles(tetrahedron, 0.2));
  EXPECT_EQ(shapeton::InspectSurface(mesh).genus, 0);
  EXPECT_NEAR((mesh.V.rowwise().norm().array() - 1.0).abs().maxCoeff(), 0.0, 1e-12);
}
