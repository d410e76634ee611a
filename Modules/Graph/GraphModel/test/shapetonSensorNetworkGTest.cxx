#include "shapetonGraphGenus.h"
#include "shapetonSensorNetwork.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
/** Brute-force reference. */
std::vector<std::array<int, 2>>
AllLinks(const std::vector<std::array<double, 2>> & points, const std::vector<double> & reach, bool gabriel)
{
  const auto distance = [&](int a, int b) {
    return std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]);
  };
  const int                       n = static_cast<int>(points.size());
  std::vector<std::array<int, 2>> links;
  for (int a = 0; a < n; ++a)
  {
    for (int b = a + 1; b < n; ++b)
    {
      bool link = distance(a, b) <= std::min(reach[a], reach[b]);
      for (int c = 0; c < n && gabriel && link; ++c)
      {
        const double x = points[c][0] - 0.5 * (points[a][0] + points[b][0]);
        const double y = points[c][1] - 0.5 * (points[a][1] + points[b][1]);
        link = c == a || c == b || std::hypot(x, y) > 0.5 * distance(a, b);
      }
      if (link)
      {
        links.push_back({ a, b });
      }
    }
  }
  return links;
}
} // namespace

TEST(SensorNetwork, LinksAreThoseOfBruteForce)
{
  shapeton::SensorNetworkOptions options;
  options.nodes = 150;
  const shapeton::SensorNetwork      network(options);
  std::vector<std::array<double, 2>> points;
  std::vector<double>                reach;
  for (const shapeton::SensorDevice & device : network.GetDevices())
  {
    points.push_back({ device.x, device.y });
    reach.push_back(200.0 * device.power);
  }
  EXPECT_EQ(shapeton::LinksBetween(points, reach, false), AllLinks(points, reach, false));
  EXPECT_EQ(shapeton::LinksBetween(points, reach, true), AllLinks(points, reach, true));
  EXPECT_EQ(shapeton::LinksBetween({ { 5.0, 5.0 } }, { 1.0 }, true).size(), 0U);
  EXPECT_EQ(shapeton::LinksBetween({ { 5.0, 5.0 }, { 5.0, 5.0 } }, { 1.0, 1.0 }, true).size(), 1U);
  EXPECT_TRUE(shapeton::LinksBetween({}, {}, false).empty());
}

TEST(SensorNetwork, GabrielGraphsArePlanarAndUnitDiskGraphsAreNot)
{
  shapeton::SensorNetworkOptions options;
  shapeton::CombinatorialMap     map;
  EXPECT_TRUE(shapeton::FindPlanarEmbedding(shapeton::SensorNetwork(options).GetGraph(), map));
  options.planar = shapeton::PlanarSubgraph::None;
  EXPECT_FALSE(shapeton::FindPlanarEmbedding(shapeton::SensorNetwork(options).GetGraph(), map));
}

TEST(SensorNetwork, DevicesMoveLeaveAndComeBack)
{
  shapeton::SensorNetworkOptions options;
  options.speed = 20.0;
  shapeton::SensorNetwork network(options);
  std::set<int>           gone;
  bool                    anyReturned = false;
  for (int step = 0; step < 120; ++step)
  {
    const std::vector<shapeton::SensorDevice> before = network.GetDevices();
    network.Advance();
    for (int i = 0; i < options.nodes; ++i)
    {
      const shapeton::SensorDevice & device = network.GetDevices()[i];
      EXPECT_LE(std::hypot(device.x - before[i].x, device.y - before[i].y), 2.0 * options.speed + 1e-9);
      EXPECT_GE(device.x, -0.1 * shapeton::SensorNetwork::side);
      EXPECT_LE(device.y, 1.1 * shapeton::SensorNetwork::side);
      EXPECT_GT(device.power, 0.0);
      EXPECT_LE(device.power, 1.0);
      anyReturned = anyReturned || (device.inNetwork && gone.count(i) > 0);
      if (!device.inNetwork)
      {
        gone.insert(i);
      }
    }
  }
  EXPECT_GT(gone.size(), 20U);
  EXPECT_TRUE(anyReturned);
}

TEST(SensorNetwork, SameSeedSameNetwork)
{
  shapeton::SensorNetworkOptions options;
  shapeton::SensorNetwork        a(options);
  shapeton::SensorNetwork        b(options);
  a.Advance();
  b.Advance();
  EXPECT_EQ(a.GetGraph().edges, b.GetGraph().edges);
  EXPECT_EQ(a.GetGraph().names[3], "d00003");
  options.seed = 2;
  EXPECT_NE(shapeton::SensorNetwork(options).GetDevices()[0].x, a.GetDevices()[0].x);
  options.range = 0.0;
  EXPECT_THROW(shapeton::SensorNetwork network(options), shapeton::ParameterError);
}
