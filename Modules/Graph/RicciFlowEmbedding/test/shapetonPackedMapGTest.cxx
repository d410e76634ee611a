#include "shapetonPackedMap.h"

#include "shapetonGraphFamilies.h"
#include "shapetonPackedMapTests.h"
#include "shapetonTestErrors.h"
#include "shapetonTestGraphs.h"

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
  std::mt19937 random(seed);
  return graphtest::MapOfEdges(shapeton::TorusGridMap(5, 4, true), [&](int) { return random() % 3 != 0; });
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
  graphtest::ExpectOrdersOf(packed, original);
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
    ExpectPackable(graphtest::AnyMap(graph));
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
    EXPECT_TRUE(basetest::Refuses([&] { MakePackedMap(graphtest::AnyMap(graph), Augmentation::None); },
                                  "use the parameter \"augmentation\" = ring"));
  }
}
