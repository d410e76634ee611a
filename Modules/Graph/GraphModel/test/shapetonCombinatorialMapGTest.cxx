#include "shapetonCombinatorialMap.h"
#include "shapetonGraphFamilies.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
/** The tetrahedron seen from above: node 3 at the center of the counter-clockwise triangle 0 1 2. */
shapeton::CombinatorialMap
Tetrahedron()
{
  const shapeton::Graph graph{ 4, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } }, {} };
  return shapeton::CombinatorialMap(graph, { { 0, 6, 5 }, { 2, 8, 1 }, { 4, 10, 3 }, { 7, 9, 11 } });
}

std::vector<int>
Nodes(const shapeton::CombinatorialMap & map, const std::vector<int> & halfEdges)
{
  std::vector<int> nodes;
  for (const int h : halfEdges)
  {
    nodes.push_back(map.Node(h));
  }
  return nodes;
}

std::string
FaultOf(const shapeton::Graph & graph, const shapeton::Rotation & rotation)
{
  return basetest::ErrorOf([&] { shapeton::CombinatorialMap map(graph, rotation); });
}

void
ExpectSameMap(const shapeton::CombinatorialMap & a, const shapeton::CombinatorialMap & b)
{
  ASSERT_EQ(a.HalfEdges(), b.HalfEdges());
  for (int h = 0; h < a.HalfEdges(); ++h)
  {
    EXPECT_EQ(a.Node(h), b.Node(h));
    EXPECT_EQ(a.NextAround(h), b.NextAround(h));
  }
}
} // namespace

TEST(CombinatorialMap, FacesOfTheTetrahedronLieToTheLeft)
{
  const shapeton::CombinatorialMap map = Tetrahedron();
  EXPECT_EQ(map.Faces(), 4);
  EXPECT_EQ(map.Genus(), 0);
  // Seen from above, the face to the left of 0 -> 1 is the inner triangle 0 1 3; the outer face is to its right.
  EXPECT_EQ(Nodes(map, map.Boundary(map.Face(0))), (std::vector<int>{ 0, 1, 3 }));
  EXPECT_EQ(Nodes(map, map.Boundary(map.Face(1))), (std::vector<int>{ 1, 0, 2 }));
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    EXPECT_EQ(map.FaceNext(h), map.PreviousAround(shapeton::CombinatorialMap::Twin(h)));
    EXPECT_EQ(map.FacePrevious(map.FaceNext(h)), h);
    EXPECT_EQ(map.Face(map.FaceNext(h)), map.Face(h));
    EXPECT_EQ(map.Node(map.NextAround(h)), map.Node(h));
  }
}

TEST(CombinatorialMap, TorusGridHasQuadrilateralsOrTriangles)
{
  const shapeton::CombinatorialMap squares = shapeton::TorusGridMap(5, 4);
  EXPECT_EQ(squares.Genus(), 1);
  EXPECT_EQ(squares.Faces(), 20);
  EXPECT_EQ(squares.FaceLengths(), std::vector<int>(20, 4));
  EXPECT_EQ(squares.Degrees(), std::vector<int>(20, 4));
  // The square above the edge from (1, 1) to (2, 1) is to its left.
  EXPECT_EQ(Nodes(squares, squares.Boundary(squares.Face(2 * 2 * 6))), (std::vector<int>{ 6, 7, 12, 11 }));
  const shapeton::CombinatorialMap triangles = shapeton::TorusGridMap(5, 4, true);
  EXPECT_EQ(triangles.Genus(), 1);
  EXPECT_EQ(triangles.FaceLengths(), std::vector<int>(40, 3));
  EXPECT_EQ(shapeton::TorusGridMap(1, 1).Genus(), 1); // a bouquet of two loops
}

TEST(CombinatorialMap, DualSwapsNodesAndFaces)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(4, 3, true);
  const shapeton::CombinatorialMap dual = map.Dual();
  EXPECT_EQ(dual.Nodes(), map.Faces());
  EXPECT_EQ(dual.Faces(), map.Nodes());
  EXPECT_EQ(dual.Genus(), 1);
  EXPECT_EQ(dual.FaceLengths(), std::vector<int>(12, 6));
  const shapeton::CombinatorialMap again = dual.Dual();
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    EXPECT_EQ(dual.Node(h), map.Face(h));
    EXPECT_EQ(again.NextAround(h) ^ 1, map.NextAround(h ^ 1));
  }
}

TEST(CombinatorialMap, MirroringTwiceChangesNothing)
{
  const shapeton::CombinatorialMap map = Tetrahedron();
  EXPECT_EQ(map.Mirrored().Genus(), 0);
  EXPECT_EQ(map.Mirrored().NextAround(0), map.PreviousAround(0));
  ExpectSameMap(map.Mirrored().Mirrored(), map);
}

TEST(CombinatorialMap, OverlapGraphHasKitesAlone)
{
  for (const shapeton::CombinatorialMap & map :
       { Tetrahedron(), shapeton::TorusGridMap(3, 4), shapeton::TorusGridMap(1, 1) })
  {
    const shapeton::OverlapGraph overlap(map);
    EXPECT_EQ(overlap.map.Nodes(), map.Nodes() + map.Faces() + map.Edges());
    EXPECT_EQ(overlap.map.Genus(), map.Genus());
    EXPECT_EQ(overlap.map.FaceLengths(), std::vector<int>(map.HalfEdges(), 4));
    const std::vector<int> degrees = overlap.map.Degrees();
    for (int f = 0; f < map.Faces(); ++f)
    {
      EXPECT_EQ(degrees[overlap.NodeOfFace(f)], map.FaceLengths()[f]);
    }
    // Around an edge: its first node, the face to the right, its second node, the face to the left.
    const std::vector<int> around = overlap.map.Around(overlap.NodeOfEdge(0));
    std::vector<int>       neighbors;
    for (const int h : around)
    {
      neighbors.push_back(overlap.map.Node(h ^ 1));
    }
    EXPECT_EQ(
      neighbors,
      (std::vector<int>{ map.Node(0), overlap.NodeOfFace(map.Face(1)), map.Node(1), overlap.NodeOfFace(map.Face(0)) }));
  }
}

TEST(CombinatorialMap, ComponentsHaveTheirOwnSurfaces)
{
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(3, 3);
  shapeton::Graph                  graph = torus.ToGraph();
  shapeton::Rotation               rotation = torus.GetRotation();
  graph.nodes = 13; // an edge, a loop, an isolated node
  graph.edges.push_back({ 9, 10 });
  graph.edges.push_back({ 11, 11 });
  rotation.insert(rotation.end(), { { 36 }, { 37 }, { 38, 39 }, {} });
  const shapeton::CombinatorialMap map(graph, rotation);
  EXPECT_EQ(map.Components(), 4);
  EXPECT_EQ(map.GenusOfComponent(), (std::vector<int>{ 1, 0, 0, 0 }));
  EXPECT_EQ(map.Genus(), 1);
  EXPECT_EQ(map.Faces(), 9 + 1 + 2);
  EXPECT_EQ(map.ComponentOfNode()[12], 3);
  EXPECT_EQ(map.FirstAround(12), -1);
  EXPECT_TRUE(map.Around(12).empty());
  EXPECT_EQ(map.Boundary(map.Face(36)), (std::vector<int>{ 36, 37 }));
}

TEST(CombinatorialMap, RotationAndGraphComeBack)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(4, 5, true);
  ExpectSameMap(shapeton::CombinatorialMap(map.ToGraph(), map.GetRotation()), map);
}

TEST(CombinatorialMap, WrongRotationsAreRefused)
{
  const shapeton::Graph triangle = shapeton::CycleGraph(3);
  EXPECT_EQ(FaultOf(triangle, { { 0, 5 }, { 1, 2 }, { 3, 4 } }), "");
  EXPECT_NE(FaultOf(triangle, { { 0, 5 }, { 1, 2 } }).find("2 orders for 3 nodes"), std::string::npos);
  EXPECT_NE(FaultOf(triangle, { { 0, 5 }, { 1, 2 }, { 3 } }).find("half-edge 4, which leaves node 2, is missing"),
            std::string::npos);
  EXPECT_NE(FaultOf(triangle, { { 0, 5 }, { 1, 2 }, { 3, 3 } }).find("half-edge 3 is listed twice"), std::string::npos);
  EXPECT_NE(FaultOf(triangle, { { 0, 4 }, { 1, 2 }, { 3, 5 } }).find("leaves another node"), std::string::npos);
  EXPECT_NE(FaultOf(triangle, { { 0, 5 }, { 1, 2 }, { 3, 6 } }).find("invalid half-edge 6"), std::string::npos);
  EXPECT_THROW(shapeton::CombinatorialMap(3, triangle.edges, { 0, 1, 2, 3, 4, 5 }),
               shapeton::InputError); // two cycles per node
}
