// Kernel launches only; the arithmetic is shared with the CPU.
#include "shapetonDeviceRays.h"
#include "shapetonDeviceRuntime.h"

namespace shapeton
{
namespace
{
using DeviceRuntime::Memory;
using DeviceRuntime::Uploaded;

struct Pixels
{
  RayVolume       volume;
  RayView         view;
  std::size_t     width;
  unsigned char * pixels;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t x, std::size_t y, std::size_t) const
  {
    RayArithmetic::ColorOfPixel(
      volume, view, static_cast<double>(x), static_cast<double>(y), pixels + 3 * (y * width + x));
  }
};

class RaysOnDevice : public DeviceRays
{
public:
  RaysOnDevice(const RayVolume & volume, std::size_t samples)
    : m_Volume(volume)
    , m_Samples(Uploaded(volume.samples, samples))
    , m_Lines(Uploaded(volume.lines, NumberOf(volume.size)))
    , m_SmoothOpacity(Uploaded(volume.smoothOpacity, NumberOf(volume.size)))
    , m_Content(Uploaded(volume.content, NumberOf(volume.blocks)))
  {
    m_Volume.samples = m_Samples.Get();
    m_Volume.lines = m_Lines.Get();
    m_Volume.smoothOpacity = m_SmoothOpacity.Get();
    m_Volume.content = m_Content.Get();
  }

  void
  Render(const RayView & view, std::size_t width, std::size_t height, unsigned char * pixels) const override
  {
    const Memory<unsigned char> memory(3 * width * height);
    DeviceRuntime::ForVoxels({ width, height, 1 }, Pixels{ m_Volume, view, width, memory.Get() });
    memory.Download(pixels);
  }

private:
  static std::size_t
  NumberOf(const int size[3])
  {
    return static_cast<std::size_t>(size[0]) * size[1] * size[2];
  }

  RayVolume             m_Volume;
  Memory<RaySample>     m_Samples;
  Memory<std::uint8_t>  m_Lines;
  Memory<std::uint16_t> m_SmoothOpacity;
  Memory<RayContent>    m_Content;
};
} // namespace

SHAPETON_DEVICE_FUNCTION DeviceRays *
ShapetonMakeRays(const RayVolume & volume, std::size_t samples)
{
  return new RaysOnDevice(volume, samples);
}
} // namespace shapeton
