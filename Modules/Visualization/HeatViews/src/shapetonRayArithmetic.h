#ifndef shapetonRayArithmetic_h
#define shapetonRayArithmetic_h

#include "shapetonHostDevice.h"
#include "shapetonLighting.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace shapeton
{
/** Color premultiplied by opacity, and opacity, all in [0, 1]. */
struct RaySample
{
  float channel[4];
};

/** Content of the neighborhood of a position, precomputed to skip voxel access. */
enum class RayContent : std::uint8_t
{
  Transparent,
  Mixed,
  /** A single line in the whole neighborhood; the gradient is 0. */
  Uniform
};

/** Edge length of a block of voxels with one RayContent. */
constexpr int RayBlockSize = 8;
/** Integer value of smoothed opacity 1. */
constexpr float FullOpacity = 65535.0F;

/** A ClassifiedVolume as raw arrays for the ray caster. */
struct RayVolume
{
  int                   size[3];
  int                   blocks[3];
  const RaySample *     samples;       ///< for "no line" and for each line
  const std::uint8_t *  lines;         ///< per voxel, 0: none, else the line's index + 1
  const std::uint16_t * smoothOpacity; ///< per voxel
  const RayContent *    content;       ///< per block
};

/** Geometry of a picture's rays in a volume: lengths in mm, in patient space, and in voxels, in index space. */
struct RayView
{
  // The picture plane.
  double center[3];
  double right[3];
  double up[3];
  double millimetersPerPixel;
  double middleX;
  double middleY;
  // The volume.
  double inverse[3][3]; ///< inverse of the direction cosines
  double spacing[3];
  double first[3]; ///< first voxel
  // The light, and the sampling along a ray.
  double        step[3]; ///< between two samples, in voxels
  double        toLight[3];
  double        halfway[3];
  unsigned char background[3];
};

/** Computes the color of a pixel; shared by the CPU and the GPU kernels.
 * Positions are continuous indices relative to the first voxel. */
namespace RayArithmetic
{
using HostDevice::Larger;
using HostDevice::Product;
using HostDevice::Smaller;

/** The coordinate clamped to the voxel centers. */
SHAPETON_HOST_DEVICE double
Within(double coordinate, int size)
{
  return Smaller(Larger(coordinate, 0.0), size - 1.0);
}

SHAPETON_HOST_DEVICE std::size_t
                     VoxelIndex(const RayVolume & volume, int x, int y, int z)
{
  return (static_cast<std::size_t>(z) * volume.size[1] + y) * volume.size[0] + x;
}

SHAPETON_HOST_DEVICE RayContent
ContentAt(const RayVolume & volume, const double position[3])
{
  int block[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    block[axis] = static_cast<int>(Within(position[axis], volume.size[axis])) / RayBlockSize;
  }
  return volume
    .content[(static_cast<std::size_t>(block[2]) * volume.blocks[1] + block[1]) * volume.blocks[0] + block[0]];
}

/** The two voxels around a coordinate, identical at the border, and the weight of the second one. */
struct Neighbors
{
  int   first;
  int   second;
  float share;
};

SHAPETON_HOST_DEVICE Neighbors
NeighborsOf(double coordinate, int size)
{
  const double within = Within(coordinate, size);
  const int    first = static_cast<int>(within);
  return { first, Smaller(first + 1, size - 1), static_cast<float>(within - first) };
}

/** Color and opacity in uniform content. */
SHAPETON_HOST_DEVICE RaySample
UniformSampleAt(const RayVolume & volume, const double position[3])
{
  int index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = static_cast<int>(Within(position[axis], volume.size[axis]));
  }
  return volume.samples[volume.lines[VoxelIndex(volume, index[0], index[1], index[2])]];
}

/** Color and opacity between voxels. At the border of an object, opacity is interpolated to one half; the slope is
 * doubled to preserve the size of the object. */
SHAPETON_HOST_DEVICE RaySample
SampleAt(const RayVolume & volume, const double position[3])
{
  const Neighbors x = NeighborsOf(position[0], volume.size[0]);
  const Neighbors y = NeighborsOf(position[1], volume.size[1]);
  const Neighbors z = NeighborsOf(position[2], volume.size[2]);
  RaySample       sum{};
  float           covered = 0.0F;
  for (int corner = 0; corner < 8; ++corner)
  {
    const bool        isSecond[3] = { (corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0 };
    const float       ofRow = (isSecond[1] ? y.share : 1.0F - y.share) * (isSecond[2] ? z.share : 1.0F - z.share);
    const float       weight = ofRow * (isSecond[0] ? x.share : 1.0F - x.share);
    const std::size_t voxel = VoxelIndex(
      volume, isSecond[0] ? x.second : x.first, isSecond[1] ? y.second : y.first, isSecond[2] ? z.second : z.first);
    const RaySample & sample = volume.samples[volume.lines[voxel]];
    if (sample.channel[3] > 0.0F)
    {
      covered += weight;
      for (int channel = 0; channel < 4; ++channel)
      {
        sum.channel[channel] += weight * sample.channel[channel];
      }
    }
  }
  const float factor = covered > 0.0F ? Smaller(Larger(2.0F * covered - 0.5F, 0.0F), 1.0F) / covered : 0.0F;
  for (float & channel : sum.channel)
  {
    channel *= factor;
  }
  return sum;
}

SHAPETON_HOST_DEVICE float
SmoothOpacityAt(const RayVolume & volume, const int index[3])
{
  return volume.smoothOpacity[VoxelIndex(volume, index[0], index[1], index[2])] / FullOpacity;
}

struct Gradient
{
  float along[3];
};

/** Gradient of the smoothed opacity, per voxel along each axis. */
SHAPETON_HOST_DEVICE Gradient
GradientAt(const RayVolume & volume, const double position[3])
{
  const Neighbors near[3] = { NeighborsOf(position[0], volume.size[0]),
                              NeighborsOf(position[1], volume.size[1]),
                              NeighborsOf(position[2], volume.size[2]) };
  Gradient        gradient{};
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    int   index[3];
    float weight = 1.0F;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const bool isSecond = (corner >> axis) & 1U;
      index[axis] = isSecond ? near[axis].second : near[axis].first;
      weight *= isSecond ? near[axis].share : 1.0F - near[axis].share;
    }
    if (weight == 0.0F)
    {
      continue;
    }
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      int before[3] = { index[0], index[1], index[2] };
      int after[3] = { index[0], index[1], index[2] };
      before[axis] = Larger(index[axis] - 1, 0);
      after[axis] = Smaller(index[axis] + 1, volume.size[axis] - 1);
      const float rise = SmoothOpacityAt(volume, after) - SmoothOpacityAt(volume, before);
      gradient.along[axis] += 0.5F * weight * rise;
    }
  }
  return gradient;
}

/** Index-space components of a physical vector. */
SHAPETON_HOST_DEVICE void
ToIndexVector(const RayView & view, const double physical[3], double index[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = Product(view.inverse[axis], physical) / view.spacing[axis];
  }
}

/** Intersection of a pixel's ray with the picture plane, as a continuous index. */
SHAPETON_HOST_DEVICE void
StartOfRay(const RayView & view, double x, double y, double start[3])
{
  const double toRight = (x - view.middleX) * view.millimetersPerPixel;
  const double upwards = (view.middleY - y) * view.millimetersPerPixel;
  double       fromFirst[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    fromFirst[axis] = ((view.center[axis] + view.right[axis] * toRight) + view.up[axis] * upwards) - view.first[axis];
  }
  ToIndexVector(view, fromFirst, start);
}

/** Range of samples for which the ray is inside the volume, whose voxels extend half a voxel beyond their centers. */
SHAPETON_HOST_DEVICE bool
Clip(const RayVolume & volume, const RayView & view, const double start[3], double & first, double & last)
{
  constexpr double greatest = 1.7976931348623157e308;
  first = -greatest;
  last = greatest;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double lower = -0.5 - start[axis];
    const double upper = volume.size[axis] - 0.5 - start[axis];
    if (view.step[axis] == 0.0)
    {
      if (lower > 0.0 || upper < 0.0)
      {
        return false;
      }
      continue;
    }
    const double a = lower / view.step[axis];
    const double b = upper / view.step[axis];
    first = Larger(first, Smaller(a, b));
    last = Smaller(last, Larger(a, b));
  }
  return first <= last;
}

SHAPETON_HOST_DEVICE Lighting
LightAt(const RayView & view, const Gradient & perVoxel)
{
  double perMillimeter[3];
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    perMillimeter[axis] = perVoxel.along[axis] / view.spacing[axis];
  }
  // Inverse transpose: direction cosines need not be exactly orthogonal.
  double gradient[3];
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    gradient[axis] = view.inverse[0][axis] * perMillimeter[0] + view.inverse[1][axis] * perMillimeter[1] +
                     view.inverse[2][axis] * perMillimeter[2];
  }
  constexpr double flat = 1e-4; // per mm; a smaller gradient does not give a direction
  const double     length = sqrt(Product(gradient, gradient));
  if (length < flat)
  {
    return Lighting::Even();
  }
  // Two-sided lighting.
  return Lighting::Of(static_cast<float>(fabs(Product(gradient, view.toLight)) / length),
                      static_cast<float>(fabs(Product(gradient, view.halfway)) / length));
}

/** Composites a sample behind the previous ones of the ray; `visible` is their transmittance. \equation{1.3} */
SHAPETON_HOST_DEVICE void
Accumulate(const RayVolume & volume,
           const RayView &   view,
           const double      position[3],
           bool              isUniform,
           float             color[3],
           float &           visible)
{
  const RaySample whole = isUniform ? UniformSampleAt(volume, position) : SampleAt(volume, position);
  const float *   sample = whole.channel;
  if (sample[3] <= 0.0F)
  {
    return;
  }
  const Gradient perVoxel = isUniform ? Gradient{} : GradientAt(volume, position);
  const float *  g = perVoxel.along;
  const float    steepness = Smaller(4.0F * sqrtf(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]), 1.0F);
  // Opaque objects are opaque throughout; transparent objects are drawn mainly at their surface.
  const float    power2 = sample[3] * sample[3];
  const float    inside = power2 * power2;
  const float    opacity = sample[3] * (inside + (1.0F - inside) * Smaller(steepness / sample[3], 1.0F));
  const float    ofSample = visible * (1.0F - sqrtf(1.0F - Smaller(opacity, 1.0F)));
  const Lighting light = LightAt(view, perVoxel);
  for (unsigned int channel = 0; channel < 3; ++channel)
  {
    color[channel] += ofSample * Smaller(light.brightness * sample[channel] / sample[3] + light.highlight, 1.0F);
  }
  visible -= ofSample;
}

/** Color of a pixel. */
SHAPETON_HOST_DEVICE void
ColorOfPixel(const RayVolume & volume, const RayView & view, double x, double y, unsigned char seen[3])
{
  constexpr float hidden = 0.004F; // transmittance at which a ray ends: about one of 255 gray levels
  double          start[3];
  double          first = 0.0;
  double          last = 0.0;
  StartOfRay(view, x, y, start);
  float color[3] = { 0.0F, 0.0F, 0.0F };
  float visible = 1.0F;
  if (Clip(volume, view, start, first, last))
  {
    // Integer sample numbers, counted from the picture plane, so adjacent rays sample the same planes.
    for (double t = ceil(first); t <= last && visible > hidden; t += 1.0)
    {
      const double position[3] = { start[0] + t * view.step[0],
                                   start[1] + t * view.step[1],
                                   start[2] + t * view.step[2] };
      const auto   content = ContentAt(volume, position);
      if (content != RayContent::Transparent)
      {
        Accumulate(volume, view, position, content == RayContent::Uniform, color, visible);
      }
    }
  }
  for (unsigned int channel = 0; channel < 3; ++channel)
  {
    const float value = 255.0F * color[channel] + visible * view.background[channel];
    seen[channel] = static_cast<unsigned char>(Smaller(value + 0.5F, 255.0F));
  }
}
} // namespace RayArithmetic
} // namespace shapeton

#endif
