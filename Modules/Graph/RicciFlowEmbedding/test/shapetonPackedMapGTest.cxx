#include "shapetonPackedMap.h"

#include "shapetonGraphFamilies.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace
{
/** A triangulated torus with some edges removed to create longer faces. */
shapeton::CombinatorialMap
TrianglesWithGaps(unsigned int seed)
{
  const shapeton::CombinatorialMap grid = shapeton::TorusGridMap(5, 4, true);
  std::mt19937                     random(seed);
  std::vector<int>                 number(grid.Edges(), -1);
  shapeton::Graph                  graph;
  graph.nodes = grid.Nodes();
  for (int e = 0; e < grid.Edges(); ++e)
  {
    if (random() % 3 != 0)
    {
      number[e] = static_cast<int>(graph.edges.size());
      graph.edges.push_back({ grid.Node(2 * e), grid.Node(2 * e + 1) });
    }
  }
  shapeton::Rotation rotation = grid.GetRotation();
  for (std::vector<int> & around : rotation)
  {
    around.erase(std::remove_if(around.begin(), around.end(), [&](int h) { return number[h / 2] < 0; }), around.end());
    std::for_each(around.begin(), around.end(), [&](int & h) { h = 2 * number[h / 2] + h % 2; });
  }
  return { graph, rotation };
}

std::set<int>
NodesOf(const shapeton::CombinatorialMap & map, int face)
{
  std::set<int> nodes;
  for (const int h : map.Boundary(face))
  {
    nodes.insert(map.Node(h));
  }
  return nodes;
}

bool
IsEdgeBetween(const shapeton::CombinatorialMap & map, int node, int other, int face, int otherFace)
{
  const std::vector<int> around = map.Around(node);
  return std::any_of(around.begin(), around.end(), [&](int h) {
    const std::set<int> faces{ map.Face(h), map.Face(h ^ 1) };
    return map.Node(h ^ 1) == other && faces == std::set<int>{ face, otherFace };
  });
}

/** FaceConflicts::sharesTwoNodes by brute force over all pairs of nodes and faces. */
std::vector<char>
SharesTwoNodes(const shapeton::CombinatorialMap & map)
{
  std::vector<char> shares(map.Faces(), 0);
  for (int one = 0; one < map.Nodes(); ++one)
  {
    for (int other = 0; other < one; ++other)
    {
      std::vector<int> faces;
      for (int face = 0; face < map.Faces(); ++face)
      {
        const std::set<int> nodes = NodesOf(map, face);
        if (nodes.count(one) && nodes.count(other))
        {
          faces.push_back(face);
        }
      }
      if (faces.size() > 2 || (faces.size() == 2 && !IsEdgeBetween(map, one, other, faces[0], faces[1])))
      {
        std::for_each(faces.begin(), faces.end(), [&](int face) { shares[face] = 1; });
      }
    }
  }
  return shares;
}

/** The rotation system with ascending half-edges at each node. */
shapeton::CombinatorialMap
AnyMap(const shapeton::Graph & graph)
{
  shapeton::Rotation rotation(graph.nodes);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    rotation[graph.edges[e][0]].push_back(static_cast<int>(2 * e));
    rotation[graph.edges[e][1]].push_back(static_cast<int>(2 * e + 1));
  }
  return { graph, rotation };
}

void
ExpectPackable(const shapeton::CombinatorialMap & original)
{
  const shapeton::PackedMap          packed = shapeton::MakePackedMap(original, shapeton::Augmentation::Ring);
  const shapeton::CombinatorialMap & map = packed.map;
  EXPECT_EQ(map.Components(), 1);
  EXPECT_EQ(map.Genus(), original.Genus());
  EXPECT_GE(map.Nodes(), 4);
  std::set<std::pair<int, int>> ends;
  for (int e = 0; e < map.Edges(); ++e)
  {
    EXPECT_NE(map.Node(2 * e), map.Node(2 * e + 1));
    EXPECT_TRUE(ends.insert(std::minmax(map.Node(2 * e), map.Node(2 * e + 1))).second);
  }
  EXPECT_EQ(shapeton::FaceConflicts(map).reason, "");
  EXPECT_NO_THROW(shapeton::MakePackedMap(map, shapeton::Augmentation::None));
}

/** The order around the graph nodes, without dummies. */
void
ExpectRotationKept(const shapeton::CombinatorialMap & original)
{
  const shapeton::PackedMap packed = shapeton::MakePackedMap(original, shapeton::Augmentation::Ring);
  std::vector<int>          graphHalfEdge(packed.map.HalfEdges(), -1);
  for (int h = 0; h < original.HalfEdges(); ++h)
  {
    graphHalfEdge[h] = h;
  }
  for (const std::vector<int> & path : packed.subdivided)
  {
    graphHalfEdge[path.front() + 1] = -1;
    graphHalfEdge[path.back() ^ 1] = path.front() + 1;
  }
  for (int h = 0; h < packed.map.HalfEdges(); ++h)
  {
    if (graphHalfEdge[h] < 0)
    {
      continue;
    }
    int next = packed.map.NextAround(h);
    while (graphHalfEdge[next] < 0)
    {
      next = packed.map.NextAround(next);
    }
    EXPECT_EQ(original.NextAround(graphHalfEdge[h]), graphHalfEdge[next]);
  }
}
} // namespace

TEST(PackedMap, AllKindsOfGraphsBecomePackable)
{
  using namespace shapeton;
  for (const Graph & graph : { Graph{ 1, {}, {} },
                               PathGraph(2),
                               PathGraph(3),
                               PathGraph(30),
                               CycleGraph(1),
                               CycleGraph(2),
                               CycleGraph(3),
                               CycleGraph(17),
                               CompleteGraph(4),
                               CompleteGraph(7),
                               CompleteBipartiteGraph(2, 3),
                               CompleteBipartiteGraph(1, 9),
                               GeneralizedPetersenGraph(5, 2),
                               GridGraph(4, 5),
                               Graph{ 3, {}, {} },
                               Graph{ 5, { { 0, 1 }, { 3, 3 }, { 3, 3 }, { 1, 0 }, { 1, 4 } }, {} } })
  {
    ExpectPackable(AnyMap(graph));
    ExpectRotationKept(AnyMap(graph));
  }
}

TEST(FaceConflicts, AreThoseOfAllPairsOfNodesAndFaces)
{
  int conflicts = 0;
  int faces = 0;
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    const shapeton::CombinatorialMap map = TrianglesWithGaps(seed);
    const std::vector<char>          expected = SharesTwoNodes(map);
    EXPECT_EQ(shapeton::FaceConflicts(map).sharesTwoNodes, expected) << seed;
    conflicts += static_cast<int>(std::count(expected.begin(), expected.end(), 1));
    faces += map.Faces();
  }
  EXPECT_GT(conflicts, faces / 10);
  EXPECT_LT(conflicts, faces * 9 / 10);
}

TEST(PackedMap, ThreeConnectedMapsStayAsTheyAre)
{
  const shapeton::CombinatorialMap wheel = shapeton::TorusGridMap(5, 6);
  EXPECT_EQ(shapeton::MakePackedMap(wheel, shapeton::Augmentation::Ring).map.Nodes(), 30);
}

TEST(PackedMap, WithoutDummiesConflictsAreRefusedWithTheReason)
{
  using namespace shapeton;
  Graph k4 = CompleteGraph(4);
  k4.edges.pop_back();
  for (const Graph & graph : { k4, CompleteBipartiteGraph(2, 3), CycleGraph(3), CycleGraph(2), PathGraph(5) })
  {
    EXPECT_TRUE(basetest::Refuses([&] { MakePackedMap(AnyMap(graph), Augmentation::None); },
                                  "use the parameter \"augmentation\" = ring"));
  }
}
