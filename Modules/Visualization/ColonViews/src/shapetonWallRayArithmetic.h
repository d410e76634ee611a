#ifndef shapetonWallRayArithmetic_h
#define shapetonWallRayArithmetic_h

#include "shapetonFlatLight.h"

#include <cmath>
#include <cstddef>

namespace shapeton
{
/** A CT interpolated between its voxels. Positions in space are continuous indices; a step along a ray is a vector. */
struct WallVolume
{
  const float *  voxels;
  int            size[3];
  std::ptrdiff_t stride[3];
  double         first[3];        ///< center of the first voxel, LPS, mm
  double         toIndex[3][3];   ///< maps a vector in space to index space
  double         indexPerMm[3];   ///< maximum change of each index per mm
  double         smallestSpacing; ///< mm
};

/** Rendering parameters of the rays. Hounsfield units and mm. */
struct WallLook
{
  static constexpr int numberOfOpacities = 4096; // of the table; chosen
  static constexpr int numberOfColors = 512;     // of the table; chosen

  double        gas;
  double        tissue;
  double        step;   ///< distance between two samples
  double        reach;  ///< maximum distance of samples from the surface
  int           inside; ///< maximum number of steps into the lumen
  int           outside;
  double        stepsBehind; ///< where the color of the boundary is sampled
  const float * opacities;   ///< per sample, from gas to tissue; the last one is repeated
  float         darkest;     ///< intensity of the first color
  float         colorStep;
  const float * colors; ///< linear red, green, blue
  float         nothing[3];
};

/** The surface point and ray of a pixel. */
struct WallRay
{
  double   point[3];  ///< surface point
  double   normal[3]; ///< into the lumen
  FlatAxes axes;
  int      isCovered; ///< 0 if there is no surface
};

/** Computes the color of a pixel; shared by the CPU and the GPU kernels. */
namespace WallRayArithmetic
{
using HostDevice::Larger;
using HostDevice::Product;
using HostDevice::Smaller;

struct Place
{
  double index[3];
};

SHAPETON_HOST_DEVICE Place
Moved(const Place & place, double steps, const Place & step)
{
  return { { place.index[0] + steps * step.index[0],
             place.index[1] + steps * step.index[1],
             place.index[2] + steps * step.index[2] } };
}

/** Index-space vector of a vector in space. */
SHAPETON_HOST_DEVICE Place
IndexOfVector(const WallVolume & volume, const double vector[3])
{
  return {
    { Product(volume.toIndex[0], vector), Product(volume.toIndex[1], vector), Product(volume.toIndex[2], vector) }
  };
}

/** Continuous index of a point; (0, 0, 0) is the center of the first voxel. */
SHAPETON_HOST_DEVICE Place
IndexOf(const WallVolume & volume, const double point[3])
{
  const double fromFirst[] = { point[0] - volume.first[0], point[1] - volume.first[1], point[2] - volume.first[2] };
  return IndexOfVector(volume, fromFirst);
}

/** Whether a position is within this number of voxels of a voxel center. */
SHAPETON_HOST_DEVICE bool
Holds(const WallVolume & volume, const Place & place, double reach)
{
  bool holds = true;
  for (int k = 0; k < 3; ++k)
  {
    holds = holds && place.index[k] >= -reach && place.index[k] <= volume.size[k] - 1 + reach;
  }
  return holds;
}

/** Whether a ball of `radius` mm is inside the grid of voxel centers. */
SHAPETON_HOST_DEVICE bool
HoldsBall(const WallVolume & volume, const Place & middle, double radius)
{
  bool holds = true;
  for (int k = 0; k < 3; ++k)
  {
    const double margin = radius * volume.indexPerMm[k];
    holds = holds && middle.index[k] - margin >= 0.0 && middle.index[k] + margin < volume.size[k] - 1.0;
  }
  return holds;
}

/** Trilinear intensity, clamped at the border; with VIsInside the position must be inside the grid of voxel centers. */
template <bool VIsInside>
SHAPETON_HOST_DEVICE float
ValueAt(const WallVolume & volume, const Place & place)
{
  const float *  corner = volume.voxels;
  double         share[3];
  std::ptrdiff_t next[3]; // offsets to the upper neighbors; 0 at the last voxels
  for (int k = 0; k < 3; ++k)
  {
    const double within = VIsInside ? place.index[k] : Smaller(Larger(place.index[k], 0.0), volume.size[k] - 1.0);
    const int    voxel = static_cast<int>(within);
    share[k] = within - voxel;
    next[k] = VIsInside || voxel + 1 < volume.size[k] ? volume.stride[k] : 0;
    corner += voxel * volume.stride[k];
  }
  double alongX[4];
  for (int k = 0; k < 4; ++k)
  {
    const float * const from = corner + (k & 1) * next[1] + (k >> 1) * next[2];
    alongX[k] = from[0] + (static_cast<double>(from[next[0]]) - from[0]) * share[0];
  }
  const double low = alongX[0] + (alongX[1] - alongX[0]) * share[1];
  const double high = alongX[2] + (alongX[3] - alongX[2]) * share[1];
  return static_cast<float>(low + (high - low) * share[2]);
}

/** Opacity of a sample; 0 for NaN. */
SHAPETON_HOST_DEVICE float
OpacityOf(const WallLook & look, float hu)
{
  if (!(hu > look.gas))
  {
    return 0.0F;
  }
  const double share = Smaller((hu - look.gas) / (look.tissue - look.gas), 1.0);
  const double place = share * (WallLook::numberOfOpacities - 1);
  const int    before = static_cast<int>(place);
  const float  low = look.opacities[before];
  return low + static_cast<float>(place - before) * (look.opacities[before + 1] - low);
}

SHAPETON_HOST_DEVICE const float *
ColorOf(const WallLook & look, float hu)
{
  const int color = static_cast<int>((hu - look.darkest) / look.colorStep);
  return look.colors + 3 * Smaller(Larger(color, 0), WallLook::numberOfColors - 1);
}

/** Lighting by the negative gradient, which points to the gas, or by the surface normal where the CT is uniform.
 * Central differences over the smallest spacing along each axis of the volume. */
template <bool VIsInside>
SHAPETON_HOST_DEVICE FlatLight
LightAt(const WallVolume & volume, const Place & place, const WallRay & ray)
{
  constexpr double weak = 60.0; // HU per mm, above the noise of a smooth region
  double           perIndex[3];
  for (int k = 0; k < 3; ++k)
  {
    const double step = volume.smallestSpacing * volume.indexPerMm[k];
    Place        before = place;
    Place        after = place;
    before.index[k] -= step;
    after.index[k] += step;
    perIndex[k] = (ValueAt<VIsInside>(volume, after) - ValueAt<VIsInside>(volume, before)) / (2.0 * step);
  }
  double normal[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double perMm = volume.toIndex[0][axis] * perIndex[0] + volume.toIndex[1][axis] * perIndex[1] +
                         volume.toIndex[2][axis] * perIndex[2];
    normal[axis] = weak * ray.normal[axis] - perMm;
  }
  const double length = sqrt(Product(normal, normal));
  for (int axis = 0; axis < 3; ++axis)
  {
    normal[axis] = length > 0.0 ? normal[axis] / length : ray.normal[axis];
  }
  return FlatLight::On(normal, ray.axes);
}

/** Farthest step into the lumen with a visible sample and no tissue between it and the surface. */
template <bool VIsInside>
SHAPETON_HOST_DEVICE int
FirstStep(const WallVolume & volume, const WallLook & look, const Place & surface, const Place & outwards)
{
  const auto boundary = static_cast<float>(0.5 * (look.gas + look.tissue));
  bool       wasGas = false;
  int        first = 0;
  for (int step = -1; step >= -look.inside; --step)
  {
    const float hu = ValueAt<VIsInside>(volume, Moved(surface, step, outwards));
    const bool  isGas = hu < boundary;
    if (wasGas && !isGas)
    {
      break; // opposite side of a fold or of the lumen
    }
    wasGas = isGas;
    first = hu > look.gas ? step : first;
  }
  return first;
}

template <bool VIsInside>
SHAPETON_HOST_DEVICE void
Cast(const WallVolume & volume, const WallLook & look, const WallRay & ray, const Place & surface, float color[3])
{
  constexpr float faint = 0.12F;  // small contribution: reuses the lighting of the previous sample
  constexpr float hidden = 0.01F; // transmittance at which a ray ends
  const double    wayOut[] = { -look.step * ray.normal[0], -look.step * ray.normal[1], -look.step * ray.normal[2] };
  const Place     outwards = IndexOfVector(volume, wayOut);
  FlatLight       light = FlatLight::On(ray.normal, ray.axes);
  float           visible = 1.0F;
  color[0] = color[1] = color[2] = 0.0F;
  for (int step = FirstStep<VIsInside>(volume, look, surface, outwards); step <= look.outside && visible > hidden;
       ++step)
  {
    const Place place = Moved(surface, step, outwards);
    const float hu = ValueAt<VIsInside>(volume, place);
    const float weight = visible * OpacityOf(look, hu);
    if (weight > faint)
    {
      light = LightAt<VIsInside>(volume, place, ray);
    }
    if (weight > 0.0F)
    {
      const bool  isBoundary = hu < look.tissue;
      const float behind = isBoundary ? ValueAt<VIsInside>(volume, Moved(place, look.stepsBehind, outwards)) : hu;
      const float * const tissue = ColorOf(look, Larger(hu, behind));
      for (int channel = 0; channel < 3; ++channel)
      {
        color[channel] += weight * (light.brightness * tissue[channel] + light.highlight);
      }
      visible -= weight;
    }
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    color[channel] += visible * look.nothing[channel];
  }
}

/** Linear red, green and blue; may exceed 1. */
SHAPETON_HOST_DEVICE void
ColorOfRay(const WallVolume & volume, const WallLook & look, const WallRay & ray, float color[3])
{
  const Place surface = IndexOf(volume, ray.point);
  if (HoldsBall(volume, surface, look.reach))
  {
    Cast<true>(volume, look, ray, surface, color);
  }
  else
  {
    Cast<false>(volume, look, ray, surface, color);
  }
}
} // namespace WallRayArithmetic
} // namespace shapeton

#endif
