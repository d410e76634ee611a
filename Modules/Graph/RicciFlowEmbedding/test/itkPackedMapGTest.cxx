#include "itkPackedMap.h"

#include "itkGraphFamilies.h"
#include "itkToolError.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
/** The rotation system in which the half-edges of each node stand in ascending order. */
itk::CombinatorialMap
AnyMap(const itk::Graph & graph)
{
  itk::Rotation rotation(graph.nodes);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    rotation[graph.edges[e][0]].push_back(static_cast<int>(2 * e));
    rotation[graph.edges[e][1]].push_back(static_cast<int>(2 * e + 1));
  }
  return { graph, rotation };
}

void
ExpectPackable(const itk::CombinatorialMap & original)
{
  const itk::PackedMap          packed = itk::MakePackedMap(original, itk::Augmentation::Ring);
  const itk::CombinatorialMap & map = packed.map;
  EXPECT_EQ(map.Components(), 1);
  EXPECT_EQ(map.Genus(), original.Genus());
  EXPECT_GE(map.Nodes(), 4);
  std::set<std::pair<int, int>> ends;
  for (int e = 0; e < map.Edges(); ++e)
  {
    EXPECT_NE(map.Node(2 * e), map.Node(2 * e + 1));
    EXPECT_TRUE(ends.insert(std::minmax(map.Node(2 * e), map.Node(2 * e + 1))).second);
  }
  EXPECT_EQ(itk::FaceConflicts(map).reason, "");
  EXPECT_NO_THROW(itk::MakePackedMap(map, itk::Augmentation::None));
}

/** The order around the nodes of the graph with dummies left out. */
void
ExpectRotationKept(const itk::CombinatorialMap & original)
{
  const itk::PackedMap packed = itk::MakePackedMap(original, itk::Augmentation::Ring);
  std::vector<int>     graphHalfEdge(packed.map.HalfEdges(), -1);
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
  using namespace itk;
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

TEST(PackedMap, ThreeConnectedMapsStayAsTheyAre)
{
  const itk::CombinatorialMap wheel = itk::TorusGridMap(5, 6);
  EXPECT_EQ(itk::MakePackedMap(wheel, itk::Augmentation::Ring).map.Nodes(), 30);
}

TEST(PackedMap, WithoutDummiesConflictsAreRefusedWithTheReason)
{
  using namespace itk;
  Graph k4 = CompleteGraph(4);
  k4.edges.pop_back();
  for (const Graph & graph : { k4, CompleteBipartiteGraph(2, 3), CycleGraph(3), CycleGraph(2), PathGraph(5) })
  {
    try
    {
      MakePackedMap(AnyMap(graph), Augmentation::None);
      FAIL();
    }
    catch (const InputError & error)
    {
      EXPECT_NE(std::string(error.what()).find("use --augmentation ring"), std::string::npos);
    }
  }
}
