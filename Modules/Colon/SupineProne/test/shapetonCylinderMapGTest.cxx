#include "shapetonCylinderMap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double pi = 3.14159265358979323846;

/** A stretched, rotated map, bent in proportion to `bend`. */
shapeton::CylinderNodes
BentNodes(double bend)
{
  shapeton::CylinderNodes nodes;
  nodes.begin = 20.0;
  nodes.step = 4.0;
  nodes.s.resize(60, 24);
  nodes.turn.resize(60, 24);
  for (int i = 0; i < nodes.Rows(); ++i)
  {
    for (int j = 0; j < nodes.Angles(); ++j)
    {
      const double angle = 2.0 * pi * j / nodes.Angles();
      nodes.s(i, j) = 5.0 + 1.2 * i * nodes.step + bend * std::sin(angle + 0.05 * i);
      nodes.turn(i, j) = 0.3 + static_cast<double>(j) / nodes.Angles() + 0.01 * i + 0.02 * std::cos(angle);
    }
  }
  return nodes;
}
} // namespace

TEST(CylinderMap, NodesGoWhereTheySay)
{
  const shapeton::CylinderNodes nodes = BentNodes(6.0);
  const shapeton::CylinderMap   map(nodes);
  for (const auto & [row, angle] : { std::pair<int, int>{ 0, 0 }, { 17, 23 }, { 59, 5 } })
  {
    const shapeton::CylinderPlace to = map.Forward({ nodes.begin + row * nodes.step, angle / 24.0 });
    EXPECT_NEAR(to.s, nodes.s(row, angle), 1e-9);
    EXPECT_NEAR(shapeton::TurnDifference(to.turn, nodes.turn(row, angle)), 0.0, 1e-12);
  }
}

TEST(CylinderMap, InverseUndoesForward)
{
  const shapeton::CylinderMap map(BentNodes(6.0));
  ASSERT_EQ(map.Flips(), 0);
  for (int k = 0; k < 500; ++k)
  {
    // within, and beyond both ends
    const shapeton::CylinderPlace from{ -30.0 + 0.67 * k, std::fmod(0.137 * k, 1.0) };
    const auto                    back = map.Inverse(map.Forward(from));
    ASSERT_TRUE(back.has_value()) << from.s << ' ' << from.turn;
    EXPECT_NEAR(back->s, from.s, 1e-6);
    EXPECT_NEAR(shapeton::TurnDifference(back->turn, from.turn), 0.0, 1e-9);
  }
}

TEST(CylinderMap, APlaceAndOneTurnMoreGoTogether)
{
  const shapeton::CylinderMap   map(BentNodes(6.0));
  const shapeton::CylinderPlace once = map.Forward({ 100.0, 0.99 });
  const shapeton::CylinderPlace twice = map.Forward({ 100.0, 1.99 });
  EXPECT_NEAR(once.s, twice.s, 1e-9);
  EXPECT_NEAR(twice.turn - once.turn, 1.0, 1e-12);
}

TEST(CylinderMap, TrianglesTurnedOverAreCounted)
{
  shapeton::CylinderNodes nodes = BentNodes(0.0);
  nodes.s(30, 7) += 3.0 * nodes.step; // beyond the next row
  EXPECT_GT(shapeton::CylinderMap(nodes).Flips(), 0);
}

TEST(CylinderMap, TurnDifferenceIsThatOfTheShorterWay)
{
  EXPECT_NEAR(shapeton::TurnDifference(0.05, 0.95), 0.1, 1e-12);
  EXPECT_NEAR(shapeton::TurnDifference(-3.2, 0.9), -0.1, 1e-12);
}
