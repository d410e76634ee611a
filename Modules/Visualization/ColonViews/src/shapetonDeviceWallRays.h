#ifndef shapetonDeviceWallRays_h
#define shapetonDeviceWallRays_h

#include "shapetonWallRayArithmetic.h"

namespace shapeton
{
/** \class DeviceWallRays
 * \brief A CT in the memory of a GPU, and rays through it. */
class DeviceWallRays
{
public:
  DeviceWallRays() = default;
  DeviceWallRays(const DeviceWallRays &) = delete;
  DeviceWallRays &
  operator=(const DeviceWallRays &) = delete;
  virtual ~DeviceWallRays() = default;

  /** Three linear colours for each ray that is covered; the others are left as they are. */
  virtual void
  Cast(const WallRay * rays, std::size_t number, float * colors) = 0;
};

/** The type of the plug-in's function ShapetonMakeWallRays(). `volume` and `look` are in the memory of the host. */
using MakeDeviceWallRaysFunction = DeviceWallRays *(const WallVolume & volume, const WallLook & look);
} // namespace shapeton

#endif
