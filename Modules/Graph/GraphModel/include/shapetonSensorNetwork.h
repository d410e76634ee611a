#ifndef shapetonSensorNetwork_h
#define shapetonSensorNetwork_h

#include "ShapetonGraphModelExport.h"
#include "shapetonGraph.h"
#include "shapetonSensorNetworkOptions.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** State of a device at one step. \ingroup ShapetonGraphModel */
struct SensorDevice
{
  double x{ 0.0 }; ///< m
  double y{ 0.0 }; ///< m
  /** Battery charge in [0, 1]; the current range is range * sqrt(power). */
  double power{ 1.0 };
  /** Whether the device is within the area and has enough charge to send. */
  bool inNetwork{ true };
};

/** \class SensorNetwork
 * \brief A network of moving devices with batteries that may leave the area and return (section 6.7).
 *
 * Each device moves nearly in a straight line, with small random turns. It may leave the area by up to a tenth of the
 * side before turning around; outside, it is not in the network. Sending consumes charge. A device below a tenth of its
 * charge leaves the network until it is half charged. Two devices are linked if both are in range of each other.
 *
 * The simulation is deterministic for given options. \ingroup ShapetonGraphModel */
class ShapetonGraphModel_EXPORT SensorNetwork
{
public:
  /** Side of the square area (m). */
  static constexpr double side = 1000.0;

  /** Starts at step 0. Throws ParameterError if an option is out of range. */
  explicit SensorNetwork(const SensorNetworkOptions & options);

  /** Moves all devices by one step. */
  void
  Advance();

  const std::vector<SensorDevice> &
  GetDevices() const
  {
    return m_Devices;
  }

  /** Name of a device: "d00017" for device 17. */
  static std::string
  NameOfDevice(int device);

  /** Graph of the step, with one named node per device in the network. */
  Graph
  GetGraph() const;

private:
  SensorNetworkOptions      m_Options;
  std::uint32_t             m_Step{ 0 };
  std::vector<SensorDevice> m_Devices;
  std::vector<double>       m_Direction; // radians
  std::vector<double>       m_Drain;     // charge lost per step
  std::vector<bool>         m_IsCharging;
};

/** Links between points within each other's range, as ascending pairs. With `gabriel`, a link is kept only if its
 * diametral disk contains no other point. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<std::array<int, 2>>
LinksBetween(const std::vector<std::array<double, 2>> & points, const std::vector<double> & reach, bool gabriel);
} // namespace shapeton

#endif
