#ifndef shapetonDeviceWallRays_h
#define shapetonDeviceWallRays_h

#include "shapetonWallRayArithmetic.h"

namespace shapeton
{
/** \class DeviceWallRays
 * \brief A CT in GPU memory, and rays through it. */
class DeviceWallRays
{
public:
  DeviceWallRays() = default;
  DeviceWallRays(const DeviceWallRays &) = delete;
  DeviceWallRays &
  operator=(const DeviceWallRays &) = delete;
  virtual ~DeviceWallRays() = default;

  /** Computes three linear color components for each covered ray; the others are unchanged. */
  virtual void
  Cast(const WallRay * rays, std::size_t number, float * colors) = 0;
};

/** Type of the plug-in's function ShapetonMakeWallRays(). `volume` and `look` are in host memory. */
using MakeDeviceWallRaysFunction = DeviceWallRays *(const WallVolume & volume, const WallLook & look);
} // namespace shapeton

#endif
