#ifndef shapetonDeviceRays_h
#define shapetonDeviceRays_h

#include "shapetonRayArithmetic.h"

namespace shapeton
{
/** \class DeviceRays
 * \brief A classified volume in GPU memory, and pictures of it. */
class DeviceRays
{
public:
  DeviceRays() = default;
  DeviceRays(const DeviceRays &) = delete;
  DeviceRays &
  operator=(const DeviceRays &) = delete;
  virtual ~DeviceRays() = default;

  /** `pixels`: three bytes each, row by row. */
  virtual void
  Render(const RayView & view, std::size_t width, std::size_t height, unsigned char * pixels) const = 0;
};

/** Type of the plug-in's function ShapetonMakeRays(). `volume` is in host memory. */
using MakeDeviceRaysFunction = DeviceRays *(const RayVolume & volume, std::size_t samples);
} // namespace shapeton

#endif
