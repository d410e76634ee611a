#include "shapetonSensorNetwork.h"

#include "shapetonPhilox.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"

#include <cmath>
#include <cstdio>

namespace shapeton
{
namespace
{
constexpr std::uint32_t startPurpose = 0x5E4501; // of the random numbers: first places
constexpr std::uint32_t stepPurpose = 0x5E4502;  // of the random numbers: moves
// Turning margin beyond the area, as a fraction of its side.
constexpr double margin = 0.1;
// Mean charge lost per step in the network, and charge gained per step when charging.
constexpr double meanDrain = 0.01;
constexpr double chargeOfStep = 0.05;
constexpr double leastPower = 0.1;
constexpr double powerToReturn = 0.5;
constexpr double greatestTurn = 0.3; // radians per step, in both directions

double
Unit(std::uint32_t word)
{
  constexpr double values = 4294967296.0; // 2^32
  return word * (1.0 / values);
}

/** Reflects a coordinate beyond the margin. Returns whether it was reflected. */
bool
Reflect(double & x, double side)
{
  const double low = -margin * side;
  const double high = (1.0 + margin) * side;
  if (x >= low && x <= high)
  {
    return false;
  }
  x = x < low ? 2.0 * low - x : 2.0 * high - x;
  return true;
}

bool
IsInside(const SensorDevice & device, double side)
{
  return device.x >= 0.0 && device.x <= side && device.y >= 0.0 && device.y <= side;
}
} // namespace

SensorNetwork::SensorNetwork(const SensorNetworkOptions & options)
  : m_Options(options), m_Devices(std::max(0, options.nodes)), m_IsCharging(m_Devices.size(), false)
{
  CheckOptions(options);
  for (std::uint32_t i = 0; i < m_Devices.size(); ++i)
  {
    const auto words = Philox4x32(options.seed, { i, 0, 0, startPurpose });
    const auto more = Philox4x32(options.seed, { i, 1, 0, startPurpose });
    m_Devices[i].x = side * Unit(words.a);
    m_Devices[i].y = side * Unit(words.b);
    m_Devices[i].power = powerToReturn + (1.0 - powerToReturn) * Unit(words.c);
    m_Direction.push_back(TwoPi * Unit(words.d));
    m_Drain.push_back(2.0 * meanDrain * Unit(more.a));
  }
}

void
SensorNetwork::Advance()
{
  ++m_Step;
  for (std::uint32_t i = 0; i < m_Devices.size(); ++i)
  {
    SensorDevice & device = m_Devices[i];
    const auto     words = Philox4x32(m_Options.seed, { i, m_Step, 0, stepPurpose });
    m_Direction[i] += greatestTurn * (2.0 * Unit(words.a) - 1.0);
    const double way = 2.0 * m_Options.speed * Unit(words.b);
    device.x += way * std::cos(m_Direction[i]);
    device.y += way * std::sin(m_Direction[i]);
    if (Reflect(device.x, side))
    {
      m_Direction[i] = Pi - m_Direction[i];
    }
    if (Reflect(device.y, side))
    {
      m_Direction[i] = -m_Direction[i];
    }
    device.power += m_IsCharging[i] ? chargeOfStep : device.inNetwork ? -m_Drain[i] : 0.0;
    m_IsCharging[i] = device.power < (m_IsCharging[i] ? powerToReturn : leastPower);
    device.inNetwork = IsInside(device, side) && !m_IsCharging[i];
  }
}

std::string
SensorNetwork::NameOfDevice(int device)
{
  char text[16];
  std::snprintf(text, sizeof(text), "d%05d", device);
  return text;
}

Graph
SensorNetwork::GetGraph() const
{
  Graph                              graph;
  std::vector<std::array<double, 2>> points;
  std::vector<double>                reach;
  for (std::size_t i = 0; i < m_Devices.size(); ++i)
  {
    if (m_Devices[i].inNetwork)
    {
      graph.names.push_back(NameOfDevice(static_cast<int>(i)));
      points.push_back({ m_Devices[i].x, m_Devices[i].y });
      reach.push_back(m_Options.range * std::sqrt(m_Devices[i].power));
    }
  }
  graph.nodes = static_cast<int>(points.size());
  graph.edges = LinksBetween(points, reach, m_Options.planar == PlanarSubgraph::Gabriel);
  return graph;
}
} // namespace shapeton
