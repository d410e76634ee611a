#ifndef shapetonPackedMapTests_h
#define shapetonPackedMapTests_h

#include "shapetonPackedMap.h"

#include <gtest/gtest.h>

#include <map>

namespace graphtest
{
/** Expects that the orders around the graph nodes without dummies are those of the map of the graph, except for the
 * placement of components. */
inline void
ExpectOrdersOf(const shapeton::PackedMap & packed, const shapeton::CombinatorialMap & map)
{
  ASSERT_EQ(packed.graphNodes, map.Nodes());
  ASSERT_EQ(packed.graphEdges, map.Edges());
  std::map<int, int> image; // a packed half-edge and the graph half-edge that it starts
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    image[h] = h;
  }
  for (const std::vector<int> & path : packed.subdivided)
  {
    image.erase(path.front() + 1);
  }
  for (const std::vector<int> & path : packed.subdivided) // the edges of the graph that run along dummies
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      EXPECT_EQ(packed.map.Node(path[i] ^ 1), packed.map.Node(path[i + 1]));
      EXPECT_GE(packed.map.Node(path[i + 1]), packed.graphNodes);
    }
    EXPECT_TRUE(image.emplace(path.back() ^ 1, path.front() + 1).second);
  }
  ASSERT_EQ(image.size(), static_cast<std::size_t>(map.HalfEdges()));
  for (const auto & [h, own] : image)
  {
    EXPECT_EQ(packed.map.Node(h), map.Node(own));
    int next = packed.map.NextAround(h);
    while (image.count(next) == 0)
    {
      next = packed.map.NextAround(next);
    }
    EXPECT_EQ(image.at(next), map.NextAround(own));
  }
}
} // namespace graphtest

#endif
