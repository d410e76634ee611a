#ifndef shapetonSensorNetwork_h
#define shapetonSensorNetwork_h

#include "SensorNetworkExport.h"
#include "shapetonGraph.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Which links between devices become edges. \ingroup SensorNetwork */
enum class PlanarSubgraph
{
  None,   ///< all links: a unit-disk graph, which is not planar
  Gabriel ///< links whose disk, that with the link as diameter, holds no other device of the network; planar
};

/** Number, reach and motion of the devices of a SensorNetwork. \ingroup SensorNetwork */
struct SensorNetworkOptions
{
  int           devices{ 200 };
  std::uint64_t seed{ 1 };
  /** Reach of a device at full power, m; > 0. */
  double range{ 120.0 };
  /** The area is a square with this side, m. */
  double side{ 1000.0 };
  /** Mean way of a device in a step, m. */
  double         speed{ 4.0 };
  PlanarSubgraph planar{ PlanarSubgraph::Gabriel };
};

/** A device at one time. \ingroup SensorNetwork */
struct SensorDevice
{
  double x{ 0.0 }; ///< m
  double y{ 0.0 }; ///< m
  /** Charge of the battery in [0, 1]; the reach is range * sqrt(power). */
  double power{ 1.0 };
  /** Within the area and with charge enough to send. */
  bool inNetwork{ true };
};

/** \class SensorNetwork
 * \brief Devices that move, run low and charge again, leave an area and come back (section 6.7).
 *
 * Each device walks straight on and turns a little at random; it may leave the area by a tenth of its side before it
 * turns around, and is not in the network meanwhile. Sending costs charge; a device whose charge is below a tenth is
 * out of the network until it is charged to one half. Two devices have a link when each one reaches the other.
 *
 * Same options, same network, step by step. \ingroup SensorNetwork */
class SensorNetwork_EXPORT SensorNetwork
{
public:
  /** At step 0. Throws ParameterError for an option out of range. */
  explicit SensorNetwork(const SensorNetworkOptions & options);

  /** Moves all devices by one step. */
  void
  Advance();

  const std::vector<SensorDevice> &
  GetDevices() const
  {
    return m_Devices;
  }

  /** "d00017" for device 17. */
  static std::string
  NameOfDevice(int device);

  /** The nodes are the devices in the network, by their names. */
  Graph
  GetGraph() const;

private:
  SensorNetworkOptions      m_Options;
  std::uint32_t             m_Step{ 0 };
  std::vector<SensorDevice> m_Devices;
  std::vector<double>       m_Direction; // radians
  std::vector<double>       m_Drain;     // of the charge, in a step
  std::vector<bool>         m_IsCharging;
};

/** The links between points whose reaches are at least their distance, ascending pairs; with `gabriel` only those whose
 * disk holds no other point. \ingroup SensorNetwork */
SensorNetwork_EXPORT std::vector<std::array<int, 2>>
LinksBetween(const std::vector<std::array<double, 2>> & points, const std::vector<double> & reach, bool gabriel);
} // namespace shapeton

#endif
