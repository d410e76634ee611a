#include "shapetonGraphFamilies.h"
#include "shapetonIncrementalMap.h"

#include <gtest/gtest.h>

#include <map>

namespace
{
/** Checks that the face labels agree with newly traced faces. */
void
ExpectFacesOf(const shapeton::IncrementalMap & map, const std::vector<std::array<int, 2>> & edges)
{
  std::vector<std::array<int, 2>> inside;
  std::vector<int>                index(edges.size(), -1);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (map.Contains(static_cast<int>(e)))
    {
      index[e] = static_cast<int>(inside.size());
      inside.push_back(edges[e]);
    }
  }
  std::vector<int> next(2 * inside.size());
  for (std::size_t h = 0; h < 2 * edges.size(); ++h)
  {
    if (index[h / 2] >= 0)
    {
      const int after = map.NextAround(static_cast<int>(h));
      next[2 * index[h / 2] + h % 2] = 2 * index[after / 2] + after % 2;
    }
  }
  const shapeton::CombinatorialMap traced(map.Nodes(), inside, next);
  ASSERT_EQ(map.Faces(), traced.Faces());
  std::map<int, int>     labelOfFace;
  const std::vector<int> lengths = traced.FaceLengths();
  for (std::size_t h = 0; h < 2 * edges.size(); ++h)
  {
    if (index[h / 2] >= 0)
    {
      const int label = map.Face(static_cast<int>(h));
      const int face = traced.Face(2 * index[h / 2] + static_cast<int>(h) % 2);
      EXPECT_EQ(labelOfFace.try_emplace(face, label).first->second, label);
      EXPECT_EQ(map.FaceLength(label), lengths[face]);
    }
  }
}
} // namespace

TEST(IncrementalMap, FacesFollowEveryChange)
{
  const shapeton::Graph    graph = shapeton::CompleteGraph(6);
  shapeton::IncrementalMap map(graph.nodes, graph.edges);
  unsigned int             state = 1;
  const auto               random = [&state](int n) {
    state = state * 1664525U + 1013904223U;
    return static_cast<int>((state >> 8) % n);
  };
  const auto corner = [&](int node) {
    int h = map.Any(node);
    for (int steps = map.Degree(node) > 0 ? random(map.Degree(node)) : 0; steps > 0; --steps)
    {
      h = map.NextAround(h);
    }
    return h;
  };
  for (int change = 0; change < 400; ++change)
  {
    const int e = random(15);
    if (map.Contains(e))
    {
      map.Remove(e);
    }
    else
    {
      const int a = corner(graph.edges[e][0]);
      map.Insert(e, a, corner(graph.edges[e][1]));
    }
    ExpectFacesOf(map, graph.edges);
  }
}

TEST(IncrementalMap, TakesAMapAsItIs)
{
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(4, 3);
  const shapeton::Graph            graph = torus.ToGraph();
  shapeton::IncrementalMap         map(torus);
  ExpectFacesOf(map, graph.edges);
  const int a = map.PreviousAround(10);
  const int b = map.PreviousAround(11);
  map.Remove(5);
  EXPECT_EQ(map.Faces(), 11);
  ExpectFacesOf(map, graph.edges);
  map.Insert(5, a, b);
  for (int h = 0; h < torus.HalfEdges(); ++h)
  {
    EXPECT_EQ(map.NextAround(h), torus.NextAround(h));
  }
}
