// Kernel launches only; the arithmetic is shared with the CPU.
#include "shapetonDeviceWallRays.h"
#include "shapetonDeviceRuntime.h"

namespace shapeton
{
namespace
{
using DeviceRuntime::Memory;
using DeviceRuntime::Uploaded;

struct Rays
{
  WallVolume      volume;
  WallLook        look;
  const WallRay * rays;
  float *         colors;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t i) const
  {
    if (rays[i].isCovered != 0)
    {
      WallRayArithmetic::ColorOfRay(volume, look, rays[i], colors + 3 * i);
    }
  }
};

class WallRaysOnDevice : public DeviceWallRays
{
public:
  WallRaysOnDevice(const WallVolume & volume, const WallLook & look)
    : m_Volume(volume)
    , m_Look(look)
    , m_Voxels(Uploaded(volume.voxels, static_cast<std::size_t>(volume.size[0]) * volume.size[1] * volume.size[2]))
    , m_Opacities(Uploaded(look.opacities, WallLook::numberOfOpacities + 1))
    , m_Colors(Uploaded(look.colors, 3 * WallLook::numberOfColors))
  {
    m_Volume.voxels = m_Voxels.Get();
    m_Look.opacities = m_Opacities.Get();
    m_Look.colors = m_Colors.Get();
  }

  void
  Cast(const WallRay * rays, std::size_t number, float * colors) override
  {
    if (m_Rays.GetNumber() != number)
    {
      m_Rays = Memory<WallRay>(number);
      m_Seen = Memory<float>(3 * number);
    }
    m_Rays.Upload(rays);
    DeviceRuntime::ForEach(number, Rays{ m_Volume, m_Look, m_Rays.Get(), m_Seen.Get() });
    m_Seen.Download(colors);
  }

private:
  WallVolume      m_Volume;
  WallLook        m_Look;
  Memory<float>   m_Voxels;
  Memory<float>   m_Opacities;
  Memory<float>   m_Colors;
  Memory<WallRay> m_Rays;
  Memory<float>   m_Seen;
};
} // namespace

SHAPETON_DEVICE_FUNCTION DeviceWallRays *
ShapetonMakeWallRays(const WallVolume & volume, const WallLook & look)
{
  return new WallRaysOnDevice(volume, look);
}
} // namespace shapeton
